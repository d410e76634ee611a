#include "itkCentrelineMatch.h"

#include "itkCentrelineShape.h"
#include "itkFlatColonAxis.h"
#include "itkToolError.h"

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
/** Medians of right matches are a few mm, of others several cm. */
constexpr double greatestDistance = 15.0; // mm
constexpr double pixelSize = 2.0;         // mm: the middle of the tube needs no more

double
Median(std::vector<double> values)
{
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

/** The median distance of the columns' middles from the places of the line that are assigned to them, mm. */
double
MedianDistance(const FlatColonAxis & axis, const CentrelineMatch & match)
{
  std::vector<double> distances;
  for (std::size_t column = 0; column < match.arcLengthOfColumn.size(); ++column)
  {
    const double * begin = match.arcLength.data();
    const double * end = begin + match.arcLength.size();
    const auto     i = std::min<Eigen::Index>(std::lower_bound(begin, end, match.arcLengthOfColumn[column]) - begin,
                                          match.arcLength.size() - 1);
    distances.push_back((axis.centres.row(column) - match.points.row(i)).norm());
  }
  return Median(distances);
}

/** The median distance of the line's points from the nearest middle of a column, mm. */
double
MedianDistanceOfLine(const FlatColonAxis & axis, const VertexMatrix & points)
{
  std::vector<double> distances;
  for (Eigen::Index i = 0; i < points.rows(); i += 5)
  {
    distances.push_back(std::sqrt((axis.centres.rowwise() - points.row(i)).rowwise().squaredNorm().minCoeff()));
  }
  return Median(distances);
}

CurveSet
Reversed(const CentrelineMatch & match)
{
  CurveSet           line;
  const Eigen::Index size = match.arcLength.size();
  line.V = match.points.colwise().reverse();
  SurfaceArray arc{ "arcLength", SurfaceArray::ValueMatrix(size, 1), false };
  line.curves.emplace_back();
  for (Eigen::Index i = 0; i < size; ++i)
  {
    line.curves[0].push_back(static_cast<int>(i));
    arc.values(i, 0) = match.arcLength[size - 1] - match.arcLength[size - 1 - i];
  }
  line.pointArrays.push_back(arc);
  return line;
}

CentrelineMatch
Assign(const FlatColonGrid & grid, const FlatColonAxis & axis, const CurveSet & centreline)
{
  CentrelineMatch match;
  OrderedCentreline(centreline, match.points, match.arcLength);
  match.arcLengthOfColumn = DistanceOfColumns(axis, centreline);
  match.columnWidth = grid.PixelSize();
  return match;
}

/** Only called where the assignment is bad. */
void
ExplainMismatch(const FlatColonGrid & grid, const FlatColonAxis & axis, double distance, CentrelineMatch & match)
{
  if (MedianDistance(axis, Assign(grid, axis, Reversed(match))) <= greatestDistance)
  {
    throw InputError("the centreline runs from the caecum to the rectum of the flat surface. Turn its points round, or "
                     "flatten the surface with this centreline.");
  }
  const double lengthOfLine = match.arcLength[match.arcLength.size() - 1] - match.arcLength[0];
  double       lengthOfAxis = 0.0;
  for (Eigen::Index i = 1; i < axis.centres.rows(); ++i)
  {
    lengthOfAxis += (axis.centres.row(i) - axis.centres.row(i - 1)).norm();
  }
  const double near = MedianDistanceOfLine(axis, match.points);
  if (lengthOfLine > 0.6 * lengthOfAxis || near > 0.7 * greatestDistance)
  {
    throw InputError("the centreline lies " + std::to_string(static_cast<int>(std::lround(distance))) +
                     " mm from the middle of the flat surface: they belong to different colons or positions. Give the "
                     "centreline that was made with this surface.");
  }
  match.warnings.push_back("the centreline covers a part of the flat surface only: places beyond its ends have no "
                           "distance along it");
}
} // namespace

CentrelineMatch
MatchCentreline(const SurfaceMesh & flat, const CurveSet & centreline)
{
  FlatColonGridOptions options;
  options.pixelSize = pixelSize;
  const FlatColonGrid grid(flat, options);
  const FlatColonAxis axis = MakeFlatColonAxis(grid);
  CentrelineMatch     match = Assign(grid, axis, centreline);
  const double        distance = MedianDistance(axis, match);
  if (distance > greatestDistance)
  {
    ExplainMismatch(grid, axis, distance, match);
  }
  return match;
}
} // namespace itk
