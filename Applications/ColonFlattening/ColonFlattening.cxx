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
using shapeton::CommandLine;

void
CheckUsage(const CommandLine & commandLine)
{
  const std::string metric = commandLine.GetString("metric");
  shapeton::RequireParameter(metric != "euclidean" || !commandLine.IsGiven("time"),
                             "--time applies to the heat diffusion metric only, not to --metric euclidean");
  shapeton::RequireParameter(
    metric == "truncatedHeatDiffusion" || !commandLine.IsGiven("eigenpairs"),
    "--eigenpairs requires --metric truncatedHeatDiffusion; heatDiffusion uses all eigenpairs");
}

shapeton::ColonFlatteningSettings
OptionsOf(CommandLine & commandLine)
{
  shapeton::ColonFlatteningSettings options;
  shapeton::ReadOptions(commandLine, options);
  if (commandLine.IsGiven("cut"))
  {
    options.cut = shapeton::OnlyCurve(shapeton::ReadCurves(commandLine, "cut"), commandLine.GetString("cut"));
  }
  if (commandLine.IsGiven("centerline"))
  {
    options.centerline = shapeton::ReadCurves(commandLine, "centerline");
  }
  options.progress = commandLine.PartOfProgress(0.0, 0.9); // the rest: writing the files
  return options;
}

itk::Image<float, 3>::Pointer
ReadCt(CommandLine & commandLine)
{
  return commandLine.IsGiven("volume") ? shapeton::ReadVolume(commandLine, "volume").image : nullptr;
}

void
Flatten(CommandLine & commandLine)
{
  CheckUsage(commandLine);
  const shapeton::ColonFlatteningViews views(commandLine);
  const std::string                    flatPath = commandLine.OutputOf("outputFlat");
  const std::string                    handlesPath = commandLine.OutputOf("handles");
  const std::string                    statisticsPath = commandLine.OutputOf("statistics");
  commandLine.RecordRun(commandLine.GetString("outputFlat") + ".run.json");

  commandLine.Progress("Reading", 0.0);
  const itk::Image<float, 3>::Pointer     ct = ReadCt(commandLine);
  const shapeton::ColonFlatteningSettings options = OptionsOf(commandLine);
  shapeton::Surface                       surface = shapeton::ReadSurface(commandLine, "inputSurface");
  shapeton::ColonFlattening               flattening =
    shapeton::FlattenColon(std::move(surface.mesh), '"' + commandLine.GetString("inputSurface") + '"', options);
  commandLine.Warn(flattening.warnings);

  commandLine.Progress("Writing", 0.92);
  flattening.map.flat.facts = commandLine.GetProvenance();
  shapeton::WriteSurface(flattening.map.flat, flatPath);
  if (!handlesPath.empty())
  {
    shapeton::WriteHandles(flattening.handles.handles, commandLine.GetProvenance(), handlesPath);
  }
  if (!statisticsPath.empty())
  {
    shapeton::Json document;
    document["provenance"] = shapeton::ProvenanceToJson(commandLine.GetProvenance());
    document["warnings"] = commandLine.GetWarnings();
    document.update(shapeton::ColonFlatteningToJson(flattening));
    shapeton::WriteJson(document, statisticsPath);
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
