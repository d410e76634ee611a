#include "shapetonFlatPageRow.h"

#include "shapetonCsvTable.h"
#include "shapetonPageColors.h"
#include "shapetonPi.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
const RGBColor hatchLight = MakeColor(214, 216, 222);
const RGBColor hatchDark = MakeColor(130, 134, 146);
const RGBColor ringColor = MakeColor(255, 222, 40);
const RGBColor markColor = MakeColor(60, 220, 255);

constexpr int nameSize = 15; ///< font height of names of segments, polyps and marks

TextStyle
StyleOf(int size, const RGBColor & color, HorizontalAnchor horizontal, VerticalAnchor vertical)
{
  return { size, color, false, horizontal, vertical };
}

/** A ring of short lines, with a dark outline for contrast on any background. */
void
DrawRing(Picture * picture, double x, double y, double radius, const RGBColor & color)
{
  const int parts = std::max(24, static_cast<int>(radius));
  for (const auto & [thickness, shade] : { std::pair<double, RGBColor>(4.0, InkColor), { 2.0, color } })
  {
    for (int i = 0; i < parts; ++i)
    {
      const double from = 2.0 * Pi * i / parts;
      const double to = 2.0 * Pi * (i + 1) / parts;
      DrawLine(picture,
               x + radius * std::cos(from),
               y + radius * std::sin(from),
               x + radius * std::cos(to),
               y + radius * std::sin(to),
               shade,
               thickness);
    }
  }
}

void
DrawCross(Picture * picture, double x, double y, double radius, const RGBColor & color)
{
  for (const auto & [thickness, shade] : { std::pair<double, RGBColor>(4.0, InkColor), { 2.0, color } })
  {
    DrawLine(picture, x - radius, y - radius, x + radius, y + radius, shade, thickness);
    DrawLine(picture, x - radius, y + radius, x + radius, y - radius, shade, thickness);
  }
}

/** Draws a polyp or mark at this position, with the name at its right, or at its left where it does not fit. */
void
DrawSpot(Picture * picture, const FlatPageRow & place, const PlacedAnnotation & placed, double x, double y)
{
  const bool   isPolyp = placed.annotation.kind == FlatAnnotation::Kind::Polyp;
  const auto & color = isPolyp ? ringColor : markColor;
  const double radius = isPolyp ? std::max(9.0, 0.5 * placed.diameter + 4.0) : 5.0;
  if (isPolyp)
  {
    DrawRing(picture, x, y, radius, color);
  }
  else
  {
    DrawCross(picture, x, y, radius, color);
  }
  TextStyle    style = StyleOf(nameSize, color, HorizontalAnchor::Left, VerticalAnchor::Center);
  const double offset = radius + 4.0;
  const int    width = MeasureText(placed.annotation.text, style).width;
  const bool   hasRoom = x + offset + width < place.left + place.Width();
  style.horizontal = hasRoom ? HorizontalAnchor::Left : HorizontalAnchor::Right;
  const int textX = static_cast<int>(std::lround(hasRoom ? x + offset : x - offset));
  DrawRimmedText(picture, placed.annotation.text, textX, static_cast<int>(std::lround(y)), style, InkColor);
}

/** Draws two slanted lines across the strip, which mark an omission. */
void
DrawBreak(Picture * picture, const FlatPageRow & place, int x)
{
  constexpr int halfWidth = 4;
  constexpr int slant = 6;
  const int     top = place.StripTop() - 3;
  const int     bottom = place.StripTop() + place.StripHeight() + 3;
  for (int y = top; y < bottom; ++y)
  {
    const int middle = x + static_cast<int>(std::lround(slant * (0.5 - static_cast<double>(y - top) / (bottom - top))));
    FillRectangle(picture, middle - halfWidth, y, 2 * halfWidth + 1, 1, PaperColor);
    FillRectangle(picture, middle - halfWidth, y, 1, 1, InkColor);
    FillRectangle(picture, middle + halfWidth, y, 1, 1, InkColor);
  }
}

/** Label spacing in cm: 1, 2 or 5 times a power of ten, at least `least` pixels. */
double
LabelStep(double pixelsPerCm, double least)
{
  constexpr double fromTwoToFive = 2.5;
  double           step = 1.0;
  for (int i = 0; step * pixelsPerCm < least && i < 12; ++i)
  {
    step *= i % 3 == 1 ? fromTwoToFive : 2.0; // 1, 2, 5, 10, ...
  }
  return step;
}

