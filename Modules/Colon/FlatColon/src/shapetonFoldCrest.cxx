#include "shapetonFoldCrest.h"

#include "shapetonPrincipalAxes.h"
#include "shapetonQuantiles.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
using Eigen::Vector2d;

/** Fraction of the plateau curvature at the end of a fold. */
constexpr double endShare = 0.2;
/** Minimum fraction of the plateau curvature at the start of a trace, well within the fold. */
constexpr double coreShare = 0.6;
/** Rise after a drop that indicates another fold, as a fraction of the plateau curvature. */
constexpr double riseShare = 0.1;
constexpr double stepLength = 0.5;     ///< mm of the map
constexpr double farthest = 20.0;      ///< mm of the map from the start of a trace
constexpr double sideways = 0.3;       ///< of a step
constexpr double memoryOfCourse = 0.9; ///< weight of the previous direction

/** First row of the fold: the row after the widest gap or, if the fold is a ring, the row with the fewest pixels. */
int
FirstRow(const FoldPixels & pixels, int rows)
{
  std::vector<int> counts(rows, 0);
  for (const FlatPixel & pixel : pixels)
  {
    ++counts[pixel.row];
  }
  int first = 0;
  int widest = 0;
  int gap = 0;
  for (int i = 0; i < 2 * rows; ++i)
  {
    const int row = i % rows;
    if (counts[row] == 0)
    {
      ++gap;
    }
    else
    {
      first = gap > widest ? row : first;
      widest = std::max(gap, widest);
      gap = 0;
    }
  }
  return widest > 0 ? first : static_cast<int>(std::min_element(counts.begin(), counts.end()) - counts.begin());
}

class CrestTracer
{
public:
  CrestTracer(const FoldPicture & picture, double floor) : m_Picture(picture), m_Floor(floor) {}

  FoldCrest
  Trace(const FoldPlaces & places, const FoldEllipse & ellipse)
  {
    m_OwnPart =
      m_Picture
        .part[m_Picture.Index(static_cast<int>(places.front().x()), this->Wrap(static_cast<int>(places.front().y())))];
    const FoldPlaces ridge = this->Ridge(places, ellipse);
    FoldCrest        crest;
    crest.plateau = this->PlateauOf(ridge);
    const auto [first, last] = this->Core(ridge, crest.plateau);
    FoldPlaces before = this->Follow(ridge, first, -1, crest.plateau);
    std::reverse(before.begin(), before.end());
    crest.places = std::move(before);
    crest.places.insert(crest.places.end(), ridge.begin() + first, ridge.begin() + last + 1);
    const FoldPlaces after = this->Follow(ridge, last, 1, crest.plateau);
    crest.places.insert(crest.places.end(), after.begin(), after.end());
    return crest;
  }

private:
  double
  ValueAt(const Vector2d & place) const
  {
    const double x = std::clamp(place.x(), 0.0, m_Picture.columns - 1.0);
    const int    column = std::min(static_cast<int>(x), std::max(0, m_Picture.columns - 2));
    const int    next = std::min(column + 1, m_Picture.columns - 1);
    const double row = std::floor(place.y());
    const int    y = this->Wrap(static_cast<int>(row));
    const int    below = this->Wrap(y + 1);
    const double fx = x - column;
    const double fy = place.y() - row;
    const auto   at = [&](int c, int r) { return static_cast<double>(m_Picture.curvature[m_Picture.Index(c, r)]); };
    return (1.0 - fy) * ((1.0 - fx) * at(column, y) + fx * at(next, y)) +
           fy * ((1.0 - fx) * at(column, below) + fx * at(next, below));
  }

  /** Whether a pixel is wall and not part of another fold. */
  bool
  IsFree(const Vector2d & place) const
  {
    const int column = static_cast<int>(std::lround(place.x()));
    if (column < 0 || column >= m_Picture.columns)
    {
      return false;
    }
    const std::size_t pixel = m_Picture.Index(column, this->Wrap(static_cast<int>(std::lround(place.y()))));
    return m_Picture.isWall[pixel] && (m_Picture.part[pixel] == 0 || m_Picture.part[pixel] == m_OwnPart);
  }

  int
  Wrap(int row) const
  {
    const int rest = row % m_Picture.rows;
    return rest < 0 ? rest + m_Picture.rows : rest;
  }

