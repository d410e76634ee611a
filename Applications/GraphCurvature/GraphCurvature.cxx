#include "GraphCurvatureXML.h"

#include "shapetonCommandLine.h"
#include "shapetonGraphCurvatureReport.h"
#include "shapetonGraphEmbedding.h"
#include "shapetonGraphGenus.h"
#include "shapetonGraphReport.h"
#include "shapetonReadOptions.h"
#include "shapetonToolGraphs.h"

#include <filesystem>

namespace
{
using namespace shapeton;

/** The requested pictures; their file names are checked before the computation. */
struct Pictures
{
  explicit Pictures(CommandLine & commandLine)
    : svg(commandLine.OutputOf("svg"))
    , title(std::filesystem::path(commandLine.GetString("graph")).filename().string())
    , hasLabels(commandLine.GetFlag("labels"))
  {
    commandLine.LeaveOutOfProvenance("labels"); // affects pictures only
    if (const std::string folder = commandLine.MakeFolderOf("report"); !folder.empty())
    {
      report = commandLine.Output(folder + "/index.html");
    }
  }

  bool
  AreRequested() const
  {
    return !svg.empty() || !report.empty();
  }

  void
  Write(const EmbeddingCertificate &  certificate,
        const GraphCurvature &        curvature,
        const GraphCurvatureOptions & options,
        CommandLine &                 commandLine) const
  {
    GraphView view = ViewOfCurvature(certificate, curvature, options);
    view.title = title;
    view.hasLabels = hasLabels;
    if (!svg.empty())
    {
      WriteGraphSheetSvg({ view }, {}, svg);
    }
    if (!report.empty())
    {
      GraphReport page{ "Curvature of " + title, { view } };
      page.paragraphs = {
        "Edges have the color of their curvature, circles that of the mean over the edges of the node. "
        "Negative: bridges between parts; positive: inside well-connected parts."
      };
      page.warnings = commandLine.GetWarnings();
      page.facts = FactsOf(curvature);
      const auto & provenance = commandLine.GetProvenance();
      page.facts.insert(page.facts.end(), provenance.begin(), provenance.end());
      WriteGraphReport(page, report);
    }
  }

  std::string svg;
  std::string report;
  std::string title;
  bool        hasLabels;
};

EmbeddingCertificate
Embedded(CommandLine & commandLine, const Graph & graph)
{
  GenusSettings genus;
  ReadOptions(commandLine, genus);
  GraphEmbeddingSettings settings;
  settings.isRotationFree = true;
  commandLine.Progress("Genus", 0.5);
  const SurfaceEmbedding surface = FindEmbedding(graph, genus);
  commandLine.Progress("Circle packing", 0.7);
  EmbeddingCertificate certificate = EmbedGraph(graph, surface.map, settings);
  commandLine.Warn(certificate.warnings);
  return certificate;
}

void
Measure(CommandLine & commandLine)
{
  const Pictures         pictures(commandLine);
  const std::string      path = commandLine.MainOutput("table");
  const std::string      nodesPath = commandLine.OutputOf("nodeTable");
  const Graph            graph = ReadGraph(commandLine, "graph");
  GraphCurvatureSettings settings;
  ReadOptions(commandLine, settings);
  commandLine.Progress("Curvature", 0.05);
  const GraphCurvature curvature = MeasureCurvature(graph, settings);
  EdgeTableOf(graph, curvature).Write(path);
  if (!nodesPath.empty())
  {
    NodeTableOf(graph, curvature).Write(nodesPath);
  }
  if (pictures.AreRequested())
  {
    const EmbeddingCertificate certificate = Embedded(commandLine, graph);
    commandLine.Progress("Painting", 0.9);
    pictures.Write(certificate, curvature, settings, commandLine);
  }
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, Measure);
}
