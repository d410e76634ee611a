#include "shapetonLeftRightPlanarity.h"

#include <algorithm>
#include <utility>

namespace shapeton
{
LeftRightPlanarity::LeftRightPlanarity(const Graph & graph, const std::vector<bool> & isUsed)
  : m_Graph(graph)
  , m_Start(graph.nodes + 1, 0)
  , m_End(graph.nodes, 0)
  , m_From(graph.edges.size(), -1)
  , m_To(graph.edges.size(), -1)
  , m_Height(graph.nodes, -1)
  , m_Parent(graph.nodes, -1)
  , m_Low(graph.edges.size(), 0)
  , m_SecondLow(graph.edges.size(), 0)
  , m_Nesting(graph.edges.size(), 0)
{
  std::size_t used = 0;
  for (std::size_t e = 0; e < isUsed.size(); ++e)
  {
    if (isUsed[e])
    {
      ++m_Start[graph.edges[e][0] + 1];
      ++m_Start[graph.edges[e][1] + 1];
      ++used;
    }
  }
  for (int v = 0; v < graph.nodes; ++v)
  {
    m_Start[v + 1] += m_Start[v];
  }
  m_Edges.resize(2 * used);
  m_Place.assign(m_Start.begin(), m_Start.end() - 1);
  for (std::size_t e = 0; e < isUsed.size(); ++e)
  {
    if (isUsed[e])
    {
      m_Edges[m_Place[graph.edges[e][0]]++] = static_cast<int>(e);
      m_Edges[m_Place[graph.edges[e][1]]++] = static_cast<int>(e);
    }
  }
  if (graph.nodes > 2 && used > 3 * static_cast<std::size_t>(graph.nodes) - 6)
  {
    m_IsPlanar = false;
    return;
  }
  Orient();
  SortLeaving();
  m_Reference.assign(graph.edges.size(), -1);
  m_Side.assign(graph.edges.size(), 1);
  m_LowEdge.assign(graph.edges.size(), -1);
  m_StackBottom.assign(graph.edges.size(), 0);
  m_IsPlanar = std::all_of(m_Roots.begin(), m_Roots.end(), [this](int root) { return TestFrom(root); });
}

// ---- orientation ----

void
LeftRightPlanarity::Orient()
{
  m_Place.assign(m_Start.begin(), m_Start.end() - 1);
  for (int v = 0; v < m_Graph.nodes; ++v)
  {
    if (m_Height[v] < 0)
    {
      m_Height[v] = 0;
      m_Roots.push_back(v);
      OrientFrom(v);
    }
  }
}

void
LeftRightPlanarity::OrientFrom(int root)
{
  int node = root;
  for (;;)
  {
    if (m_Place[node] == m_Start[node + 1])
    {
      if (node == root)
      {
        return;
      }
      const int edge = m_Parent[node];
      node = m_From[edge];
      FinishOriented(edge);
      continue;
    }
    const int edge = m_Edges[m_Place[node]++];
    if (m_From[edge] >= 0)
    {
      continue; // visited from the other end
    }
    const int other = m_Graph.edges[edge][0] == node ? m_Graph.edges[edge][1] : m_Graph.edges[edge][0];
    m_From[edge] = node;
    m_To[edge] = other;
    m_Low[edge] = m_SecondLow[edge] = m_Height[node];
    if (m_Height[other] < 0)
    {
      m_Parent[other] = edge;
      m_Height[other] = m_Height[node] + 1;
      node = other;
    }
    else
    {
      m_Low[edge] = m_Height[other];
      FinishOriented(edge);
    }
  }
}

/** Nesting order, and the return points of the parent edge. */
void
LeftRightPlanarity::FinishOriented(int edge)
{
  const int node = m_From[edge];
  const int parent = m_Parent[node];
  m_Nesting[edge] = 2 * m_Low[edge] + (m_SecondLow[edge] < m_Height[node] ? 1 : 0);
  if (parent < 0)
  {
    return;
  }
  if (m_Low[edge] < m_Low[parent])
  {
    m_SecondLow[parent] = std::min(m_Low[parent], m_SecondLow[edge]);
    m_Low[parent] = m_Low[edge];
  }
  else if (m_Low[edge] > m_Low[parent])
  {
    m_SecondLow[parent] = std::min(m_SecondLow[parent], m_Low[edge]);
  }
  else
  {
    m_SecondLow[parent] = std::min(m_SecondLow[parent], m_SecondLow[edge]);
  }
}

/** Keeps in m_Edges the edges that leave each node, in nesting order. */
void
LeftRightPlanarity::SortLeaving()
{
  for (int v = 0; v < m_Graph.nodes; ++v)
  {
    const auto first = m_Edges.begin() + m_Start[v];
    const auto last =
      std::partition(first, m_Edges.begin() + m_Start[v + 1], [&](int edge) { return m_From[edge] == v; });
    std::sort(
      first, last, [this](int a, int b) { return std::make_pair(m_Nesting[a], a) < std::make_pair(m_Nesting[b], b); });
    m_End[v] = static_cast<int>(last - m_Edges.begin());
    m_Place[v] = m_Start[v];
  }
}

// ---- test ----

bool
LeftRightPlanarity::IsConflicting(const Interval & interval, int edge) const
{
  return !interval.IsEmpty() && m_Low[interval.high] > m_Low[edge];
}

int
LeftRightPlanarity::LowestOf(const ConflictPair & pair) const
{
  if (pair.left.IsEmpty())
  {
    return m_Low[pair.right.low];
  }
  if (pair.right.IsEmpty())
  {
    return m_Low[pair.left.low];
  }
  return std::min(m_Low[pair.left.low], m_Low[pair.right.low]);
}

bool
LeftRightPlanarity::TestFrom(int root)
{
  int node = root;
  for (;;)
  {
    if (m_Place[node] == m_End[node])
    {
      if (node == root)
      {
        return true;
      }
      const int edge = m_Parent[node];
      RemoveBackEdges(edge);
      node = m_From[edge];
      if (!FinishTested(edge, m_Place[node]++))
      {
        return false;
      }
      continue;
    }
    const int edge = m_Edges[m_Place[node]];
    m_StackBottom[edge] = static_cast<int>(m_Stack.size());
    if (m_Parent[m_To[edge]] == edge)
    {
      node = m_To[edge];
      continue;
    }
    m_LowEdge[edge] = edge;
    m_Stack.push_back({ {}, { edge, edge } });
    if (!FinishTested(edge, m_Place[node]++))
    {
      return false;
    }
  }
}

/** Merges the return edges of an edge into those of earlier edges at the node; `position` is the position of the edge.
 */
bool
LeftRightPlanarity::FinishTested(int edge, int position)
{
  const int node = m_From[edge];
  const int parent = m_Parent[node];
  if (m_Low[edge] >= m_Height[node])
  {
    return true;
  }
  if (position == m_Start[node])
  {
    m_LowEdge[parent] = m_LowEdge[edge];
    return true;
  }
  return AddConstraints(edge, parent);
}

bool
LeftRightPlanarity::AddConstraints(int edge, int parent)
{
  ConflictPair merged;
  if (!MergeReturnEdges(edge, parent, merged) || !MergeConflicting(edge, merged))
  {
    return false;
  }
  if (!merged.left.IsEmpty() || !merged.right.IsEmpty())
  {
    m_Stack.push_back(merged);
  }
  return true;
}

/** All return edges of the edge are on one side. */
bool
LeftRightPlanarity::MergeReturnEdges(int edge, int parent, ConflictPair & merged)
{
  do
  {
    ConflictPair pair = m_Stack.back();
    m_Stack.pop_back();
    if (!pair.left.IsEmpty())
    {
      std::swap(pair.left, pair.right);
    }
    if (!pair.left.IsEmpty())
    {
      return false;
    }
    if (m_Low[pair.right.low] > m_Low[parent])
    {
      if (merged.right.IsEmpty())
      {
        merged.right.high = pair.right.high;
      }
      else
      {
        m_Reference[merged.right.low] = pair.right.high;
      }
      merged.right.low = pair.right.low;
    }
    else
    {
      m_Reference[pair.right.low] = m_LowEdge[parent];
    }
  } while (static_cast<int>(m_Stack.size()) != m_StackBottom[edge]);
  return true;
}

/** Return edges of earlier edges that end above the lowest return point of this one are on the other side. */
bool
LeftRightPlanarity::MergeConflicting(int edge, ConflictPair & merged)
{
  while (!m_Stack.empty() && (IsConflicting(m_Stack.back().left, edge) || IsConflicting(m_Stack.back().right, edge)))
  {
    ConflictPair pair = m_Stack.back();
    m_Stack.pop_back();
    if (IsConflicting(pair.right, edge))
    {
      std::swap(pair.left, pair.right);
    }
    if (IsConflicting(pair.right, edge))
    {
      return false;
    }
    if (merged.right.low >= 0)
    {
      m_Reference[merged.right.low] = pair.right.high;
    }
    if (pair.right.low >= 0)
    {
      merged.right.low = pair.right.low;
    }
    if (merged.left.IsEmpty())
    {
      merged.left.high = pair.left.high;
    }
    else
    {
      m_Reference[merged.left.low] = pair.left.high;
    }
    merged.left.low = pair.left.low;
  }
  return true;
}

/** Trims return edges to the node from the top of an interval. */
void
LeftRightPlanarity::Trim(Interval & trimmed, const Interval & other, int node)
{
  while (trimmed.high >= 0 && m_To[trimmed.high] == node)
  {
    trimmed.high = m_Reference[trimmed.high];
  }
  if (trimmed.high < 0 && trimmed.low >= 0)
  {
    m_Reference[trimmed.low] = other.low;
    m_Side[trimmed.low] = -1;
    trimmed.low = -1;
  }
}

/** Removes return edges that end at the start of the tree edge. */
void
LeftRightPlanarity::RemoveBackEdges(int edge)
{
  const int node = m_From[edge];
  while (!m_Stack.empty() && LowestOf(m_Stack.back()) == m_Height[node])
  {
    if (const int low = m_Stack.back().left.low; low >= 0)
    {
      m_Side[low] = -1;
    }
    m_Stack.pop_back();
  }
  if (!m_Stack.empty())
  {
    ConflictPair & pair = m_Stack.back();
    Trim(pair.left, pair.right, node);
    Trim(pair.right, pair.left, node);
  }
  if (m_Low[edge] < m_Height[node])
  {
    const int left = m_Stack.back().left.high;
    const int right = m_Stack.back().right.high;
    m_Reference[edge] = left >= 0 && (right < 0 || m_Low[left] > m_Low[right]) ? left : right;
  }
}

// ---- embedding ----

/** Node orders that can be traversed in both directions. */
class LeftRightPlanarity::EdgeOrders
{
public:
  explicit EdgeOrders(std::vector<int> & next) : m_Next(next), m_Previous(next.size(), -1) {}

