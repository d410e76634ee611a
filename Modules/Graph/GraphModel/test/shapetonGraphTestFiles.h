#ifndef shapetonGraphTestFiles_h
#define shapetonGraphTestFiles_h

#include "shapetonFileBytes.h"
#include "shapetonGraphReader.h"
#include "shapetonTestFolder.h"

#include <cstdio>
#include <filesystem>
#include <string>
#include <unistd.h>

namespace graphtest
{
/** A file with this text, removed at scope exit. */
class GraphTestFile
{
public:
  GraphTestFile(const std::string & name, const std::string & text)
    : m_Path((std::filesystem::temp_directory_path() / (std::to_string(getpid()) + '-' + name)).string())
  {
    shapeton::WriteFileBytes(m_Path, text);
  }
  GraphTestFile(const GraphTestFile &) = delete;
  GraphTestFile &
  operator=(const GraphTestFile &) = delete;
  ~GraphTestFile() { std::remove(m_Path.c_str()); }

  const std::string &
  Path() const
  {
    return m_Path;
  }

private:
  std::string m_Path;
};

inline shapeton::GraphFile
ReadText(const std::string & name, const std::string & text)
{
  return shapeton::ReadGraph(GraphTestFile(name, text).Path());
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
