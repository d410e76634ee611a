#include "shapetonDummyColumns.h"

namespace shapeton
{
namespace
{
/** Number of dummies of a column. Chosen: mean displacements of two outages of a power grid are 0.009, 0.002, 0.001,
 * 0.0004 and 0.0001 for 0, 3, 6, 12 and 24. */
constexpr int lengthOfColumn = 12;

/** Builds the map edge by edge, and its rotation from that of the old map. */
class ColumnBuilder
{
public:
  ColumnBuilder(const Graph & graph, const PackedMap & packed, const std::vector<char> & isDeleted)
    : m_Packed(packed), m_First(packed.map.HalfEdges()), m_IsPath(packed.map.Edges(), 0)
  {
    m_Result.graph = { graph.nodes, {}, graph.names };
    m_Map.nodes = packed.map.Nodes();
    for (const std::vector<int> & path : packed.subdivided)
    {
      m_IsPath[path.front() / 2] = 1;
    }
    for (int e = 0; e < packed.map.Edges(); ++e)
    {
      const bool isOfGraph = e < packed.graphEdges;
      m_IsColumn.push_back(isOfGraph && isDeleted[e] != 0 && m_IsPath[e] == 0);
      if (!m_IsColumn[e])
      {
        this->Keep(e);
        if (isOfGraph)
        {
          m_Result.graph.edges.push_back(graph.edges[e]);
        }
      }
    }
    m_Rotation.resize(packed.map.Nodes());
  }

  PackedGraph
  Build()
  {
    for (int e = 0; e < m_Packed.map.Edges(); ++e)
    {
      if (m_IsColumn[e])
      {
        this->AddColumn(e);
      }
    }
    for (int node = 0; node < m_Packed.map.Nodes(); ++node)
    {
      for (const int h : m_Packed.map.Around(node))
      {
        m_Rotation[node].insert(m_Rotation[node].end(), m_First[h].begin(), m_First[h].end());
      }
    }
    PackedMap & packed = m_Result.packed;
    packed.map = CombinatorialMap(m_Map, m_Rotation);
    packed.graphNodes = m_Packed.graphNodes;
    packed.graphEdges = static_cast<int>(m_Result.graph.edges.size());
    packed.rings = m_Packed.rings;
    for (const std::vector<int> & path : m_Packed.subdivided)
    {
      packed.subdivided.emplace_back();
      for (const int h : path)
      {
        packed.subdivided.back().push_back(m_First[h].front());
      }
    }
    return std::move(m_Result);
  }

private:
  int
  Add(int from, int to)
  {
    m_Map.edges.push_back({ from, to });
    return static_cast<int>(2 * m_Map.edges.size()) - 2;
  }

  void
  Keep(int e)
  {
    const int h = this->Add(m_Packed.map.Node(2 * e), m_Packed.map.Node(2 * e + 1));
    m_First[2 * e] = { h };
    m_First[2 * e + 1] = { h + 1 };
  }

  /** The column is crossed from right to left, seen from the first end. */
  void
  AddColumn(int e)
  {
    const int          ends[2] = { m_Packed.map.Node(2 * e), m_Packed.map.Node(2 * e + 1) };
    std::vector<int> & ofFirst = m_First[2 * e];
    std::vector<int> & ofSecond = m_First[2 * e + 1];
    std::vector<int>   along;
    const int          start = m_Map.nodes;
    m_Map.nodes += lengthOfColumn;
    m_Rotation.resize(m_Map.nodes);
    for (int i = 0; i < lengthOfColumn; ++i)
    {
      ofFirst.push_back(this->Add(ends[0], start + i));
      ofSecond.insert(ofSecond.begin(), this->Add(ends[1], start + i));
      if (i + 1 < lengthOfColumn)
      {
        along.push_back(this->Add(start + i, start + i + 1));
      }
    }
    for (int i = 0; i < lengthOfColumn; ++i)
    {
      std::vector<int> & around = m_Rotation[start + i];
      if (i > 0)
      {
        around.push_back(along[i - 1] + 1);
      }
      around.push_back(ofSecond[lengthOfColumn - 1 - i] + 1);
      if (i + 1 < lengthOfColumn)
      {
        around.push_back(along[i]);
      }
      around.push_back(ofFirst[i] + 1);
    }
  }

  const PackedMap &             m_Packed;
  std::vector<std::vector<int>> m_First; ///< for each old half-edge, the new ones in its place
  std::vector<char>             m_IsPath;
  std::vector<char>             m_IsColumn;
  Graph                         m_Map;
  Rotation                      m_Rotation;
  PackedGraph                   m_Result;
};
} // namespace

PackedGraph
WithColumns(const Graph & graph, const PackedMap & packed, const std::vector<char> & isDeleted)
{
  return ColumnBuilder(graph, packed, isDeleted).Build();
}
} // namespace shapeton
