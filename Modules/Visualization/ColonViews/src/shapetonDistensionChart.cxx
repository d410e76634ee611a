#include "shapetonDistensionChart.h"

#include "shapetonCenterlineStations.h"
#include "shapetonColonDistension.h"
#include "shapetonCsvTable.h"
#include "shapetonPageColors.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace shapeton
{
namespace
{
const RGBColor labelInk = MakeColor(92, 96, 106);
const RGBColor gapShade = MakeColor(206, 208, 214);
const RGBColor wide = MakeColor(160, 200, 226);
const RGBColor narrow = MakeColor(240, 150, 100);
const RGBColor curveColor = MakeColor(22, 74, 116);
const RGBColor limitColor = MakeColor(196, 44, 44);

constexpr int labelSize = 14; // pixels

using Stations = std::vector<CenterlineStation>;

/** Interpolated values at a distance from the anal verge. */
struct Place
{
  double caliber{ 0.0 };
  bool   isGap{ false };
  bool   isKnown{ false };
};

Place
PlaceAt(const Stations & stations, double distance)
{
  const auto after =
    std::find_if(stations.begin(), stations.end(), [&](const CenterlineStation & s) { return s.distance >= distance; });
  if (after == stations.end())
  {
    return {};
  }
  if (after == stations.begin())
  {
    return { after->caliber, after->isGap, after->distance == distance };
  }
  const auto   before = after - 1;
  const double length = after->distance - before->distance;
  const double share = length > 0.0 ? (distance - before->distance) / length : 1.0;
  return { before->caliber + share * (after->caliber - before->caliber), before->isGap || after->isGap, true };
}

/** Draws the areas under the curve, and the gaps, column by column. */
void
DrawAreas(Picture * picture, const PlotFrame & frame, const Stations & stations)
{
  constexpr double opacity = 0.75;
  const int        bottom = frame.top + frame.height;
  for (int column = 0; column < frame.width; ++column)
  {
    const double distance = frame.x.lower + (frame.x.upper - frame.x.lower) * column / (frame.width - 1.0);
    const Place  place = PlaceAt(stations, distance);
    const int    x = frame.left + column;
    if (place.isKnown && place.isGap)
    {
      FillRectangle(picture, x, frame.top, 1, frame.height, gapShade);
    }
    else if (place.isKnown)
    {
      const int y = static_cast<int>(std::lround(frame.PixelOfY(place.caliber)));
      FillRectangle(picture, x, y, 1, bottom - y, place.caliber < LeastDistendedCaliber ? narrow : wide, opacity);
    }
  }
}

void
DrawCurve(Picture * picture, const PlotFrame & frame, const Stations & stations)
{
  constexpr double thickness = 1.6;
  for (std::size_t i = 1; i < stations.size(); ++i)
  {
    const CenterlineStation & a = stations[i - 1];
    const CenterlineStation & b = stations[i];
    if (!a.isGap && !b.isGap)
    {
      DrawLine(picture,
               frame.PixelOfX(a.distance),
               frame.PixelOfY(a.caliber),
               frame.PixelOfX(b.distance),
               frame.PixelOfY(b.caliber),
               curveColor,
               thickness);
    }
  }
}

void
DrawLimit(Picture * picture, const PlotFrame & frame)
{
  constexpr int dash = 8;
  const int     y = static_cast<int>(std::lround(frame.PixelOfY(LeastDistendedCaliber)));
  for (int x = 0; x < frame.width; x += 2 * dash)
  {
    FillRectangle(picture, frame.left + x, y - 1, std::min(dash, frame.width - x), 2, limitColor);
  }
  TextStyle style{ labelSize, limitColor, false, HorizontalAnchor::Left, VerticalAnchor::Center };
  DrawText(picture, CsvTable::Rounded(LeastDistendedCaliber, 3) + " mm", frame.left + frame.width + 6, y, style);
}

/** Draws segment borders, and above the chart each segment name, on a second line if it does not fit on the first. */
void
DrawSegments(Picture * picture, const PlotFrame & frame, const std::vector<ColonSegment> & segments)
{
  constexpr int lineHeight = 18;
  int           ends[2] = { frame.left - 8, frame.left - 8 };
  for (const ColonSegment & segment : segments)
  {
    const int left = static_cast<int>(std::lround(frame.PixelOfX(segment.begin)));
    const int right = static_cast<int>(std::lround(frame.PixelOfX(segment.end)));
    for (const int x : { left, right })
    {
      FillRectangle(picture, x, frame.top - 8, 1, frame.height + 8, labelInk);
    }
    TextStyle style{ labelSize, InkColor };
    const int textWidth = MeasureText(segment.name, style).width;
    const int start = std::clamp(
      (left + right - textWidth) / 2, frame.left, std::max(frame.left + frame.width + 40 - textWidth, frame.left));
    const int line = start > ends[0] + 8 ? 0 : 1;
    ends[line] = start + textWidth;
    style.vertical = VerticalAnchor::Bottom;
    DrawText(picture, segment.name, start, frame.top - 10 - line * lineHeight, style);
  }
}

void
DrawKey(Picture * picture, const PlotFrame & frame, const DistensionChartOptions & options, bool hasGaps)
{
  constexpr int   titleSize = 22;
  constexpr int   titleTop = 12;
  constexpr int   legendSize = 15;
  constexpr int   legendTop = 16;
  constexpr int   legendBottom = 40;
  constexpr int   distanceOfEntries = 40; // from text to text
  TextStyle       style{ titleSize, InkColor, true };
  const TextStyle title = FitText(options.title, style, frame.width / 3);
  DrawText(picture, options.title, frame.left, titleTop, title);
  std::vector<LegendEntry> legend{ { wide, "at least 10 mm" }, { narrow, "narrower" } };
  if (hasGaps)
  {
    legend.push_back({ gapShade, "no lumen found" });
  }
  int right = frame.left + frame.width;
  style.bold = false;
  style.size = legendSize;
  for (auto entry = legend.rbegin(); entry != legend.rend(); ++entry)
  {
    right -= MeasureText(entry->text, style).width + distanceOfEntries;
    DrawLegend(picture, { *entry }, right, legendTop, legendBottom, InkColor);
  }
}
} // namespace

PlotFrame
DistensionFrame(const CurveSet & centerline, const DistensionChartOptions & options)
{
  constexpr unsigned int smallestWidth = 500;
  constexpr unsigned int smallestHeight = 300;
  if (options.width < smallestWidth || options.height < smallestHeight)
  {
    throw std::invalid_argument("the picture of a distension chart must have at least 500 x 300 pixels");
  }
  constexpr int    left = 90, top = 96, right = 66, bottom = 62; // pixels around the plot
  constexpr double roomAbove = 1.08;                             // relative to the greatest caliber
  PlotFrame        frame;
  frame.left = left;
  frame.top = top;
  frame.width = static_cast<int>(options.width) - frame.left - right;
  frame.height = static_cast<int>(options.height) - frame.top - bottom;
  frame.x = { "distance from the anal verge (cm)", 0.0, 1.0, MillimetersAsCentimeters };
  frame.y = { "caliber (mm)", 0.0, 2.0 * LeastDistendedCaliber };
  for (const CenterlineStation & station : StationsOf(centerline))
  {
    frame.x.upper = std::max(frame.x.upper, station.distance);
    frame.y.upper = std::max(frame.y.upper, roomAbove * station.caliber);
  }
  return frame;
}

Picture::Pointer
DrawDistensionChart(const CurveSet &                  centerline,
                    const std::vector<ColonSegment> & segments,
                    const DistensionChartOptions &    options)
{
  const PlotFrame frame = DistensionFrame(centerline, options);
  Stations        stations = StationsOf(centerline);
  std::stable_sort(stations.begin(), stations.end(), [](const CenterlineStation & a, const CenterlineStation & b) {
    return a.distance < b.distance;
  });
  const bool hasGaps =
    std::any_of(stations.begin(), stations.end(), [](const CenterlineStation & s) { return s.isGap; });
  auto picture = NewPicture(options.width, options.height, PaperColor);
  DrawPlotFrame(picture, frame);
  DrawAreas(picture, frame, stations);
  DrawLimit(picture, frame);
  DrawCurve(picture, frame, stations);
  DrawSegments(picture, frame, segments);
  DrawKey(picture, frame, options, hasGaps);
  return picture;
}
} // namespace shapeton
