#include "DicomResultsToColonXML.h"

#include "shapetonCommandLine.h"
#include "shapetonDicomToColon.h"
#include "shapetonExceptions.h"
#include "shapetonMappedImage.h"
#include "shapetonReadOptions.h"
#include "shapetonSha256.h"
#include "shapetonVolumeWriter.h"

#include <algorithm>

namespace
{
using namespace shapeton;

bool
IsOfReport(const CommandLine & commandLine)
{
  return commandLine.IsGiven("markers") || commandLine.IsGiven("verdicts");
}

void
CheckUsage(const CommandLine & commandLine)
{
  const bool ofSegments = commandLine.IsGiven("mask") || commandLine.IsGiven("labels") || commandLine.IsGiven("table");
  RequireParameter(ofSegments || IsOfReport(commandLine),
                   "no output requested: use --mask, --labels or --table for a segmentation, --markers or "
                   "--verdicts for a report");
  RequireParameter(!ofSegments || !IsOfReport(commandLine),
                   "--markers and --verdicts require a report; --mask, --labels and --table require a segmentation");
  RequireParameter(commandLine.IsGiven("verdicts") == commandLine.IsGiven("exam"),
                   "--verdicts requires --exam, the examination whose candidates the report judges, and "
                   "--exam requires --verdicts");
  RequireVolumeName(commandLine.GetString("mask"));
  RequireVolumeName(commandLine.GetString("labels"));
}

void
WriteSegments(CommandLine & commandLine, const DicomSource & source)
{
  const std::string mask = commandLine.OutputOf("mask");
  const std::string labels = commandLine.OutputOf("labels");
  const std::string table = commandLine.OutputOf("table");
  const auto        file = ReadDicomSegmentation(commandLine.GetString("input"));
  const auto        chosen = commandLine.GetIntegers("segments");
  commandLine.Warn(file.notes);
  if (!commandLine.GetFlag("anySeries"))
  {
    RequireMadeOn(file, source);
  }
  if (source.series.Has(DicomDefectKind::shear))
  {
    commandLine.AddProvenance("repair", "deshear: slices moved within their planes by whole pixels");
  }
  const auto metadata = ProvenanceMetadata(commandLine.GetProvenance());
  if (!mask.empty())
  {
    const auto lumen = chosen.empty() ? LumenSegmentsOf(file) : chosen;
    const auto labels = ReadDicomSegments(file, lumen, source).labels;
    const auto isLumen = [](unsigned short label) { return label != 0; };
    WriteVolume(MapVoxels<unsigned char>(labels.GetPointer(), isLumen).GetPointer(), mask, metadata);
  }
  if (!labels.empty() || !table.empty())
  {
    const auto numbers = chosen.empty() ? AllSegmentsOf(file) : chosen;
    const auto voxels = ReadDicomSegments(file, numbers, source);
    if (!labels.empty())
    {
      WriteVolume(voxels.labels.GetPointer(), labels, metadata);
    }
    if (!table.empty())
    {
      TableOfSegments(file, numbers, voxels).Write(table);
    }
  }
}

void
WriteReport(CommandLine & commandLine, const DicomSource & source)
{
  const std::string markers = commandLine.OutputOf("markers");
  const std::string verdicts = commandLine.OutputOf("verdicts");
  const auto        points = ReadDicomReportPoints(commandLine.GetString("input"), source);
  if (!markers.empty())
  {
    Remarks remarks;
    WriteMarkups(MarkupsOfReport(points, remarks), markers);
    commandLine.Warn(remarks);
  }
  if (!verdicts.empty())
  {
    const ColonExamination exam(commandLine.GetString("exam"));
    Remarks                remarks;
    WriteReaderVerdicts(VerdictsOfReport(points, exam, source, remarks), exam, verdicts);
    commandLine.Warn(remarks);
  }
}

DicomSource
ReadSource(const CommandLine & commandLine)
{
  DicomSourceOptions options;
  ReadOptions(commandLine, options);
  options.offersDeshear = true;
  options.forPoints = IsOfReport(commandLine);
  return ReadDicomSource(commandLine.GetString("source"), options);
}

void
Convert(CommandLine & commandLine)
{
  CheckUsage(commandLine);
  const std::string input = commandLine.GetString("input");
  commandLine.Progress("Reading", 0.0);
  const auto source = ReadSource(commandLine);
  commandLine.AddInput("input", "sha256:" + Sha256OfFile(input));
  commandLine.AddInput("source", IdentityOfSeries(source.series.GetSelector()));
  IsOfReport(commandLine) ? WriteReport(commandLine, source) : WriteSegments(commandLine, source);
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, Convert);
}
