#include "shapetonLumenCells.h"

#include "shapetonInterruption.h"

#include <algorithm>
#include <numeric>

namespace shapeton
{
namespace
{
/** Maximum distance of a cell from its center, in radii of its inscribed ball. */
constexpr double reach = 1.5;
/** Minimum radius of a cell, in voxels; above zero, so that even a cell at the narrowest voxel includes its neighbors.
 */
constexpr double leastRadius = 0.7;

std::vector<int>
WidestFirst(const LumenGrid & grid)
{
  std::vector<int> order(grid.NumberOfNodes());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&grid](int a, int b) {
    return grid.Distance(a) != grid.Distance(b) ? grid.Distance(a) > grid.Distance(b) : a < b;
  });
  return order;
}
} // namespace

LumenCells::LumenCells(const LumenGrid & grid) : cellOf(grid.NumberOfNodes(), -1)
{
  for (const int node : WidestFirst(grid))
  {
    if (cellOf[node] < 0)
    {
      const int cell = this->BestNeighbor(grid, node);
      if (cell >= 0)
      {
        cellOf[node] = cell;
      }
      else
      {
        Interruption::Check();
        this->Claim(grid, node);
      }
    }
  }
  volumes.assign(centers.size(), 0.0);
  for (const int cell : cellOf)
  {
    volumes[cell] += grid.NodeVolume();
  }
  this->FindPassages(grid);
}

double
LumenCells::UsualRadius() const
{
  std::vector<int> order(centers.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [this](int a, int b) { return radii[a] < radii[b]; });
  const double volume = std::accumulate(volumes.begin(), volumes.end(), 0.0);
  double       passed = 0.0;
  for (const int cell : order)
  {
    passed += volumes[cell];
    if (passed >= 0.5 * volume)
    {
      return radii[cell];
    }
  }
  return 0.0;
}

int
LumenCells::BestNeighbor(const LumenGrid & grid, int node) const
{
  const Eigen::Vector3d position = grid.Position(node);
  int                   best = -1;
  double                least = reach * reach;
  for (const int stride : grid.Strides())
  {
    for (const int offset : { stride, -stride })
    {
      const int neighbor = grid.Neighbor(node, offset);
      const int cell = neighbor < 0 ? -1 : cellOf[neighbor];
      if (cell < 0 || cell == best)
      {
        continue;
      }
      const double ratio = (position - positions[cell]).squaredNorm() / (radii[cell] * radii[cell]);
      if (ratio < least || (ratio == least && cell < best))
      {
        least = ratio;
        best = cell;
      }
    }
  }
  return best;
}

void
LumenCells::Claim(const LumenGrid & grid, int center)
{
  const int    cell = this->NumberOfCells();
  const double radius = grid.Distance(center);
  centers.push_back(center);
  positions.push_back(grid.Position(center));
  radii.push_back(std::max(radius, leastRadius * grid.Spacing().maxCoeff()));
  cellOf[center] = cell;
  // Distances are accurate to half a voxel, and the ball must not extend through a thin wall.
  const double       ball = radius - 0.5 * grid.Spacing().maxCoeff();
  const auto         at = grid.Voxel(center);
  std::array<int, 3> from, to;
  for (int a = 0; a < 3; ++a)
  {
    const int steps = static_cast<int>(std::max(0.0, ball) / grid.Spacing()[a]);
    from[a] = std::max(0, at[a] - steps);
    to[a] = std::min(grid.Size()[a] - 1, at[a] + steps);
  }
  for (int z = from[2]; z <= to[2]; ++z)
  {
    for (int y = from[1]; y <= to[1]; ++y)
    {
      for (int x = from[0]; x <= to[0]; ++x)
      {
        const Eigen::Vector3d step = Eigen::Vector3d(x - at[0], y - at[1], z - at[2]).cwiseProduct(grid.Spacing());
        const int             node = step.squaredNorm() < ball * ball ? grid.NodeAt(x, y, z) : -1;
        if (node >= 0 && cellOf[node] < 0)
        {
          cellOf[node] = cell;
        }
      }
    }
  }
}

void
LumenCells::FindPassages(const LumenGrid & grid)
{
  std::vector<CellPassage> touches;
  for (int node = 0; node < grid.NumberOfNodes(); ++node)
  {
    for (const int stride : grid.Strides())
    {
      const int neighbor = grid.Neighbor(node, stride);
      if (neighbor >= 0 && cellOf[neighbor] != cellOf[node])
      {
        const int narrow = grid.Distance(node) <= grid.Distance(neighbor) ? node : neighbor;
        touches.push_back({ std::min(cellOf[node], cellOf[neighbor]),
                            std::max(cellOf[node], cellOf[neighbor]),
                            grid.Distance(narrow),
                            narrow });
      }
    }
  }
  const auto widestFirst = [](const CellPassage & p, const CellPassage & q) {
    return p.clearance != q.clearance ? p.clearance > q.clearance : p.node < q.node;
  };
  std::sort(touches.begin(), touches.end(), [&](const CellPassage & p, const CellPassage & q) {
    return p.a != q.a ? p.a < q.a : (p.b != q.b ? p.b < q.b : widestFirst(p, q));
  });
  for (const CellPassage & touch : touches)
  {
    if (passages.empty() || passages.back().a != touch.a || passages.back().b != touch.b)
    {
      passages.push_back(touch);
    }
  }
  std::sort(passages.begin(), passages.end(), [&](const CellPassage & p, const CellPassage & q) {
    return p.clearance != q.clearance ? p.clearance > q.clearance : (p.a != q.a ? p.a < q.a : p.b < q.b);
  });
}
} // namespace shapeton
