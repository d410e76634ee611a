#include "shapetonGraphBuilder.h"
#include "shapetonGraphFormat.h"

#include <optional>

namespace shapeton
{
namespace
{
/** The line "p tw NODES EDGES" (or p edge, p td, p cep, ...), and the edges: "u v" of PACE, "e u v" of DIMACS. */
class PaceReader
{
public:
  explicit PaceReader(const GraphText & text) : m_Text(text) {}

  Graph
  Read()
  {
    LineReader lines(m_Text.bytes);
    for (std::string_view line; lines.Next(line);)
    {
      m_Line = lines.Number();
      const std::vector<std::string_view> words = Words(line);
      if (words.empty() || words[0] == "c")
      {
        continue;
      }
      if (words[0] == "p")
      {
        this->ReadHeader(words);
      }
      else
      {
        this->ReadEdge(words);
      }
    }
    return this->Finish();
  }

private:
  void
  ReadHeader(const std::vector<std::string_view> & words)
  {
    m_Text.Require(
      !m_Builder, m_Line, "a second line \"p\": the file contains several graphs", "use one graph per file");
    m_Text.Require(words.size() != 4 || words[1] != "sp",
                   m_Line,
                   "the graph is directed (\"p sp\": shortest paths)",
                   "write it as an undirected graph, \"p tw NODES EDGES\"");
    int nodes = 0;
    m_Text.Require(words.size() == 4 && ParseInt(words[2], nodes) && ParseInt(words[3], m_Edges) && m_Edges >= 0,
                   m_Line,
                   "the line is not \"p tw NODES EDGES\"");
    m_Builder.emplace(m_Text, nodes, m_Line);
  }

  void
  ReadEdge(const std::vector<std::string_view> & words)
  {
    m_Text.Require(m_Builder.has_value(), m_Line, "an edge precedes the line \"p tw NODES EDGES\"");
    const std::size_t skip = words[0] == "e" ? 1 : 0;
    m_Text.Require(
      words[0] != "a", m_Line, "the graph is directed (an arc \"a\")", "write its edges without directions");
    m_Text.Require(words.size() == skip + 2, m_Line, "the line is not an edge: expected two node numbers");
    const int first = this->NodeOf(words[skip]);
    m_Builder->AddEdge(first, this->NodeOf(words[skip + 1]));
  }

  int
  NodeOf(std::string_view word) const
  {
    int number = 0;
    if (!(ParseInt(word, number) && number >= 1 && number <= m_Builder->Nodes()))
    {
      m_Text.Refuse(
        m_Line, Quoted(word) + " is not a node: nodes are numbered from 1 to " + std::to_string(m_Builder->Nodes()));
    }
    return number - 1;
  }

  Graph
  Finish()
  {
    m_Text.Require(m_Builder.has_value(), 0, "the line \"p tw NODES EDGES\" is missing", "add it before the edges");
    const std::size_t edges = m_Builder->Edges();
    if (edges != static_cast<std::size_t>(m_Edges))
    {
      m_Text.Refuse(m_Line,
                    "the file ends after " + std::to_string(edges) + " edges, but its line \"p\" states " +
                      std::to_string(m_Edges),
                    "the file is truncated or its line \"p\" is wrong: use a complete copy or correct it");
    }
    return m_Builder->Take();
  }

  const GraphText &                   m_Text;
  std::optional<NumberedGraphBuilder> m_Builder;
  int                                 m_Edges{ 0 };
  int                                 m_Line{ 0 };
};
} // namespace

Graph
ReadPace(const GraphText & text, std::vector<std::string> &)
{
  return PaceReader(text).Read();
}
} // namespace shapeton
