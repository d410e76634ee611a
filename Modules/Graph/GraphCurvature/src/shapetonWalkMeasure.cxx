#include "shapetonWalkMeasure.h"

#include "shapetonExceptions.h"
#include "shapetonNumberText.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace shapeton
{
Fraction
SimplestFraction(double value, const std::string & parameter)
{
  constexpr double      most = 2147483648.0; // 2^31
  constexpr long double one = 1.0L;
  Fraction              before{ 1, 0 };
  Fraction              fraction{ 0, 1 };
  long double           rest = value; // the remaining continued fraction; long double keeps its terms exact enough
  while (static_cast<double>(fraction.numerator) / static_cast<double>(fraction.denominator) != value)
  {
    rest = one / rest;
    const auto term = static_cast<std::int64_t>(std::min<long double>(rest, most));
    rest -= static_cast<long double>(term);
    const Fraction next{ term * fraction.numerator + before.numerator,
                         term * fraction.denominator + before.denominator };
    if (static_cast<double>(next.denominator) > most || term == 0)
    {
      throw ParameterError("the parameter \"" + parameter + "\" = " + NumberText(value) +
                           " is too close to another fraction; use one with fewer digits");
    }
    before = fraction;
    fraction = next;
  }
  return fraction;
}

NeighborLists::NeighborLists(const Graph & graph) : m_Start(1, 0)
{
  const Incidence  incidence(graph);
  std::vector<int> others;
  for (int node = 0; node < graph.nodes; ++node)
  {
    others.clear();
    for (int i = incidence.start[node]; i < incidence.start[node + 1]; ++i)
    {
      const int h = incidence.halfEdges[i];
      others.push_back(graph.edges[h / 2][1 - h % 2]);
    }
    std::sort(others.begin(), others.end());
    m_Degrees.push_back(static_cast<int>(others.size()));
    m_LoopEnds.push_back(static_cast<int>(std::count(others.begin(), others.end(), node)));
    for (const int other : others)
    {
      if (other == node)
      {
        continue;
      }
      if (m_Neighbors.size() == m_Start.back() || m_Neighbors.back().node != other)
      {
        m_Neighbors.push_back({ other, 0 });
      }
      ++m_Neighbors.back().edges;
    }
    m_Start.push_back(m_Neighbors.size());
  }
}

int
NeighborLists::CommonNeighbors(int a, int b) const
{
  int              common = 0;
  const Neighbor * p = this->Begin(a);
  const Neighbor * q = this->Begin(b);
  while (p != this->End(a) && q != this->End(b))
  {
    common += p->node == q->node ? 1 : 0;
    const bool isNext = p->node <= q->node;
    q += q->node <= p->node ? 1 : 0;
    p += isNext ? 1 : 0;
  }
  return common;
}

namespace
{
std::int64_t
Product(std::int64_t a, std::int64_t b)
{
  // An arc of the transport costs at most 3; leave room for sums.
  constexpr std::int64_t room = 8;
  std::int64_t           product = 0;
  if (__builtin_mul_overflow(a, b, &product) || product > std::numeric_limits<std::int64_t>::max() / room)
  {
    throw InputError("the degrees of the graph are too large for exact transport; use an idleness with fewer digits");
  }
  return product;
}

/** Adds the walk from a node, times `sign`. */
void
AddWalk(const NeighborLists &   lists,
        int                     node,
        std::int64_t            atHome,
        std::int64_t            perHalfEdge,
        std::vector<NodeMass> & sum)
{
  sum.push_back({ node, atHome + lists.LoopEnds(node) * perHalfEdge });
  for (const auto * neighbor = lists.Begin(node); neighbor != lists.End(node); ++neighbor)
  {
    sum.push_back({ neighbor->node, neighbor->edges * perHalfEdge });
  }
}
} // namespace

MassTransfer
TransferBetween(const NeighborLists & lists, int a, int b, const Fraction & idleness)
{
  const std::int64_t degreeA = lists.Degree(a);
  const std::int64_t degreeB = lists.Degree(b);
  const std::int64_t multiple = Product(degreeA / std::gcd(degreeA, degreeB), degreeB);
  const std::int64_t active = idleness.denominator - idleness.numerator;
  MassTransfer       transfer;
  transfer.total = Product(multiple, idleness.denominator);
  std::vector<NodeMass> masses;
  AddWalk(lists, a, idleness.numerator * multiple, active * (multiple / degreeA), masses);
  AddWalk(lists, b, -idleness.numerator * multiple, -active * (multiple / degreeB), masses);
  std::sort(masses.begin(), masses.end(), [](const NodeMass & p, const NodeMass & q) { return p.node < q.node; });
  for (std::size_t i = 0; i < masses.size();)
  {
    const int    node = masses[i].node;
    std::int64_t net = 0;
    for (; i < masses.size() && masses[i].node == node; ++i)
    {
      net += masses[i].mass;
    }
    if (net != 0)
    {
      (net > 0 ? transfer.supplies : transfer.demands).push_back({ node, net > 0 ? net : -net });
    }
  }
  return transfer;
}
} // namespace shapeton
