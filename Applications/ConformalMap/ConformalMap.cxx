#include "ConformalMapXML.h"

#include "shapetonCommandLine.h"
#include "shapetonConformalMapPicture.h"
#include "shapetonCsvTable.h"
#include "shapetonHeatDiffusionMetric.h"
#include "shapetonJson.h"
#include "shapetonReadOptions.h"
#include "shapetonSurfaceReader.h"
#include "shapetonToolSurfaces.h"
#include "shapetonSurfaceWriter.h"
#include "shapetonExceptions.h"

namespace
{
using namespace shapeton;

void
CheckUsage(const CommandLine & commandLine)
{
  const auto corners = commandLine.GetIntegers("corners");
  RequireParameter(corners.empty() || corners.size() == 4,
                   "--corners requires four vertices, for example --corners 0,10,20,30");
  RequireParameter(corners.empty() || commandLine.GetString("domain") == "rectangle",
                   "--corners requires --domain rectangle");
  RequireParameter(!commandLine.IsGiven("time") || commandLine.GetString("metric") == "heatDiffusion",
                   "--time requires --metric heatDiffusion");
  RequireParameter(!commandLine.IsGiven("forms") || commandLine.GetString("domain") == "slit",
                   "--forms requires --domain slit, the slit maps of all inner boundaries");
}

/** Edge lengths in the heat diffusion metric. */
Eigen::VectorXd
DiffusionLengths(CommandLine & commandLine, const SurfaceMesh & mesh)
{
  const SurfaceConnectivity connectivity(mesh);
  RequireOneManifold(connectivity, commandLine.GetString("inputSurface"));
  double time = commandLine.GetDouble("time");
  if (time == 0.0)
  {
    const double h = MeanEdgeAt55000Faces(connectivity, EdgeLengths(connectivity, mesh.V));
    time = 8.0 * h * h;
    commandLine.AddProvenance("chosen.time", CsvTable::Number(time));
  }
  return ComputeHeatDiffusionMetric(mesh, time).edgeLengths;
}

ConformalMap
MapOf(CommandLine & commandLine, const SurfaceMesh & mesh)
{
  ConformalMapSettings options;
  ReadOptions(commandLine, options);
  if (commandLine.GetString("metric") == "heatDiffusion")
  {
    options.edgeLengths = DiffusionLengths(commandLine, mesh);
  }
  return MapConformally(mesh, options, commandLine.GetString("inputSurface"));
}

/** Whether the surface was cut open to become this rectangle; repair would join the sides of the cut. */
bool
IsCutOpen(const CommandLine & commandLine)
{
  return commandLine.GetString("domain") == "rectangle" &&
         FindSurfaceArray(ReadSurfaceFile(commandLine.GetString("inputSurface")).mesh.fieldArrays, CutCorners) !=
           nullptr;
}

void
Flatten(CommandLine & commandLine)
{
  CheckUsage(commandLine);
  const std::string  flat = commandLine.MainOutput("flatSurface");
  const std::string  statistics = commandLine.OutputOf("statistics");
  const std::string  picture = commandLine.OutputOf("picture");
  const std::string  forms = commandLine.OutputOf("forms");
  SurfaceReadOptions options;
  options.anyExtent = true; // angles have no unit
  options.takesOneComponent = true;
  const Surface surface = IsCutOpen(commandLine) ? ReadSurface(commandLine, "inputSurface")
                                                 : ReadRepairedSurface(commandLine, "inputSurface", options);
  commandLine.Progress("Mapping", 0.1);
  const ConformalMap map = MapOf(commandLine, surface.mesh);
  commandLine.Warn(map.warnings);
  commandLine.Progress("Writing", 0.7);
  WriteSurface(map.flat, commandLine.GetProvenance(), flat);
  if (!statistics.empty())
  {
    commandLine.WriteDocument({ { "map", ConformalMapToJson(map) } }, statistics);
  }
  if (!picture.empty())
  {
    WritePng(DrawConformalMap(map), picture);
  }
  if (!forms.empty())
  {
    WritePng(DrawHolomorphicForms(map), forms);
  }
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, Flatten);
}
