#include "GraphEmbeddingXML.h"

#include "shapetonCommandLine.h"
#include "shapetonGraphEmbedding.h"
#include "shapetonGraphGenus.h"
#include "shapetonGraphInSpace.h"
#include "shapetonGraphOnMesh.h"
#include "shapetonReadOptions.h"
#include "shapetonToolSurfaces.h"
#include "shapetonToolGraphs.h"
#include "shapetonGraphReport.h"
#include "shapetonExceptions.h"

#include <filesystem>
#include <utility>

namespace
{
using shapeton::CommandLine;

shapeton::GraphEmbeddingSettings
OptionsOf(const CommandLine & commandLine)
{
  shapeton::GraphEmbeddingSettings options;
  shapeton::ReadOptions(commandLine, options);
  options.isRotationFree = !commandLine.IsGiven("rotation");
  return options;
}

void
WriteOntoMesh(CommandLine & commandLine, const shapeton::EmbeddingCertificate & certificate, const std::string & path)
{
  shapeton::SurfaceReadOptions options;
  options.anyExtent = true;
  options.takesOneComponent = true;
  const shapeton::Surface     surface = shapeton::ReadRepairedSurface(commandLine, "onto", options);
  const shapeton::GraphOnMesh graph =
    shapeton::MapGraphOntoMesh(certificate, surface.mesh, commandLine.GetString("onto"));
  commandLine.Warn(graph.warnings);
  shapeton::WriteGraphOnMesh(graph, surface.mesh, shapeton::ProvenanceMetadata(commandLine.GetProvenance()), path);
}

/** Rotation system of the graph: read from a file, or with a small genus. */
shapeton::SurfaceEmbedding
SurfaceOf(CommandLine & commandLine, const shapeton::Graph & graph)
{
  if (commandLine.IsGiven("rotation"))
  {
    return { shapeton::ReadRotation(commandLine, "rotation", graph), 0, false };
  }
  shapeton::GenusSettings options;
  shapeton::ReadOptions(commandLine, options);
  return shapeton::FindEmbedding(graph, options);
}

/** The requested pictures; their file names are checked before the computation. */
struct Pictures
{
  explicit Pictures(CommandLine & commandLine)
    : svg(commandLine.OutputOf("svg"))
    , vtp(commandLine.OutputOf("vtp"))
    , surface(commandLine.OutputOf("surface"))
    , title(std::filesystem::path(commandLine.GetString("graph")).filename().string())
  {
    options.disk =
      commandLine.GetString("disk") == "klein" ? shapeton::DiskModel::Klein : shapeton::DiskModel::Poincare;
    for (const char * name : { "disk", "part", "component", "unit" }) // the certificate does not depend on them
    {
      commandLine.LeaveOutOfProvenance(name);
    }
    if (commandLine.IsGiven("report"))
    {
      const std::string folder = commandLine.GetString("report");
      commandLine.MakeFolder(folder);
      report = commandLine.Output(folder + "/index.html");
    }
  }

  void
  Write(const shapeton::EmbeddingCertificate & certificate) const
  {
    const shapeton::GraphView view{ title, &certificate, {}, false };
    if (!svg.empty())
    {
      shapeton::WriteGraphSvg(view, options, svg);
    }
    if (!vtp.empty())
    {
      shapeton::WriteGraphVtp(certificate, certificate.provenance, vtp);
    }
    if (!surface.empty())
    {
      shapeton::WriteGraphInSpace(certificate, certificate.provenance, surface);
    }
    if (!report.empty())
    {
      shapeton::GraphReport page{ "Embedding of " + title,        { view }, {},          certificate.warnings,
                                  shapeton::FactsOf(certificate), {},       options.disk };
      shapeton::WriteGraphReport(page, report);
    }
  }

  std::string                   svg;
  std::string                   vtp;
  std::string                   surface;
  std::string                   title;
  std::string                   report;
  shapeton::GraphPictureOptions options;
};

void
Embed(CommandLine & commandLine)
{
  shapeton::RequireParameter(!commandLine.IsGiven("rotation") || !commandLine.IsGiven("genus"),
                             "--rotation determines the genus; omit --genus");
  shapeton::RequireParameter(!commandLine.IsGiven("onto") || commandLine.IsGiven("surface"),
                             "--onto requires --surface");
  Pictures          pictures(commandLine);
  const std::string onMesh = commandLine.IsGiven("onto") ? std::exchange(pictures.surface, "") : "";
  const std::string output = commandLine.GetString("certificate");
  const std::string path = commandLine.Output(output);
  commandLine.RecordRun(output + ".run.json");
  const shapeton::Graph graph = shapeton::ReadGraph(commandLine, "graph");
  commandLine.Progress("Genus", 0.05);
  const shapeton::SurfaceEmbedding surface = SurfaceOf(commandLine, graph);
  commandLine.Progress("Circle packing", 0.3);
  shapeton::EmbeddingCertificate certificate = shapeton::EmbedGraph(graph, surface.map, OptionsOf(commandLine));
  if (!commandLine.IsGiven("rotation"))
  {
    certificate.statistics.emplace_back("genusLowerBound", surface.lowerBound);
  }
  commandLine.Warn(certificate.warnings);
  certificate.provenance = commandLine.GetProvenance();
  certificate.warnings = commandLine.GetWarnings();
  commandLine.Progress("Writing", 0.8);
  shapeton::WriteEmbeddingCertificate(certificate, path);
  commandLine.Progress("Painting", 0.9);
  pictures.Write(certificate);
  if (!onMesh.empty())
  {
    WriteOntoMesh(commandLine, certificate, onMesh);
  }
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, Embed);
}
