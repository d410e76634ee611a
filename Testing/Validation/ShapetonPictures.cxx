#include "ShapetonPictures.h"

#include "shapetonColorMap.h"
#include "shapetonHeatAxis.h"
#include "shapetonQuantiles.h"
#include "shapetonTestImages.h"
#include "shapetonVolumeRendering.h"

#include <algorithm>
#include <array>
#include <cmath>

using namespace shapeton;

namespace
{
constexpr int margin = 8, captionHeight = 24, titleHeight = 36, scaleHeight = 34;

const RGBColor paper = MakeColor(255, 255, 255);
const RGBColor ink = MakeColor(30, 30, 30);

RGBColor
ColorOfLevel(unsigned int level)
{
  return HeatColor((level - 0.5) / numberOfLevels);
}

/** Whether nearly all values are equal within half a percent; ranks would then show the rounding of a converged
 * field. */
bool
IsFlat(const std::vector<float> & values)
{
  const float high = LowerQuantile(values, 0.99);
  return values.empty() || high - LowerQuantile(values, 0.01) < 0.005F * high;
}

template <typename TLevel>
itk::Image<unsigned char, 3>::Pointer
MakeLevels(const TrialVolume & volume, const TLevel & levelOfVoxel)
{
  const auto levels = NewImageOn<itk::Image<unsigned char, 3>>(volume.image, true);
  for (std::size_t i = 0; i < volume.GetNumberOfVoxels(); ++i)
  {
    if (volume.IsObject(i))
    {
      levels->GetBufferPointer()[i] = static_cast<unsigned char>(levelOfVoxel(i));
    }
  }
  return levels;
}
} // namespace

itk::Image<unsigned char, 3>::Pointer
LevelsOf(const TrialVolume & volume, const Trial & trial)
{
  const float * const field = trial.field->GetBufferPointer();
  std::vector<float>  values;
  for (std::size_t i = 0; i < volume.GetNumberOfVoxels(); ++i)
  {
    if (volume.IsObject(i))
    {
      values.push_back(field[i]);
    }
  }
  if (IsFlat(values))
  {
    return MakeLevels(volume, [](std::size_t) { return (numberOfLevels + 1) / 2; });
  }
  HeatHistogram histogram({ 0 });
  histogram.AddToRow(0, values.data(), values.size());
  const HeatAxis             axis(histogram);
  std::vector<unsigned char> levelOfBin(HeatHistogram::NumberOfBins, 1);
  for (unsigned int bin = 1; bin < HeatHistogram::NumberOfBins; ++bin)
  {
    const double position =
      0.5 * (axis.PositionOf(HeatHistogram::LowerEdge(bin)) + axis.PositionOf(HeatHistogram::LowerEdge(bin + 1)));
    levelOfBin[bin] =
      static_cast<unsigned char>(std::min(numberOfLevels, 1 + static_cast<unsigned int>(position * numberOfLevels)));
  }
  return MakeLevels(volume, [&](std::size_t voxel) {
    return trial.visits && field[voxel] == 0.0F ? 0U : levelOfBin[HeatHistogram::BinOf(field[voxel])];
  });
}

Picture::Pointer
RenderLevels(const itk::Image<unsigned char, 3> * levels, unsigned int width, unsigned int height, double azimuth)
{
  constexpr double                  unit = 1.0 / (numberOfLevels + 1);
  std::vector<TransferFunctionLine> lines;
  for (unsigned int level = 1; level <= numberOfLevels; ++level)
  {
    lines.push_back({ (level - 0.5) * unit, (level + 0.5) * unit, ColorOfLevel(level), 1.0 });
  }
  const auto field = MapVoxels<float>(levels, [](unsigned char level) { return static_cast<float>(level * unit); });
  VolumeRenderingOptions options;
  options.azimuth = azimuth;
  options.elevation = 25.0;
  options.width = width;
  options.height = height;
  options.annotations = false;
  const ShapeTransferFunction transferFunction(lines);
  options.focus = VisibleRegion(field, transferFunction);
  options.zoom = 1.1;
  return RenderVolume(field, transferFunction, options);
}

