#include "shapetonFlatColonAxis.h"

#include "shapetonParallelFor.h"
#include "shapetonExceptions.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
constexpr int rowsOfColumn = 96; ///< used for a mean over a column; chosen

/** Calls `take` for evenly spaced pixels of a column that are on a face. */
template <typename TTake>
void
ForColumn(const FlatColonGrid & grid, int column, const TTake & take)
{
  const int step = std::max(1, grid.Rows() / rowsOfColumn);
  for (int row = 0; row < grid.Rows(); row += step)
  {
    const FlatSample sample = grid.SampleOfPixel(column, row);
    if (sample.face >= 0)
    {
      take(sample);
    }
  }
}

/** Center of the wall (three values), and mean distance from it to the wall; NaN for a column without faces. */
Eigen::Vector4d
MeasureColumn(const FlatColonGrid & grid, int column)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double          weight = 0.0;
  ForColumn(grid, column, [&](const FlatSample & sample) {
    sum += sample.scale * sample.point; // weighted by length in space
    weight += sample.scale;
  });
  const Eigen::Vector3d center = sum / weight;
  double                distance = 0.0;
  ForColumn(
    grid, column, [&](const FlatSample & sample) { distance += sample.scale * (sample.point - center).norm(); });
  return { center.x(), center.y(), center.z(), distance / weight };
}

/** Replaces NaN rows by the nearest valid row; earlier rows are preferred. */
void
FillGaps(Eigen::MatrixXd & values, const std::string & what)
{
  const Eigen::MatrixXd given = values;
  const auto            nearestFrom = [&](Eigen::Index i, int step) {
    while (i >= 0 && i < given.rows() && !given.row(i).allFinite())
    {
      i += step;
    }
    return i;
  };
  for (Eigen::Index i = 0; i < given.rows(); ++i)
  {
    const Eigen::Index before = nearestFrom(i, -1);
    const Eigen::Index after = nearestFrom(i, 1);
    if (before < 0 && after >= given.rows())
    {
      throw InputError("the flat surface has no " + what);
    }
    const bool takesBefore = before >= 0 && (after >= given.rows() || i - before <= after - i);
    values.row(i) = given.row(takesBefore ? before : after);
  }
}

/** Gaussian smoothing along the rows, with point reflection at the ends. */
Eigen::MatrixXd
Smoothed(const Eigen::MatrixXd & values, double deviation)
{
  const int           last = static_cast<int>(values.rows()) - 1;
  const int           reach = static_cast<int>(std::ceil(3.0 * deviation));
  std::vector<double> weights;
  for (int i = -reach; i <= reach; ++i)
  {
    weights.push_back(std::exp(-0.5 * i * i / (deviation * deviation)));
  }
  Eigen::MatrixXd smoothed(values.rows(), values.cols());
  ParallelForBlocks(values.rows(), [&](std::size_t row) {
    Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(values.cols());
    double             weight = 0.0;
    for (int i = -reach; i <= reach; ++i)
    {
      const int at = static_cast<int>(row) + i;
      const int end = at < 0 ? 0 : last;
      const int inside = std::clamp(at, 0, last);
      const int mirrored = std::clamp(2 * end - at, 0, last);
      sum += weights[i + reach] *
             (at == inside ? values.row(at) : Eigen::RowVectorXd(2.0 * values.row(end) - values.row(mirrored)));
      weight += weights[i + reach];
    }
    smoothed.row(row) = sum / weight;
  });
  return smoothed;
}

/** Isotonic regression (least squares) by pooling adjacent violators. */
std::vector<double>
NeverFalling(const Eigen::MatrixXd & values)
{
  struct Pool
  {
    double sum;
    int    number;
  };
  std::vector<Pool> pools;
  for (Eigen::Index i = 0; i < values.rows(); ++i)
  {
    Pool pool{ values(i, 0), 1 };
    while (!pools.empty() && pools.back().sum * pool.number > pool.sum * pools.back().number)
    {
      pool.sum += pools.back().sum;
      pool.number += pools.back().number;
      pools.pop_back();
    }
    pools.push_back(pool);
  }
  std::vector<double> fit;
  for (const Pool & pool : pools)
  {
    fit.insert(fit.end(), pool.number, pool.sum / pool.number);
  }
  return fit;
}

/** At most `number` evenly spaced indices out of `total`, including both ends. */
std::vector<int>
Spread(int total, int number)
{
  const int        parts = std::max(1, std::min(total, number) - 1);
  std::vector<int> indices;
  for (int i = 0; i <= parts && total > 0; ++i)
  {
    indices.push_back(static_cast<int>(static_cast<std::int64_t>(i) * (total - 1) / parts));
  }
  return indices;
}

/** Assigns a station to each point: nondecreasing station indices with the minimum sum of squared distances (dynamic
 * programming). */
