#include "GraphConformalTypeXML.h"

#include "shapetonCommandLine.h"
#include "shapetonExceptions.h"
#include "shapetonGraphCurvatureReport.h"
#include "shapetonGraphGenus.h"
#include "shapetonJson.h"
#include "shapetonReadOptions.h"
#include "shapetonSha256.h"
#include "shapetonToolGraphs.h"

#include <algorithm>
#include <filesystem>

namespace
{
using shapeton::CommandLine;

/** The graph, or with --planarPart a maximal planar subgraph of it; `what` names it in the warning. */
shapeton::Graph
PlanarOf(CommandLine & commandLine, shapeton::Graph graph, const std::string & what)
{
  if (!commandLine.GetFlag("planarPart"))
  {
    return graph;
  }
  const std::vector<int> kept = shapeton::PlanarEdges(graph);
  const std::size_t      all = graph.edges.size();
  if (kept.size() < all)
  {
    commandLine.Warn(what + std::to_string(all - kept.size()) + " of " + std::to_string(all) +
                     " edges are left out of the planar part");
  }
  return shapeton::GraphWithEdges(graph, kept);
}

/** The graph, or the graphs of a folder in the order of their file names. */
std::vector<shapeton::Graph>
GraphsOf(CommandLine & commandLine)
{
  const std::string path = commandLine.GetString("graph");
  if (!std::filesystem::is_directory(path))
  {
    return { PlanarOf(commandLine, shapeton::ReadGraph(commandLine, "graph"), "") };
  }
  std::vector<shapeton::Graph> graphs;
  std::string                  identities;
  for (const std::string & file : shapeton::GraphFilesOf(path))
  {
    shapeton::GraphFile read = shapeton::ReadGraph(file);
    const std::string   name = std::filesystem::path(file).filename().string();
    identities += name + ' ' + read.identity + '\n';
    for (const std::string & note : read.notes)
    {
      commandLine.Warn(name + ": " + note);
    }
    graphs.push_back(PlanarOf(commandLine, std::move(read.graph), name + ": "));
  }
  commandLine.AddInput("graph", "sha256:" + shapeton::Sha256OfBytes(identities));
  return graphs;
}

/** Number of the node with the name of the option `root`. */
int
RootOf(const CommandLine & commandLine, const shapeton::Graph & graph)
{
  const std::string name = commandLine.GetString("root");
  for (int node = 0; node < graph.nodes; ++node)
  {
    if (shapeton::NameOfNode(graph, node) == name)
    {
      return node;
    }
  }
  throw shapeton::InputError("a graph has no node \"" + name + "\"; see --root");
}

shapeton::ConformalTypeResult
TypeOf(CommandLine & commandLine, const std::vector<shapeton::Graph> & graphs)
{
  const bool                      hasRoot = commandLine.IsGiven("root");
  shapeton::ConformalTypeSettings settings;
  shapeton::ReadOptions(commandLine, settings);
  settings.progress = commandLine.PartOfProgress(0.1, 0.9);
  if (!std::filesystem::is_directory(commandLine.GetString("graph")))
  {
    settings.root = hasRoot ? RootOf(commandLine, graphs.front()) : -1;
    return shapeton::FindConformalType(graphs.front(), settings);
  }
  shapeton::RequireParameter(hasRoot, "a sequence of graphs requires --root");
  shapeton::RequireParameter(!settings.maximumRadius,
                             "--maximumRadius applies to balls of one graph, not to a sequence");
  std::vector<int> roots;
  for (const shapeton::Graph & graph : graphs)
  {
    roots.push_back(RootOf(commandLine, graph));
  }
  return shapeton::FindConformalType(graphs, roots, settings.progress);
}

void
Find(CommandLine & commandLine)
{
  const std::string output = commandLine.GetString("verdict");
  const std::string path = commandLine.Output(output);
  const std::string table = commandLine.OutputOf("table");
  const std::string svg = commandLine.OutputOf("svg");
  commandLine.RecordRun(output + ".run.json");
  const std::vector<shapeton::Graph>  graphs = GraphsOf(commandLine);
  const shapeton::ConformalTypeResult result = TypeOf(commandLine, graphs);
  if (result.type == shapeton::ConformalType::NotDecided)
  {
    commandLine.Warn("the balls do not decide the type: there are too few, or packing and resistance disagree");
  }
  shapeton::Json document;
  document["provenance"] = shapeton::ProvenanceToJson(commandLine.GetProvenance());
  document["warnings"] = commandLine.GetWarnings();
  document.update(shapeton::ConformalTypeToJson(result, shapeton::NameOfNode(graphs.front(), result.root)));
  shapeton::WriteJson(document, path);
  if (!table.empty())
  {
    shapeton::BallTableOf(result).Write(table);
  }
  if (!svg.empty())
  {
    shapeton::WriteConformalTypeSvg(result, svg);
  }
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, Find);
}