/** Length along the ruler in mm, excluding omitted sections. */
double
LengthShown(const FlatColonRow & row, const std::vector<double> & distanceOfColumns)
{
  double length = distanceOfColumns[row.firstColumn + row.columns - 1] - distanceOfColumns[row.firstColumn];
  for (const FlatColonCut & cut : row.cuts)
  {
    length -= distanceOfColumns[cut.firstColumn + cut.columns - 1] - distanceOfColumns[cut.firstColumn];
  }
  return length;
}

/** The segment that continues from the previous row, unless the next segment's label is at the same position. */
const PlacedAnnotation *
SegmentGoingOn(const FlatPageRow & place, const std::vector<PlacedAnnotation> & annotations, const TextStyle & style)
{
  const PlacedAnnotation * goingOn = nullptr;
  double                   next = place.left + place.Width();
  for (const PlacedAnnotation & placed : annotations)
  {
    const bool isSegment = placed.annotation.kind == FlatAnnotation::Kind::Segment;
    if (isSegment && placed.column < place.row.firstColumn)
    {
      goingOn = &placed;
    }
    else if (isSegment && place.row.Shows(placed.column))
    {
      next = std::min(next, place.XOf(placed.column));
    }
  }
  const bool hasRoom = goingOn && place.left + MeasureText(goingOn->annotation.text, style).width + 4 < next;
  return hasRoom ? goingOn : nullptr;
}
} // namespace

void
DrawStripOfRow(Picture * picture, const FlatPageRow & place, const Picture * strip, const FlatColonGrid & grid)
{
  constexpr int    hatchPeriod = 8;
  constexpr double pale = 0.5;
  constexpr double madeUp = 0.85;         // not part of the wall
  constexpr double opacityOfBorder = 0.6; // of the overlap
  const int        stripWidth = grid.Columns();
  const RGBColor * source = strip->GetBufferPointer();
  for (int x = 0; x < place.Width(); ++x)
  {
    const int column = place.row.ColumnAt(x);
    for (int y = 0; y < place.StripHeight(); ++y)
    {
      const int  row = ((y - place.overlap) % place.turn + place.turn) % place.turn;
      const bool isBeyond = y < place.overlap || y >= place.overlap + place.turn;
      RGBColor   color = source[static_cast<std::size_t>(row) * stripWidth + column];
      if (grid.IsBridged(column, row))
      {
        color = (x + y) % hatchPeriod == 0 ? hatchDark : MixColors(color, hatchLight, madeUp);
      }
      color = isBeyond ? MixColors(color, PaperColor, pale) : color;
      picture->SetPixel({ { place.left + x, place.StripTop() + y } }, color);
    }
  }
  for (const int y : { place.overlap, place.overlap + place.turn })
  {
    if (place.overlap > 0)
    {
      FillRectangle(picture, place.left, place.StripTop() + y, place.Width(), 1, InkColor, opacityOfBorder);
    }
  }
  DrawRectangle(
    picture, place.left - 1, place.StripTop() - 1, place.Width() + 2, place.StripHeight() + 2, FaintInkColor);
  for (const FlatColonCut & cut : place.row.cuts)
  {
    DrawBreak(picture, place, static_cast<int>(std::lround(place.XOf(cut.firstColumn))));
  }
}

