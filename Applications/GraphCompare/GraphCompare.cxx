#include "GraphCompareXML.h"

#include "shapetonCommandLine.h"
#include "shapetonCsvTable.h"
#include "shapetonGraphComparisonPictures.h"
#include "shapetonJson.h"
#include "shapetonReadOptions.h"
#include "shapetonToolGraphs.h"

namespace
{
using shapeton::CommandLine;

/** One row per pair of corresponding nodes, with their common color; unmatched nodes have separate rows. */
shapeton::CsvTable
TableOfNodes(const shapeton::GraphComparison & comparison)
{
  const auto               colors = shapeton::ColorsOfNodes(comparison);
  const std::vector<int> & image = comparison.correspondence.image;
  const shapeton::Graph &  a = comparison.a.graph;
  const shapeton::Graph &  b = comparison.b.graph;
  std::vector<bool>        hasPartner(b.nodes, false);
  shapeton::CsvTable       table({ "a", "b", "color" });
  for (int v = 0; v < a.nodes; ++v)
  {
    const bool found = image[v] >= 0;
    table.AddRow({ shapeton::NameOfNode(a, v), found ? shapeton::NameOfNode(b, image[v]) : "", colors[0][v] });
    if (found)
    {
      hasPartner[image[v]] = true;
    }
  }
  for (int v = 0; v < b.nodes; ++v)
  {
    if (!hasPartner[v])
    {
      table.AddRow({ "", shapeton::NameOfNode(b, v), colors[1][v] });
    }
  }
  return table;
}

void
WriteCertificate(CommandLine & commandLine, shapeton::EmbeddingCertificate & certificate, const std::string & path)
{
  certificate.provenance = commandLine.GetProvenance();
  shapeton::WriteEmbeddingCertificate(certificate, path);
}

void
Compare(CommandLine & commandLine)
{
  const std::string folder = commandLine.GetString("outputFolder");
  commandLine.MakeFolder(folder);
  const std::string comparisonPath = commandLine.Output(folder + "/comparison.json");
  const std::string nodesPath = commandLine.Output(folder + "/nodes.csv");
  const std::string pathA = commandLine.Output(folder + "/a.json");
  const std::string pathB = commandLine.Output(folder + "/b.json");
  commandLine.RecordRun(folder + "/run.json");
  commandLine.LeaveOutOfProvenance("labels"); // affects pictures only

  const shapeton::Graph   a = shapeton::ReadGraph(commandLine, "graphA");
  const shapeton::Graph   b = shapeton::ReadGraph(commandLine, "graphB");
  shapeton::GenusSettings genus;
  shapeton::ReadOptions(commandLine, genus);
  commandLine.Progress("Comparing", 0.1);
  shapeton::GraphComparison comparison = shapeton::CompareGraphs(a, b, genus);
  for (const auto * certificate : { &comparison.a, &comparison.b })
  {
    for (const std::string & warning : certificate->warnings)
    {
      commandLine.Warn((certificate == &comparison.a ? "first graph: " : "second graph: ") + warning);
    }
  }

  commandLine.Progress("Writing", 0.9);
  shapeton::Json document;
  document["provenance"] = shapeton::ProvenanceToJson(commandLine.GetProvenance());
  document["warnings"] = commandLine.GetWarnings();
  document.update(shapeton::ComparisonToJson(comparison));
  shapeton::WriteJson(document, comparisonPath);
  TableOfNodes(comparison).Write(nodesPath);
  WriteCertificate(commandLine, comparison.a, pathA);
  WriteCertificate(commandLine, comparison.b, pathB);
  commandLine.Progress("Painting", 0.95);
  shapeton::WriteComparisonPictures(
    comparison,
    { folder, commandLine.GetFlag("labels"), commandLine.GetProvenance(), commandLine.GetWarnings() },
    [&](const std::string & path) { return commandLine.Output(path); });
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, Compare);
}
