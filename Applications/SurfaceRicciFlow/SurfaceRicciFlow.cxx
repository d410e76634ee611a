#include "SurfaceRicciFlowXML.h"

#include "shapetonCommandLine.h"
#include "shapetonConformalMapPicture.h"
#include "shapetonExceptions.h"
#include "shapetonJson.h"
#include "shapetonReadOptions.h"
#include "shapetonSurfaceRicciFlow.h"
#include "shapetonSurfaceWriter.h"
#include "shapetonToolSurfaces.h"

namespace
{
using namespace shapeton;

/** The target curvatures in a point array of the surface. */
Eigen::VectorXd
CurvaturesIn(const SurfaceMesh & mesh, const std::string & name, const std::string & what)
{
  const SurfaceArray * array = FindSurfaceArray(mesh.pointArrays, name);
  if (!array || array->values.cols() != 1)
  {
    throw InputError(what + ": it has no point array \"" + name + "\" with one value per vertex");
  }
  return array->values.col(0);
}

void
Flow(CommandLine & commandLine)
{
  const std::string  flat = commandLine.MainOutput("flatSurface");
  const std::string  triangulation = commandLine.OutputOf("triangulation");
  const std::string  statistics = commandLine.OutputOf("statistics");
  const std::string  picture = commandLine.OutputOf("picture");
  SurfaceReadOptions reading;
  reading.anyExtent = true; // angles have no unit
  reading.takesOneComponent = true;
  const std::string        input = commandLine.GetString("inputSurface");
  const Surface            surface = ReadRepairedSurface(commandLine, "inputSurface", reading);
  SurfaceRicciFlowSettings options;
  ReadOptions(commandLine, options);
  if (const std::string array = commandLine.GetString("curvatureArray"); !array.empty())
  {
    options.targetCurvatures = CurvaturesIn(surface.mesh, array, input);
  }
  options.progress = commandLine.PartOfProgress(0.1, 0.9);
  const SurfaceRicciFlow flow = FlowSurface(surface.mesh, options, input);
  commandLine.Warn(flow.warnings);
  commandLine.Progress("Writing", 0.9);
  WriteSurface(flow.flat, commandLine.GetProvenance(), flat);
  if (!triangulation.empty())
  {
    WriteSurface(FinalTriangulation(surface.mesh, flow), commandLine.GetProvenance(), triangulation);
  }
  if (!picture.empty())
  {
    RequireParameter(flow.geometry != RicciGeometry::Spherical,
                     "--picture shows maps to the plane or the disk; the result is a sphere");
    WritePng(DrawFlatSurface(flow.flat, input), picture);
  }
  if (!statistics.empty())
  {
    commandLine.WriteDocument({ { "flow", SurfaceRicciFlowToJson(flow) } }, statistics);
  }
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, Flow);
}