  /** Mean position for each millimeter along the ellipse, weighted by squared curvature. */
  FoldPlaces
  Ridge(const FoldPlaces & places, const FoldEllipse & ellipse) const
  {
    const double binsPerPixel = std::min(1.0, m_Picture.pixelSize);
    double       least = 0.0;
    double       most = 0.0;
    for (const Vector2d & place : places)
    {
      const double along = (place - ellipse.center).dot(ellipse.axis);
      least = std::min(least, along);
      most = std::max(most, along);
    }
    const int           bins = 1 + static_cast<int>((most - least) * binsPerPixel);
    FoldPlaces          sums(bins, Vector2d::Zero());
    std::vector<double> weights(bins, 0.0);
    for (const Vector2d & place : places)
    {
      const double along = (place - ellipse.center).dot(ellipse.axis);
      const int    bin = std::min(bins - 1, static_cast<int>((along - least) * binsPerPixel));
      const double value = this->ValueAt(place);
      sums[bin] += value * value * place;
      weights[bin] += value * value;
    }
    FoldPlaces ridge;
    for (int bin = 0; bin < bins; ++bin)
    {
      if (weights[bin] > 0.0)
      {
        ridge.push_back(sums[bin] / weights[bin]);
      }
    }
    return ridge;
  }

  double
  PlateauOf(const FoldPlaces & ridge) const
  {
    std::vector<double> values;
    for (const Vector2d & place : ridge)
    {
      values.push_back(this->ValueAt(place));
    }
    constexpr double slightlyAboveMedian = 0.6;
    return LowerQuantile(std::move(values), slightlyAboveMedian);
  }

  /** Indices of the first and last positions on the plateau. */
  std::pair<int, int>
  Core(const FoldPlaces & ridge, double plateau) const
  {
    int first = -1;
    int last = -1;
    for (int i = 0; i < static_cast<int>(ridge.size()); ++i)
    {
      if (this->ValueAt(ridge[i]) >= coreShare * plateau)
      {
        first = first < 0 ? i : first;
        last = i;
      }
    }
    return { std::max(first, 0), std::max(last, 0) };
  }

  /** Traces outward from a point of the ridge. */
  FoldPlaces
  Follow(const FoldPlaces & ridge, int start, int side, double plateau) const
  {
    const int  back = std::clamp(start - 6 * side, 0, static_cast<int>(ridge.size()) - 1);
    FoldPlaces path;
    if (back == start)
    {
      return path;
    }
    const double step = stepLength / m_Picture.pixelSize;
    const double level = std::max(endShare * plateau, m_Floor);
    Vector2d     course = (ridge[start] - ridge[back]).normalized();
    Vector2d     place = ridge[start];
    double       lowest = this->ValueAt(place);
    std::size_t  atLowest = 0;
    for (double way = 0.0; way < farthest; way += stepLength)
    {
      place = this->Step(place, course, step);
      const double value = this->ValueAt(place);
      if (!this->IsFree(place) || value < level)
      {
        break;
      }
      path.push_back(place);
      if (value < lowest)
      {
        lowest = value;
        atLowest = path.size();
      }
      if (value > lowest + riseShare * plateau && lowest < coreShare * plateau)
      {
        path.resize(atLowest);
        break;
      }
    }
    return path;
  }

  /** Steps forward, deviating slightly toward higher curvature. */
  Vector2d
  Step(const Vector2d & place, Vector2d & course, double step) const
  {
    const Vector2d side(-course.y(), course.x());
    const Vector2d ahead = place + step * course;
    Vector2d       best = ahead;
    double         most = this->ValueAt(ahead);
    for (const double shift : { -1.0, -0.5, 0.5, 1.0 })
    {
      const Vector2d candidate = ahead + shift * sideways * step * side;
      const double   value = this->ValueAt(candidate);
      if (value > most)
      {
        most = value;
        best = candidate;
      }
    }
    course = (memoryOfCourse * course + (1.0 - memoryOfCourse) * (best - place).normalized()).normalized();
    return best;
  }

  const FoldPicture & m_Picture;
  double              m_Floor;
  int                 m_OwnPart{ 0 };
};
} // namespace

FoldPlaces
UnrollFold(const FoldPixels & pixels, int rows)
{
  const int  first = FirstRow(pixels, rows);
  FoldPlaces places;
  places.reserve(pixels.size());
  for (const FlatPixel & pixel : pixels)
  {
    places.emplace_back(pixel.column, pixel.row < first ? pixel.row + rows : pixel.row);
  }
  return places;
}

