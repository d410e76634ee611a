#include "GraphConformalTypeXML.h"

#include "shapetonCommandLine.h"
#include "shapetonExceptions.h"
#include "shapetonGraphCurvatureReport.h"
#include "shapetonGraphGenus.h"
#include "shapetonJson.h"
#include "shapetonReadOptions.h"
#include "shapetonSha256.h"
#include "shapetonToolGraphs.h"

#include <filesystem>

namespace
{
using namespace shapeton;

/** The graph, or with --planarPart a maximal planar subgraph of it; `what` names it in the warning. */
Graph
PlanarOf(CommandLine & commandLine, Graph graph, const std::string & what)
{
  if (!commandLine.GetFlag("planarPart"))
  {
    CombinatorialMap map;
    if (!FindPlanarEmbedding(graph, map))
    {
      throw InputError('"' + commandLine.GetString("graph") + "\": " + what +
                       "the graph is not planar; use --planarPart");
    }
    return graph;
  }
  const std::vector<int> kept = PlanarEdges(graph);
  const std::size_t      all = graph.edges.size();
  if (kept.size() < all)
  {
    commandLine.Warn(what + std::to_string(all - kept.size()) + " of " + std::to_string(all) +
                     " edges are left out of the planar part");
  }
  return GraphWithEdges(graph, kept);
}

/** The graph, or the graphs of a folder in the order of their file names. */
std::vector<Graph>
GraphsOf(CommandLine & commandLine)
{
  const std::string path = commandLine.GetString("graph");
  if (!std::filesystem::is_directory(path))
  {
    return { PlanarOf(commandLine, ReadGraph(commandLine, "graph"), "") };
  }
  std::vector<Graph> graphs;
  std::string        identities;
  for (const std::string & file : GraphFilesOf(path))
  {
    GraphFile         read = ReadGraph(file);
    const std::string name = std::filesystem::path(file).filename().string();
    identities += name + ' ' + read.identity + '\n';
    for (const std::string & note : read.notes)
    {
      commandLine.Warn(name + ": " + note);
    }
    graphs.push_back(PlanarOf(commandLine, std::move(read.graph), name + ": "));
  }
  commandLine.AddInput("graph", "sha256:" + Sha256OfBytes(identities));
  return graphs;
}

/** Number of the node with the name of the option `root`. */
int
RootOf(const CommandLine & commandLine, const Graph & graph)
{
  const std::string name = commandLine.GetString("root");
  for (int node = 0; node < graph.nodes; ++node)
  {
    if (NameOfNode(graph, node) == name)
    {
      return node;
    }
  }
  throw InputError('"' + commandLine.GetString("graph") + "\": a graph has no node \"" + name + "\"; see --root");
}

ConformalTypeResult
TypeOf(CommandLine & commandLine, const std::vector<Graph> & graphs)
{
  const bool            hasRoot = commandLine.IsGiven("root");
  ConformalTypeSettings settings;
  ReadOptions(commandLine, settings);
  settings.progress = commandLine.PartOfProgress(0.1, 0.9);
  if (!std::filesystem::is_directory(commandLine.GetString("graph")))
  {
    settings.root = hasRoot ? RootOf(commandLine, graphs.front()) : -1;
    return FindConformalType(graphs.front(), settings);
  }
  RequireParameter(hasRoot, "a sequence of graphs requires --root");
  RequireParameter(!settings.maximumRadius, "--maximumRadius applies to balls of one graph, not to a sequence");
  std::vector<int> roots;
  for (const Graph & graph : graphs)
  {
    roots.push_back(RootOf(commandLine, graph));
  }
  return FindConformalType(graphs, roots, settings.progress);
}

void
Find(CommandLine & commandLine)
{
  const std::string         path = commandLine.MainOutput("verdict");
  const std::string         table = commandLine.OutputOf("table");
  const std::string         svg = commandLine.OutputOf("svg");
  const std::vector<Graph>  graphs = GraphsOf(commandLine);
  const ConformalTypeResult result = TypeOf(commandLine, graphs);
  if (result.type == ConformalType::NotDecided)
  {
    commandLine.Warn("the balls do not decide the type: there are too few, or packing and resistance disagree");
  }
  if (commandLine.IsGiven("maximumRadius") &&
      result.balls.back().radius < std::stoi(commandLine.GetString("maximumRadius")))
  {
    commandLine.Warn("the outer face is reached before --maximumRadius: the largest ball has the radius " +
                     std::to_string(result.balls.back().radius));
  }
  commandLine.WriteDocument(ConformalTypeToJson(result, NameOfNode(graphs.front(), result.root)), path);
  if (!table.empty())
  {
    BallTableOf(result).Write(table);
  }
  if (!svg.empty())
  {
    WriteConformalTypeSvg(result, svg);
  }
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, Find);
}
