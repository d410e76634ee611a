#include "shapetonGraphBuilder.h"
#include "shapetonGraphFormat.h"

#include <cstdint>

namespace shapeton
{
namespace
{
/** Each byte from 63 to 126 holds six bits. */
constexpr char        FirstByte = 63;
constexpr char        LastByte = 126;
constexpr std::size_t BitsOfByte = 6;

/** The six bits of a printable byte. */
class SixBits
{
public:
  SixBits(const GraphText & text, std::string_view line, int number) : m_Text(text), m_Line(line), m_Number(number)
  {
    for (const char c : line)
    {
      if (!(c >= FirstByte && c <= LastByte))
      {
        text.Refuse(number, "the byte " + Quoted({ &c, 1 }) + " is invalid in this format");
      }
    }
  }

  /** The number of nodes: 1, 4 or 8 bytes. */
  int
  TakeSize()
  {
    const bool         isLong = !m_Line.empty() && m_Line[0] == '~';
    const bool         isLongest = isLong && m_Line.size() > 1 && m_Line[1] == '~';
    const std::size_t  skip = isLongest ? 2 : isLong ? 1 : 0;
    const std::size_t  digits = isLongest ? 6 : isLong ? 3 : 1;
    const std::int64_t most = 2147483647;
    m_Text.Require(
      m_Line.size() >= skip + digits, m_Number, "the number of nodes is truncated", "use a complete copy of the file");
    std::int64_t size = 0;
    for (std::size_t i = skip; i < skip + digits; ++i)
    {
      size = size * 64 + (m_Line[i] - FirstByte);
    }
    m_Line.remove_prefix(skip + digits);
    if (size > most)
    {
      m_Text.Refuse(m_Number, "the graph has " + std::to_string(size) + " nodes, more than supported");
    }
    return static_cast<int>(size);
  }

  std::size_t
  Bits() const
  {
    return BitsOfByte * m_Line.size();
  }

  bool
  Bit(std::size_t index) const
  {
    return ((m_Line[index / BitsOfByte] - FirstByte) >> (BitsOfByte - 1 - index % BitsOfByte) & 1) != 0;
  }

private:
  const GraphText & m_Text;
  std::string_view  m_Line;
  int               m_Number;
};

struct GraphLine
{
  std::string_view text;
  int              number;
};

/** The only line of the file with a graph, without the header. */
GraphLine
OnlyLine(const GraphText & text, std::string_view header)
{
  GraphLine  only{ {}, 0 };
  LineReader lines(text.bytes);
  for (std::string_view line; lines.Next(line);)
  {
    if (line.substr(0, header.size()) == header)
    {
      line.remove_prefix(header.size());
    }
    if (line.find_first_not_of(" \t") == std::string_view::npos)
    {
      continue;
    }
    text.Require(only.number == 0, lines.Number(), "the file contains a second graph", "use one graph per file");
    only = { line, lines.Number() };
  }
  text.Require(only.number > 0, 0, "the file does not contain a graph", "use a file that contains a graph");
  text.Require(
    only.text[0] != '&', only.number, "the graph is directed (digraph6)", "write it as an undirected graph, graph6");
  return only;
}
} // namespace

Graph
ReadGraph6(const GraphText & text, std::vector<std::string> & notes)
{
  const GraphLine line = OnlyLine(text, ">>graph6<<");
  if (line.text[0] == ':' || line.text[0] == ';')
  {
    return ReadSparse6(text, notes);
  }
  SixBits              bits(text, line.text, line.number);
  NumberedGraphBuilder builder(text, bits.TakeSize(), line.number, 0);
  const std::size_t    pairs = static_cast<std::size_t>(builder.Nodes()) * (builder.Nodes() - 1) / 2;
  const std::size_t    bytes = (pairs + BitsOfByte - 1) / BitsOfByte;
  if (bits.Bits() / BitsOfByte != bytes)
  {
    text.Refuse(line.number,
                "a graph of " + std::to_string(builder.Nodes()) + " nodes needs " + std::to_string(bytes) +
                  " bytes of edges, but " + std::to_string(bits.Bits() / BitsOfByte) + " follow",
                "use a complete copy of the file");
  }
  std::size_t index = 0;
  for (int second = 1; second < builder.Nodes(); ++second)
  {
    for (int first = 0; first < second; ++first, ++index)
    {
      if (bits.Bit(index))
      {
        builder.AddEdge(first, second);
      }
    }
  }
  return builder.Take();
}

Graph
ReadSparse6(const GraphText & text, std::vector<std::string> &)
{
  GraphLine line = OnlyLine(text, ">>sparse6<<");
  if (line.text[0] != ':')
  {
    text.Refuse(line.number,
                line.text[0] == ';' ? "incremental sparse6 requires the preceding graph"
                                    : "a sparse6 graph starts with a colon",
                "write the graph as graph6 or sparse6");
  }
  line.text.remove_prefix(1);
  SixBits              bits(text, line.text, line.number);
  NumberedGraphBuilder builder(text, bits.TakeSize(), line.number, 0);
  std::size_t          width = 0;
  while ((static_cast<std::int64_t>(1) << width) < builder.Nodes())
  {
    ++width;
  }
  std::int64_t current = 0;
  for (std::size_t i = 0; i + 1 + width <= bits.Bits(); i += 1 + width)
  {
    current += bits.Bit(i) ? 1 : 0;
    std::int64_t other = 0;
    for (std::size_t k = 1; k <= width; ++k)
    {
      other = 2 * other + (bits.Bit(i + k) ? 1 : 0);
    }
    if (current >= builder.Nodes() || other >= builder.Nodes())
    {
      break; // padding
    }
    if (other > current)
    {
      current = other;
    }
    else
    {
      builder.AddEdge(static_cast<int>(other), static_cast<int>(current));
    }
  }
  return builder.Take();
}
} // namespace shapeton
