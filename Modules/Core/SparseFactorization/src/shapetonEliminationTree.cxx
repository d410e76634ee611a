#include "shapetonEliminationTree.h"

#include <algorithm>
#include <numeric>

namespace shapeton
{
namespace
{
/** The earlier neighbors of each column. */
struct UpperPattern
{
  UpperPattern(const std::vector<int> & place, const std::vector<std::array<int, 2>> & edges)
    : begin(place.size() + 1, 0), rows(edges.size())
  {
    for (const auto & [a, b] : edges)
    {
      ++begin[std::max(place[a], place[b]) + 1];
    }
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
    for (const auto & [a, b] : edges)
    {
      rows[next[std::max(place[a], place[b])]++] = std::min(place[a], place[b]);
    }
  }
  std::vector<std::size_t> begin;
  std::vector<int>         rows;
};

/** Liu's algorithm with path compression. */
std::vector<int>
ParentsOf(const UpperPattern & pattern)
{
  const int        n = static_cast<int>(pattern.begin.size()) - 1;
  std::vector<int> parent(n, -1);
  std::vector<int> ancestor(n, -1);
  for (int column = 0; column < n; ++column)
  {
    for (std::size_t p = pattern.begin[column]; p < pattern.begin[column + 1]; ++p)
    {
      for (int i = pattern.rows[p]; i != -1 && i != column;)
      {
        const int next = ancestor[i];
        ancestor[i] = column;
        if (next == -1)
        {
          parent[i] = column;
        }
        i = next;
      }
    }
  }
  return parent;
}

/** The columns in postorder, children in ascending order. */
std::vector<int>
PostorderOf(const std::vector<int> & parent)
{
  const int        n = static_cast<int>(parent.size());
  std::vector<int> firstChild(n + 1, -1); // column n: the roots
  std::vector<int> sibling(n, -1);
  for (int i = n - 1; i >= 0; --i)
  {
    const int p = parent[i] == -1 ? n : parent[i];
    sibling[i] = firstChild[p];
    firstChild[p] = i;
  }
  std::vector<int> postorder;
  postorder.reserve(n);
  std::vector<int> stack{ n };
  while (!stack.empty())
  {
    const int i = stack.back();
    if (firstChild[i] != -1)
    {
      stack.push_back(firstChild[i]);
      firstChild[i] = sibling[firstChild[i]];
      continue;
    }
    stack.pop_back();
    if (i < n)
    {
      postorder.push_back(i);
    }
  }
  return postorder;
}

/** Row by row: the nonzero columns of a row of the factor form a subtree below that row. */
std::vector<int>
CountsOf(const UpperPattern & pattern, const std::vector<int> & parent)
{
  const int        n = static_cast<int>(parent.size());
  std::vector<int> count(n, 0);
  std::vector<int> seen(n, -1);
  for (int row = 0; row < n; ++row)
  {
    seen[row] = row;
    for (std::size_t p = pattern.begin[row]; p < pattern.begin[row + 1]; ++p)
    {
      for (int i = pattern.rows[p]; seen[i] != row; i = parent[i])
      {
        ++count[i];
        seen[i] = row;
      }
    }
  }
  return count;
}
} // namespace

std::vector<int>
PlacesOf(const std::vector<int> & order)
{
  std::vector<int> place(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    place[order[i]] = static_cast<int>(i);
  }
  return place;
}

EliminationTree::EliminationTree(std::vector<int> & order, const std::vector<std::array<int, 2>> & edges)
{
  const std::vector<int> postorder = PostorderOf(ParentsOf({ PlacesOf(order), edges }));
  std::vector<int>       reordered(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    reordered[i] = order[postorder[i]];
  }
  order = std::move(reordered);
  const UpperPattern pattern(PlacesOf(order), edges);
  parent = ParentsOf(pattern);
  count = CountsOf(pattern, parent);
}
} // namespace shapeton
