#include "shapetonHeatColoring.h"
#include "shapetonColorMap.h"

#include <algorithm>

namespace shapeton
{
HeatColoring
ColorByHeat(const HeatAxis & axis)
{
  return [axis](float heat) {
    return heat < HeatHistogram::LowerEdge(1) ? std::nullopt : std::optional<RGBColor>(axis.ColorOf(heat));
  };
}

HeatColoring
ColorByClass(const std::vector<HeatClass> & classes)
{
  struct Range
  {
    double   lower;
    double   upper;
    RGBColor color;
  };
  std::vector<Range> ranges;
  for (const HeatClass & heatClass : classes)
  {
    if (heatClass.label != 0)
    {
      ranges.push_back({ heatClass.lowerHeat, heatClass.upperHeat, ClassColor(heatClass.label) });
    }
  }
  return [ranges](float heat) {
    const auto found = std::find_if(
      ranges.begin(), ranges.end(), [&](const Range & range) { return heat >= range.lower && heat < range.upper; });
    return found == ranges.end() ? std::nullopt : std::optional<RGBColor>(found->color);
  };
}

HeatColoring
ColorByLine(const ShapeTransferFunction & transferFunction)
{
  return [transferFunction](float heat) {
    const int line = transferFunction.LineOf(heat);
    return line < 0 ? std::nullopt : std::optional<RGBColor>(transferFunction.GetLines()[line].color);
  };
}
} // namespace shapeton
