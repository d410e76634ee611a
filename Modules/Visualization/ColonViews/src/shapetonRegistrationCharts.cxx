#include "shapetonAlignedColons.h"
#include "shapetonFlatColonLocator.h"
#include "shapetonPageColors.h"
#include "shapetonPlotFrame.h"
#include "shapetonRegistrationPictures.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace shapeton
{
namespace
{
const RGBColor shade = MakeColor(206, 208, 214);
const RGBColor blue = MakeColor(22, 74, 116);
const RGBColor paleBlue = MakeColor(120, 170, 210);
const RGBColor colorOfLimit = MakeColor(196, 44, 44);

/** Size of a chart, pixels. */
constexpr int width = 1000;
constexpr int height = 380;

/** An empty chart along the supine colon, with the names of its segments. */
struct Chart
{
  Chart(const RegistrationParts & parts, const std::vector<double> & distances, const PlotAxis & y, double limit)
    : picture(NewPicture(width, height, PaperColor))
  {
    constexpr int left = 84, top = 60, right = 30, bottom = 62; // pixels around the plot
    frame.left = left;
    frame.top = top;
    frame.width = width - frame.left - right;
    frame.height = height - frame.top - bottom;
    frame.x = { "distance along the supine centerline from the anal verge (cm)",
                distances.front(),
                std::max(distances.back(), distances.front() + 1.0),
                MillimetersAsCentimeters };
    frame.y = y;
    DrawPlotFrame(picture, frame);
    const int line = static_cast<int>(std::lround(frame.PixelOfY(limit)));
    for (int x = 0; x < frame.width; x += 16)
    {
      FillRectangle(picture, frame.left + x, line, std::min(8, frame.width - x), 2, colorOfLimit);
    }
    this->NameSegments(parts.supine->segments);
  }

  void
  NameSegments(const std::vector<ColonSegmentExtent> & segments)
  {
    constexpr int nameSize = 14;
    constexpr int lineHeight = 18;
    TextStyle     style{ nameSize, InkColor, false, HorizontalAnchor::Left, VerticalAnchor::Bottom };
    int           ends[2] = { frame.left - 8, frame.left - 8 };
    for (const ColonSegmentExtent & segment : segments)
    {
      const int x = static_cast<int>(std::lround(frame.PixelOfX(std::max(segment.begin, frame.x.lower))));
      FillRectangle(picture, x, frame.top - 8, 1, frame.height + 8, FaintInkColor);
      const int textWidth = MeasureText(segment.name, style).width;
      const int start = std::min(x + 4, width - 4 - textWidth);
      const int line = start > ends[0] + 8 ? 0 : 1;
      ends[line] = start + textWidth;
      DrawText(picture, segment.name, start, frame.top - 8 - lineHeight * line, style);
    }
  }

  Picture::Pointer picture;
  PlotFrame        frame;
};

/** Confidence around the tube in a column. */
struct ColumnConfidence
{
  double mean{ 0.0 };
  double least{ 1.0 };
  bool   isExcluded{ true };
};

ColumnConfidence
ConfidenceOf(const MapOfSurface & map, const FlatColonGrid & grid, int column)
{
  ColumnConfidence confidence;
  int              number = 0;
  for (int row = 0; row < grid.Rows(); ++row)
  {
    const MapOfSurface::Place place = map.AtPixel(column, row);
    if (!place.isExcluded)
    {
      confidence.mean += place.confidence;
      confidence.least = std::min(confidence.least, place.confidence);
      ++number;
    }
  }
  confidence.mean /= std::max(1, number);
  confidence.isExcluded = 2 * number < grid.Rows();
  return confidence;
}
} // namespace

Picture::Pointer
DrawConfidenceChart(const RegistrationParts & parts)
{
  const AlignedColons       colons(parts, 60);
  const FlatColonGrid &     grid = colons.Grid();
  const std::vector<double> distances = colons.Distances();
  const MapOfSurface        map(parts.results->supineToProne, grid, 1.0); // the circumference is not used here
  Chart                     chart(parts, distances, { "confidence", 0.0, 1.0 }, 0.5);
  ColumnConfidence          before;
  for (int column = 0; column < grid.Columns(); ++column)
  {
    const ColumnConfidence at = ConfidenceOf(map, grid, column);
    const double           x = chart.frame.PixelOfX(distances[column]);
    const double           left = column > 0 ? chart.frame.PixelOfX(distances[column - 1]) : x;
    if (at.isExcluded)
    {
      const int from = static_cast<int>(std::lround(left));
      const int pixels = std::max(1, static_cast<int>(std::lround(x)) - from);
      FillRectangle(chart.picture, from, chart.frame.top, pixels, chart.frame.height, shade);
    }
    else if (column > 0 && !before.isExcluded)
    {
      const auto       y = [&](double value) { return chart.frame.PixelOfY(value); };
      constexpr double thicknessOfLeast = 1.2, thicknessOfMean = 2.0;
      DrawLine(chart.picture, left, y(before.least), x, y(at.least), paleBlue, thicknessOfLeast);
      DrawLine(chart.picture, left, y(before.mean), x, y(at.mean), blue, thicknessOfMean);
    }
    before = at;
  }
  return chart.picture;
}

Picture::Pointer
DrawErrorChart(const RegistrationParts & parts)
{
  const RegistrationResults & results = *parts.results;
  if (results.points.empty())
  {
    throw std::invalid_argument("an error chart requires points with known errors");
  }
  const AlignedColons    colons(parts, 60);
  const FlatColonLocator locator(colons.Grid());
  constexpr double       limit = 10.0;     // mm, drawn as a line
  constexpr double       roomAbove = 1.05; // relative to the greatest error
  double                 greatest = 20.0;  // mm
  for (const PointError & error : results.errors)
  {
    greatest = error.kind == PointError::Kind::Counted ? std::max(greatest, roomAbove * error.inSpace) : greatest;
  }
  Chart chart(parts, colons.Distances(), { "error in space (mm)", 0.0, greatest }, limit);
  for (std::size_t i = 0; i < results.points.size(); ++i)
  {
    if (results.errors[i].kind == PointError::Kind::Counted)
    {
      const int    column = locator.Find(results.points[i].source).pixel.column;
      const double x = chart.frame.PixelOfX(colons.Distances()[column]);
      const double y = chart.frame.PixelOfY(results.errors[i].inSpace);
      DrawLine(chart.picture, x, y, x, y, blue, 3.0, 0.5);
    }
  }
  return chart.picture;
}
} // namespace shapeton