  /** -1 starts an order. */
  void
  InsertAfter(int halfEdge, int after)
  {
    const int previous = after < 0 ? halfEdge : after;
    const int following = after < 0 ? halfEdge : m_Next[after];
    m_Next[previous] = halfEdge;
    m_Next[halfEdge] = following;
    m_Previous[following] = halfEdge;
    m_Previous[halfEdge] = previous;
  }
  int
  Before(int halfEdge) const
  {
    return m_Previous[halfEdge];
  }

private:
  std::vector<int> & m_Next;
  std::vector<int>   m_Previous;
};

/** Resolves the side of an edge relative to its chain of references, without recursion. */
int
LeftRightPlanarity::SideOf(int edge)
{
  std::vector<int> & chain = m_StackBottom; // reused to store the way back
  int                last = -1;
  while (m_Reference[edge] >= 0)
  {
    chain[edge] = last;
    last = edge;
    edge = m_Reference[edge];
  }
  while (last >= 0)
  {
    m_Side[last] *= m_Side[edge];
    m_Reference[last] = -1;
    edge = last;
    last = chain[last];
  }
  return m_Side[edge];
}

int
LeftRightPlanarity::LeavingHalfEdge(int edge) const
{
  return 2 * edge + (m_Graph.edges[edge][0] == m_From[edge] ? 0 : 1);
}

void
LeftRightPlanarity::WriteNextAround(std::vector<int> & next)
{
  for (const int edge : m_Edges)
  {
    if (m_Reference[edge] >= 0)
    {
      SideOf(edge);
    }
  }
  for (int v = 0; v < m_Graph.nodes; ++v)
  {
    for (int i = m_Start[v]; i < m_End[v]; ++i)
    {
      m_Nesting[m_Edges[i]] *= m_Side[m_Edges[i]];
    }
  }
  SortLeaving();
  m_LeftOf.assign(m_Graph.nodes, -1);
  m_RightOf.assign(m_Graph.nodes, -1);
  EdgeOrders orders(next);
  LinkLeaving(orders);
  for (const int root : m_Roots)
  {
    EmbedFrom(root, orders);
  }
}

/** Leaving edges around each node, in their order. */
void
LeftRightPlanarity::LinkLeaving(EdgeOrders & orders) const
{
  for (int v = 0; v < m_Graph.nodes; ++v)
  {
    int last = -1;
    for (int i = m_Start[v]; i < m_End[v]; ++i)
    {
      const int halfEdge = LeavingHalfEdge(m_Edges[i]);
      orders.InsertAfter(halfEdge, last);
      last = halfEdge;
    }
  }
}

/** The tree edge to a node precedes its leaving edges. A back edge to it is placed next to the tree edge of the subtree
 * that it returns from, outside earlier ones. */
void
LeftRightPlanarity::EmbedFrom(int root, EdgeOrders & orders)
{
  int node = root;
  for (;;)
  {
    if (m_Place[node] == m_End[node])
    {
      if (node == root)
      {
        return;
      }
      node = m_From[m_Parent[node]];
      continue;
    }
    const int edge = m_Edges[m_Place[node]++];
    const int leaving = LeavingHalfEdge(edge);
    const int target = m_To[edge];
    if (m_Parent[target] == edge)
    {
      const int lastOfTarget = m_End[target] > m_Start[target] ? LeavingHalfEdge(m_Edges[m_End[target] - 1]) : -1;
      orders.InsertAfter(leaving ^ 1, lastOfTarget);
      m_LeftOf[node] = m_RightOf[node] = leaving;
      node = target;
    }
    else if (m_Side[edge] == 1)
    {
      orders.InsertAfter(leaving ^ 1, m_RightOf[target]);
    }
    else
    {
      orders.InsertAfter(leaving ^ 1, orders.Before(m_LeftOf[target]));
      m_LeftOf[target] = leaving ^ 1;
    }
  }
}
} // namespace shapeton
