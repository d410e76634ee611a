#include "shapetonSliceMontage.h"

#include "shapetonAxisTicks.h"
#include "shapetonColorMap.h"
#include "shapetonCsvTable.h"
#include "shapetonPageColors.h"
#include "shapetonQuantiles.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace shapeton
{
namespace
{
using ImageType = itk::Image<float, 3>;

constexpr SlicePlane planes[] = { SlicePlane::Axial, SlicePlane::Coronal, SlicePlane::Sagittal };

/** Layout, pixels. */
constexpr int margin = 16;
constexpr int gap = 14;
constexpr int titleHeight = 40;
constexpr int captionHeight = 26;
constexpr int legendWidth = 225;
constexpr int greatestPanelHeight = 460;
constexpr int footHeight = 24;

itk::Index<3>
MiddleOf(const itk::ImageBase<3> * image)
{
  itk::Index<3> middle = image->GetBufferedRegion().GetIndex();
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    middle[axis] += static_cast<itk::IndexValueType>(image->GetBufferedRegion().GetSize(axis) / 2);
  }
  return middle;
}

/** Extent of the volume along an axis, mm. */
double
LengthOf(const itk::ImageBase<3> * image, unsigned int axis)
{
  return image->GetSpacing()[axis] * image->GetBufferedRegion().GetSize(axis);
}

/** One slice with its colors. */
Picture::Pointer
PaintColoredSlice(const SliceView &       view,
                  const ImageType *       gray,
                  const ImageType *       heat,
                  const HeatColoring &    coloring,
                  const IntensityWindow & window,
                  double                  opacity)
{
  auto picture = PaintSlice(view, gray, window);
  ColorSlice(
    picture, view, [&](const itk::Index<3> & index) { return coloring(heat->GetPixel(index)); }, opacity);
  DrawSliceLetters(picture, view);
  return picture;
}

/** Scale at which three slices side by side fill the width, with limited height. */
double
ScaleFor(const itk::ImageBase<3> * image, int width)
{
  double lengths = 0.0;
  double greatestHeight = 0.0;
  for (const SlicePlane plane : planes)
  {
    const SliceAxes axes = AxesOf(image, plane);
    lengths += LengthOf(image, axes.across);
    greatestHeight = std::max(greatestHeight, LengthOf(image, axes.down));
  }
  return std::max(lengths / (width - 2 * gap), greatestHeight / greatestPanelHeight);
}

void
Check(const ImageType * gray, const ImageType * heat, const SliceMontageOptions & options)
{
  if (!gray || !heat || gray->GetBufferedRegion() != heat->GetBufferedRegion() ||
      gray->GetBufferedRegion().GetNumberOfPixels() == 0)
  {
    throw std::invalid_argument("the image and the heat volume of a montage must have the same size");
  }
  if (options.cut && !gray->GetBufferedRegion().IsInside(*options.cut))
  {
    throw std::invalid_argument("the cut of a montage is outside the volume");
  }
  constexpr unsigned int smallestWidth = 600;
  if (options.width < smallestWidth)
  {
    throw std::invalid_argument("a montage must be at least 600 pixels wide");
  }
}
} // namespace

IntensityWindow
WindowOf(const ImageType * gray, const IntensityWindow & window)
{
  if (window.lower < window.upper)
  {
    return window;
  }
  constexpr std::size_t greatestSample = 1000000;
  const std::size_t     number = gray->GetBufferedRegion().GetNumberOfPixels();
  const std::size_t     stride = number / greatestSample + 1;
  std::vector<float>    sample;
  for (std::size_t i = 0; i < number; i += stride)
  {
    sample.push_back(gray->GetBufferPointer()[i]);
  }
  const double lower = LowerQuantile(sample, 0.005);
  const double upper = LowerQuantile(sample, 0.995);
  return upper > lower ? IntensityWindow{ lower, upper } : IntensityWindow{ lower, lower + 1.0 };
}

Picture::Pointer
DrawSliceMontage(const itk::Image<float, 3> * gray,
                 const itk::Image<float, 3> * heat,
                 const HeatColoring &         coloring,
                 const SliceMontageOptions &  options)
{
  Check(gray, heat, options);
  const itk::Index<3> cut = options.cut.value_or(MiddleOf(gray));
  const int           width = static_cast<int>(options.width) - 2 * margin - (options.legend.empty() ? 0 : legendWidth);
  const double        scale = ScaleFor(gray, width);
  const IntensityWindow  window = WindowOf(gray, options.window);
  std::vector<SliceView> views;
  int                    panelHeight = 0;
  for (const SlicePlane plane : planes)
  {
    views.emplace_back(gray, gray->GetBufferedRegion(), plane, cut[AxesOf(gray, plane).through], scale);
    panelHeight = std::max(panelHeight, static_cast<int>(views.back().GetHeight()));
  }
  const int top = options.title.empty() ? margin : margin + titleHeight;
  auto      picture = NewPicture(
    options.width, static_cast<unsigned int>(top + captionHeight + panelHeight + margin + footHeight), PaperColor);
  constexpr int titleSize = 22;
  constexpr int captionSize = 15;
  TextStyle     style{ titleSize, InkColor, true };
  DrawText(picture,
           options.title,
           margin,
           margin,
           FitText(options.title, style, static_cast<int>(options.width) - 2 * margin));
  style.size = captionSize;
  style.bold = false;
  int left = margin;
  for (std::size_t i = 0; i < views.size(); ++i)
  {
    const unsigned int        through = views[i].GetAxes().through;
    const itk::IndexValueType slice = views[i].GetSlice() - gray->GetBufferedRegion().GetIndex(through) + 1;
    const int                 panelWidth = static_cast<int>(views[i].GetWidth());
    const std::string         caption = NameOf(planes[i]) + ", slice " + std::to_string(slice) + " of " +
                                std::to_string(gray->GetBufferedRegion().GetSize(through));
    DrawText(picture, caption, left, top, FitText(caption, style, panelWidth));
    PastePicture(
      picture, PaintColoredSlice(views[i], gray, heat, coloring, window, options.opacity), left, top + captionHeight);
    left += panelWidth + gap;
  }
  const int     bottom = top + captionHeight + panelHeight;
  constexpr int barBottom = 28; // below the slices
  constexpr int barLength = 160;
  DrawScaleBar(picture, margin, bottom + barBottom, barLength, scale, InkColor);
  DrawLegend(
    picture, options.legend, static_cast<int>(options.width) - margin - legendWidth + gap, top + captionHeight, bottom);
  return picture;
}

std::vector<LegendEntry>
LegendOf(const std::vector<HeatClass> & classes)
{
  std::vector<LegendEntry> legend;
  for (const HeatClass & heatClass : classes)
  {
    if (heatClass.label != 0)
    {
      legend.push_back({ IsIncoherent(heatClass) ? PaperColor : ColorOfClass(heatClass), NameOfClass(heatClass) });
    }
  }
  return legend;
}

std::vector<LegendEntry>
LegendOf(const ShapeTransferFunction & transferFunction)
{
  std::vector<LegendEntry> legend;
  for (const TransferFunctionLine & line : transferFunction.GetLines())
  {
    const std::string range = HeatLabel(line.lowerHeat) + " to " + HeatLabel(line.upperHeat);
    legend.push_back({ line.opacity > 0.0 ? line.color : PaperColor, line.name.empty() ? range : line.name });
  }
  return legend;
}
} // namespace shapeton
