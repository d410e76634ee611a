#include "shapetonCenterlineMatch.h"

#include "shapetonCenterlineShape.h"
#include "shapetonExceptions.h"
#include "shapetonFlatSurface.h"
#include "shapetonQuantiles.h"
#include "shapetonSurfaceConnectivity.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
/** Maximum fraction of the wall length along which the centerline may be outside the wall. The fraction is 0 for
 * correct centerlines, and at least 0.24 for centerlines of the same patient in the other position. */
constexpr double greatestShareOutside = 0.1;
/** Lower bound of the wall radius, mm. */
constexpr double leastRadius = 8.0;
constexpr double pixelSize = 2.0; // mm; sufficient for the center of the tube

/** Quality of the fit of a line to the columns assigned to its points. */
struct MatchQuality
{
  /** Fraction of the tube length along which the line is farther from the center than the wall. */
  double shareOutside{ 0.0 };
  /** Median distance, mm. */
  double medianDistance{ 0.0 };
};

MatchQuality
QualityOf(const FlatColonAxis & axis, const CenterlineMatch & match)
{
  std::vector<double> distances;
  double              outside = 0.0;
  double              all = 0.0;
  for (Eigen::Index column = 0; column < axis.centers.rows(); ++column)
  {
    const double * begin = match.arcLength.data();
    const double * end = begin + match.arcLength.size();
    const auto     i = std::min<Eigen::Index>(std::lower_bound(begin, end, match.arcLengthOfColumn[column]) - begin,
                                          match.arcLength.size() - 1);
    const double   length = column > 0 ? (axis.centers.row(column) - axis.centers.row(column - 1)).norm() : 0.0;
    distances.push_back((axis.centers.row(column) - match.points.row(i)).norm());
    all += length;
    outside += distances.back() > std::max(axis.radii[column], leastRadius) ? length : 0.0;
  }
  return { all > 0.0 ? outside / all : 1.0, UpperMedian(distances) };
}

/** Median distance from the points of the line to the nearest column center, mm. */
double
MedianDistanceOfLine(const FlatColonAxis & axis, const VertexMatrix & points)
{
  std::vector<double> distances;
  for (Eigen::Index i = 0; i < points.rows(); i += 5)
  {
    distances.push_back(std::sqrt((axis.centers.rowwise() - points.row(i)).rowwise().squaredNorm().minCoeff()));
  }
  return UpperMedian(distances);
}

CurveSet
Reversed(const CenterlineMatch & match)
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

CenterlineMatch
Assign(const FlatColonGrid & grid, const FlatColonAxis & axis, const CurveSet & centerline)
{
  CenterlineMatch match;
  OrderedCenterline(centerline, match.points, match.arcLength);
  match.arcLengthOfColumn = DistanceOfColumns(axis, centerline);
  match.columnWidth = grid.PixelSize();
  return match;
}

/** Whether the wall had handles before it was cut open. */
bool
HasHandles(const SurfaceMesh & flat)
{
  const std::vector<int> source = FlatSourcePoints(flat, "the flat surface");
  const FaceMatrix       F = flat.F.unaryExpr([&](int i) { return source[i]; });
  return SurfaceConnectivity(F, flat.NumberOfVertices()).Components().front().genus.value_or(0) > 0;
}

std::string
Percent(double share)
{
  return std::to_string(static_cast<int>(std::lround(100.0 * share))) + " %";
}

/** Throws the error that explains a bad assignment. If the map has handles, a column may contain the walls of touching
 * loops, and its center may be outside the colon. In that case, the majority of the columns decides. */
void
ExplainMismatch(const FlatColon &     flat,
                const FlatColonGrid & grid,
                const FlatColonAxis & axis,
                const MatchQuality &  quality,
                CenterlineMatch &     match)
{
  if (quality.medianDistance <= leastRadius && HasHandles(flat.Surface()))
  {
    match.warnings.push_back("large handles compress or fold the flat map along " + Percent(quality.shareOutside) +
                             " of its length: landmarks there are unreliable; use a wall with repaired topology");
    return;
  }
  if (QualityOf(axis, Assign(grid, axis, Reversed(match))).shareOutside <= greatestShareOutside)
  {
    throw InputError("the centerline runs from the cecum to the rectum of the flat surface. Reverse its points, or "
                     "flatten the surface with this centerline.");
  }
  const double lengthOfLine = match.arcLength[match.arcLength.size() - 1] - match.arcLength[0];
  double       lengthOfAxis = 0.0;
  for (Eigen::Index i = 1; i < axis.centers.rows(); ++i)
  {
    lengthOfAxis += (axis.centers.row(i) - axis.centers.row(i - 1)).norm();
  }
  const double     near = MedianDistanceOfLine(axis, match.points);
  constexpr double wholeLine = 0.6; // a shorter line may be a correct part
  if (lengthOfLine > wholeLine * lengthOfAxis || near > leastRadius)
  {
    throw InputError("the centerline is outside the flat surface along " + Percent(quality.shareOutside) +
                     " of its length (median distance from the middle: " +
                     std::to_string(static_cast<int>(std::lround(quality.medianDistance))) +
                     " mm): they belong to different colons or positions. Give the centerline created with this "
                     "surface.");
  }
  match.warnings.push_back("the centerline covers only a part of the flat surface: positions beyond its ends have no "
                           "distance along it");
}
} // namespace

CenterlineMatch
MatchCenterline(const FlatColon & flat, const CurveSet & centerline)
{
  FlatColonGridOptions options;
  options.pixelSize = pixelSize;
  const FlatColonGrid & grid = flat.Grid(options);
  const FlatColonAxis & axis = flat.Axis(options);
  CenterlineMatch       match = Assign(grid, axis, centerline);
  const MatchQuality    quality = QualityOf(axis, match);
  if (quality.shareOutside > greatestShareOutside)
  {
    ExplainMismatch(flat, grid, axis, quality, match);
  }
  return match;
}
} // namespace shapeton
