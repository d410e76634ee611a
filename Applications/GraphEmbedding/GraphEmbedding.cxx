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
using namespace shapeton;

GraphEmbeddingSettings
OptionsOf(const CommandLine & commandLine)
{
  GraphEmbeddingSettings options;
  ReadOptions(commandLine, options);
  options.isRotationFree = !commandLine.IsGiven("rotation");
  return options;
}

void
WriteOntoMesh(CommandLine & commandLine, const EmbeddingCertificate & certificate, const std::string & path)
{
  SurfaceReadOptions options;
  options.anyExtent = true;
  options.takesOneComponent = true;
  const Surface     surface = ReadRepairedSurface(commandLine, "onto", options);
  const GraphOnMesh graph = MapGraphOntoMesh(certificate, surface.mesh, commandLine.GetString("onto"));
  commandLine.Warn(graph.warnings);
  WriteGraphOnMesh(graph, surface.mesh, ProvenanceMetadata(commandLine.GetProvenance()), path);
}

/** Rotation system of the graph: read from a file, or with a small genus. */
SurfaceEmbedding
SurfaceOf(CommandLine & commandLine, const Graph & graph)
{
  if (commandLine.IsGiven("rotation"))
  {
    return { ReadRotation(commandLine, "rotation", graph), 0, false };
  }
  GenusSettings options;
  ReadOptions(commandLine, options);
  return FindEmbedding(graph, options);
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
    options.disk = commandLine.GetString("disk") == "klein" ? DiskModel::Klein : DiskModel::Poincare;
    options.fromEdgeNode = commandLine.GetString("infinity") == "edgeNode";
    for (const char * name : { "disk", "part", "component", "unit" }) // the certificate does not depend on them
    {
      commandLine.LeaveOutOfProvenance(name);
    }
    if (const std::string folder = commandLine.MakeFolderOf("report"); !folder.empty())
    {
      report = commandLine.Output(folder + "/index.html");
    }
  }

  void
  Write(const EmbeddingCertificate & certificate) const
  {
    const GraphView view{ title, &certificate, {}, false };
    if (!svg.empty())
    {
      WriteGraphSvg(view, options, svg);
    }
    if (!vtp.empty())
    {
      WriteGraphVtp(certificate, certificate.provenance, vtp);
    }
    if (!surface.empty())
    {
      WriteGraphInSpace(certificate, certificate.provenance, surface);
    }
    if (!report.empty())
    {
      GraphReport page{ "Embedding of " + title, { view }, {},          certificate.warnings,
                        FactsOf(certificate),    {},       options.disk };
      WriteGraphReport(page, report);
    }
  }

  std::string         svg;
  std::string         vtp;
  std::string         surface;
  std::string         title;
  std::string         report;
  GraphPictureOptions options;
};

void
Embed(CommandLine & commandLine)
{
  RequireParameter(!commandLine.IsGiven("rotation") || !commandLine.IsGiven("genus"),
                   "--rotation determines the genus; omit --genus");
  RequireParameter(!commandLine.IsGiven("onto") || commandLine.IsGiven("surface"), "--onto requires --surface");
  Pictures          pictures(commandLine);
  const std::string onMesh = commandLine.IsGiven("onto") ? std::exchange(pictures.surface, "") : "";
  const std::string path = commandLine.MainOutput("certificate");
  const Graph       graph = ReadGraph(commandLine, "graph");
  commandLine.Progress("Genus", 0.05);
  const SurfaceEmbedding surface = SurfaceOf(commandLine, graph);
  commandLine.Progress("Circle packing", 0.3);
  EmbeddingCertificate certificate = EmbedGraph(graph, surface.map, OptionsOf(commandLine));
  if (!commandLine.IsGiven("rotation"))
  {
    certificate.statistics.emplace_back("genusLowerBound", surface.lowerBound);
    if (!surface.minimal && !commandLine.IsGiven("genus"))
    {
      commandLine.Warn("genus " + std::to_string(surface.map.Genus()) +
                       " is the smallest found, but not proved to be the smallest: the lower bound is " +
                       std::to_string(surface.lowerBound));
    }
  }
  commandLine.Warn(certificate.warnings);
  certificate.provenance = commandLine.GetProvenance();
  certificate.warnings = commandLine.GetWarnings();
  commandLine.Progress("Writing", 0.8);
  WriteEmbeddingCertificate(certificate, path);
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
