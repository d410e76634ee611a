#include "shapetonSupernodes.h"

#include "shapetonEliminationTree.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace shapeton
{
namespace
{
/** The later neighbors of each column. */
struct LowerPattern
{
  LowerPattern(const std::vector<int> & place, const std::vector<std::array<int, 2>> & edges)
    : begin(place.size() + 1, 0), rows(edges.size())
  {
    for (const auto & [a, b] : edges)
    {
      ++begin[std::min(place[a], place[b]) + 1];
    }
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
    for (const auto & [a, b] : edges)
    {
      rows[next[std::min(place[a], place[b])]++] = std::max(place[a], place[b]);
    }
  }
  std::vector<std::size_t> begin;
  std::vector<int>         rows;
};
} // namespace

Supernodes::Supernodes(std::vector<int> itsOrder, const std::vector<std::array<int, 2>> & edges)
  : order(std::move(itsOrder))
{
  {
    const EliminationTree tree(order, edges);
    ColumnRuns            runs = MergeColumns(order, tree);
    order = std::move(runs.order);
    firstColumn = std::move(runs.firstColumn);
  }
  const std::vector<int> place = PlacesOf(order);
  this->BuildRows(place, edges);
  this->CutWideOnes();
  this->BuildPlaces();
  this->BuildEntries(place, edges);
  this->BuildSubtrees();
}

double
Supernodes::Products(int s) const
{
  const double     width = this->Width(s);
  const double     below = this->NumberOfRows(s);
  constexpr double ofUpdate = 1.5;
  return width * (width * width + 2.0 * width * below + ofUpdate * below * below);
}

std::vector<int>
Supernodes::SupernodeOfColumns() const
{
  std::vector<int> supernode(order.size());
  for (std::size_t s = 0; s + 1 < firstColumn.size(); ++s)
  {
    std::fill(supernode.begin() + firstColumn[s], supernode.begin() + firstColumn[s + 1], static_cast<int>(s));
  }
  return supernode;
}

/** The rows of a supernode are the union of the matrix rows of its columns and the rows of its children, without its
 * own columns. */
void
Supernodes::BuildRows(const std::vector<int> & place, const std::vector<std::array<int, 2>> & edges)
{
  const int              number = static_cast<int>(firstColumn.size()) - 1;
  const LowerPattern     pattern(place, edges);
  const std::vector<int> supernodeOf = this->SupernodeOfColumns();
  std::vector<int>       seen(order.size(), -1);
  std::vector<int>       lastOne(number, -1); // rows of the children found so far
  std::vector<int>       before(number, -1);
  parent.assign(number, -1);
  rowBegin.assign(1, 0);
  for (int s = 0; s < number; ++s)
  {
    const int  end = firstColumn[s + 1];
    const auto add = [&](int row) {
      if (row >= end && seen[row] != s)
      {
        seen[row] = s;
        rows.push_back(row);
      }
    };
    std::for_each(pattern.rows.begin() + pattern.begin[firstColumn[s]], pattern.rows.begin() + pattern.begin[end], add);
    for (int child = lastOne[s]; child != -1; child = before[child])
    {
      for (std::size_t p = rowBegin[child]; p < rowBegin[child + 1]; ++p)
      {
        add(rows[p]);
      }
    }
    std::sort(rows.begin() + rowBegin.back(), rows.end());
    if (rows.size() > rowBegin.back())
    {
      parent[s] = supernodeOf[rows[rowBegin.back()]];
      before[s] = lastOne[parent[s]];
      lastOne[parent[s]] = s;
    }
    rowBegin.push_back(rows.size());
  }
}

/** The panels of a supernode form a chain: the rows of each include the columns of the following ones, and all
 * children belong to the first. */
void
Supernodes::CutWideOnes()
{
  const Supernodes whole = std::move(*this);
  std::vector<int> firstPanel;
  order = whole.order;
  rowBegin.assign(1, 0);
  rows.clear();
  firstColumn.clear();
  for (int s = 0; s < whole.Number(); ++s)
  {
    firstPanel.push_back(static_cast<int>(firstColumn.size()));
    const int          width = whole.Width(s);
    const int          end = whole.firstColumn[s + 1];
    const std::int64_t panels = (width + maximalWidth - 1) / maximalWidth;
    for (std::int64_t panel = 0; panel < panels; ++panel)
    {
      firstColumn.push_back(whole.firstColumn[s] + static_cast<int>(width * panel / panels));
      for (int column = whole.firstColumn[s] + static_cast<int>(width * (panel + 1) / panels); column < end; ++column)
      {
        rows.push_back(column);
      }
      rows.insert(rows.end(), whole.rows.begin() + whole.rowBegin[s], whole.rows.begin() + whole.rowBegin[s + 1]);
      rowBegin.push_back(rows.size());
    }
  }
  firstColumn.push_back(whole.firstColumn.back());
  parent.clear();
  for (int s = 0; s < whole.Number(); ++s)
  {
    const int end = s + 1 < whole.Number() ? firstPanel[s + 1] : static_cast<int>(firstColumn.size()) - 1;
    for (int panel = firstPanel[s] + 1; panel < end; ++panel)
    {
      parent.push_back(panel);
    }
    parent.push_back(whole.parent[s] == -1 ? -1 : firstPanel[whole.parent[s]]);
  }
}

void
Supernodes::BuildPlaces()
{
  placeInParent.resize(rows.size());
  for (int s = 0; s < this->Number(); ++s)
  {
    const int p = parent[s];
    if (p == -1)
    {
      continue;
    }
    std::size_t inParent = rowBegin[p];
    for (std::size_t i = rowBegin[s]; i < rowBegin[s + 1]; ++i)
    {
      if (rows[i] < firstColumn[p + 1])
      {
        placeInParent[i] = rows[i] - firstColumn[p];
        continue;
      }
      while (rows[inParent] != rows[i])
      {
        ++inParent;
      }
      placeInParent[i] = this->Width(p) + static_cast<int>(inParent - rowBegin[p]);
    }
  }
}

void
Supernodes::BuildEntries(const std::vector<int> & place, const std::vector<std::array<int, 2>> & edges)
{
  const std::vector<int> supernodeOf = this->SupernodeOfColumns();
  entryBegin.assign(this->Number() + 1, 0);
  for (const int column : place)
  {
    ++entryBegin[supernodeOf[column] + 1];
  }
  for (const auto & [a, b] : edges)
  {
    ++entryBegin[supernodeOf[std::min(place[a], place[b])] + 1];
  }
  std::partial_sum(entryBegin.begin(), entryBegin.end(), entryBegin.begin());
  entries.resize(entryBegin.back());
  std::vector<std::size_t> next(entryBegin.begin(), entryBegin.end() - 1);
  const auto               add = [&](int row, int column, int source) {
    const int s = supernodeOf[column];
    int       local = row - firstColumn[s];
    if (row >= firstColumn[s + 1])
    {
      const auto first = rows.begin() + rowBegin[s];
      local = this->Width(s) + static_cast<int>(std::lower_bound(first, rows.begin() + rowBegin[s + 1], row) - first);
    }
    entries[next[s]++] = { local, column - firstColumn[s], source };
  };
  for (std::size_t vertex = 0; vertex < place.size(); ++vertex)
  {
    add(place[vertex], place[vertex], -1 - static_cast<int>(vertex));
  }
  for (std::size_t edge = 0; edge < edges.size(); ++edge)
  {
    const auto ends = std::minmax(place[edges[edge][0]], place[edges[edge][1]]);
    add(ends.second, ends.first, static_cast<int>(edge));
  }
}

void
Supernodes::BuildSubtrees()
{
  firstDescendant.resize(this->Number());
  std::iota(firstDescendant.begin(), firstDescendant.end(), 0);
  numberOfChildren.assign(this->Number(), 0);
  lastChild.assign(this->Number(), -1);
  sibling.assign(this->Number(), -1);
  for (int s = 0; s < this->Number(); ++s)
  {
    if (parent[s] != -1)
    {
      firstDescendant[parent[s]] = std::min(firstDescendant[parent[s]], firstDescendant[s]);
      ++numberOfChildren[parent[s]];
      sibling[s] = lastChild[parent[s]];
      lastChild[parent[s]] = s;
    }
  }
}
} // namespace shapeton
