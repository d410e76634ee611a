#include "shapetonPlotFrame.h"

#include "shapetonAxisTicks.h"
#include "shapetonCsvTable.h"

#include <cmath>

namespace shapeton
{
namespace
{
const RGBColor ink = MakeColor(30, 32, 38);
const RGBColor grid = MakeColor(226, 228, 232);

/** Layout, pixels. */
constexpr int tickLength = 5;
constexpr int numberSize = 15;
constexpr int titleSize = 16;
constexpr int topOfTitleX = 29;  ///< below the area
constexpr int leftOfTitleY = 74; ///< to the left of the area
} // namespace

void
DrawPlotFrame(Picture * picture, const PlotFrame & frame)
{
  constexpr int leastDistanceX = 70;
  constexpr int leastDistanceY = 36;
  const int     right = frame.left + frame.width;
  const int     bottom = frame.top + frame.height;
  TextStyle     style{ numberSize, ink, false, HorizontalAnchor::Center };
  const auto    ticksOf = [](const PlotAxis & axis, int number) {
    return RoundTicks(axis.shownPerValue * axis.lower, axis.shownPerValue * axis.upper, number);
  };
  for (const double value : ticksOf(frame.x, frame.width / leastDistanceX))
  {
    const int x = static_cast<int>(std::lround(frame.PixelOfX(value / frame.x.shownPerValue)));
    FillRectangle(picture, x, frame.top, 1, frame.height, grid);
    FillRectangle(picture, x, bottom, 1, tickLength, ink);
    DrawText(picture, CsvTable::Rounded(value, 6), x, bottom + tickLength + 3, style);
  }
  style.horizontal = HorizontalAnchor::Right;
  style.vertical = VerticalAnchor::Center;
  for (const double value : ticksOf(frame.y, frame.height / leastDistanceY))
  {
    const int y = static_cast<int>(std::lround(frame.PixelOfY(value / frame.y.shownPerValue)));
    FillRectangle(picture, frame.left, y, frame.width, 1, grid);
    FillRectangle(picture, frame.left - tickLength, y, tickLength, 1, ink);
    DrawText(picture, CsvTable::Rounded(value, 6), frame.left - tickLength - 4, y, style);
  }
  DrawRectangle(picture, frame.left - 1, frame.top - 1, frame.width + 2, frame.height + 2, ink);
  style.size = titleSize;
  style.horizontal = HorizontalAnchor::Center;
  style.vertical = VerticalAnchor::Top;
  DrawText(
    picture, frame.x.title, (frame.left + right) / 2, bottom + topOfTitleX, FitText(frame.x.title, style, frame.width));
  style = FitText(frame.y.title, style, frame.height);
  style.upwards = true;
  style.horizontal = HorizontalAnchor::Left;
  style.vertical = VerticalAnchor::Center;
  DrawText(picture, frame.y.title, frame.left - leftOfTitleY, (frame.top + bottom) / 2, style);
}
} // namespace shapeton
