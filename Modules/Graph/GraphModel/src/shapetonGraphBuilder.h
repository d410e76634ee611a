#ifndef shapetonGraphBuilder_h
#define shapetonGraphBuilder_h

#include "shapetonGraph.h"
#include "shapetonGraphText.h"

#include <string_view>
#include <unordered_map>

namespace shapeton
{
/** Nodes by their names, edges between names. */
class GraphBuilder
{
public:
  explicit GraphBuilder(const GraphText & text) : m_Text(text) {}

  /** Declares a node; refuses a name that has been declared. */
  void
  AddNode(std::string_view name, int line);

  /** The node of this name, made when there is none. */
  int
  NodeOf(std::string_view name);

  /** The node of this name; refuses a name that is not declared. */
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

  /** The graph; refuses one without nodes. */
  Graph
  Take();

private:
  int
  Append(std::string_view name);

  const GraphText &                    m_Text;
  Graph                                m_Graph;
  std::unordered_map<std::string, int> m_Nodes;
};

/** A graph of nodes 1 ... n, as formats of numbers have it. */
class NumberedGraphBuilder
{
public:
  /** Refuses a number of nodes that is not in [1, 10 million]. `firstName` is the name of node 0. */
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

  /** The graph with the numbers of the file as names. */
  Graph
  Take();

private:
  Graph m_Graph;
  int   m_FirstName;
};
} // namespace shapeton

#endif
