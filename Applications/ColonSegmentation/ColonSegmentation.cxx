#include "ColonSegmentationXML.h"

#include "itkColonModelFiles.h"
#include "itkColonModelReport.h"
#include "itkCommandLine.h"
#include "itkExceptions.h"
#include "itkToolVolumes.h"

namespace
{
using itk::CommandLine;

void
CheckUsage(const CommandLine & commandLine)
{
  itk::RequireParameter(!commandLine.GetFlag("inputIsLumen") || !commandLine.IsGiven("lumen"),
                    "--lumen belongs to a CT; with --inputIsLumen the input itself is the lumen");
  itk::RequireParameter(!commandLine.GetFlag("inputIsLumen") || !commandLine.IsGiven("position"),
                    "--position says where fluid pools; a lumen (--inputIsLumen) needs none");
}

itk::ColonModelOptions
OptionsOf(CommandLine & commandLine, const std::string & patientPosition)
{
  itk::ColonModelOptions options;
  const std::string      position = commandLine.GetString("position");
  options.patientPosition = position == "auto" ? patientPosition : position;
  for (const auto & point : commandLine.GetPoints("seedPoint"))
  {
    options.seedPoints.emplace_back(point.data());
  }
  options.faces = commandLine.GetInteger("faces");
  options.keepPieces = commandLine.GetFlag("keepPieces");
  options.keepPartial = commandLine.GetFlag("keepPartial");
  options.progress = commandLine.PartOfProgress(0.0, 0.9); // then the files are written
  return options;
}

itk::ColonModel
ModelOf(CommandLine & commandLine, const itk::Volume & volume, const itk::ColonModelOptions & options)
{
  if (commandLine.GetFlag("inputIsLumen"))
  {
    return itk::BuildColonModelOfLumen(itk::MaskOfVolume(volume, commandLine.GetString("inputVolume")), options);
  }
  if (commandLine.IsGiven("lumen"))
  {
    const auto mask = itk::ReadMask(commandLine, "lumen", volume.image);
    return itk::BuildColonModel(volume.image, mask.GetPointer(), options);
  }
  return itk::BuildColonModel(volume.image, options);
}

void
Segment(CommandLine & commandLine)
{
  CheckUsage(commandLine);
  const itk::ColonModelFiles  files(commandLine, commandLine.GetString("outputFolder"));
  const itk::ColonModelReport report(commandLine, commandLine.GetString("report"));
  const itk::Volume           volume = itk::ReadVolume(commandLine, "inputVolume");
  itk::ColonModel             model = ModelOf(commandLine, volume, OptionsOf(commandLine, volume.patientPosition));
  commandLine.Warn(model.warnings);
  const bool isPartial = !model.failure.empty();
  if (!isPartial || commandLine.GetFlag("keepPartial"))
  {
    commandLine.Progress("Writing", 0.92);
    files.Write(model, isPartial);
    report.Write(model, volume, isPartial);
  }
  if (isPartial)
  {
    throw itk::InputError(commandLine.GetString("inputVolume") + ": " + model.failure);
  }
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, Segment);
}
