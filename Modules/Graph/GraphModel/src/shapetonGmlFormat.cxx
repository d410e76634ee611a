#include "shapetonGraphBuilder.h"
#include "shapetonGraphFormat.h"

#include <algorithm>
#include <cctype>

namespace shapeton
{
namespace
{
struct GmlToken
{
  enum class Kind
  {
    End,
    Word, // a key or a number
    Text, // in double quotes
    Open,
    Close
  };
  Kind             kind{ Kind::End };
  std::string_view text;
  int              line{ 0 };
};

class GmlTokens
{
public:
  explicit GmlTokens(const GraphText & text) : m_Text(text), m_Rest(text.bytes) {}

  GmlToken
  Next()
  {
    this->SkipBlanks();
    if (m_Rest.empty())
    {
      return { GmlToken::Kind::End, {}, m_Line };
    }
    if (m_Rest[0] == '[' || m_Rest[0] == ']')
    {
      return this->Take(m_Rest[0] == '[' ? GmlToken::Kind::Open : GmlToken::Kind::Close, 1);
    }
    if (m_Rest[0] == '"')
    {
      const std::size_t end = m_Rest.find('"', 1);
      m_Text.Require(end != std::string_view::npos, m_Line, "a quoted string is not closed");
      return this->Take(GmlToken::Kind::Text, end + 1);
    }
    return this->Take(GmlToken::Kind::Word, std::min(m_Rest.find_first_of(" \t\r\n\f\v[]\"#"), m_Rest.size()));
  }

private:
  GmlToken
  Take(GmlToken::Kind kind, std::size_t length)
  {
    const GmlToken token{ kind, m_Rest.substr(0, length), m_Line };
    this->Skip(length);
    return token;
  }

  void
  Skip(std::size_t length)
  {
    m_Line += static_cast<int>(std::count(m_Rest.begin(), m_Rest.begin() + length, '\n'));
    m_Rest.remove_prefix(length);
  }

  void
  SkipBlanks()
  {
    while (!m_Rest.empty() && (std::isspace(static_cast<unsigned char>(m_Rest[0])) != 0 || m_Rest[0] == '#'))
    {
      this->Skip(m_Rest[0] == '#' ? std::min(m_Rest.find('\n'), m_Rest.size()) : 1);
    }
  }

  const GraphText & m_Text;
  std::string_view  m_Rest;
  int               m_Line{ 1 };
};

class GmlReader
{
public:
  explicit GmlReader(const GraphText & text) : m_Text(text), m_Tokens(text), m_Builder(text) {}

  Graph
  Read()
  {
    Entry graph;
    for (GmlToken key = m_Tokens.Next(); key.kind != GmlToken::Kind::End; key = m_Tokens.Next())
    {
      const GmlToken value = this->ValueOf(key);
      if (key.text == "graph" && value.kind == GmlToken::Kind::Open)
      {
        m_Text.Require(graph.line == 0,
                       key.line,
                       "the file contains a second graph; the first one starts in line " + std::to_string(graph.line),
                       "use one graph per file");
        graph.line = key.line;
        this->ReadGraph(key.line);
      }
      else
      {
        this->SkipValue(value);
      }
    }
    m_Text.Require(graph.line > 0, 0, "the entry \"graph [ ... ]\" is missing", "use a file that contains a graph");
    for (const Edge & edge : m_Edges)
    {
      const int first = m_Builder.DeclaredNode(edge.source, edge.line);
      m_Builder.AddEdge(first, m_Builder.DeclaredNode(edge.target, edge.line), edge.line);
    }
    return m_Builder.Take();
  }

private:
  /** Value and line number of a key that may occur once per list; line 0 if not yet found. */
  struct Entry
  {
    std::string_view value;
    int              line{ 0 };
  };

  struct Edge
  {
    std::string_view source;
    std::string_view target;
    int              line;
  };

  void
  TakeOnce(const GmlToken & key, std::string_view value, const std::string & owner, Entry & entry) const
  {
    if (entry.line > 0)
    {
      m_Text.Refuse(key.line,
                    owner + " has a second " + Quoted(key.text) + "; the first one is in line " +
                      std::to_string(entry.line),
                    "remove one of them");
    }
    entry = { value, key.line };
  }

