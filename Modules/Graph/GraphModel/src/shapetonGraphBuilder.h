#ifndef shapetonGraphBuilder_h
#define shapetonGraphBuilder_h

#include "shapetonGraph.h"
#include "shapetonGraphText.h"

#include <string_view>
#include <unordered_map>

namespace shapeton
{
/** Builds a graph from node names and edges between names. */
class GraphBuilder
{
public:
  explicit GraphBuilder(const GraphText & text) : m_Text(text) {}

  /** Declares a node; rejects a duplicate name. */
  void
  AddNode(std::string_view name, int line);

  /** The node with this name, created if necessary. */
  int
  NodeOf(std::string_view name);

  /** The node with this name; rejects an undeclared name. */
  int
  DeclaredNode(std::string_view name, int line) const;

  bool
  HasNode(std::string_view name) const;

  void
  AddEdge(int first, int second, int line);

  std::size_t
  Edges() const
  {
    return m_Graph.edges.size();
  }

  /** The graph; rejects a graph without nodes. */
  Graph
  Take();

private:
  int
  Append(std::string_view name);

  const GraphText &                    m_Text;
  Graph                                m_Graph;
  std::unordered_map<std::string, int> m_Nodes;
};

/** Builds a graph with nodes 1 ... n, for numeric formats. */
class NumberedGraphBuilder
{
public:
  /** Rejects a number of nodes outside [1, 10 million]. `firstName` is the name of node 0. */
  NumberedGraphBuilder(const GraphText & text, int nodes, int line, int firstName = 1);

  /** `first` and `second` in [0, nodes). */
  void
  AddEdge(int first, int second)
  {
    m_Graph.edges.push_back({ first, second });
  }

  int
  Nodes() const
  {
    return m_Graph.nodes;
  }
  std::size_t
  Edges() const
  {
    return m_Graph.edges.size();
  }

  /** The graph, with the node numbers of the file as names. */
  Graph
  Take();

private:
  Graph m_Graph;
  int   m_FirstName;
};
} // namespace shapeton

#endif
