#include "SurfaceRicciFlowXML.h"

#include "shapetonCommandLine.h"
#include "shapetonConformalMapPicture.h"
#include "shapetonExceptions.h"
#include "shapetonJson.h"
#include "shapetonReadOptions.h"
#include "shapetonSurfaceRicciFlow.h"
#include "shapetonSurfaceWriter.h"
#include "shapetonToolSurfaces.h"

#include <filesystem>

namespace
{
using shapeton::CommandLine;

void
CheckUsage(const CommandLine & commandLine)
{
  for (const char * name : { "flatSurface", "triangulation" })
  {
    const std::string path = commandLine.GetString(name);
    shapeton::RequireParameter(path.empty() || std::filesystem::path(path).extension() == ".vtp",
                               "the output " + path + " must have the extension .vtp, which stores its arrays");
  }
}

/** The target curvatures in a point array of the surface. */
Eigen::VectorXd
CurvaturesIn(const shapeton::SurfaceMesh & mesh, const std::string & name, const std::string & what)
{
  const shapeton::SurfaceArray * array = shapeton::FindSurfaceArray(mesh.pointArrays, name);
  if (!array || array->values.cols() != 1)
  {
    throw shapeton::InputError(what + ": it has no point array \"" + name + "\" with one value per vertex");
  }
  return array->values.col(0);
}

void
WriteStatistics(const CommandLine & commandLine, const shapeton::SurfaceRicciFlow & flow, const std::string & path)
{
  shapeton::Json document;
  document["provenance"] = shapeton::ProvenanceToJson(commandLine.GetProvenance());
  document["warnings"] = commandLine.GetWarnings();
  document["flow"] = shapeton::SurfaceRicciFlowToJson(flow);
  shapeton::WriteJson(document, path);
}

void
Flow(CommandLine & commandLine)
{
  CheckUsage(commandLine);
  const std::string output = commandLine.GetString("flatSurface");
  const std::string flat = commandLine.Output(output);
  const std::string triangulation = commandLine.OutputOf("triangulation");
  const std::string statistics = commandLine.OutputOf("statistics");
  const std::string picture = commandLine.OutputOf("picture");
  commandLine.RecordRun(output + ".run.json");
  shapeton::SurfaceReadOptions reading;
  reading.anyExtent = true; // angles have no unit
  reading.takesOneComponent = true;
  const std::string                  input = commandLine.GetString("inputSurface");
  const shapeton::Surface            surface = shapeton::ReadRepairedSurface(commandLine, "inputSurface", reading);
  shapeton::SurfaceRicciFlowSettings options;
  shapeton::ReadOptions(commandLine, options);
  if (const std::string array = commandLine.GetString("curvatureArray"); !array.empty())
  {
    options.targetCurvatures = CurvaturesIn(surface.mesh, array, input);
  }
  options.progress = commandLine.PartOfProgress(0.1, 0.9);
  const shapeton::SurfaceRicciFlow flow = shapeton::FlowSurface(surface.mesh, options, input);
  commandLine.Warn(flow.warnings);
  commandLine.Progress("Writing", 0.9);
  shapeton::WriteSurface(flow.flat, commandLine.GetProvenance(), flat);
  if (!triangulation.empty())
  {
    shapeton::WriteSurface(
      shapeton::FinalTriangulation(surface.mesh, flow), commandLine.GetProvenance(), triangulation);
  }
  if (!picture.empty())
  {
    shapeton::RequireParameter(flow.geometry != shapeton::RicciGeometry::Spherical,
                               "--picture shows maps to the plane or the disk; the result is a sphere");
    shapeton::WritePng(shapeton::DrawFlatSurface(flow.flat, input), picture);
  }
  if (!statistics.empty())
  {
    WriteStatistics(commandLine, flow, statistics);
  }
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, Flow);
}
