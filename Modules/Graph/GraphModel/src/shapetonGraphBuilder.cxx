#include "shapetonGraphBuilder.h"

namespace shapeton
{
namespace
{
// Larger drawings are illegible, and DOT subgraphs can multiply the number of edges.
constexpr std::size_t MostEdges = 100000000;
constexpr int         MostNodes = 10000000;
} // namespace

int
GraphBuilder::Append(std::string_view name)
{
  const int node = m_Graph.nodes++;
  m_Graph.names.emplace_back(name);
  m_Nodes.emplace(name, node);
  return node;
}

void
GraphBuilder::AddNode(std::string_view name, int line)
{
  if (this->HasNode(name))
  {
    m_Text.Refuse(line, "the node " + Quoted(name) + " is declared twice", "use a unique id for each node");
  }
  this->Append(name);
}

bool
GraphBuilder::HasNode(std::string_view name) const
{
  return m_Nodes.find(std::string(name)) != m_Nodes.end();
}

int
GraphBuilder::NodeOf(std::string_view name)
{
  const auto found = m_Nodes.find(std::string(name));
  return found != m_Nodes.end() ? found->second : this->Append(name);
}

int
GraphBuilder::DeclaredNode(std::string_view name, int line) const
{
  const auto found = m_Nodes.find(std::string(name));
  if (found == m_Nodes.end())
  {
    m_Text.Refuse(line,
                  "an edge refers to the node " + Quoted(name) + ", which is not declared",
                  "declare the node or correct the edge");
  }
  return found->second;
}

void
GraphBuilder::AddEdge(int first, int second, int line)
{
  m_Text.Require(
    m_Graph.edges.size() < MostEdges, line, "the graph has more than 100 million edges", "use a part of it");
  m_Graph.edges.push_back({ first, second });
}

Graph
GraphBuilder::Take()
{
  m_Text.Require(m_Graph.nodes > 0, 0, "the graph has no nodes", "use a graph with at least one node");
  return std::move(m_Graph);
}

NumberedGraphBuilder::NumberedGraphBuilder(const GraphText & text, int nodes, int line, int firstName)
  : m_FirstName(firstName)
{
  text.Require(nodes > 0, line, "the graph has no nodes", "use a graph with at least one node");
  if (nodes > MostNodes)
  {
    text.Refuse(line,
                "the graph has " + std::to_string(nodes) + " nodes, more than 10 million",
                "correct the number or use a part of the graph");
  }
  m_Graph.nodes = nodes;
}

Graph
NumberedGraphBuilder::Take()
{
  m_Graph.names.reserve(m_Graph.nodes);
  for (int node = 0; node < m_Graph.nodes; ++node)
  {
    m_Graph.names.push_back(std::to_string(node + m_FirstName));
  }
  return std::move(m_Graph);
}
} // namespace shapeton
