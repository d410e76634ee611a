#include "GraphCompareXML.h"

#include "shapetonCommandLine.h"
#include "shapetonCsvTable.h"
#include "shapetonGraphComparisonPictures.h"
#include "shapetonJson.h"
#include "shapetonReadOptions.h"
#include "shapetonToolGraphs.h"

namespace
{
using namespace shapeton;

/** One row per pair of corresponding nodes, with their common color; unmatched nodes have separate rows. */
CsvTable
TableOfNodes(const GraphComparison & comparison)
{
  const auto               colors = ColorsOfNodes(comparison);
  const std::vector<int> & image = comparison.correspondence.image;
  const Graph &            a = comparison.a.graph;
  const Graph &            b = comparison.b.graph;
  std::vector<bool>        hasPartner(b.nodes, false);
  CsvTable                 table({ "a", "b", "color" });
  for (int v = 0; v < a.nodes; ++v)
  {
    const bool found = image[v] >= 0;
    table.AddRow({ NameOfNode(a, v), found ? NameOfNode(b, image[v]) : "", colors[0][v] });
    if (found)
    {
      hasPartner[image[v]] = true;
    }
  }
  for (int v = 0; v < b.nodes; ++v)
  {
    if (!hasPartner[v])
    {
      table.AddRow({ "", NameOfNode(b, v), colors[1][v] });
    }
  }
  return table;
}

void
WriteCertificate(CommandLine & commandLine, EmbeddingCertificate & certificate, const std::string & path)
{
  certificate.provenance = commandLine.GetProvenance();
  WriteEmbeddingCertificate(certificate, path);
}

void
Compare(CommandLine & commandLine)
{
  const std::string folder = commandLine.MakeFolderOf("outputFolder");
  const std::string comparisonPath = commandLine.Output(folder + "/comparison.json");
  const std::string nodesPath = commandLine.Output(folder + "/nodes.csv");
  const std::string pathA = commandLine.Output(folder + "/a.json");
  const std::string pathB = commandLine.Output(folder + "/b.json");
  commandLine.RecordRun(folder + "/run.json");
  commandLine.LeaveOutOfProvenance("labels"); // affects pictures only

  const Graph   a = ReadGraph(commandLine, "graphA");
  const Graph   b = ReadGraph(commandLine, "graphB");
  GenusSettings genus;
  ReadOptions(commandLine, genus);
  commandLine.Progress("Comparing", 0.1);
  GraphComparison comparison = CompareGraphs(a, b, genus);
  for (const auto * certificate : { &comparison.a, &comparison.b })
  {
    for (const std::string & warning : certificate->warnings)
    {
      commandLine.Warn((certificate == &comparison.a ? "first graph: " : "second graph: ") + warning);
    }
  }

  commandLine.Progress("Writing", 0.9);
  commandLine.WriteDocument(ComparisonToJson(comparison), comparisonPath);
  TableOfNodes(comparison).Write(nodesPath);
  WriteCertificate(commandLine, comparison.a, pathA);
  WriteCertificate(commandLine, comparison.b, pathB);
  commandLine.Progress("Painting", 0.95);
  WriteComparisonPictures(
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
