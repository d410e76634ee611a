#include "shapetonPicture.h"

#include "shapetonFileBytes.h"
#include "shapetonImageDataAdapter.h"
#include "shapetonExceptions.h"
#include "shapetonParallelFor.h"

#include <vtkFreeTypeTools.h>
#include <vtkImageData.h>
#include <vtkImageFlip.h>
#include <vtkNew.h>
#include <vtkJPEGWriter.h>
#include <vtkPNGWriter.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <stdexcept>

namespace shapeton
{
namespace
{
int
WidthOf(const Picture * picture)
{
  return static_cast<int>(picture->GetBufferedRegion().GetSize(0));
}

int
HeightOf(const Picture * picture)
{
  return static_cast<int>(picture->GetBufferedRegion().GetSize(1));
}

RGBColor &
PixelAt(Picture * picture, int x, int y)
{
  return picture->GetBufferPointer()[static_cast<std::size_t>(y) * WidthOf(picture) + x];
}

void
Blend(Picture * picture, int x, int y, const RGBColor & color, double opacity)
{
  RGBColor & pixel = PixelAt(picture, x, y);
  pixel = MixColors(pixel, color, opacity);
}

bool
IsInside(const Picture * picture, int x, int y)
{
  return x >= 0 && y >= 0 && x < WidthOf(picture) && y < HeightOf(picture);
}

/** Encodes in memory, so that disk errors occur when the file is written, not inside an image library. */
template <typename TWriter>
std::string
Encode(const Picture * picture, TWriter * writer)
{
  vtkNew<vtkImageFlip> upwards; // VTK stores rows bottom-up
  upwards->SetInputData(ImageDataOf(picture));
  upwards->SetFilteredAxis(1);
  writer->WriteToMemoryOn();
  writer->SetInputConnection(upwards->GetOutputPort());
  writer->Write();
  vtkUnsignedCharArray * const bytes = writer->GetResult();
  return std::string(reinterpret_cast<const char *>(bytes->GetPointer(0)), bytes->GetNumberOfValues());
}

/** Coverage of rendered text, in the last of 4 components per pixel; the extent is relative to the upright, lower left
 * anchored position. */
void
RenderText(const std::string & text, const TextStyle & style, vtkImageData * coverage, int dimensions[2])
{
  // The font size is given in points: at 72 points per inch, a point is a pixel.
  constexpr int           pointsPerInch = 72;
  vtkNew<vtkTextProperty> property;
  property->SetFontFamilyToArial();
  property->SetFontSize(style.size);
  property->SetBold(style.bold);
  property->SetColor(1.0, 1.0, 1.0);
  property->SetOrientation(style.upwards ? 90.0 : 0.0);
  static std::mutex                 mutex; // VTK shares fonts and glyphs between threads
  const std::lock_guard<std::mutex> lock(mutex);
  if (!vtkFreeTypeTools::GetInstance()->RenderString(property, vtkStdString(text), pointsPerInch, coverage, dimensions))
  {
    throw std::runtime_error("cannot render the text \"" + text + "\"");
  }
}

int
Aligned(int anchor, int length, bool centered, bool atEnd)
{
  if (centered)
  {
    return anchor - length / 2;
  }
  return atEnd ? anchor - length : anchor;
}
} // namespace

RGBColor
MakeColor(unsigned char red, unsigned char green, unsigned char blue)
{
  RGBColor color;
  color.Set(red, green, blue);
  return color;
}

RGBColor
MixColors(const RGBColor & from, const RGBColor & to, double share)
{
  RGBColor mixed;
  for (unsigned int channel = 0; channel < 3; ++channel)
  {
    mixed[channel] = static_cast<unsigned char>(from[channel] + (to[channel] - from[channel]) * share + 0.5);
  }
  return mixed;
}

Picture::Pointer
NewPicture(unsigned int width, unsigned int height, const RGBColor & background)
{
  if (width == 0 || height == 0)
  {
    throw std::invalid_argument("the width and the height of a picture must be positive");
  }
  auto picture = Picture::New();
  picture->SetRegions(Picture::SizeType{ { width, height } });
  picture->Allocate();
  picture->FillBuffer(background);
  return picture;
}

void
WritePng(const Picture * picture, const std::string & path)
{
  WriteFileBytes(path, Encode(picture, vtkNew<vtkPNGWriter>().Get()));
}

std::string
EncodeJpeg(const Picture * picture, int quality)
{
  vtkNew<vtkJPEGWriter> writer;
  writer->SetQuality(quality);
  return Encode(picture, writer.Get());
}

void
WritePngs(const std::vector<PictureFile> & files)
{
  ParallelFor(files.size(), [&](std::size_t i) { WritePng(files[i].draw(), files[i].path); });
}

void
FillRectangle(Picture * picture, int left, int top, int width, int height, const RGBColor & color, double opacity)
{
  const int right = std::min(left + width, WidthOf(picture));
  const int bottom = std::min(top + height, HeightOf(picture));
  for (int y = std::max(top, 0); y < bottom; ++y)
  {
    for (int x = std::max(left, 0); x < right; ++x)
    {
      Blend(picture, x, y, color, opacity);
    }
  }
}

void
DrawRectangle(Picture * picture, int left, int top, int width, int height, const RGBColor & color, int thickness)
{
  FillRectangle(picture, left, top, width, thickness, color);
  FillRectangle(picture, left, top + height - thickness, width, thickness, color);
  FillRectangle(picture, left, top + thickness, thickness, height - 2 * thickness, color);
  FillRectangle(picture, left + width - thickness, top + thickness, thickness, height - 2 * thickness, color);
}

void
DrawLine(Picture *        picture,
         double           x0,
         double           y0,
         double           x1,
         double           y1,
         const RGBColor & color,
         double           thickness,
         double           opacity)
{
  const double reach = 0.5 * thickness + 0.5;
  const double dx = x1 - x0;
  const double dy = y1 - y0;
  const double lengthSquared = dx * dx + dy * dy;
  const int    left = std::max(static_cast<int>(std::floor(std::min(x0, x1) - reach)), 0);
  const int    right = std::min(static_cast<int>(std::ceil(std::max(x0, x1) + reach)), WidthOf(picture) - 1);
  const int    top = std::max(static_cast<int>(std::floor(std::min(y0, y1) - reach)), 0);
  const int    bottom = std::min(static_cast<int>(std::ceil(std::max(y0, y1) + reach)), HeightOf(picture) - 1);
  for (int y = top; y <= bottom; ++y)
  {
    for (int x = left; x <= right; ++x)
    {
      const double along = lengthSquared > 0.0 ? ((x - x0) * dx + (y - y0) * dy) / lengthSquared : 0.0;
      const double nearest = std::clamp(along, 0.0, 1.0);
      const double offX = x - (x0 + nearest * dx);
      const double offY = y - (y0 + nearest * dy);
      const double coverage = std::clamp(reach - std::sqrt(offX * offX + offY * offY), 0.0, 1.0);
      if (coverage > 0.0)
      {
        Blend(picture, x, y, color, coverage * opacity);
      }
    }
  }
}

void
PastePicture(Picture * picture, const Picture * source, int left, int top)
{
  const int width = WidthOf(source);
  for (int y = std::max(0, -top); y < std::min(HeightOf(source), HeightOf(picture) - top); ++y)
  {
    for (int x = std::max(0, -left); x < std::min(width, WidthOf(picture) - left); ++x)
    {
      PixelAt(picture, left + x, top + y) = source->GetBufferPointer()[static_cast<std::size_t>(y) * width + x];
    }
  }
}

TextExtent
MeasureText(const std::string & text, const TextStyle & style)
{
  if (text.empty())
  {
    return {};
  }
  vtkNew<vtkImageData> coverage;
  int                  dimensions[2];
  RenderText(text, style, coverage, dimensions);
  return { dimensions[0], dimensions[1] };
}

TextStyle
FitText(const std::string & text, TextStyle style, int width)
{
  constexpr int leastSize = 8;
  while (style.size > leastSize && MeasureText(text, style).width > width)
  {
    --style.size;
  }
  return style;
}

void
DrawText(Picture * picture, const std::string & text, int x, int y, const TextStyle & style)
{
  if (text.empty())
  {
    return;
  }
  vtkNew<vtkImageData> coverage;
  int                  dimensions[2];
  RenderText(text, style, coverage, dimensions);
  const int left = Aligned(
    x, dimensions[0], style.horizontal == HorizontalAnchor::Center, style.horizontal == HorizontalAnchor::Right);
  const int top =
    Aligned(y, dimensions[1], style.vertical == VerticalAnchor::Center, style.vertical == VerticalAnchor::Bottom);
  int extent[6];
  coverage->GetExtent(extent);
  for (int row = 0; row < dimensions[1]; ++row)
  {
    for (int column = 0; column < dimensions[0]; ++column)
    {
      const auto * const texel = static_cast<const unsigned char *>(
        coverage->GetScalarPointer(extent[0] + column, extent[2] + dimensions[1] - 1 - row, 0));
      if (texel[3] > 0 && IsInside(picture, left + column, top + row))
      {
        Blend(picture, left + column, top + row, style.color, texel[3] / 255.0);
      }
    }
  }
}

void
DrawRimmedText(Picture * picture, const std::string & text, int x, int y, const TextStyle & style, const RGBColor & rim)
{
  TextStyle rimStyle = style;
  rimStyle.color = rim;
  for (const int dy : { -1, 0, 1 })
  {
    for (const int dx : { -1, 0, 1 })
    {
      DrawText(picture, text, x + dx, y + dy, rimStyle);
    }
  }
  DrawText(picture, text, x, y, style);
}
} // namespace shapeton
