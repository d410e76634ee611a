#include "ConformalMapXML.h"

#include "shapetonCommandLine.h"
#include "shapetonConformalMapPicture.h"
#include "shapetonCsvTable.h"
#include "shapetonHeatDiffusionMetric.h"
#include "shapetonJson.h"
#include "shapetonReadOptions.h"
#include "shapetonToolSurfaces.h"
#include "shapetonSurfaceWriter.h"
#include "shapetonExceptions.h"

#include <filesystem>
#include <limits>

namespace
{
using shapeton::CommandLine;

void
CheckUsage(const CommandLine & commandLine)
{
  const auto        corners = commandLine.GetIntegers("corners");
  const std::string flat = commandLine.GetString("flatSurface");
  shapeton::RequireParameter(std::filesystem::path(flat).extension() == ".vtp",
                             "the output " + flat + " must have the extension .vtp, which stores its arrays");
  shapeton::RequireParameter(corners.empty() || corners.size() == 4,
                             "--corners requires four vertices, for example --corners 0,10,20,30");
  shapeton::RequireParameter(corners.empty() || commandLine.GetString("domain") == "rectangle",
                             "--corners requires --domain rectangle");
  shapeton::RequireParameter(!commandLine.IsGiven("time") || commandLine.GetString("metric") == "heatDiffusion",
                             "--time requires --metric heatDiffusion");
  shapeton::RequireParameter(!commandLine.IsGiven("forms") || commandLine.GetString("domain") == "slit",
                             "--forms requires --domain slit, the slit maps of all inner boundaries");
}

/** Edge lengths in the heat diffusion metric. */
Eigen::VectorXd
DiffusionLengths(CommandLine & commandLine, const shapeton::SurfaceMesh & mesh)
{
  const shapeton::SurfaceConnectivity connectivity(mesh);
  shapeton::RequireOneManifold(connectivity, commandLine.GetString("inputSurface"));
  double time = commandLine.GetDouble("time");
  if (time == 0.0)
  {
    const double h = shapeton::MeanEdgeAt55000Faces(connectivity, shapeton::EdgeLengths(connectivity, mesh.V));
    time = 8.0 * h * h;
    commandLine.AddProvenance("chosen.time", shapeton::CsvTable::Number(time));
  }
  return shapeton::ComputeHeatDiffusionMetric(mesh, time).edgeLengths;
}

shapeton::ConformalMap
MapOf(CommandLine & commandLine, const shapeton::SurfaceMesh & mesh)
{
  shapeton::ConformalMapSettings options;
  shapeton::ReadOptions(commandLine, options);
  if (commandLine.GetString("metric") == "heatDiffusion")
  {
    options.edgeLengths = DiffusionLengths(commandLine, mesh);
  }
  return shapeton::MapConformally(mesh, options, commandLine.GetString("inputSurface"));
}

void
WriteStatistics(const CommandLine & commandLine, const shapeton::ConformalMap & map, const std::string & path)
{
  shapeton::Json document;
  document["provenance"] = shapeton::ProvenanceToJson(commandLine.GetProvenance());
  document["warnings"] = commandLine.GetWarnings();
  document["map"] = shapeton::ConformalMapToJson(map);
  shapeton::WriteJson(document, path);
}

void
Flatten(CommandLine & commandLine)
{
  CheckUsage(commandLine);
  const std::string output = commandLine.GetString("flatSurface");
  const std::string flat = commandLine.Output(output);
  const std::string statistics = commandLine.OutputOf("statistics");
  const std::string picture = commandLine.OutputOf("picture");
  const std::string forms = commandLine.OutputOf("forms");
  commandLine.RecordRun(output + ".run.json");
  shapeton::SurfaceReadOptions options;
  options.anyExtent = true; // angles have no unit
  options.takesOneComponent = true;
  const shapeton::Surface surface = shapeton::ReadRepairedSurface(commandLine, "inputSurface", options);
  commandLine.Progress("Mapping", 0.1);
  const shapeton::ConformalMap map = MapOf(commandLine, surface.mesh);
  commandLine.Warn(map.warnings);
  commandLine.Progress("Writing", 0.7);
  shapeton::WriteSurface(map.flat, commandLine.GetProvenance(), flat);
  if (!statistics.empty())
  {
    WriteStatistics(commandLine, map, statistics);
  }
  if (!picture.empty())
  {
    shapeton::WritePng(shapeton::DrawConformalMap(map), picture);
  }
  if (!forms.empty())
  {
    shapeton::WritePng(shapeton::DrawHolomorphicForms(map), forms);
  }
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, Flatten);
}
