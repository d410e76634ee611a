#include "shapetonFlatColonPage.h"

#include "shapetonFlatColonLocator.h"
#include "shapetonFlatPageRow.h"
#include "shapetonPageColors.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>
#include <stdexcept>

namespace shapeton
{
namespace
{
/** Layout, pixels. */
constexpr int leftMargin = 52;
constexpr int rightMargin = 20;
constexpr int gapBetweenRows = 10;
constexpr int leastWidth = 480;
constexpr int headMargin = 12;
constexpr int titleLineHeight = 30;
constexpr int noteLineHeight = 20;
constexpr int gapOfLinks = 26; ///< between two strips of a row

/** Column of a distance along the centerline. */
double
ColumnOfDistance(const std::vector<double> & distanceOfColumns, double distance)
{
  const auto after = std::lower_bound(distanceOfColumns.begin(), distanceOfColumns.end(), distance);
  return static_cast<double>(after - distanceOfColumns.begin());
}

class Placing
{
public:
  Placing(const FlatColonGrid & grid, const std::vector<double> & distanceOfColumns)
    : m_Grid(grid), m_DistanceOfColumns(distanceOfColumns)
  {}

  PlacedAnnotation
  Place(const FlatAnnotation & annotation)
  {
    PlacedAnnotation placed;
    placed.annotation = annotation;
    if (annotation.distance && !m_DistanceOfColumns.empty())
    {
      placed.column = ColumnOfDistance(m_DistanceOfColumns, *annotation.distance);
      return placed;
    }
    if (!annotation.uv && !annotation.point)
    {
      throw std::invalid_argument("the annotation '" + annotation.text + "' has no position on the map");
    }
    const FlatPixel pixel = annotation.uv ? m_Grid.PixelOfUv(*annotation.uv) : this->Locate(*annotation.point);
    placed.column = pixel.column + 0.5;
    placed.row = pixel.row + 0.5;
    const FlatSample sample = m_Grid.SampleOfPixel(pixel.column, pixel.row);
    const double     scale = sample.face >= 0 && sample.scale > 0.0 ? sample.scale : 1.0;
    placed.diameter = annotation.diameter / scale / m_Grid.PixelSize();
    return placed;
  }

private:
  FlatPixel
  Locate(const Eigen::Vector3d & point)
  {
    if (!m_Locator)
    {
      m_Locator = std::make_unique<FlatColonLocator>(m_Grid);
    }
    return m_Locator->Find(point).pixel;
  }

