#include "shapetonCellTree.h"

#include "shapetonDisjointSets.h"
#include "shapetonInterruption.h"

#include <algorithm>

namespace shapeton
{
namespace
{
/** Usual and absolute maximum radius (mm) of holes between two loops. A single limit of 7 mm was rejected: in a
 * validation exam (realistic 145 prone) a difference of 0.01 mm affected 400 mm of line. */
constexpr double usualHole = 7.0;
constexpr double widestHole = 10.0;
/** Minimum gain (mm) in path length for treating a passage as a hole, and the additional gain required per mm of width
 * above the usual width. Openings in thin septa between adjacent loops are up to half the caliber wide. */
constexpr double leastGain = 40.0;
constexpr double gainOfWide = 100.0;
/** Tolerance for equal lengths (mm). Summing the same lengths in a different order changes the sum by less than
 * this. */
constexpr double sameLength = 1e-6;
/** Base length (mm) of long rings, to which a multiple of the radius is added. In shorter rings, the path cost already
 * avoids the narrow passage, and a path may take either side of a fold. */
constexpr double shortRing = 60.0;
constexpr double ringRadii = 4.0;
/** Minimum length (mm) of side branches other than haustra; alternatively, minimum volume (mm^3) of the lumen farther
 * than besideWay (mm) plus 1.5 radii from the middle of the path. */
constexpr double shortestBranch = 40.0;
constexpr double smallestBranch = 20e3;
constexpr double besideWay = 10.0;
/** Maximum radius of a hole relative to the caliber on both sides, measured within holeReach (mm). */
constexpr double leastOpening = 0.4;
constexpr double holeReach = 30.0;
/** Limits the run time. */
constexpr int mostExchanges = 30;
} // namespace

CellTree::CellTree(const LumenCells & cells, double coreRadius)
  : m_Cells(cells), m_CoreRadius(coreRadius), m_Links(cells.NumberOfCells()), m_IsInTree(cells.passages.size(), 0)
{
  this->SpanWidest();
  // Each swap lengthens a path, so the loop terminates; the bound limits the run time for degenerate input.
  for (int exchanges = 0; exchanges < mostExchanges && this->Exchange(); ++exchanges)
  {}
}

void
CellTree::SpanWidest()
{
  DisjointSets pieces(m_Cells.NumberOfCells());
  for (int p = 0; p < static_cast<int>(m_Cells.passages.size()); ++p)
  {
    if (pieces.Join(m_Cells.passages[p].a, m_Cells.passages[p].b))
    {
      this->AddLink(p);
    }
  }
}

double
CellTree::Length(int passage) const
{
  const CellPassage & p = m_Cells.passages[passage];
  return (m_Cells.positions[p.a] - m_Cells.positions[p.b]).norm();
}

void
CellTree::AddLink(int passage)
{
  const CellPassage & p = m_Cells.passages[passage];
  m_Links[p.a].push_back({ p.b, passage, this->Length(passage) });
  m_Links[p.b].push_back({ p.a, passage, this->Length(passage) });
  m_IsInTree[passage] = 1;
}

void
CellTree::RemoveLink(int passage)
{
  for (const int cell : { m_Cells.passages[passage].a, m_Cells.passages[passage].b })
  {
    auto & links = m_Links[cell];
    links.erase(
      std::find_if(links.begin(), links.end(), [passage](const TreeLink & link) { return link.passage == passage; }));
  }
  m_IsInTree[passage] = 0;
}

double
CellTree::LeastGain(int passage) const
{
  return leastGain + gainOfWide * std::max(0.0, m_Cells.passages[passage].clearance - usualHole);
}

TreeWalk
CellTree::WalkFrom(int cell) const
{
  TreeWalk walk(m_Links.size());
  walk.Visit(m_Links, cell);
  return walk;
}

TreeWalk
CellTree::WalkAll() const
{
  TreeWalk walk(m_Links.size());
  for (int cell = 0; cell < static_cast<int>(m_Links.size()); ++cell)
  {
    if (walk.depth[cell] < 0)
    {
      walk.Visit(m_Links, cell);
    }
  }
  return walk;
}

int
CellTree::FarthestCore(const TreeWalk & walk) const
{
  int farthest = walk.order.front();
  for (const int cell : walk.order)
  {
    if (m_Cells.radii[cell] >= m_CoreRadius && walk.length[cell] > walk.length[farthest])
    {
      farthest = cell;
    }
  }
  return farthest;
}

std::array<int, 2>
CellTree::Ends(int member) const
{
  const int first = this->FarthestCore(this->WalkFrom(member));
  return { first, this->FarthestCore(this->WalkFrom(first)) };
}

std::vector<int>
CellTree::Groups() const
{
  const TreeWalk   walk = this->WalkAll();
  std::vector<int> groups(m_Links.size(), -1);
  for (const int cell : walk.order)
  {
    groups[cell] = walk.parent[cell] < 0 ? cell : groups[walk.parent[cell]];
  }
  return groups;
}

std::vector<int>
CellTree::Way(int from, int to) const
{
  const TreeWalk   walk = this->WalkFrom(to);
  std::vector<int> way;
  for (int cell = from; cell >= 0; cell = walk.parent[cell])
  {
    way.push_back(cell);
  }
  return way;
}

double
CellTree::SideBranches(const std::vector<int> & way, double area) const
{
  std::vector<int> place(m_Links.size(), -1);
  for (int i = 0; i < static_cast<int>(way.size()); ++i)
  {
    place[way[i]] = i;
  }
  const TreeWalk      walk = this->WalkFrom(way.front());
  std::vector<double> longest(way.size(), 0.0);
  std::vector<double> volumes(way.size(), 0.0);
  for (const int cell : walk.order)
  {
    place[cell] = place[cell] < 0 ? place[walk.parent[cell]] : place[cell];
    const int    stem = way[place[cell]];
    const double beyond = walk.length[cell] - walk.length[stem] - m_Cells.radii[stem];
    if (m_Cells.radii[cell] >= m_CoreRadius)
    {
      longest[place[cell]] = std::max(longest[place[cell]], beyond - m_Cells.radii[stem]);
    }
    volumes[place[cell]] += beyond > besideWay + 0.5 * m_Cells.radii[stem] ? m_Cells.volumes[cell] : 0.0;
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < way.size(); ++i)
  {
    const double length = longest[i] > shortestBranch ? longest[i] : 0.0;
    sum += std::max(length, volumes[i] > smallestBranch ? volumes[i] / area : 0.0);
  }
  return sum;
}

double
CellTree::WidestOnWay(const std::vector<int> & way, int i, int direction) const
{
  const int last = static_cast<int>(way.size()) - 1;
  double    widest = m_Cells.radii[way[i]];
  double    passed = 0.0;
  for (int next = i + direction; next >= 0 && next <= last; next += direction)
  {
    passed += (m_Cells.positions[way[next]] - m_Cells.positions[way[next - direction]]).norm();
    if (passed > holeReach)
    {
      break;
    }
    widest = std::max(widest, m_Cells.radii[way[next]]);
  }
  return widest;
}

double
CellTree::Holes(const std::vector<int> & way) const
{
  double sum = 0.0;
  double most = 0.0;
  for (int i = 1; i < static_cast<int>(way.size()); ++i)
  {
    const auto & links = m_Links[way[i]];
    const auto   link =
      std::find_if(links.begin(), links.end(), [&](const TreeLink & found) { return found.cell == way[i - 1]; });
    const double width = std::min(this->WidestOnWay(way, i - 1, -1), this->WidestOnWay(way, i, 1));
    const double likeness = 1.0 - m_Cells.passages[link->passage].clearance / (leastOpening * width);
    // A hole may be crossed by several consecutive passages: count it once.
    sum += std::max(0.0, likeness - most);
    most = likeness > 0.0 ? std::max(most, likeness) : 0.0;
  }
  return sum;
}

std::vector<CellTree::Neck>
CellTree::Necks() const
{
  const TreeWalk         walk = this->WalkAll();
  const std::vector<int> groups = this->Groups();
  std::vector<double>    beyond = m_Cells.volumes;
  for (auto cell = walk.order.rbegin(); cell != walk.order.rend(); ++cell)
  {
    if (walk.parent[*cell] >= 0)
    {
      beyond[walk.parent[*cell]] += beyond[*cell];
    }
  }
  std::vector<Neck> necks;
  for (const int cell : walk.order)
  {
    const int passage = walk.passage[cell];
    if (passage >= 0 && m_Cells.passages[passage].clearance <= widestHole)
    {
      necks.push_back({ passage, std::min(beyond[cell], beyond[groups[cell]] - beyond[cell]) });
    }
  }
  return necks;
}

TreeRing
CellTree::Ring(const TreeWalk & all, int passage) const
{
  TreeRing ring{ { m_Cells.passages[passage].a }, {}, {} };
  TreeRing back{ { m_Cells.passages[passage].b }, {}, {} };
  while (ring.cells.back() != back.cells.back())
  {
    TreeRing & deeper = all.depth[ring.cells.back()] >= all.depth[back.cells.back()] ? ring : back;
    const int  cell = deeper.cells.back();
    const int  parent = all.parent[cell];
    if (parent < 0)
    {
      return {};
    }
    deeper.cells.push_back(parent);
    deeper.passages.push_back(all.passage[cell]);
    deeper.lengths.push_back(this->Length(all.passage[cell]));
  }
  ring.cells.insert(ring.cells.end(), back.cells.rbegin() + 1, back.cells.rend());
  ring.passages.insert(ring.passages.end(), back.passages.rbegin(), back.passages.rend());
  ring.lengths.insert(ring.lengths.end(), back.lengths.rbegin(), back.lengths.rend());
  return ring;
}

bool
CellTree::IsLongRing(const TreeRing & ring, int passage) const
{
  double widest = 0.0;
  for (const int cell : ring.cells)
  {
    widest = std::max(widest, m_Cells.radii[cell]);
  }
  return ring.Length() > shortRing + ringRadii * widest + this->Length(passage);
}

CellTree::Swap
CellTree::BestSwap(int in, const TreeRing & ring, const TreeReach & reach) const
{
  const double              before = reach.LongestWay(m_Cells.passages[in].a);
  const std::vector<double> ways = reach.LongestWaysWithout(ring, this->Length(in));
  Swap                      best{ in, -1, 0.0 };
  for (std::size_t i = 0; i < ways.size(); ++i)
  {
    const int    out = ring.passages[i];
    const double surplus = ways[i] - before - this->LeastGain(out);
    const double clearance = m_Cells.passages[out].clearance;
    // Close the hole between two branches at its narrowest passage.
    const bool isNarrower = best.out >= 0 && clearance < m_Cells.passages[best.out].clearance;
    if (clearance <= widestHole && surplus > best.surplus + (isNarrower ? -sameLength : sameLength))
    {
      best = { in, out, surplus };
    }
  }
  return best;
}

bool
CellTree::Exchange()
{
  const TreeWalk    all = this->WalkAll();
  std::vector<char> isCore;
  for (const double radius : m_Cells.radii)
  {
    isCore.push_back(radius >= m_CoreRadius ? 1 : 0);
  }
  const TreeReach reach(m_Links, all, isCore);
  Swap            best{ -1, -1, 0.0 };
  for (int p = 0; p < static_cast<int>(m_Cells.passages.size()); ++p)
  {
    if (m_IsInTree[p] || m_Cells.passages[p].clearance > widestHole)
    {
      continue;
    }
    Interruption::Check();
    const TreeRing ring = this->Ring(all, p);
    if (this->IsLongRing(ring, p))
    {
      const Swap swap = this->BestSwap(p, ring, reach);
      best = swap.surplus > best.surplus + sameLength ? swap : best;
    }
  }
  if (best.out < 0)
  {
    return false;
  }
  this->RemoveLink(best.out);
  this->AddLink(best.in);
  return true;
}

void
CellTree::SortOut()
{
  const TreeWalk         all = this->WalkAll();
  const std::vector<int> groups = this->Groups();
  m_Open.assign(m_Cells.NumberOfCells(), {});
  m_Merges.clear();
  for (int p = 0; p < static_cast<int>(m_Cells.passages.size()); ++p)
  {
    const CellPassage & passage = m_Cells.passages[p];
    if (!m_IsInTree[p])
    {
      const TreeRing ring = this->Ring(all, p);
      if (groups[passage.a] != groups[passage.b] || this->IsLongRing(ring, p))
      {
        m_Merges.push_back({ p, ring.Length() });
        continue;
      }
    }
    m_Open[passage.a].push_back(passage.b);
    m_Open[passage.b].push_back(passage.a);
  }
  for (auto & cells : m_Open)
  {
    std::sort(cells.begin(), cells.end());
  }
}

bool
CellTree::IsOpen(int a, int b) const
{
  return std::binary_search(m_Open[a].begin(), m_Open[a].end(), b);
}
} // namespace shapeton
