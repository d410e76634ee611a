#include "shapetonToolGraphs.h"

#include "shapetonCommandLine.h"
#include "shapetonSha256.h"

namespace shapeton
{
Graph
ReadGraph(CommandLine & commandLine, const std::string & parameter)
{
  GraphFile file = ReadGraph(commandLine.GetString(parameter));
  commandLine.AddInput(parameter, file.identity);
  commandLine.Warn(file.notes);
  return std::move(file.graph);
}

CombinatorialMap
ReadRotation(CommandLine & commandLine, const std::string & parameter, const Graph & graph)
{
  const std::string path = commandLine.GetString(parameter);
  CombinatorialMap  map = ReadRotation(graph, path);
  commandLine.AddInput(parameter, "sha256:" + Sha256OfFile(path));
  return map;
}
} // namespace shapeton
