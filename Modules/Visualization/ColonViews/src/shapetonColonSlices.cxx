#include "shapetonColonPictures.h"

#include "shapetonLumenBox.h"
#include "shapetonPageColors.h"
#include "shapetonPictureAnnotation.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
const RGBColor gasColor = MakeColor(64, 224, 255);
const RGBColor fluidColor = MakeColor(255, 150, 40);
const RGBColor wallColor = MakeColor(255, 70, 160);
// Used without a CT.
const RGBColor outside = MakeColor(58, 60, 68);
const RGBColor flatGas = MakeColor(14, 15, 20);
const RGBColor flatFluid = MakeColor(206, 208, 212);

/** Layout, pixels. */
constexpr int margin = 16;
constexpr int gap = 14;
constexpr int headingHeight = 40;
constexpr int captionHeight = 24;
constexpr int pageWidth = 1400;
constexpr int greatestPanelHeight = 560;
constexpr int titleSize = 22;
constexpr int textSize = 15;

using LumenType = itk::Image<unsigned char, 3>;

Picture::Pointer
PaintPanel(const ColonParts & colon, const SliceView & view, const IntensityWindow & window)
{
  const auto labelAt = [&](const itk::Index<3> & index) { return colon.lumen->GetPixel(index); };
  const bool hasCt = colon.ct != nullptr;
  auto picture = hasCt ? PaintSlice(view, colon.ct, window) : NewPicture(view.GetWidth(), view.GetHeight(), outside);
  if (!hasCt)
  {
    ColorSlice(
      picture,
      view,
      [&](const itk::Index<3> & index) {
        const unsigned char label = labelAt(index);
        return label == 0 ? std::optional<RGBColor>() : label == 2 ? flatFluid : flatGas;
      },
      1.0);
  }
  // The wall is drawn first, so it is visible only where it differs from the outlines.
  constexpr double thickness = 1.5;
  if (colon.wall)
  {
    DrawSurfaceCut(picture, view, *colon.wall, wallColor, thickness);
  }
  const auto is = [&](unsigned char label) {
    return [=](const itk::Index<3> & index) { return labelAt(index) == label; };
  };
  DrawMaskOutline(picture, view, is(2), fluidColor, thickness);
  DrawMaskOutline(picture, view, is(1), gasColor, thickness);
  DrawSliceLetters(picture, view);
  return picture;
}

/** Scale at which this number of slices side by side fills the page width, with limited height. */
double
ScaleFor(const LumenType * lumen, const itk::ImageRegion<3> & focus, const SliceAxes & axes, std::size_t number)
{
  const auto & spacing = lumen->GetSpacing();
  const double across = spacing[axes.across] * static_cast<double>(focus.GetSize(axes.across));
  const double down = spacing[axes.down] * static_cast<double>(focus.GetSize(axes.down));
  const double room = pageWidth - 2 * margin - gap * (static_cast<double>(number) - 1.0);
  return std::max(across * static_cast<double>(number) / room, down / greatestPanelHeight);
}

std::vector<itk::IndexValueType>
SlicesOf(const LumenType * lumen, const LumenAreas & areas, unsigned int axis, int number)
{
  const itk::ImageRegion<3>        box = LumenBox(lumen, areas, 0.0);
  const auto                       count = static_cast<int>(box.GetSize(axis));
  const int                        shown = std::min(number, count);
  std::vector<itk::IndexValueType> slices;
  for (int i = 0; i < shown; ++i)
  {
    slices.push_back(box.GetIndex(axis) + static_cast<itk::IndexValueType>((i + 0.5) / shown * count));
  }
  // The slice with the largest area replaces the nearest of the other slices.
  const auto                most = std::max_element(areas[axis].begin(), areas[axis].end()) - areas[axis].begin();
  const itk::IndexValueType largest = lumen->GetBufferedRegion().GetIndex(axis) + most;
  const auto                nearest =
    std::min_element(slices.begin(), slices.end(), [&](itk::IndexValueType a, itk::IndexValueType b) {
      return std::abs(a - largest) < std::abs(b - largest);
    });
  if (nearest != slices.end())
  {
    *nearest = largest;
  }
  return slices;
}

void
DrawHead(Picture * picture, const ColonParts & colon, const std::string & title)
{
  constexpr int titleTop = 12;
  constexpr int legendTop = 17;
  constexpr int legendBottom = 40;
  constexpr int distanceOfLegend = 160; // from the title
  constexpr int distanceOfEntries = 46; // from text to text
  TextStyle     style{ titleSize, InkColor, true };
  DrawText(picture, title, margin, titleTop, style);
  std::vector<LegendEntry> legend{ { gasColor, "gas" }, { fluidColor, "fluid" } };
  if (colon.wall)
  {
    legend.push_back({ wallColor, "wall, where it departs from these" });
  }
  style.size = textSize;
  style.bold = false;
  int left = margin + MeasureText(title, style).width + distanceOfLegend;
  for (const LegendEntry & entry : legend)
  {
    DrawLegend(picture, { entry }, left, legendTop, legendBottom);
    left += MeasureText(entry.text, style).width + distanceOfEntries;
  }
}
} // namespace

std::vector<itk::IndexValueType>
ChooseSlices(const itk::Image<unsigned char, 3> * lumen, SlicePlane plane, int number)
{
  return SlicesOf(lumen, AreasOf(lumen), AxesOf(lumen, plane).through, number);
}

Picture::Pointer
DrawColonSlices(const ColonParts & colon, SlicePlane plane, int number, const IntensityWindow & window)
{
  CheckParts(colon);
  constexpr double                       surroundings = 25.0; // mm
  constexpr int                          smallestWidth = 640;
  constexpr int                          footHeight = 44;
  constexpr int                          barBottom = 32; // below the slices
  constexpr int                          barLength = 160;
  const LumenAreas                       areas = AreasOf(colon.lumen);
  const itk::ImageRegion<3>              focus = LumenBox(colon.lumen, areas, surroundings);
  const SliceAxes                        axes = AxesOf(colon.lumen, plane);
  const std::vector<itk::IndexValueType> slices = SlicesOf(colon.lumen, areas, axes.through, std::max(number, 1));
  const double                           scale = ScaleFor(colon.lumen, focus, axes, slices.size());
  const SliceView                        first(colon.lumen, focus, plane, slices.front(), scale);
  const int                              panelTop = headingHeight + captionHeight + 6;
  const int                              bottom = panelTop + static_cast<int>(first.GetHeight());
  const int                              step = static_cast<int>(first.GetWidth()) + gap;
  const int                              used = 2 * margin + static_cast<int>(slices.size()) * step - gap;
  auto picture = NewPicture(static_cast<unsigned int>(std::max(used, smallestWidth)), bottom + footHeight, PaperColor);
  std::string title = NameOf(plane) + " slices";
  title[0] = static_cast<char>(title[0] - 'a' + 'A');
  DrawHead(picture, colon, title);
  TextStyle style{ textSize, InkColor };
  int       left = margin;
  for (const itk::IndexValueType slice : slices)
  {
    const SliceView   view(colon.lumen, focus, plane, slice, scale);
    const auto        region = colon.lumen->GetBufferedRegion();
    const std::string caption = "slice " + std::to_string(slice - region.GetIndex(axes.through) + 1) + " of " +
                                std::to_string(region.GetSize(axes.through));
    DrawText(picture, caption, left, headingHeight + 6, style);
    PastePicture(picture, PaintPanel(colon, view, window), left, panelTop);
    left += step;
  }
  DrawScaleBar(picture, margin, bottom + barBottom, barLength, scale, InkColor);
  return picture;
}
} // namespace shapeton
