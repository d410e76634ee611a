#include "shapetonGraphBuilder.h"
#include "shapetonGraphFormat.h"

#include <algorithm>

namespace shapeton
{
namespace
{
/** Numbers of the first line: NODES EDGES [FORMAT [WEIGHTS]], FORMAT three digits: sizes, node weights, edge weights.
 */
struct MetisHeader
{
  int  nodes{ 0 };
  int  edges{ 0 };
  int  numbersOfNode{ 0 };
  bool hasEdgeWeights{ false };
};

struct Neighbor
{
  int node;
  int other;
};

class MetisReader
{
public:
  explicit MetisReader(const GraphText & text) : m_Text(text), m_Lines(text.bytes) {}

  Graph
  Read()
  {
    this->ReadHeader();
    NumberedGraphBuilder builder(m_Text, m_Header.nodes, m_Lines.Number());
    // Each node has its own line, an empty one if it has no neighbors.
    if (m_Text.bytes.size() < static_cast<std::size_t>(m_Header.nodes))
    {
      m_Text.Refuse(m_Lines.Number(),
                    "the file is shorter than " + std::to_string(m_Header.nodes) + " lines, one for each node",
                    "use a complete copy of the file");
    }
    for (int node = 0; node < m_Header.nodes; ++node)
    {
      this->ReadNode(node);
    }
    this->RequireEnd();
    this->AddEdges(builder);
    return builder.Take();
  }

private:
  /** The next line that is not a comment; false at the end. */
  bool
  NextLine(std::vector<std::string_view> & words)
  {
    for (std::string_view line; m_Lines.Next(line);)
    {
      if (line.empty() || line[0] != '%')
      {
        words = Words(line);
        return true;
      }
    }
    return false;
  }

  int
  Number(std::string_view word, int least) const
  {
    int value = 0;
    if (!(ParseInt(word, value) && value >= least))
    {
      m_Text.Refuse(m_Lines.Number(), Quoted(word) + " is not an integer from " + std::to_string(least) + " on");
    }
    return value;
  }

  void
  ReadHeader()
  {
    std::vector<std::string_view> words;
    while (words.empty() && this->NextLine(words))
    {}
    m_Text.Require(words.size() >= 2 && words.size() <= 4,
                   m_Lines.Number(),
                   "the first line is not \"NODES EDGES [FORMAT [WEIGHTS]]\"",
                   "correct it, or name an edge list .edges");
    m_Header.nodes = this->Number(words[0], 0);
    m_Header.edges = this->Number(words[1], 0);
    const int format = words.size() > 2 ? this->Number(words[2], 0) : 0;
    if (!(format % 10 < 2 && format / 10 % 10 < 2 && format / 100 < 2))
    {
      m_Text.Refuse(m_Lines.Number(),
                    "the format " + Quoted(words.size() > 2 ? words[2] : "") + " must consist of the digits 0 and 1");
    }
    const int weights = words.size() > 3 ? this->Number(words[3], 1) : 1;
    m_Header.hasEdgeWeights = format % 10 == 1;
    m_Header.numbersOfNode = (format / 10 % 10 == 1 ? weights : 0) + format / 100;
  }

  void
  ReadNode(int node)
  {
    std::vector<std::string_view> words;
    if (!this->NextLine(words))
    {
      m_Text.Refuse(m_Lines.Number(),
                    "the file ends at node " + std::to_string(node) + " of " + std::to_string(m_Header.nodes),
                    "use a complete copy of the file");
    }
    const std::size_t step = m_Header.hasEdgeWeights ? 2 : 1;
    const auto        start = static_cast<std::size_t>(m_Header.numbersOfNode);
    m_Text.Require(words.size() >= start && (words.size() - start) % step == 0,
                   m_Lines.Number(),
                   "the line of a node does not have the weights stated in the first line");
    for (std::size_t i = start; i < words.size(); i += step)
    {
      const int other = this->Number(words[i], 1);
      if (other > m_Header.nodes)
      {
        m_Text.Refuse(m_Lines.Number(),
                      "node " + Quoted(words[i]) + " does not exist: nodes are numbered from 1 to " +
                        std::to_string(m_Header.nodes));
      }
      m_Neighbors.push_back({ node, other - 1 });
    }
  }

  void
  RequireEnd()
  {
    for (std::vector<std::string_view> words; this->NextLine(words);)
    {
      if (!(words.empty()))
      {
        m_Text.Refuse(m_Lines.Number(),
                      "the file continues after the last of its " + std::to_string(m_Header.nodes) + " nodes",
                      "correct the first line or remove the rest");
      }
    }
  }

  /** Each edge is listed at both end nodes; a loop twice at its node. */
  void
  AddEdges(NumberedGraphBuilder & builder) const
  {
    std::vector<std::pair<int, int>> forward;
    std::vector<std::pair<int, int>> backward;
    for (const Neighbor & neighbor : m_Neighbors)
    {
      auto & list = neighbor.node <= neighbor.other ? forward : backward;
      list.emplace_back(std::min(neighbor.node, neighbor.other), std::max(neighbor.node, neighbor.other));
    }
    std::sort(forward.begin(), forward.end());
    std::sort(backward.begin(), backward.end());
    std::size_t next = 0; // index into backward
    for (std::size_t i = 0; i < forward.size(); ++i)
    {
      const auto [first, second] = forward[i];
      const bool isLoop = first == second;
      const bool isTwice = isLoop ? i + 1 < forward.size() && forward[i + 1] == forward[i]
                                  : next < backward.size() && backward[next] == forward[i];
      if (!isLoop && next < backward.size() && backward[next] < forward[i])
      {
        this->RequireTwice(false, backward[next].second, backward[next].first);
      }
      this->RequireTwice(isTwice, first, second);
      builder.AddEdge(first, second);
      (isLoop ? i : next) += 1;
    }
    if (next < backward.size())
    {
      this->RequireTwice(false, backward[next].second, backward[next].first);
    }
    if (builder.Edges() != static_cast<std::size_t>(m_Header.edges))
    {
      m_Text.Refuse(0,
                    "the file has " + std::to_string(builder.Edges()) + " edges, but its first line states " +
                      std::to_string(m_Header.edges),
                    "the file is truncated or its first line is wrong: use a complete copy or correct it");
    }
  }

  void
  RequireTwice(bool isTwice, int first, int second) const
  {
    if (!isTwice)
    {
      m_Text.Refuse(0,
                    "node " + std::to_string(first + 1) + " lists node " + std::to_string(second + 1) +
                      " more often than the reverse: the graph is directed or the file is damaged",
                    "list each edge at both of its nodes");
    }
  }

  const GraphText &     m_Text;
  LineReader            m_Lines;
  MetisHeader           m_Header;
  std::vector<Neighbor> m_Neighbors;
};
} // namespace

Graph
ReadMetis(const GraphText & text, std::vector<std::string> &)
{
  return MetisReader(text).Read();
}
} // namespace shapeton