std::vector<int>
AssignInOrder(const VertexMatrix & points, const VertexMatrix & stations)
{
  const auto       numberOfStations = static_cast<std::size_t>(stations.rows());
  Eigen::VectorXd  cost = Eigen::VectorXd::Zero(stations.rows());
  std::vector<int> best(points.rows() * numberOfStations);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    Eigen::Index least = 0;
    double       leastCost = cost[0];
    for (Eigen::Index j = 0; j < stations.rows(); ++j)
    {
      least = cost[j] < leastCost ? j : least;
      leastCost = std::min(leastCost, cost[j]);
      best[i * numberOfStations + j] = static_cast<int>(least);
      cost[j] = leastCost + (points.row(i) - stations.row(j)).squaredNorm();
    }
  }
  Eigen::Index last = 0;
  cost.minCoeff(&last);
  std::vector<int> assigned(points.rows());
  int              station = static_cast<int>(last);
  for (Eigen::Index i = points.rows() - 1; i >= 0; --i)
  {
    assigned[i] = station;
    station = best[i * numberOfStations + station];
  }
  return assigned;
}
} // namespace

FlatColonAxis
MakeFlatColonAxis(const FlatColonGrid & grid, double smoothing)
{
  RequireParameter(smoothing >= 0.0, "the smoothing of the axis must not be negative");
  Eigen::MatrixXd measured(grid.Columns(), 4);
  ParallelFor(grid.Columns(),
              [&](std::size_t column) { measured.row(column) = MeasureColumn(grid, static_cast<int>(column)); });
  FillGaps(measured, "column with faces");
  const double          length = smoothing > 0.0 ? smoothing : 0.2 * grid.Circumference();
  const Eigen::MatrixXd smooth = Smoothed(measured, std::max(0.5, length / grid.PixelSize()));
  FlatColonAxis         axis;
  axis.centers = smooth.leftCols(3);
  axis.radii = smooth.col(3).cwiseMax(1e-3 * grid.Circumference());
  axis.tangents.resize(grid.Columns(), 3);
  const int last = grid.Columns() - 1;
  for (int column = 0; column <= last; ++column)
  {
    const Eigen::RowVector3d along =
      axis.centers.row(std::min(last, column + 1)) - axis.centers.row(std::max(0, column - 1));
    axis.tangents.row(column) =
      along.norm() > 0.0 ? Eigen::RowVector3d(along.normalized()) : Eigen::RowVector3d(1, 0, 0);
  }
  return axis;
}

FlatColonFrame
FrameAt(const FlatColonAxis & axis, int column, const Eigen::Vector3d & point)
{
  FlatColonFrame frame;
  frame.right = axis.tangents.row(column);
  Eigen::Vector3d towards = axis.centers.row(column).transpose() - point;
  towards -= frame.right.dot(towards) * frame.right;
  frame.towards = towards.norm() > 1e-9 ? Eigen::Vector3d(towards.normalized()) : frame.right.unitOrthogonal();
  frame.down = frame.right.cross(frame.towards); // right x down points away from the axis
  return frame;
}

std::vector<double>
DistanceOfColumns(const FlatColonGrid & grid)
{
  if (!grid.HasArcLength())
  {
    return {};
  }
  Eigen::MatrixXd means(grid.Columns(), 1);
  ParallelFor(grid.Columns(), [&](std::size_t column) {
    double sum = 0.0;
    double number = 0.0;
    ForColumn(grid, static_cast<int>(column), [&](const FlatSample & sample) {
      sum += sample.arcLength;
      number += 1.0;
    });
    means(column, 0) = sum / number;
  });
  FillGaps(means, "column with faces");
  return NeverFalling(means);
}

std::vector<double>
DistanceOfColumns(const FlatColonAxis & axis, const CurveSet & centerline)
{
  // Chosen: limits the assignment to 8 million pairs; columns are about 1 mm wide in a colon 2 m long.
  constexpr int         mostColumns = 2000;
  constexpr int         mostStations = 4000;
  const Eigen::VectorXd arcLength = PointValues(centerline, "arcLength", "the centerline");
  if (centerline.curves.size() != 1)
  {
    throw InputError("the centerline has " + std::to_string(centerline.curves.size()) + " curves instead of one");
  }
  const std::vector<int> & curve = centerline.curves.front();
  const std::vector<int>   columns = Spread(static_cast<int>(axis.centers.rows()), mostColumns);
  const std::vector<int>   stations = Spread(static_cast<int>(curve.size()), mostStations);
  VertexMatrix             points(columns.size(), 3);
  VertexMatrix             places(stations.size(), 3);
  for (std::size_t i = 0; i < columns.size(); ++i)
  {
    points.row(i) = axis.centers.row(columns[i]);
  }
  for (std::size_t j = 0; j < stations.size(); ++j)
  {
    places.row(j) = centerline.V.row(curve[stations[j]]);
  }
  const std::vector<int> assigned = AssignInOrder(points, places);
  std::vector<double>    distances(axis.centers.rows(), arcLength[curve[stations[assigned.front()]]]);
  for (std::size_t i = 1; i < columns.size(); ++i)
  {
    const double from = arcLength[curve[stations[assigned[i - 1]]]];
    const double to = arcLength[curve[stations[assigned[i]]]];
    const int    width = columns[i] - columns[i - 1];
    for (int step = 1; step <= width; ++step)
    {
      distances[columns[i - 1] + step] = from + (to - from) * step / width;
    }
  }
  return distances;
}
} // namespace shapeton
