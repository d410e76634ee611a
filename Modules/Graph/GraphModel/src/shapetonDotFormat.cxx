#include "shapetonDotTokens.h"
#include "shapetonGraphBuilder.h"
#include "shapetonGraphFormat.h"

#include <algorithm>
#include <set>

namespace shapeton
{
namespace
{
/** Recursive-descent parser of the DOT language; attributes are ignored. */
class DotReader
{
public:
  explicit DotReader(const GraphText & text) : m_Text(text), m_Tokens(text), m_Builder(text) { this->Advance(); }

  Graph
  Read(std::vector<std::string> & notes)
  {
    m_IsStrict = this->SkipKeyword("strict");
    m_Text.Require(!m_Token.IsKeyword("digraph"),
                   m_Token.line,
                   "the graph is directed (digraph)",
                   "write \"graph\" and \"--\" to make its edges undirected");
    this->Expect(this->SkipKeyword("graph"), "the keyword graph");
    if (m_Token.IsName())
    {
      this->Advance();
    }
    this->ReadBody();
    if (m_Token.kind != DotToken::Kind::End)
    {
      m_Text.Refuse(m_Token.line, Quoted(m_Token.text) + " follows the end of the graph", "use one graph per file");
    }
    if (m_Dropped > 0)
    {
      notes.push_back(std::to_string(m_Dropped) + " repeated edges were skipped because the graph is strict");
    }
    return m_Builder.Take();
  }

private:
  using Nodes = std::vector<int>;

  void
  Advance()
  {
    m_Token = m_Tokens.Next();
  }

  void
  Expect(bool condition, const std::string & what) const
  {
    if (!condition)
    {
      m_Text.Refuse(m_Token.line,
                    "expected " + what + ", found " + Quoted(m_Token.text),
                    m_Token.kind == DotToken::Kind::End ? "use a complete copy of the file" : "correct the file there");
    }
  }

  bool
  SkipKeyword(std::string_view word)
  {
    const bool isThere = m_Token.IsKeyword(word);
    if (isThere)
    {
      this->Advance();
    }
    return isThere;
  }

  bool
  SkipSymbol(std::string_view symbol)
  {
    const bool isThere = m_Token.Is(symbol);
    if (isThere)
    {
      this->Advance();
    }
    return isThere;
  }

  /** { statements }; returns the nodes mentioned in them. */
  Nodes
  ReadBody()
  {
    constexpr int mostDepth = 200; // each level uses stack
    m_Text.Require(++m_Depth <= mostDepth, m_Token.line, "subgraphs are nested more than 200 deep");
    this->Expect(this->SkipSymbol("{"), "an opening brace");
    Nodes nodes;
    while (!this->SkipSymbol("}"))
    {
      const Nodes more = this->ReadStatement();
      nodes.insert(nodes.end(), more.begin(), more.end());
      this->SkipSymbol(";");
    }
    --m_Depth;
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
  }

  Nodes
  ReadStatement()
  {
    if (this->SkipKeyword("graph") || this->SkipKeyword("node") || this->SkipKeyword("edge"))
    {
      this->Expect(m_Token.Is("["), "a list of attributes");
      this->ReadAttributes();
      return {};
    }
    if (m_Token.IsName() && !m_Token.IsKeyword("subgraph"))
    {
      const DotToken name = m_Token;
      this->Advance();
      if (this->SkipSymbol("="))
      {
        this->Expect(m_Token.IsName(), "a value");
        this->Advance();
        return {};
      }
      return this->ReadChain(this->NodesFrom(name));
    }
    return this->ReadChain(this->ReadEnd());
  }

  /** Returns the node for a name that was just read; skips its port. */
  Nodes
  NodeOf(const DotToken & name)
  {
    for (int i = 0; i < 2 && this->SkipSymbol(":"); ++i)
    {
      this->Expect(m_Token.IsName(), "a port");
      this->Advance();
    }
    return { m_Builder.NodeOf(name.text) };
  }

  /** The nodes of a list separated by commas, whose first name was just read. */
  Nodes
  NodesFrom(const DotToken & first)
  {
    Nodes nodes = this->NodeOf(first);
    while (this->SkipSymbol(","))
    {
      this->Expect(m_Token.IsName() && !m_Token.IsKeyword("subgraph"), "a node");
      const DotToken name = m_Token;
      this->Advance();
      nodes.push_back(this->NodeOf(name).front());
    }
    return nodes;
  }

  /** An end of an edge: a list of nodes or a subgraph. */
  Nodes
  ReadEnd()
  {
    if (m_Token.IsName() && !m_Token.IsKeyword("subgraph"))
    {
      const DotToken name = m_Token;
      this->Advance();
      return this->NodesFrom(name);
    }
    if (this->SkipKeyword("subgraph") && m_Token.IsName())
    {
      this->Advance();
    }
    this->Expect(m_Token.Is("{"), "a node or a subgraph");
    return this->ReadBody();
  }

  /** -- end -- end ... [attributes] */
  Nodes
  ReadChain(Nodes nodes)
  {
    Nodes last = nodes;
    while (m_Token.Is("--") || m_Token.Is("->"))
    {
      m_Text.Require(
        m_Token.Is("--"), m_Token.line, "an edge \"->\" is directed, but the graph is undirected", "write \"--\"");
      const int line = m_Token.line;
      this->Advance();
      const Nodes next = this->ReadEnd();
      this->AddEdges(last, next, line);
      nodes.insert(nodes.end(), next.begin(), next.end());
      last = next;
    }
    this->ReadAttributes();
    return nodes;
  }

  void
  ReadAttributes()
  {
    while (this->SkipSymbol("["))
    {
      while (!this->SkipSymbol("]"))
      {
        this->Expect(m_Token.IsName(), "the name of an attribute");
        this->Advance();
        if (this->SkipSymbol("="))
        {
          this->Expect(m_Token.IsName(), "the value of an attribute");
          this->Advance();
        }
        if (!this->SkipSymbol(","))
        {
          this->SkipSymbol(";");
        }
      }
    }
  }

  /** Adds an edge from each node of one end to each of the other. */
  void
  AddEdges(const Nodes & from, const Nodes & to, int line)
  {
    for (const int first : from)
    {
      for (const int second : to)
      {
        if (m_IsStrict && !m_Known.insert(std::minmax(first, second)).second)
        {
          ++m_Dropped;
          continue;
        }
        m_Builder.AddEdge(first, second, line);
      }
    }
  }

  const GraphText &             m_Text;
  DotTokens                     m_Tokens;
  GraphBuilder                  m_Builder;
  DotToken                      m_Token;
  std::set<std::pair<int, int>> m_Known; // known edges of a strict graph
  int                           m_Dropped{ 0 };
  int                           m_Depth{ 0 };
  bool                          m_IsStrict{ false };
};
} // namespace

Graph
ReadDot(const GraphText & text, std::vector<std::string> & notes)
{
  return DotReader(text).Read(notes);
}
} // namespace shapeton
