#include "shapetonTreeReach.h"

#include <algorithm>

namespace shapeton
{
void
TreeWalk::Visit(const TreeLinks & links, int cell)
{
  const std::size_t begin = order.size();
  order.push_back(cell);
  length[cell] = 0.0;
  depth[cell] = 0;
  for (std::size_t i = begin; i < order.size(); ++i)
  {
    const int at = order[i];
    for (const TreeLink & link : links[at])
    {
      if (depth[link.cell] < 0)
      {
        length[link.cell] = length[at] + link.length;
        depth[link.cell] = depth[at] + 1;
        parent[link.cell] = at;
        passage[link.cell] = link.passage;
        order.push_back(link.cell);
      }
    }
  }
}

TreeReach::TreeReach(const TreeLinks & links, const TreeWalk & all, const std::vector<char> & isCore)
  : m_Links(links), m_Walk(all), m_IsCore(isCore), m_Below(links.size()), m_Above(links.size())
{
  for (auto cell = all.order.rbegin(); cell != all.order.rend(); ++cell)
  {
    m_Below[*cell] = this->Around(*cell, all.passage[*cell]);
  }
  for (const int cell : all.order)
  {
    if (all.parent[cell] >= 0)
    {
      m_Above[cell] = this->Around(all.parent[cell], all.passage[cell]);
    }
  }
}

TreeReach::Part
TreeReach::Join(const Part & a, const Part & b)
{
  return { std::max(a.deepest, b.deepest), std::max({ a.longest, b.longest, a.deepest + b.deepest }) };
}

TreeReach::Part
TreeReach::Around(int cell, int passage, int other) const
{
  Part part;
  part.deepest = m_IsCore[cell] ? 0.0 : part.deepest;
  for (const TreeLink & link : m_Links[cell])
  {
    if (link.passage != passage && link.passage != other)
    {
      const Part & beyond = m_Walk.parent[link.cell] == cell ? m_Below[link.cell] : m_Above[cell];
      part = Join(part, Farther(beyond, link.length));
    }
  }
  return part;
}

std::vector<TreeReach::Part>
TreeReach::FromTheFirst(const std::vector<Part> & hanging, const std::vector<double> & lengths)
{
  std::vector<Part> parts{ hanging.front() };
  Part              last = hanging.front(); // the same part, relative to the last cell
  double            length = 0.0;
  for (std::size_t i = 1; i < hanging.size(); ++i)
  {
    length += lengths[i - 1];
    last = Join(Farther(last, lengths[i - 1]), hanging[i]);
    parts.push_back({ std::max(parts.back().deepest, hanging[i].deepest + length), last.longest });
  }
  return parts;
}

std::vector<double>
TreeReach::LongestWaysWithout(const TreeRing & ring, double length) const
{
  const std::size_t links = ring.passages.size();
  std::vector<Part> hanging;
  for (std::size_t i = 0; i <= links; ++i)
  {
    hanging.push_back(
      this->Around(ring.cells[i], i > 0 ? ring.passages[i - 1] : -1, i < links ? ring.passages[i] : -1));
  }
  const std::vector<Part> before = FromTheFirst(hanging, ring.lengths);
  std::reverse(hanging.begin(), hanging.end());
  const std::vector<Part> behind = FromTheFirst(hanging, { ring.lengths.rbegin(), ring.lengths.rend() });
  std::vector<double>     ways;
  for (std::size_t out = 0; out < links; ++out)
  {
    ways.push_back(Join(before[out], Farther(behind[links - 1 - out], length)).longest);
  }
  return ways;
}
} // namespace shapeton
