#ifndef shapetonGraphTestFiles_h
#define shapetonGraphTestFiles_h

#include "shapetonFileBytes.h"
#include "shapetonGraphReader.h"
#include "shapetonTestFolder.h"

#include <string>

namespace graphtest
{
inline shapeton::GraphFile
ReadText(const std::string & name, const std::string & text)
{
  const basetest::Folder folder;
  shapeton::WriteFileBytes(folder / name, text);
  return shapeton::ReadGraph(folder / name);
}

/** Text of a graph, such as "a-b b-c (a b c)": edges in order, then nodes. */
inline std::string
Shown(const shapeton::Graph & graph)
{
  std::string shown;
  for (const auto & [first, second] : graph.edges)
  {
    shown += shapeton::NameOfNode(graph, first) + '-' + shapeton::NameOfNode(graph, second) + ' ';
  }
  shown += '(';
  for (int node = 0; node < graph.nodes; ++node)
  {
    shown += (node > 0 ? " " : "") + shapeton::NameOfNode(graph, node);
  }
  return shown + ')';
}

/** Result of the reader for this text: the graph or the exception message. */
inline std::string
AnswerTo(const std::string & name, const std::string & text)
{
  std::string       shown;
  const std::string message = basetest::MessageOf([&] { shown = Shown(ReadText(name, text).graph); });
  return shown.empty() ? message : shown;
}
} // namespace graphtest

#endif
