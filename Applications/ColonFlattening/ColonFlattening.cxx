#include "ColonFlatteningXML.h"

#include "shapetonColonFlatteningReport.h"
#include "shapetonCommandLine.h"
#include "shapetonJson.h"
#include "shapetonReadOptions.h"
#include "shapetonToolSurfaces.h"
#include "shapetonSurfaceWriter.h"
#include "shapetonExceptions.h"
#include "shapetonToolVolumes.h"

namespace
{
using namespace shapeton;

void
CheckUsage(const CommandLine & commandLine)
{
  const std::string metric = commandLine.GetString("metric");
  RequireParameter(metric != "euclidean" || !commandLine.IsGiven("time"),
                   "--time applies to the heat diffusion metric only, not to --metric euclidean");
  RequireParameter(metric == "truncatedHeatDiffusion" || !commandLine.IsGiven("eigenpairs"),
                   "--eigenpairs requires --metric truncatedHeatDiffusion; heatDiffusion uses all eigenpairs");
}

ColonFlatteningSettings
OptionsOf(CommandLine & commandLine)
{
  ColonFlatteningSettings options;
  ReadOptions(commandLine, options);
  if (commandLine.IsGiven("cut"))
  {
    options.cut = OnlyCurve(ReadCurves(commandLine, "cut"), commandLine.GetString("cut"));
  }
  if (commandLine.IsGiven("centerline"))
  {
    options.centerline = ReadCurves(commandLine, "centerline");
  }
  options.progress = commandLine.PartOfProgress(0.0, 0.9); // the rest: writing the files
  return options;
}

itk::Image<float, 3>::Pointer
ReadCt(CommandLine & commandLine)
{
  return commandLine.IsGiven("volume") ? ReadVolume(commandLine, "volume").image : nullptr;
}

void
Flatten(CommandLine & commandLine)
{
  CheckUsage(commandLine);
  const ColonFlatteningViews views(commandLine);
  const std::string          flatPath = commandLine.MainOutput("outputFlat");
  const std::string          handlesPath = commandLine.OutputOf("handles");
  const std::string          statisticsPath = commandLine.OutputOf("statistics");

  commandLine.Progress("Reading", 0.0);
  const itk::Image<float, 3>::Pointer ct = ReadCt(commandLine);
  const ColonFlatteningSettings       options = OptionsOf(commandLine);
  Surface                             surface = ReadSurface(commandLine, "inputSurface");
  ColonFlattening                     flattening =
    FlattenColon(std::move(surface.mesh), '"' + commandLine.GetString("inputSurface") + '"', options);
  commandLine.Warn(flattening.warnings);

  commandLine.Progress("Writing", 0.92);
  flattening.map.flat.facts = commandLine.GetProvenance();
  WriteSurface(flattening.map.flat, flatPath);
  if (!handlesPath.empty())
  {
    WriteHandles(flattening.handles.handles, commandLine.GetProvenance(), handlesPath);
  }
  if (!statisticsPath.empty())
  {
    commandLine.WriteDocument(ColonFlatteningToJson(flattening), statisticsPath);
  }
  commandLine.Progress("Painting", 0.94);
  views.Write(flattening, options.centerline, ct);
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, Flatten);
}