  /** The token after a key; it must exist. */
  GmlToken
  ValueOf(const GmlToken & key)
  {
    if (!(key.kind == GmlToken::Kind::Word &&
          (std::isalpha(static_cast<unsigned char>(key.text[0])) != 0 || key.text[0] == '_')))
    {
      m_Text.Refuse(key.line, "expected a key, found " + Quoted(key.text));
    }
    const GmlToken value = m_Tokens.Next();
    if (value.kind == GmlToken::Kind::End)
    {
      m_Text.Refuse(value.line, "the file ends after the key " + Quoted(key.text), "use a complete copy of the file");
    }
    if (value.kind == GmlToken::Kind::Close)
    {
      m_Text.Refuse(value.line, "the key " + Quoted(key.text) + " has no value");
    }
    return value;
  }

  /** Calls `take(key, value)` for each entry of a list, up to the closing bracket. */
  template <typename Take>
  void
  ReadList(int line, const Take & take)
  {
    for (GmlToken key = m_Tokens.Next(); key.kind != GmlToken::Kind::Close; key = m_Tokens.Next())
    {
      m_Text.Require(
        key.kind != GmlToken::Kind::End, line, "a list has no closing bracket", "use a complete copy of the file");
      take(key, this->ValueOf(key));
    }
  }

  void
  SkipValue(const GmlToken & value)
  {
    for (int depth = value.kind == GmlToken::Kind::Open ? 1 : 0; depth > 0;)
    {
      const GmlToken token = m_Tokens.Next();
      m_Text.Require(token.kind != GmlToken::Kind::End,
                     value.line,
                     "a list has no closing bracket",
                     "use a complete copy of the file");
      depth += token.kind == GmlToken::Kind::Open ? 1 : token.kind == GmlToken::Kind::Close ? -1 : 0;
    }
  }

  void
  ReadGraph(int line)
  {
    Entry directed;
    this->ReadList(line, [&](const GmlToken & key, const GmlToken & value) {
      const bool isList = value.kind == GmlToken::Kind::Open;
      if (key.text == "node" && isList)
      {
        this->ReadNode(key.line);
      }
      else if (key.text == "edge" && isList)
      {
        this->ReadEdge(key.line);
      }
      else
      {
        if (key.text == "directed")
        {
          m_Text.Require(
            value.text == "0", key.line, "the graph is directed", "write \"directed 0\" to make its edges undirected");
          this->TakeOnce(key, value.text, "the graph", directed);
        }
        this->SkipValue(value);
      }
    });
  }

  std::string_view
  Id(const GmlToken & value) const
  {
    int number = 0;
    if (!(value.kind == GmlToken::Kind::Word && ParseInt(value.text, number)))
    {
      m_Text.Refuse(value.line, Quoted(value.text) + " is not an integer; node ids must be integers");
    }
    return value.text;
  }

  void
  ReadNode(int line)
  {
    Entry id;
    this->ReadList(line, [&](const GmlToken & key, const GmlToken & value) {
      if (key.text == "id")
      {
        this->TakeOnce(key, this->Id(value), "the node", id);
        return;
      }
      this->SkipValue(value);
    });
    m_Text.Require(id.line > 0, line, "the node has no id");
    m_Builder.AddNode(id.value, line);
  }

  void
  ReadEdge(int line)
  {
    Entry source;
    Entry target;
    this->ReadList(line, [&](const GmlToken & key, const GmlToken & value) {
      if (key.text == "source" || key.text == "target")
      {
        this->TakeOnce(key, this->Id(value), "the edge", key.text == "source" ? source : target);
        return;
      }
      this->SkipValue(value);
    });
    m_Text.Require(source.line > 0 && target.line > 0, line, "the edge lacks a source or a target");
    m_Edges.push_back({ source.value, target.value, line });
  }

  const GraphText & m_Text;
  GmlTokens         m_Tokens;
  GraphBuilder      m_Builder;
  std::vector<Edge> m_Edges;
};
} // namespace

Graph
ReadGml(const GraphText & text, std::vector<std::string> &)
{
  return GmlReader(text).Read();
}
} // namespace shapeton