Picture::Pointer
DrawPlane(const TrialVolume &                  volume,
          const itk::Image<unsigned char, 3> * levels,
          unsigned int                         axis,
          std::size_t                          slice,
          unsigned int                         width,
          unsigned int                         height)
{
  const unsigned int across = axis == 0 ? 1 : 0, down = axis == 2 ? 1 : 2;
  const auto         size = volume.image->GetLargestPossibleRegion().GetSize();
  const auto         spacing = volume.image->GetSpacing();
  const auto         direction = volume.image->GetDirection();
  const bool         flipAcross = direction(across, across) < 0.0;
  const bool         flipDown = (direction(down, down) < 0.0) == (down == 1); // posterior and feet are below
  const double       unit = std::max(size[across] * spacing[across] / width, size[down] * spacing[down] / height);
  const auto         columns = static_cast<unsigned int>(size[across] * spacing[across] / unit);
  const auto         rows = static_cast<unsigned int>(size[down] * spacing[down] / unit);
  auto               plane = NewPicture(width, height, MakeColor(0, 0, 0));
  for (unsigned int row = 0; row < rows; ++row)
  {
    for (unsigned int column = 0; column < columns; ++column)
    {
      itk::Index<3> index;
      index[axis] = static_cast<itk::IndexValueType>(slice);
      index[across] = std::min<itk::IndexValueType>(size[across] - 1, (column + 0.5) * unit / spacing[across]);
      index[down] = std::min<itk::IndexValueType>(size[down] - 1, (row + 0.5) * unit / spacing[down]);
      index[across] = flipAcross ? size[across] - 1 - index[across] : index[across];
      index[down] = flipDown ? size[down] - 1 - index[down] : index[down];
      const unsigned int level = levels == nullptr ? 0 : levels->GetPixel(index);
      const double       gray = (volume.image->GetPixel(index) - volume.lower) / (volume.upper - volume.lower);
      const auto         shade = static_cast<unsigned char>(levels ? 0.0 : 240.0 * std::clamp(gray, 0.0, 1.0));
      plane->SetPixel({ { (width - columns) / 2 + column, (height - rows) / 2 + row } },
                      level > 0 ? ColorOfLevel(level) : MakeColor(shade, shade, shade));
    }
  }
  return plane;
}

PictureSheet::PictureSheet(const std::string & title, const Layout & layout) : m_Layout(layout)
{
  const auto width = static_cast<unsigned int>(margin + layout.columns * (layout.width + margin));
  const auto height = static_cast<unsigned int>(titleHeight + (layout.hasScale ? scaleHeight : 0) +
                                                layout.rows * (captionHeight + layout.height + margin));
  m_Picture = NewPicture(width, height, paper);
  TextStyle style;
  style.size = 19;
  style.bold = true;
  style.color = ink;
  DrawText(m_Picture, title, margin, margin, FitText(title, style, static_cast<int>(width) - 2 * margin));
  if (!layout.hasScale)
  {
    return;
  }
  const int bottom = static_cast<int>(height) - scaleHeight + 8;
  style.size = 14;
  style.bold = false;
  const std::string least = "least", most = "most (colors share the object voxels of a panel equally)";
  DrawText(m_Picture, least, margin, bottom, style);
  int left = margin + MeasureText(least, style).width + 8;
  for (unsigned int level = 1; level <= numberOfLevels; ++level, left += 18)
  {
    FillRectangle(m_Picture, left, bottom, 18, 16, ColorOfLevel(level));
  }
  DrawText(m_Picture, most, left + 8, bottom, style);
}

void
PictureSheet::Put(std::size_t row, std::size_t column, const std::string & caption, const Picture * panel)
{
  const int left = margin + static_cast<int>(column * (m_Layout.width + margin));
  const int top = titleHeight + static_cast<int>(row * (captionHeight + m_Layout.height + margin));
  TextStyle style;
  style.size = 15;
  style.color = ink;
  DrawText(m_Picture, caption, left, top + 2, FitText(caption, style, static_cast<int>(m_Layout.width)));
  PastePicture(m_Picture, panel, left, top + captionHeight);
}

void
PictureSheet::Write(const std::string & path) const
{
  WritePng(m_Picture, path);
}
