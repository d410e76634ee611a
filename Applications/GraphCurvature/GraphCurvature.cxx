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
using shapeton::CommandLine;

/** The requested pictures; their file names are checked before the computation. */
struct Pictures
{
  explicit Pictures(CommandLine & commandLine)
    : svg(commandLine.OutputOf("svg"))
    , title(std::filesystem::path(commandLine.GetString("graph")).filename().string())
    , hasLabels(commandLine.GetFlag("labels"))
  {
    commandLine.LeaveOutOfProvenance("labels"); // affects pictures only
    if (commandLine.IsGiven("report"))
    {
      const std::string folder = commandLine.GetString("report");
      commandLine.MakeFolder(folder);
      report = commandLine.Output(folder + "/index.html");
    }
  }

  bool
  AreRequested() const
  {
    return !svg.empty() || !report.empty();
  }

  void
  Write(const shapeton::EmbeddingCertificate &  certificate,
        const shapeton::GraphCurvature &        curvature,
        const shapeton::GraphCurvatureOptions & options,
        CommandLine &                           commandLine) const
  {
    shapeton::GraphView view = shapeton::ViewOfCurvature(certificate, curvature, options);
    view.title = title;
    view.hasLabels = hasLabels;
    if (!svg.empty())
    {
      shapeton::WriteGraphSheetSvg({ view }, {}, svg);
    }
    if (!report.empty())
    {
      shapeton::GraphReport page{ "Curvature of " + title, { view } };
      page.paragraphs = {
        "Edges have the color of their curvature, circles that of the mean over the edges of the node. "
        "Negative: bridges between parts; positive: inside well-connected parts."
      };
      page.warnings = commandLine.GetWarnings();
      page.facts = shapeton::FactsOf(curvature);
      const auto & provenance = commandLine.GetProvenance();
      page.facts.insert(page.facts.end(), provenance.begin(), provenance.end());
      shapeton::WriteGraphReport(page, report);
    }
  }

  std::string svg;
  std::string report;
  std::string title;
  bool        hasLabels;
};

shapeton::EmbeddingCertificate
Embedded(CommandLine & commandLine, const shapeton::Graph & graph)
{
  shapeton::GenusSettings genus;
  shapeton::ReadOptions(commandLine, genus);
  shapeton::GraphEmbeddingSettings settings;
  settings.isRotationFree = true;
  commandLine.Progress("Genus", 0.5);
  const shapeton::SurfaceEmbedding surface = shapeton::FindEmbedding(graph, genus);
  commandLine.Progress("Circle packing", 0.7);
  shapeton::EmbeddingCertificate certificate = shapeton::EmbedGraph(graph, surface.map, settings);
  for (const std::string & warning : certificate.warnings)
  {
    commandLine.Warn(warning);
  }
  return certificate;
}

void
Measure(CommandLine & commandLine)
{
  const Pictures    pictures(commandLine);
  const std::string output = commandLine.GetString("table");
  const std::string path = commandLine.Output(output);
  const std::string nodesPath = commandLine.OutputOf("nodeTable");
  commandLine.RecordRun(output + ".run.json");
  const shapeton::Graph            graph = shapeton::ReadGraph(commandLine, "graph");
  shapeton::GraphCurvatureSettings settings;
  shapeton::ReadOptions(commandLine, settings);
  commandLine.Progress("Curvature", 0.05);
  const shapeton::GraphCurvature curvature = shapeton::MeasureCurvature(graph, settings);
  shapeton::EdgeTableOf(graph, curvature).Write(path);
  if (!nodesPath.empty())
  {
    shapeton::NodeTableOf(graph, curvature).Write(nodesPath);
  }
  if (pictures.AreRequested())
  {
    const shapeton::EmbeddingCertificate certificate = Embedded(commandLine, graph);
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
