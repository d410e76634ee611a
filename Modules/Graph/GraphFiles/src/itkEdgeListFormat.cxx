#include "itkGraphBuilder.h"
#include "itkGraphFormat.h"

namespace itk
{
namespace
{
bool
IsComment(std::string_view word)
{
  return word[0] == '#' || word[0] == '%' || word.substr(0, 2) == "//";
}

/** What follows the two names of an edge: nothing, weights and times, or attributes in braces as NetworkX writes them.
 */
bool
IsWeight(std::string_view word)
{
  double number = 0.0;
  return ParseDouble(word, number);
}
} // namespace

Graph
ReadEdgeList(const GraphText & text, std::vector<std::string> &)
{
  GraphBuilder builder(text);
  LineReader   lines(text.bytes);
  for (std::string_view line; lines.Next(line);)
  {
    const std::vector<std::string_view> words = Words(line, ",;");
    if (words.empty() || IsComment(words[0]))
    {
      continue;
    }
    const int number = lines.Number();
    if (words.size() < 2)
    {
      text.Refuse(number,
                  "the line has one word, " + Quoted(words[0]) + ", but an edge joins two nodes",
                  "write the names of two nodes on each line");
    }
    for (std::size_t i = 2; i < words.size() && words[i][0] != '{' && !IsComment(words[i]); ++i)
    {
      if (!IsWeight(words[i]))
      {
        text.Refuse(number,
                    Quoted(words[i]) + " after the two nodes of an edge is no number",
                    "write the names of two nodes, without blanks, and at most numbers after them");
      }
    }
    const int first = builder.NodeOf(words[0]);
    builder.AddEdge(first, builder.NodeOf(words[1]), number);
  }
  return builder.Take();
}
} // namespace itk
