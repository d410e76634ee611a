#include "shapetonShortTransport.h"

#include <algorithm>
#include <deque>
#include <limits>

namespace shapeton
{
namespace
{
// Nodes of the network; supplies and demands follow.
constexpr int Source = 0;
constexpr int Sink = 1;
constexpr int Hub = 2;
constexpr int FirstSupply = 3;

constexpr int          LongestDistance = 3; // between neighbors of adjacent nodes
constexpr std::int64_t Unlimited =
  std::numeric_limits<std::int64_t>::max() / 4; // a capacity whose sums do not overflow
} // namespace

void
ShortTransport::Join(int from, int to, int cost, std::int64_t room)
{
  m_Out[from].push_back(static_cast<int>(m_Arcs.size()));
  m_Arcs.push_back({ to, cost, room });
  m_Out[to].push_back(static_cast<int>(m_Arcs.size()));
  m_Arcs.push_back({ from, -cost, 0 });
}

/** Marks the neighbors of a node with a new number. */
int
ShortTransport::MarkNeighbors(int node)
{
  const int mark = m_LastMark++;
  for (const auto * near = m_Lists.Begin(node); near != m_Lists.End(node); ++near)
  {
    m_Marks[near->node] = mark;
  }
  return mark;
}

/** Distance of another node from the node whose neighbors have this mark, if it is at most 3. */
int
ShortTransport::DistanceFromMark(int mark, int node) const
{
  const auto isNear = [&](const NeighborLists::Neighbor & n) { return m_Marks[n.node] == mark; };
  return m_Marks[node] == mark ? 1 : std::any_of(m_Lists.Begin(node), m_Lists.End(node), isNear) ? 2 : LongestDistance;
}

/** Cost of the only possible transport if all mass comes from, or goes to, one node. This covers leaves, including
 * those of large hubs. */
std::int64_t
ShortTransport::CostFrom(const NodeMass & single, const std::vector<NodeMass> & others)
{
  const int    mark = this->MarkNeighbors(single.node);
  std::int64_t cost = 0;
  for (const NodeMass & other : others)
  {
    cost += other.mass * this->DistanceFromMark(mark, other.node);
  }
  return cost;
}

void
ShortTransport::Build(const MassTransfer & transfer)
{
  const int supplies = static_cast<int>(transfer.supplies.size());
  const int firstDemand = FirstSupply + supplies;
  m_Arcs.clear();
  m_Out.assign(firstDemand + transfer.demands.size(), {});
  for (std::size_t d = 0; d < transfer.demands.size(); ++d)
  {
    const int node = firstDemand + static_cast<int>(d);
    this->Join(node, Sink, 0, transfer.demands[d].mass);
    this->Join(Hub, node, 0, Unlimited);
  }
  for (int s = 0; s < supplies; ++s)
  {
    const int from = transfer.supplies[s].node;
    this->Join(Source, FirstSupply + s, 0, transfer.supplies[s].mass);
    this->Join(FirstSupply + s, Hub, LongestDistance, Unlimited);
    const int mark = this->MarkNeighbors(from);
    for (std::size_t d = 0; d < transfer.demands.size(); ++d)
    {
      const int distance = this->DistanceFromMark(mark, transfer.demands[d].node);
      if (distance < LongestDistance)
      {
        this->Join(FirstSupply + s, firstDemand + static_cast<int>(d), distance, Unlimited);
      }
    }
  }
}

/** Lengths of shortest residual paths from the source (Bellman and Ford); returns the length to the sink. */
int
ShortTransport::FindDistances()
{
  constexpr int     far = std::numeric_limits<int>::max() / 2;
  std::vector<char> isQueued(m_Out.size(), 0);
  std::deque<int>   queue{ Source };
  m_Distances.assign(m_Out.size(), far);
  m_Distances[Source] = 0;
  while (!queue.empty())
  {
    const int node = queue.front();
    queue.pop_front();
    isQueued[node] = 0;
    for (const int i : m_Out[node])
    {
      const Arc & arc = m_Arcs[i];
      const int   length = m_Distances[node] + arc.cost;
      if (arc.room > 0 && length < m_Distances[arc.to])
      {
        m_Distances[arc.to] = length;
        if (isQueued[arc.to] == 0)
        {
          isQueued[arc.to] = 1;
          queue.push_back(arc.to);
        }
      }
    }
  }
  return m_Distances[Sink];
}

/** Levels of nodes along arcs of shortest paths; returns whether the sink is reached. */
bool
ShortTransport::FindLevels()
{
  m_Levels.assign(m_Out.size(), -1);
  m_Levels[Source] = 0;
  std::vector<int> queue{ Source };
  for (std::size_t k = 0; k < queue.size(); ++k)
  {
    const int node = queue[k];
    for (const int i : m_Out[node])
    {
      const Arc & arc = m_Arcs[i];
      if (arc.room > 0 && m_Levels[arc.to] < 0 && m_Distances[arc.to] == m_Distances[node] + arc.cost)
      {
        m_Levels[arc.to] = m_Levels[node] + 1;
        queue.push_back(arc.to);
      }
    }
  }
  return m_Levels[Sink] >= 0;
}

std::int64_t
ShortTransport::Push(int node, std::int64_t most)
{
  if (node == Sink)
  {
    return most;
  }
  for (; m_Next[node] < m_Out[node].size(); ++m_Next[node])
  {
    const int i = m_Out[node][m_Next[node]];
    Arc &     arc = m_Arcs[i];
    if (arc.room <= 0 || m_Levels[arc.to] != m_Levels[node] + 1 || m_Distances[arc.to] != m_Distances[node] + arc.cost)
    {
      continue;
    }
    const std::int64_t pushed = this->Push(arc.to, std::min(most, arc.room));
    if (pushed > 0)
    {
      arc.room -= pushed;
      m_Arcs[i ^ 1].room += pushed;
      return pushed;
    }
  }
  return 0;
}

std::int64_t
ShortTransport::MaximumFlow()
{
  std::int64_t flow = 0;
  while (this->FindLevels())
  {
    m_Next.assign(m_Out.size(), 0);
    while (const std::int64_t pushed = this->Push(Source, Unlimited))
    {
      flow += pushed;
    }
  }
  return flow;
}

std::int64_t
ShortTransport::Cost(const MassTransfer & transfer)
{
  if (transfer.supplies.size() == 1 || transfer.demands.size() == 1)
  {
    const bool isFromOne = transfer.supplies.size() == 1;
    return this->CostFrom((isFromOne ? transfer.supplies : transfer.demands).front(),
                          isFromOne ? transfer.demands : transfer.supplies);
  }
  std::int64_t rest = 0;
  for (const NodeMass & supply : transfer.supplies)
  {
    rest += supply.mass;
  }
  this->Build(transfer);
  std::int64_t cost = 0;
  while (rest > 0)
  {
    const int length = this->FindDistances();
    if (length >= LongestDistance)
    {
      break;
    }
    const std::int64_t flow = this->MaximumFlow();
    cost += length * flow;
    rest -= flow;
  }
  return cost + LongestDistance * rest;
}
} // namespace shapeton
