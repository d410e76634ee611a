#include "shapetonMinimalPath.h"

#include "shapetonRadixQueue.h"

#include <algorithm>
#include <limits>

namespace shapeton
{
namespace
{
/** What a step looks at, side by side in memory. */
struct Record
{
  double reached;
  /** Of half a mm. */
  float cost;
  int   cell;
};

std::vector<Record>
MakeRecords(const LumenGrid & grid, const LumenCells & cells, int exponent)
{
  std::vector<Record> records(grid.NumberOfNodes());
  for (int node = 0; node < grid.NumberOfNodes(); ++node)
  {
    const double base = 1.0 / (grid.Distance(node) + 0.1);
    // Not std::pow, whose last bit depends on the processor.
    double cost = 0.5 * base;
    for (int i = 1; i < exponent; ++i)
    {
      cost *= base;
    }
    records[node] = { std::numeric_limits<double>::infinity(), static_cast<float>(cost), cells.cellOf[node] };
  }
  return records;
}
} // namespace

std::vector<int>
PathTree::PathTo(int node) const
{
  std::vector<int> path;
  for (; node >= 0; node = parents[node])
  {
    path.push_back(node);
  }
  std::reverse(path.begin(), path.end());
  return path;
}

PathTree
GrowPathTree(const LumenGrid & grid, const LumenCells & cells, const CellTree & tree, int start, int exponent)
{
  std::vector<Record> records = MakeRecords(grid, cells, exponent);
  PathTree            paths;
  paths.parents.assign(grid.NumberOfNodes(), -1);
  paths.lengths.assign(grid.NumberOfNodes(), -1.0F);
  RadixQueue queue;
  queue.Push(0.0, start);
  records[start].reached = 0.0;
  paths.lengths[start] = 0.0F;
  while (!queue.IsEmpty())
  {
    const auto [cost, node] = queue.Pop();
    const Record here = records[node];
    if (cost > here.reached)
    {
      continue;
    }
    paths.order.push_back(node);
    for (const auto & step : grid.Steps())
    {
      const int next = grid.Neighbour(node, step.offset);
      if (next < 0)
      {
        continue;
      }
      Record &     there = records[next];
      const double through = cost + step.length * (static_cast<double>(here.cost) + there.cost);
      if (through < there.reached && (here.cell == there.cell || tree.IsOpen(here.cell, there.cell)))
      {
        there.reached = through;
        paths.parents[next] = node;
        paths.lengths[next] = paths.lengths[node] + static_cast<float>(step.length);
        queue.Push(through, next);
      }
    }
  }
  return paths;
}

NearestPlaces
NearestOnPath(const LumenGrid &        grid,
              const LumenCells &       cells,
              const CellTree &         tree,
              const std::vector<int> & path,
              double                   reach)
{
  std::vector<int>    nearest(grid.NumberOfNodes(), -1);
  std::vector<double> reached(grid.NumberOfNodes(), std::numeric_limits<double>::infinity());
  RadixQueue          queue;
  for (int i = 0; i < static_cast<int>(path.size()); ++i)
  {
    if (path[i] >= 0 && nearest[path[i]] < 0)
    {
      nearest[path[i]] = i;
      reached[path[i]] = 0.0;
      queue.Push(0.0, path[i]);
    }
  }
  while (!queue.IsEmpty())
  {
    const auto [length, node] = queue.Pop();
    if (length > reached[node])
    {
      continue;
    }
    for (const auto & step : grid.Steps())
    {
      const int    next = grid.Neighbour(node, step.offset);
      const double through = length + step.length;
      if (next >= 0 && through <= reach && through < reached[next] &&
          (cells.cellOf[node] == cells.cellOf[next] || tree.IsOpen(cells.cellOf[node], cells.cellOf[next])))
      {
        reached[next] = through;
        nearest[next] = nearest[node];
        queue.Push(through, next);
      }
    }
  }
  return { std::move(nearest), { reached.begin(), reached.end() } };
}
} // namespace shapeton