void
DrawRulerOfRow(Picture * picture, const FlatPageRow & place, const std::vector<double> & distanceOfColumns, bool isArc)
{
  constexpr double millimetersPerCm = 10.0;
  constexpr int    roomAtTheRight = 18;
  constexpr int    leastDistance = 3; // between ticks
  constexpr int    longTick = 11;
  constexpr int    shortTick = 6;
  constexpr int    distanceOfUnit = 5; // from the first label
  constexpr int    topOfSecondLine = 12;
  const int        top = place.StripTop() + place.StripHeight() + 3;
  const double     length = LengthShown(place.row, distanceOfColumns);
  const double     pixelsPerCm = length > 0.0 ? place.Width() / length * millimetersPerCm : place.Width();
  const double     labelStep = LabelStep(pixelsPerCm, 58.0);
  const double     tickStep = LabelStep(pixelsPerCm, 4.0);
  FillRectangle(picture, place.left, top, place.Width(), 1, InkColor);
  const TextStyle style = StyleOf(14, InkColor, HorizontalAnchor::Center, VerticalAnchor::Top);
  int             lastTick = place.left - leastDistance;
  int             labelEnd = place.left - distanceOfUnit;
  for (const FlatColonTick & tick : RulerTicks(distanceOfColumns, millimetersPerCm * tickStep))
  {
    if (!place.row.Shows(tick.column))
    {
      continue;
    }
    const int    x = static_cast<int>(std::lround(place.XOf(tick.column)));
    const double cm = tick.distance / millimetersPerCm;
    const double labels = cm / labelStep;
    const bool   isLabel = std::abs(labels - std::round(labels)) < 1e-6 && x >= labelEnd;
    if (x - lastTick >= leastDistance || isLabel)
    {
      FillRectangle(picture, x, top, 1, isLabel ? longTick : shortTick, InkColor);
      lastTick = x;
    }
    const std::string text = CsvTable::Rounded(cm, 6) + " cm";
    const int         width = MeasureText(text, style).width;
    if (isLabel && x - width / 2 > labelEnd && x + width / 2 < place.left + place.Width() + roomAtTheRight)
    {
      DrawText(picture, text, x, top + 13, style);
      labelEnd = x + width / 2 + 6;
    }
  }
  const TextStyle unit = StyleOf(12, FaintInkColor, HorizontalAnchor::Right, VerticalAnchor::Top);
  DrawText(picture, isArc ? "from" : "along", place.left - 8, top - 2, unit);
  DrawText(picture, isArc ? "anus" : "map", place.left - 8, top + topOfSecondLine, unit);
}

void
DrawScaleOfRow(Picture * picture, const FlatPageRow & place, double pixelSize)
{
  constexpr int      barLength = 110;
  const FlatColonRow row = place.row;
  const auto         rounded = [](double scale) { return CsvTable::Rounded(scale, 2); };
  const std::string text = "1 mm of the map: " + rounded(row.scale) + " mm of wall (" + rounded(row.lowScale) + " to " +
                           rounded(row.highScale) + ")";
  const TextStyle style = StyleOf(12, FaintInkColor, HorizontalAnchor::Right, VerticalAnchor::Bottom);
  const int       right = place.left + place.Width();
  const int       bottom = place.StripTop() - 24;
  const int       barLeft = right - MeasureText(text, style).width - 14 - barLength;
  const bool      hasRoom = barLeft >= place.left;
  if (hasRoom)
  {
    DrawText(picture, text, right, bottom + 2, style);
  }
  DrawScaleBar(picture, hasRoom ? barLeft : place.left, bottom, barLength, row.scale * pixelSize, InkColor);
}

void
DrawAnnotationsOfRow(Picture * picture, const FlatPageRow & place, const std::vector<PlacedAnnotation> & annotations)
{
  constexpr int            heightOfName = 20;
  constexpr double         thickness = 1.5, opacity = 0.8; // of borders of segments
  const TextStyle          nameStyle = StyleOf(nameSize, InkColor, HorizontalAnchor::Left, VerticalAnchor::Bottom);
  const PlacedAnnotation * goingOn = SegmentGoingOn(place, annotations, nameStyle);
  int                      textEnd = place.left - 1;
  const int                pageEnd = static_cast<int>(picture->GetLargestPossibleRegion().GetSize()[0]) - 3;
  const auto               drawName = [&](const std::string & name, int at) {
    const int width = MeasureText(name, nameStyle).width;
    const int x = std::min(at, pageEnd - width);
    if (x > textEnd)
    {
      DrawText(picture, name, x, place.StripTop() - 4, nameStyle);
      textEnd = x + width + 8;
    }
  };
  for (const PlacedAnnotation & placed : annotations)
  {
    const bool isSegment = placed.annotation.kind == FlatAnnotation::Kind::Segment;
    if (&placed == goingOn)
    {
      drawName(placed.annotation.text, place.left);
    }
    if (!place.row.Shows(placed.column))
    {
      continue;
    }
    const double x = place.XOf(placed.column);
    if (isSegment)
    {
      const int top = place.StripTop() - heightOfName;
      DrawLine(picture, x, top, x, place.StripTop() + place.StripHeight(), InkColor, thickness, opacity);
      drawName(placed.annotation.text, static_cast<int>(x) + 6);
      continue;
    }
    for (const int turns : { -1, 0, 1 }) // repeat in the overlap
    {
      const double y = placed.row + turns * place.turn + place.overlap;
      if (y >= 0.0 && y < place.StripHeight())
      {
        DrawSpot(picture, place, placed, x, place.StripTop() + y);
      }
    }
  }
}
} // namespace shapeton
