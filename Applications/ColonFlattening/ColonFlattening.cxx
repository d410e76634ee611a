#include "ColonFlatteningXML.h"

#include "itkColonFlatteningReport.h"
#include "itkCommandLine.h"
#include "itkToolSurfaces.h"
#include "itkSurfaceWriter.h"
#include "itkExceptions.h"
#include "itkToolVolumes.h"

namespace
{
using itk::CommandLine;

void
CheckUsage(const CommandLine & commandLine)
{
  const std::string metric = commandLine.GetString("metric");
  itk::RequireParameter(metric != "euclidean" || !commandLine.IsGiven("time"),
                    "--time belongs to the heat diffusion metric; --metric euclidean has none");
  itk::RequireParameter(metric == "truncatedHeatDiffusion" || !commandLine.IsGiven("eigenpairs"),
                    "--eigenpairs belongs to --metric truncatedHeatDiffusion; heatDiffusion takes all of them");
}

itk::ColonFlatteningOptions
OptionsOf(CommandLine & commandLine)
{
  itk::ColonFlatteningOptions options;
  const std::string           metric = commandLine.GetString("metric");
  options.metric = metric == "euclidean"       ? itk::FlatMetric::Euclidean
                   : metric == "heatDiffusion" ? itk::FlatMetric::HeatDiffusion
                                               : itk::FlatMetric::TruncatedHeatDiffusion;
  options.time = commandLine.GetDouble("time");
  options.eigenpairs = commandLine.GetInteger("eigenpairs");
  options.removeHandles = commandLine.GetFlag("removeHandles");
  options.tube.conjugate =
    commandLine.GetString("method") == "published" ? itk::TubeConjugate::Published : itk::TubeConjugate::Laplacian;
  if (commandLine.IsGiven("cut"))
  {
    options.tube.cutCurve = itk::OnlyCurve(itk::ReadCurves(commandLine, "cut"), commandLine.GetString("cut"));
  }
  if (commandLine.IsGiven("centreline"))
  {
    options.centreline = itk::ReadCurves(commandLine, "centreline");
  }
  options.progress = commandLine.PartOfProgress(0.0, 0.9); // then the files are written
  return options;
}

itk::Image<float, 3>::Pointer
ReadCt(CommandLine & commandLine)
{
  return commandLine.IsGiven("volume") ? itk::ReadVolume(commandLine, "volume").image : nullptr;
}

void
Flatten(CommandLine & commandLine)
{
  CheckUsage(commandLine);
  const itk::ColonFlatteningViews views(commandLine);
  const std::string               flatPath = commandLine.OutputOf("outputFlat");
  const std::string               handlesPath = commandLine.OutputOf("handles");
  const std::string               statisticsPath = commandLine.OutputOf("statistics");
  commandLine.RecordRun(commandLine.GetString("outputFlat") + ".run.json");

  commandLine.Progress("Reading", 0.0);
  const itk::Image<float, 3>::Pointer ct = ReadCt(commandLine);
  const itk::ColonFlatteningOptions   options = OptionsOf(commandLine);
  itk::Surface                        surface = itk::ReadSurface(commandLine, "inputSurface");
  itk::ColonFlattening                flattening =
    itk::FlattenColon(std::move(surface.mesh), '"' + commandLine.GetString("inputSurface") + '"', options);
  commandLine.Warn(flattening.warnings);

  commandLine.Progress("Writing", 0.92);
  flattening.map.flat.facts = commandLine.GetProvenance();
  itk::WriteSurface(flattening.map.flat, flatPath);
  if (!handlesPath.empty())
  {
    itk::WriteHandles(flattening.handles.handles, commandLine.GetProvenance(), handlesPath);
  }
  if (!statisticsPath.empty())
  {
    itk::Json document;
    document["provenance"] = itk::ProvenanceToJson(commandLine.GetProvenance());
    document["warnings"] = commandLine.GetWarnings();
    document.update(itk::ColonFlatteningToJson(flattening));
    itk::WriteJson(document, statisticsPath);
  }
  commandLine.Progress("Painting", 0.94);
  views.Write(flattening, options.centreline, ct);
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, Flatten);
}
