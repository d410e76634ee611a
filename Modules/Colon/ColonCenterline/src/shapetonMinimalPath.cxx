#include "shapetonMinimalPath.h"

#include "shapetonRadixQueue.h"

#include <algorithm>
#include <limits>

namespace shapeton
{
namespace
{
/** Data of one step, adjacent in memory. */
struct Record
{
  double reached;
  /** Cost of half a mm. */
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
GrowPathTree(const LumenGrid & grid, const LumenCells & cells, const CellTree & tree, int start, int exponent, int last)
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
    if (node == last)
    {
      break;
    }
    grid.ForEachNeighbor(node, [&, cost = cost, node = node](int next, double length) {
      Record &     there = records[next];
      const double through = cost + length * (static_cast<double>(here.cost) + there.cost);
      if (through < there.reached && (here.cell == there.cell || tree.IsOpen(here.cell, there.cell)))
      {
        there.reached = through;
        paths.parents[next] = node;
        paths.lengths[next] = paths.lengths[node] + static_cast<float>(length);
        queue.Push(through, next);
      }
    });
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
  struct Place
  {
    double reached;
    int    nearest;
    int    cell;
  };
  std::vector<Place> places(grid.NumberOfNodes());
  for (int node = 0; node < grid.NumberOfNodes(); ++node)
  {
    places[node] = { std::numeric_limits<double>::infinity(), -1, cells.cellOf[node] };
  }
  RadixQueue queue;
  for (int i = 0; i < static_cast<int>(path.size()); ++i)
  {
    if (path[i] >= 0 && places[path[i]].nearest < 0)
    {
      places[path[i]].nearest = i;
      places[path[i]].reached = 0.0;
      queue.Push(0.0, path[i]);
    }
  }
  while (!queue.IsEmpty())
  {
    const auto [way, node] = queue.Pop();
    const Place here = places[node];
    if (way > here.reached)
    {
      continue;
    }
    grid.ForEachNeighbor(node, [&, way = way](int next, double length) {
      Place &      there = places[next];
      const double through = way + length;
      if (through <= reach && through < there.reached &&
          (here.cell == there.cell || tree.IsOpen(here.cell, there.cell)))
      {
        there.reached = through;
        there.nearest = here.nearest;
        queue.Push(through, next);
      }
    });
  }
  NearestPlaces result;
  for (const Place & place : places)
  {
    result.indices.push_back(place.nearest);
    result.distances.push_back(static_cast<float>(place.reached));
  }
  return result;
}
} // namespace shapeton
