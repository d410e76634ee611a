#include "shapetonGraphBuilder.h"
#include "shapetonGraphFormat.h"

#if __has_include("itk_expat.h") // in an ITK source tree
#  include "itk_expat.h"
#else
#  include <expat.h>
#endif

#include <exception>
#include <memory>

namespace shapeton
{
namespace
{
/** expat handlers. Errors are stored until the parser returns: exceptions must not pass through a C library. */
class GraphMLReader
{
public:
  explicit GraphMLReader(const GraphText & text)
    : m_Text(text), m_Builder(text), m_Parser(XML_ParserCreateNS(nullptr, '|'), XML_ParserFree)
  {
    XML_SetUserData(m_Parser.get(), this);
    XML_SetElementHandler(m_Parser.get(), Begin, End);
  }

  Graph
  Read()
  {
    constexpr std::size_t piece = 1 << 24; // expat counts in int
    for (std::size_t start = 0; start < m_Text.bytes.size(); start += piece)
    {
      const std::size_t size = std::min(piece, m_Text.bytes.size() - start);
      const bool        isLast = start + size == m_Text.bytes.size();
      const auto        status = XML_Parse(m_Parser.get(), m_Text.bytes.data() + start, static_cast<int>(size), isLast);
      if (m_Error)
      {
        std::rethrow_exception(m_Error);
      }
      if (status != XML_STATUS_OK)
      {
        m_Text.Refuse(this->Line(),
                      std::string("the XML is not well-formed: ") + XML_ErrorString(XML_GetErrorCode(m_Parser.get())),
                      "use a complete copy of the file or correct it there");
      }
    }
    m_Text.Require(m_HasGraph, 0, "the element graph is missing", "use a GraphML file that contains a graph");
    for (const Edge & edge : m_Edges)
    {
      const int first = m_Builder.DeclaredNode(edge.source, edge.line);
      m_Builder.AddEdge(first, m_Builder.DeclaredNode(edge.target, edge.line), edge.line);
    }
    return m_Builder.Take();
  }

private:
  struct Edge
  {
    std::string source;
    std::string target;
    int         line;
  };

  static void XMLCALL
  Begin(void * self, const XML_Char * name, const XML_Char ** attributes)
  {
    auto & reader = *static_cast<GraphMLReader *>(self);
    try
    {
      reader.BeginElement(name, attributes);
    }
    catch (...)
    {
      reader.m_Error = std::current_exception();
      XML_StopParser(reader.m_Parser.get(), XML_FALSE);
    }
  }

  static void XMLCALL
  End(void * self, const XML_Char *)
  {
    --static_cast<GraphMLReader *>(self)->m_Depth;
  }

  int
  Line() const
  {
    return static_cast<int>(XML_GetCurrentLineNumber(m_Parser.get()));
  }

  static std::string
  Attribute(const XML_Char ** attributes, std::string_view name)
  {
    for (; *attributes != nullptr; attributes += 2)
    {
      if (name == *attributes)
      {
        return attributes[1];
      }
    }
    return {};
  }

  void
  BeginElement(std::string_view qualified, const XML_Char ** attributes)
  {
    const std::string_view name = qualified.substr(qualified.rfind('|') + 1);
    const int              line = this->Line();
    ++m_Depth;
    if (!(m_Depth > 1 || name == "graphml"))
    {
      m_Text.Refuse(line, "the outermost element is " + Quoted(name) + ", not graphml", "use a GraphML file");
    }
    if (name == "graph")
    {
      this->BeginGraph(attributes);
    }
    else if (name == "node" && m_HasGraph)
    {
      const std::string id = Attribute(attributes, "id");
      m_Text.Require(!id.empty(), line, "a node has no id");
      m_Builder.AddNode(id, line);
    }
    else if (name == "edge" && m_HasGraph)
    {
      this->BeginEdge(attributes);
    }
    m_Text.Require(
      name != "hyperedge", line, "a hyperedge joins more than two nodes", "use a graph without hyperedges");
  }

  void
  BeginGraph(const XML_Char ** attributes)
  {
    m_Text.Require(
      !m_HasGraph, this->Line(), "the file contains a second graph, or one inside a node", "use one graph per file");
    const std::string kind = Attribute(attributes, "edgedefault");
    if (!(kind.empty() || kind == "directed" || kind == "undirected"))
    {
      m_Text.Refuse(this->Line(), "edgedefault is " + Quoted(kind) + ", neither directed nor undirected");
    }
    m_HasGraph = true;
    m_IsDirected = kind == "directed";
  }

  void
  BeginEdge(const XML_Char ** attributes)
  {
    const int         line = this->Line();
    const std::string direction = Attribute(attributes, "directed");
    m_Text.Require(direction.empty() ? !m_IsDirected : direction == "false",
                   line,
                   "the graph is directed: this edge has a direction",
                   "state edgedefault=\"undirected\" to make its edges undirected");
    Edge edge{ Attribute(attributes, "source"), Attribute(attributes, "target"), line };
    m_Text.Require(!edge.source.empty() && !edge.target.empty(), line, "the edge lacks a source or a target");
    m_Edges.push_back(std::move(edge));
  }

  const GraphText &                                            m_Text;
  GraphBuilder                                                 m_Builder;
  std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> m_Parser;
  std::exception_ptr                                           m_Error;
  std::vector<Edge>                                            m_Edges;
  int                                                          m_Depth{ 0 };
  bool                                                         m_HasGraph{ false };
  bool                                                         m_IsDirected{ false };
};
} // namespace

Graph
ReadGraphML(const GraphText & text, std::vector<std::string> &)
{
  return GraphMLReader(text).Read();
}
} // namespace shapeton