FoldEllipse::FoldEllipse(const FoldPlaces & places) : center(Vector2d::Zero())
{
  const auto number = static_cast<double>(places.size());
  for (const Vector2d & place : places)
  {
    center += place / number;
  }
  constexpr double pixelsPerVariance = 12.0; // of a pixel: a uniform distribution of width 1
  Eigen::Matrix2d  covariance = Eigen::Matrix2d::Identity() / pixelsPerVariance;
  for (const Vector2d & place : places)
  {
    covariance += (place - center) * (place - center).transpose() / number;
  }
  const PrincipalAxes axes(covariance);
  axis = axes.vectors.col(1);
  axis = axis.y() < 0.0 || (axis.y() == 0.0 && axis.x() < 0.0) ? Vector2d(-axis) : axis;
  elongation = std::sqrt(axes.values[1] / axes.values[0]);
  longHalf = 2.0 * std::sqrt(axes.values[1]);
}

double
MillimetersOfPixel(const FoldPicture & picture, const Vector2d & place)
{
  const int column = std::clamp(static_cast<int>(std::lround(place.x())), 0, picture.columns - 1);
  const int row = static_cast<int>(std::lround(place.y())) % picture.rows;
  return picture.pixelSize * picture.scale[picture.Index(column, row < 0 ? row + picture.rows : row)];
}

double
FoldCrest::Length(const FoldPicture & picture) const
{
  double length = 0.0;
  for (std::size_t i = 1; i < places.size(); ++i)
  {
    length += (places[i] - places[i - 1]).norm() * MillimetersOfPixel(picture, 0.5 * (places[i] + places[i - 1]));
  }
  return length;
}

Vector2d
FoldCrest::Middle(const FoldPicture & picture) const
{
  double rest = 0.5 * this->Length(picture);
  for (std::size_t i = 1; i < places.size(); ++i)
  {
    rest -= (places[i] - places[i - 1]).norm() * MillimetersOfPixel(picture, 0.5 * (places[i] + places[i - 1]));
    if (rest <= 0.0)
    {
      return places[i];
    }
  }
  return places.front();
}

FoldCrest
CrestOfEllipse(const FoldPicture & picture, const FoldPlaces & places, const FoldEllipse & ellipse)
{
  const int pieces = std::max(2, static_cast<int>(std::lround(2.0 * ellipse.longHalf)));
  FoldCrest crest;
  for (int i = 0; i <= pieces; ++i)
  {
    Vector2d place = ellipse.center + (2.0 * i / pieces - 1.0) * ellipse.longHalf * ellipse.axis;
    place.x() = std::clamp(place.x(), 0.0, picture.columns - 1.0);
    crest.places.push_back(place);
  }
  for (const Vector2d & place : places)
  {
    const auto row = static_cast<int>(place.y()) % picture.rows;
    crest.plateau +=
      picture.curvature[picture.Index(static_cast<int>(place.x()), row)] / static_cast<double>(places.size());
  }
  return crest;
}

FoldCrest
TraceCrest(const FoldPicture & picture, const FoldPlaces & places, const FoldEllipse & ellipse, double floor)
{
  return CrestTracer(picture, floor).Trace(places, ellipse);
}

FoldPixels
PixelsAlongCrest(const FoldPicture & picture, const FoldCrest & crest)
{
  constexpr double       reach = 2.0; // mm on the surface; chosen
  std::vector<FlatPixel> pixels;
  for (const Vector2d & place : crest.places)
  {
    const int    column = static_cast<int>(std::lround(place.x()));
    const int    row = static_cast<int>(std::lround(place.y()));
    const double radius = reach / std::max(1e-3, MillimetersOfPixel(picture, place));
    const int    steps = std::min(64, static_cast<int>(radius));
    const auto   wrap = [&](int y) { return (y % picture.rows + picture.rows) % picture.rows; };
    const float  level = 0.5F * picture.curvature[picture.Index(std::clamp(column, 0, picture.columns - 1), wrap(row))];
    for (int y = row - steps; y <= row + steps; ++y)
    {
      for (int x = std::max(0, column - steps); x <= std::min(picture.columns - 1, column + steps); ++x)
      {
        const bool isNear = (Vector2d(x, y) - place).norm() <= radius;
        if (isNear && picture.curvature[picture.Index(x, wrap(y))] >= level &&
            picture.isWall[picture.Index(x, wrap(y))])
        {
          pixels.push_back({ x, wrap(y) });
        }
      }
    }
  }
  return pixels;
}
} // namespace shapeton
