#include "shapetonSliceMontage.h"

#include "shapetonAxisTicks.h"
#include "shapetonColorMap.h"
#include "shapetonCsvTable.h"
#include "shapetonPageColors.h"
#include "shapetonQuantiles.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <tuple>
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
constexpr int legendWidth = 190;
constexpr int greatestPanelHeight = 460;
constexpr int footHeight = 24;

/** Number of (coarsely quantized) colors and of colored voxels of a slice. */
struct SliceScore
{
  std::bitset<4096> colors;
  std::size_t       voxels{ 0 };
};

/** The default cut of DrawSliceMontage(), from every n-th voxel of each axis, at most a few million voxels. */
itk::Index<3>
MostColorfulCut(const ImageType * heat, const HeatColoring & coloring)
{
  const ImageType::RegionType            region = heat->GetBufferedRegion();
  const ImageType::SizeType              size = region.GetSize();
  const double                           voxels = static_cast<double>(region.GetNumberOfPixels());
  const auto                             stride = std::max<itk::SizeValueType>(std::lround(std::cbrt(voxels / 4e6)), 1);
  std::array<std::vector<SliceScore>, 3> scores;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    scores[axis].resize(size[axis]);
  }
  const float * const heats = heat->GetBufferPointer();
  for (itk::SizeValueType z = stride / 2; z < size[2]; z += stride)
  {
    for (itk::SizeValueType y = stride / 2; y < size[1]; y += stride)
    {
      for (itk::SizeValueType x = stride / 2; x < size[0]; x += stride)
      {
        const auto color = coloring(heats[(z * size[1] + y) * size[0] + x]);
        if (color)
        {
          const unsigned int coarse = ((*color)[0] >> 4) << 8 | ((*color)[1] >> 4) << 4 | (*color)[2] >> 4;
          for (SliceScore * score : { &scores[0][x], &scores[1][y], &scores[2][z] })
          {
            score->colors.set(coarse);
            ++score->voxels;
          }
        }
      }
    }
  }
  itk::Index<3> cut;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const auto rank = [&](itk::SizeValueType slice) {
      const double offMiddle = std::fabs(static_cast<double>(slice) - 0.5 * (size[axis] - 1.0));
      return std::make_tuple(scores[axis][slice].colors.count(), scores[axis][slice].voxels, -offMiddle);
    };
    itk::SizeValueType best = 0;
    for (itk::SizeValueType slice = 1; slice < size[axis]; ++slice)
    {
      best = rank(slice) > rank(best) ? slice : best;
    }
    cut[axis] = region.GetIndex(axis) + static_cast<itk::IndexValueType>(best);
  }
  return cut;
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
  const itk::Index<3> cut = options.cut ? *options.cut : MostColorfulCut(heat, coloring);
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
LegendOf(const std::vector<HeatClass> & classes, const ShapeQuantity & quantity)
{
  std::vector<LegendEntry> legend;
  for (const HeatClass & heatClass : classes)
  {
    if (heatClass.label != 0)
    {
      legend.push_back(
        { ClassColor(heatClass.label),
          "class " + std::to_string(heatClass.label) + ": " + quantity.name + " " + HeatLabel(heatClass.meanHeat) });
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
    legend.push_back({ line.color, line.name.empty() ? range : line.name });
  }
  return legend;
}
} // namespace shapeton
