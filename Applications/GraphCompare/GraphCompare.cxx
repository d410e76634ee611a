#include "GraphCompareXML.h"

#include "itkCommandLine.h"
#include "itkCsvTable.h"
#include "itkGraphComparisonPictures.h"
#include "itkToolGraphs.h"

namespace
{
using itk::CommandLine;

/** One row for each node of both graphs: its colour is that of its partner. */
itk::CsvTable
TableOfNodes(const itk::GraphComparison & comparison)
{
  const auto               colours = itk::ColoursOfNodes(comparison);
  const std::vector<int> & image = comparison.correspondence.image;
  const itk::Graph &       a = comparison.a.graph;
  const itk::Graph &       b = comparison.b.graph;
  std::vector<bool>        hasPartner(b.nodes, false);
  itk::CsvTable            table({ "a", "b", "colour" });
  for (int v = 0; v < a.nodes; ++v)
  {
    const bool found = image[v] >= 0;
    table.AddRow({ itk::NameOfNode(a, v), found ? itk::NameOfNode(b, image[v]) : "", colours[0][v] });
    if (found)
    {
      hasPartner[image[v]] = true;
    }
  }
  for (int v = 0; v < b.nodes; ++v)
  {
    if (!hasPartner[v])
    {
      table.AddRow({ "", itk::NameOfNode(b, v), colours[1][v] });
    }
  }
  return table;
}

void
WriteCertificate(CommandLine & commandLine, itk::EmbeddingCertificate & certificate, const std::string & path)
{
  certificate.provenance = commandLine.GetProvenance();
  itk::WriteEmbeddingCertificate(certificate, path);
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
  commandLine.LeaveOutOfProvenance("labels"); // of pictures alone

  const itk::Graph  a = itk::ReadGraph(commandLine, "graphA");
  const itk::Graph  b = itk::ReadGraph(commandLine, "graphB");
  itk::GenusOptions genus;
  genus.seed = static_cast<std::uint64_t>(commandLine.GetInteger("seed"));
  commandLine.Progress("Comparing", 0.1);
  itk::GraphComparison comparison = itk::CompareGraphs(a, b, genus);
  for (const auto * certificate : { &comparison.a, &comparison.b })
  {
    for (const std::string & warning : certificate->warnings)
    {
      commandLine.Warn((certificate == &comparison.a ? "first graph: " : "second graph: ") + warning);
    }
  }

  commandLine.Progress("Writing", 0.9);
  itk::Json document;
  document["provenance"] = itk::ProvenanceToJson(commandLine.GetProvenance());
  document["warnings"] = commandLine.GetWarnings();
  document.update(itk::ComparisonToJson(comparison));
  itk::WriteJson(document, comparisonPath);
  TableOfNodes(comparison).Write(nodesPath);
  WriteCertificate(commandLine, comparison.a, pathA);
  WriteCertificate(commandLine, comparison.b, pathB);
  commandLine.Progress("Painting", 0.95);
  itk::WriteComparisonPictures(
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
