#include "shapetonGraphBuilder.h"
#include "shapetonGraphFormat.h"

#include <algorithm>
#include <initializer_list>
#include <utility>

namespace shapeton
{
namespace
{
bool
IsComment(std::string_view word)
{
  return word[0] == '#' || word[0] == '%' || word.substr(0, 2) == "//";
}

/** Optional content after the two names of an edge: weights and times, or attributes in braces as written by NetworkX.
 */
bool
IsWeight(std::string_view word)
{
  double number = 0.0;
  return ParseDouble(word, number);
}

/** Column names in the first line of a table. */
bool
IsHeader(const std::vector<std::string_view> & words)
{
  const auto isOneOf = [](std::string_view word, std::initializer_list<const char *> names) {
    return std::any_of(names.begin(), names.end(), [&](const char * name) { return EqualWithoutCase(word, name); });
  };
  return words.size() >= 2 && isOneOf(words[0], { "source", "from", "node1", "id1", "src" }) &&
         isOneOf(words[1], { "target", "to", "node2", "id2", "dst" });
}
} // namespace

Graph
ReadEdgeList(const GraphText & text, std::vector<std::string> & notes)
{
  bool         isFirst = true;
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
    if (std::exchange(isFirst, false) && IsHeader(words))
    {
      notes.push_back("line " + std::to_string(number) + " has column names and was skipped");
      continue;
    }
    if (words.size() < 2)
    {
      text.Refuse(number,
                  "the line has only one word, " + Quoted(words[0]) + ", but an edge joins two nodes",
                  "write the names of two nodes on each line");
    }
    for (std::size_t i = 2; i < words.size() && words[i][0] != '{' && !IsComment(words[i]); ++i)
    {
      if (!IsWeight(words[i]))
      {
        text.Refuse(number,
                    Quoted(words[i]) + " after the two nodes of an edge is not a number",
                    "write the names of two nodes, without blanks, and at most numbers after them");
      }
    }
    const int first = builder.NodeOf(words[0]);
    builder.AddEdge(first, builder.NodeOf(words[1]), number);
  }
  return builder.Take();
}
} // namespace shapeton
