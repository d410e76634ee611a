#include "ConformalMapXML.h"

#include "itkCommandLine.h"
#include "itkConformalMapPicture.h"
#include "itkCsvTable.h"
#include "itkHeatDiffusionMetric.h"
#include "itkToolSurfaces.h"
#include "itkSurfaceWriter.h"
#include "itkExceptions.h"

#include <filesystem>
#include <limits>

namespace
{
using itk::CommandLine;

void
CheckUsage(const CommandLine & commandLine)
{
  const auto        corners = commandLine.GetIntegers("corners");
  const std::string flat = commandLine.GetString("flatSurface");
  itk::RequireParameter(std::filesystem::path(flat).extension() == ".vtp",
                    "the output " + flat + " needs the extension .vtp, which keeps its arrays");
  itk::RequireParameter(corners.empty() || corners.size() == 4,
                    "--corners takes four vertices, for example --corners 0,10,20,30");
  itk::RequireParameter(corners.empty() || commandLine.GetString("domain") == "rectangle",
                    "--corners are those of a rectangle; give --domain rectangle");
  itk::RequireParameter(!commandLine.IsGiven("time") || commandLine.GetString("metric") == "heatDiffusion",
                    "--time is that of the heat diffusion metric; give --metric heatDiffusion");
}

itk::ConformalDomain
DomainOf(const std::string & name)
{
  return name == "rectangle" ? itk::ConformalDomain::Rectangle
         : name == "annulus" ? itk::ConformalDomain::Annulus
                             : itk::ConformalDomain::Slit;
}

/** The lengths of the edges in the metric of diffusion. */
Eigen::VectorXd
DiffusionLengths(CommandLine & commandLine, const itk::SurfaceMesh & mesh)
{
  const itk::SurfaceConnectivity connectivity(mesh);
  itk::RequireOneManifold(connectivity, commandLine.GetString("inputSurface"));
  double time = commandLine.GetDouble("time");
  if (time == 0.0)
  {
    time = itk::DefaultDiffusionTime(
      connectivity, itk::EdgeLengths(connectivity, mesh.V), std::numeric_limits<double>::infinity());
    commandLine.AddProvenance("chosen.time", itk::CsvTable::Number(time));
  }
  return itk::ComputeHeatDiffusionMetric(mesh, time).edgeLengths;
}

itk::ConformalMap
MapOf(CommandLine & commandLine, const itk::SurfaceMesh & mesh)
{
  itk::ConformalMapOptions options;
  options.domain = DomainOf(commandLine.GetString("domain"));
  options.outerBoundary = commandLine.GetInteger("outerBoundary");
  options.innerBoundary = commandLine.GetInteger("innerBoundary");
  options.corners = commandLine.GetIntegers("corners");
  if (commandLine.GetString("metric") == "heatDiffusion")
  {
    options.edgeLengths = DiffusionLengths(commandLine, mesh);
  }
  return itk::MapConformally(mesh, options, commandLine.GetString("inputSurface"));
}

void
WriteStatistics(const CommandLine & commandLine, const itk::ConformalMap & map, const std::string & path)
{
  itk::Json document;
  document["provenance"] = itk::ProvenanceToJson(commandLine.GetProvenance());
  document["warnings"] = commandLine.GetWarnings();
  document["map"] = itk::ConformalMapToJson(map);
  itk::WriteJson(document, path);
}

void
Flatten(CommandLine & commandLine)
{
  CheckUsage(commandLine);
  const std::string output = commandLine.GetString("flatSurface");
  const std::string flat = commandLine.Output(output);
  const std::string statistics = commandLine.OutputOf("statistics");
  const std::string picture = commandLine.OutputOf("picture");
  commandLine.RecordRun(output + ".run.json");
  const itk::Surface surface = itk::ReadRepairedSurface(commandLine, "inputSurface", true); // angles have no unit
  commandLine.Progress("Mapping", 0.1);
  const itk::ConformalMap map = MapOf(commandLine, surface.mesh);
  commandLine.Warn(map.warnings);
  commandLine.Progress("Writing", 0.7);
  itk::WriteSurface(map.flat, commandLine.GetProvenance(), flat);
  if (!statistics.empty())
  {
    WriteStatistics(commandLine, map, statistics);
  }
  if (!picture.empty())
  {
    itk::WritePng(itk::DrawConformalMap(map), picture);
  }
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, Flatten);
}
