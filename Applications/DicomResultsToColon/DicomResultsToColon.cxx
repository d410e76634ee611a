#include "DicomResultsToColonXML.h"

#include "shapetonCommandLine.h"
#include "shapetonDicomToColon.h"
#include "shapetonExceptions.h"
#include "shapetonReadOptions.h"
#include "shapetonSha256.h"
#include "shapetonVolumeWriter.h"

#include <algorithm>

namespace
{
using shapeton::CommandLine;

bool
IsOfReport(const CommandLine & commandLine)
{
  return commandLine.IsGiven("markers") || commandLine.IsGiven("verdicts");
}

void
CheckUsage(const CommandLine & commandLine)
{
  const bool ofSegments = commandLine.IsGiven("mask") || commandLine.IsGiven("labels") || commandLine.IsGiven("table");
  shapeton::RequireParameter(ofSegments || IsOfReport(commandLine),
                             "no output requested: use --mask, --labels or --table for a segmentation, --markers or "
                             "--verdicts for a report");
  shapeton::RequireParameter(
    !ofSegments || !IsOfReport(commandLine),
    "--markers and --verdicts require a report; --mask, --labels and --table require a segmentation");
  shapeton::RequireParameter(commandLine.IsGiven("verdicts") == commandLine.IsGiven("exam"),
                             "--verdicts requires --exam, the examination whose candidates the report judges, and "
                             "--exam requires --verdicts");
  shapeton::RequireVolumeName(commandLine.GetString("mask"));
  shapeton::RequireVolumeName(commandLine.GetString("labels"));
}

/** Mask that is 1 in all segments. */
itk::Image<unsigned char, 3>::Pointer
MaskOf(const shapeton::DicomLabelImage * labels)
{
  const auto mask = itk::Image<unsigned char, 3>::New();
  mask->CopyInformation(labels);
  mask->SetRegions(labels->GetBufferedRegion());
  mask->Allocate();
  std::transform(labels->GetBufferPointer(),
                 labels->GetBufferPointer() + labels->GetBufferedRegion().GetNumberOfPixels(),
                 mask->GetBufferPointer(),
                 [](unsigned short label) { return label != 0; });
  return mask;
}

void
WriteSegments(CommandLine & commandLine, const shapeton::DicomSource & source)
{
  const std::string mask = commandLine.OutputOf("mask");
  const std::string labels = commandLine.OutputOf("labels");
  const std::string table = commandLine.OutputOf("table");
  const auto        file = shapeton::ReadDicomSegmentation(commandLine.GetString("input"));
  const auto        chosen = commandLine.GetIntegers("segments");
  commandLine.Warn(file.notes);
  if (!commandLine.GetFlag("anySeries"))
  {
    shapeton::RequireMadeOn(file, source);
  }
  if (source.series.Has(shapeton::DicomDefectKind::shear))
  {
    commandLine.AddProvenance("repair", "deshear: slices moved within their planes by whole pixels");
  }
  const auto metadata = shapeton::ProvenanceMetadata(commandLine.GetProvenance());
  if (!mask.empty())
  {
    const auto lumen = chosen.empty() ? shapeton::LumenSegmentsOf(file) : chosen;
    shapeton::WriteVolume(MaskOf(shapeton::ReadDicomSegments(file, lumen, source).labels).GetPointer(), mask, metadata);
  }
  if (!labels.empty() || !table.empty())
  {
    const auto numbers = chosen.empty() ? shapeton::AllSegmentsOf(file) : chosen;
    const auto voxels = shapeton::ReadDicomSegments(file, numbers, source);
    if (!labels.empty())
    {
      shapeton::WriteVolume(voxels.labels.GetPointer(), labels, metadata);
    }
    if (!table.empty())
    {
      shapeton::TableOfSegments(file, numbers, voxels).Write(table);
    }
  }
}

void
WriteReport(CommandLine & commandLine, const shapeton::DicomSource & source)
{
  const std::string markers = commandLine.OutputOf("markers");
  const std::string verdicts = commandLine.OutputOf("verdicts");
  const auto        points = shapeton::ReadDicomReportPoints(commandLine.GetString("input"), source);
  if (!markers.empty())
  {
    shapeton::WriteMarkups(shapeton::MarkupsOfReport(points), markers);
  }
  if (!verdicts.empty())
  {
    const shapeton::ColonExamination exam(commandLine.GetString("exam"));
    shapeton::Remarks                remarks;
    shapeton::WriteReaderVerdicts(shapeton::VerdictsOfReport(points, exam, source, remarks), exam, verdicts);
    commandLine.Warn(remarks);
  }
}

shapeton::DicomSource
ReadSource(const CommandLine & commandLine)
{
  shapeton::DicomSourceOptions options;
  shapeton::ReadOptions(commandLine, options);
  options.offersDeshear = true;
  options.forPoints = IsOfReport(commandLine);
  return shapeton::ReadDicomSource(commandLine.GetString("source"), options);
}

void
Convert(CommandLine & commandLine)
{
  CheckUsage(commandLine);
  const std::string input = commandLine.GetString("input");
  commandLine.Progress("Reading", 0.0);
  const auto source = ReadSource(commandLine);
  commandLine.AddInput("input", "sha256:" + shapeton::Sha256OfFile(input));
  commandLine.AddInput("source", shapeton::IdentityOfSeries(source.series.GetSelector()));
  IsOfReport(commandLine) ? WriteReport(commandLine, source) : WriteSegments(commandLine, source);
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, Convert);
}
