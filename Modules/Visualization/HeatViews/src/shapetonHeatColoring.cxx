#include "shapetonHeatColoring.h"
#include "shapetonAxisTicks.h"
#include "shapetonColorMap.h"

namespace shapeton
{
RGBColor
ColorOfClass(const HeatClass & heatClass)
{
  constexpr unsigned char gray = 128;
  return heatClass.isSurroundings ? MakeColor(gray, gray, gray) : ClassColor(heatClass.label);
}

std::string
NameOfClass(const HeatClass & heatClass)
{
  return "class " + std::to_string(heatClass.label) + ": " +
         (heatClass.isSurroundings  ? "surroundings"
          : IsIncoherent(heatClass) ? "incoherent"
                                    : HeatLabel(heatClass.lowerHeat) + " to " + HeatLabel(heatClass.upperHeat));
}

HeatColoring
ColorByHeat(const HeatAxis & axis)
{
  return [axis](float heat) {
    return heat < HeatHistogram::LowerEdge(1) ? std::nullopt : std::optional<RGBColor>(axis.ColorOf(heat));
  };
}

HeatColoring
ColorByLine(const ShapeTransferFunction & transferFunction)
{
  return [transferFunction](float heat) {
    const int  line = transferFunction.LineOf(heat);
    const bool isShown = line >= 0 && transferFunction.GetLines()[line].opacity > 0.0;
    return isShown ? std::optional<RGBColor>(transferFunction.GetLines()[line].color) : std::nullopt;
  };
}
} // namespace shapeton
