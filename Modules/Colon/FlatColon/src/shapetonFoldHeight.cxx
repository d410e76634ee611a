#include "shapetonFoldHeight.h"

#include "shapetonQuantiles.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace shapeton
{
namespace
{
using Eigen::Vector2d;
using Eigen::Vector3d;

/** Maximum surface distance (mm) from the crest to a foot: the length of the flanks of the highest folds. */
constexpr double farthestFoot = 18.0;

class HeightMeter
{
public:
  HeightMeter(const FlatColonGrid & grid, const FoldPicture & picture) : m_Grid(grid), m_Picture(picture) {}

  /** Height above the wall on both sides of a crest point; negative if a foot is missing. */
  double
  HeightAt(const Vector2d & place, const Vector2d & across) const
  {
    std::vector<Vector3d> section;
    if (!this->AddFlank(place, -across, section))
    {
      return -1.0;
    }
    std::reverse(section.begin(), section.end());
    if (!this->AddFlank(place, across, section))
    {
      return -1.0;
    }
    const Vector3d foot = section.front();
    const Vector3d way = section.back() - foot;
    if (!(way.norm() > 0.0))
    {
      return -1.0;
    }
    double height = 0.0;
    for (const Vector3d & point : section)
    {
      height = std::max(height, (point - foot).cross(way).norm() / way.norm());
    }
    return height;
  }

private:
  std::size_t
  IndexAt(const Vector2d & place) const
  {
    const int row = static_cast<int>(std::lround(place.y())) % m_Picture.rows;
    return m_Picture.Index(static_cast<int>(std::lround(place.x())), row < 0 ? row + m_Picture.rows : row);
  }

  /** Collects points from the crest to the foot; returns false if the map or the wall ends before the foot is
   * reached. */
  bool
  AddFlank(const Vector2d & start, const Vector2d & course, std::vector<Vector3d> & points) const
  {
    std::vector<Vector3d> flank;
    std::size_t           foot = 0;
    double                least = 0.0;
    double                way = 0.0;
    for (Vector2d place = start; way < farthestFoot; place += course)
    {
      const auto column = static_cast<int>(std::lround(place.x()));
      if (column < 0 || column >= m_Picture.columns || !m_Picture.isWall[this->IndexAt(place)])
      {
        break;
      }
      const double curvature = m_Picture.sign * m_Picture.curvature[this->IndexAt(place)];
      flank.push_back(m_Grid.PointOfPixel(column, static_cast<int>(std::lround(place.y()))));
      if (curvature < least)
      {
        least = curvature;
        foot = flank.size();
      }
      else if (foot > 0 && curvature > 0.5 * least)
      {
        break; // beyond the foot
      }
      way += MillimetersOfPixel(m_Picture, place);
    }
    points.insert(points.end(), flank.begin(), flank.begin() + static_cast<std::ptrdiff_t>(foot));
    return foot > 0;
  }

  const FlatColonGrid & m_Grid;
  const FoldPicture &   m_Picture;
};
} // namespace

double
HeightOfFold(const FlatColonGrid & grid, const FoldPicture & picture, const FoldCrest & crest)
{
  constexpr std::size_t reach = 3; // points on either side that define the crest direction
  const HeightMeter     meter(grid, picture);
  std::vector<double>   heights;
  for (std::size_t i = reach; i + reach < crest.places.size(); ++i)
  {
    const Vector2d along = crest.places[i + reach] - crest.places[i - reach];
    if (along.norm() > 0.0)
    {
      const double height = meter.HeightAt(crest.places[i], Vector2d(-along.y(), along.x()).normalized());
      if (height >= 0.0)
      {
        heights.push_back(height);
      }
    }
  }
  if (heights.size() < 3)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  constexpr double nearlyHighest = 0.9;
  return LowerQuantile(std::move(heights), nearlyHighest);
}
} // namespace shapeton