  const FlatColonGrid &             m_Grid;
  const std::vector<double> &       m_DistanceOfColumns;
  std::unique_ptr<FlatColonLocator> m_Locator; ///< created on first use
};

std::vector<PlacedAnnotation>
PlaceAll(const FlatColonGrid &               grid,
         const std::vector<double> &         distanceOfColumns,
         const std::vector<FlatAnnotation> & annotations)
{
  Placing                       placing(grid, distanceOfColumns);
  std::vector<PlacedAnnotation> placed;
  for (const FlatAnnotation & annotation : annotations)
  {
    placed.push_back(placing.Place(annotation));
  }
  std::stable_sort(placed.begin(), placed.end(), [](const PlacedAnnotation & a, const PlacedAnnotation & b) {
    return a.column < b.column;
  });
  return placed;
}

std::vector<double>
DistanceAlongMap(const FlatColonGrid & grid)
{
  std::vector<double> distances;
  for (int column = 0; column < grid.Columns(); ++column)
  {
    distances.push_back((column + 0.5) * grid.PixelSize());
  }
  return distances;
}

std::vector<std::string>
LinesOf(const std::string & text)
{
  std::vector<std::string> lines;
  std::istringstream       stream(text);
  for (std::string line; std::getline(stream, line);)
  {
    lines.push_back(line);
  }
  return lines;
}

int
HeadHeight(const FlatColonPageOptions & options)
{
  return headMargin + (options.title.empty() ? 0 : titleLineHeight) +
         noteLineHeight * static_cast<int>(LinesOf(options.note).size());
}

void
DrawHead(Picture * picture, const FlatColonPageOptions & options, int width)
{
  constexpr int titleSize = 21;
  constexpr int noteSize = 14;
  TextStyle     style{ titleSize, InkColor, true };
  int           y = 10;
  if (!options.title.empty())
  {
    DrawText(picture, options.title, leftMargin, y, FitText(options.title, style, width));
    y += titleLineHeight;
  }
  style.size = noteSize;
  style.bold = false;
  style.color = FaintInkColor;
  for (const std::string & line : LinesOf(options.note))
  {
    DrawText(picture, line, leftMargin, y, FitText(line, style, width));
    y += noteLineHeight;
  }
}

void
RequireFit(const Picture * strip, const FlatColonGrid & grid, const std::vector<double> & distances, double overlap)
{
  const auto size = strip->GetLargestPossibleRegion().GetSize();
  if (size[0] != static_cast<itk::SizeValueType>(grid.Columns()) ||
      size[1] != static_cast<itk::SizeValueType>(grid.Rows()))
  {
    throw std::invalid_argument("the strip does not have the size of the grid");
  }
  if (!distances.empty() && distances.size() != size[0])
  {
    throw std::invalid_argument("the number of distances does not match the columns");
  }
  if (!(overlap >= 0.0 && overlap <= 0.5))
  {
    throw std::invalid_argument("the overlap must be from 0 to 0.5");
  }
}

/** \param strips strips of each row, one below the other. */
std::vector<FlatPageRow>
LayOut(const FlatColonGrid & grid, const FlatColonPageOptions & options, int strips)
{
  std::vector<FlatPageRow> places;
  int                      top = HeadHeight(options);
  for (const FlatColonRow & row : BreakIntoRows(grid, options.greatestColumns, options.longestBridge))
  {
    FlatPageRow place{
      row, leftMargin, top, static_cast<int>(std::lround(options.overlap * grid.Rows())), grid.Rows()
    };
    top = place.Bottom() + (strips - 1) * (place.StripHeight() + gapOfLinks) + gapBetweenRows;
    places.push_back(place);
  }
  return places;
}

/** Layout of the second strip of a row. */
FlatPageRow
Lower(FlatPageRow place)
{
  place.top += place.StripHeight() + gapOfLinks;
  return place;
}

/** Content of a page: one strip, or a pair. */
struct PageParts
{
  const FlatColonGrid &               grid;
  const std::vector<double> &         distanceOfColumns;
  const std::vector<FlatAnnotation> & annotations;
  const FlatColonPageOptions &        options;
  const Picture *                     strip{ nullptr };
  const FlatColonPair *               pair{ nullptr };
};

void
DrawNameOfStrip(Picture * picture, const FlatPageRow & place, const std::string & name)
{
  TextStyle style{ 16, InkColor, false, HorizontalAnchor::Right, VerticalAnchor::Center, true };
  DrawText(picture, name, place.left - 8, place.StripTop() + place.StripHeight() / 2, style);
}

void
DrawLinks(Picture * picture, const FlatPageRow & place, const PageParts & parts)
{
  const double top = place.StripTop() + place.StripHeight() + 1.0;
  const double bottom = Lower(place).StripTop() - 2.0;
  for (const FlatColonLink & link : parts.pair->links)
  {
    const double upper = link.upper.x() / parts.grid.PixelSize();
    const double lower = link.lower.x() / parts.grid.PixelSize();
    if (place.row.Shows(upper) && place.row.Shows(lower))
    {
      DrawLine(picture, place.XOf(upper), top, place.XOf(lower), bottom, link.color, 2.0);
    }
  }
}

void
DrawRow(Picture * picture, const FlatPageRow & place, const PageParts & parts, const std::vector<double> & distances)
{
  FlatPageRow last = place;
  if (parts.pair)
  {
    last = Lower(place);
    DrawStripOfRow(picture, place, parts.pair->upper, parts.grid);
    DrawStripOfRow(picture, last, parts.pair->lower, parts.grid);
    DrawNameOfStrip(picture, place, parts.pair->upperName);
    DrawNameOfStrip(picture, last, parts.pair->lowerName);
    DrawLinks(picture, place, parts);
  }
  else
  {
    DrawStripOfRow(picture, place, parts.strip, parts.grid);
  }
  DrawRulerOfRow(picture, last, distances, !parts.distanceOfColumns.empty());
  DrawScaleOfRow(picture, place, parts.grid.PixelSize());
}

Picture::Pointer
DrawPage(const PageParts & parts)
{
  const std::vector<FlatPageRow>      places = LayOut(parts.grid, parts.options, parts.pair ? 2 : 1);
  const std::vector<PlacedAnnotation> placed = PlaceAll(parts.grid, parts.distanceOfColumns, parts.annotations);
  const std::vector<double>           distances =
    parts.distanceOfColumns.empty() ? DistanceAlongMap(parts.grid) : parts.distanceOfColumns;
  int rowWidth = leastWidth;
  for (const FlatPageRow & place : places)
  {
    rowWidth = std::max(rowWidth, place.Width());
  }
  const int bottom = (parts.pair ? Lower(places.back()) : places.back()).Bottom();
  const int barWidth = parts.options.colorBar ? colorBarWidth : 0;
  const int width = leftMargin + rowWidth + rightMargin + barWidth;
  auto      picture = NewPicture(width, bottom + gapBetweenRows, PaperColor);
  DrawHead(picture, parts.options, width - leftMargin - rightMargin);
  for (const FlatPageRow & place : places)
  {
    DrawRow(picture, place, parts, distances);
    DrawAnnotationsOfRow(picture, place, placed);
  }
  if (parts.options.colorBar)
  {
    const int height = std::min(320, bottom - places.front().StripTop() - FlatPageRow::ruler);
    DrawColorBar(picture, width - barWidth, places.front().StripTop(), height, *parts.options.colorBar, InkColor);
  }
  return picture;
}
} // namespace

Picture::Pointer
DrawFlatColonPage(const Picture *                     strip,
                  const FlatColonGrid &               grid,
                  const std::vector<double> &         distanceOfColumns,
                  const std::vector<FlatAnnotation> & annotations,
                  const FlatColonPageOptions &        options)
{
  RequireFit(strip, grid, distanceOfColumns, options.overlap);
  return DrawPage({ grid, distanceOfColumns, annotations, options, strip, nullptr });
}

Picture::Pointer
DrawFlatColonPairPage(const FlatColonPair &               pair,
                      const FlatColonGrid &               grid,
                      const std::vector<double> &         distanceOfColumns,
                      const std::vector<FlatAnnotation> & annotations,
                      const FlatColonPageOptions &        options)
{
  RequireFit(pair.upper, grid, distanceOfColumns, options.overlap);
  RequireFit(pair.lower, grid, distanceOfColumns, options.overlap);
  return DrawPage({ grid, distanceOfColumns, annotations, options, nullptr, &pair });
}
} // namespace shapeton
