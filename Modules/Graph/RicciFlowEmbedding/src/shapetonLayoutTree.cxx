#include "shapetonLayoutTree.h"

#include "shapetonParallelFor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace shapeton
{
namespace
{
/** Visits nodes by highest priority, given by `priorityOf(priority of the previous node, half-edge)`. */
template <typename TPriority>
LayoutTree
GrowTree(const CombinatorialMap & map, const CirclePacking & packing, int root, const TPriority & priorityOf)
{
  struct Arrival
  {
    double priority;
    int    node;
    int    halfEdge;
    bool
    operator<(const Arrival & other) const
    {
      return priority != other.priority ? priority < other.priority : halfEdge > other.halfEdge;
    }
  };
  LayoutTree                   tree;
  std::vector<char>            isDone(map.Nodes(), 0);
  std::vector<double>          best(map.Nodes(), -std::numeric_limits<double>::infinity()); // best queued priority
  std::priority_queue<Arrival> queue;
  tree.arrival.assign(map.Nodes(), -1);
  queue.push({ 0.0, root, -1 });
  while (!queue.empty())
  {
    const Arrival next = queue.top();
    queue.pop();
    if (isDone[next.node])
    {
      continue;
    }
    isDone[next.node] = 1;
    tree.order.push_back(next.node);
    tree.arrival[next.node] = next.halfEdge;
    const int first = map.FirstAround(next.node);
    int       h = first;
    do
    {
      const int node = map.Node(CombinatorialMap::Twin(h));
      if (!isDone[node] && !std::isinf(packing.nodeRadii[node]))
      {
        const double priority = priorityOf(next.priority, h);
        if (priority >= best[node]) // others would be popped too late
        {
          best[node] = priority;
          queue.push({ priority, node, h });
        }
      }
      h = map.NextAround(h);
    } while (h != first);
  }
  return tree;
}
} // namespace

int
LargestFiniteNode(const CirclePacking & packing)
{
  int largest = -1;
  for (std::size_t node = 0; node < packing.nodeRadii.size(); ++node)
  {
    if (!std::isinf(packing.nodeRadii[node]) && (largest < 0 || packing.nodeRadii[node] > packing.nodeRadii[largest]))
    {
      largest = static_cast<int>(node);
    }
  }
  return largest;
}

LayoutTree
LayoutTree::OfLargestCircles(const CombinatorialMap & map, const CirclePacking & packing, int root)
{
  const std::vector<double> & radii = packing.nodeRadii;
  return GrowTree(map, packing, root, [&](double, int h) {
    return std::min(radii[map.Node(h)], radii[map.Node(CombinatorialMap::Twin(h))]);
  });
}

LayoutTree
LayoutTree::OfShortestPaths(const CombinatorialMap & map, const CirclePacking & packing)
{
  const std::vector<double> & radii = packing.nodeRadii;
  return GrowTree(map, packing, LargestFiniteNode(packing), [&](double priority, int h) {
    return priority - radii[map.Node(h)] - radii[map.Node(CombinatorialMap::Twin(h))];
  });
}
} // namespace shapeton
