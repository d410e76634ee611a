#include "ColonSegmentationXML.h"

#include "shapetonColonModelFiles.h"
#include "shapetonColonModelReport.h"
#include "shapetonColonWall.h"
#include "shapetonCommandLine.h"
#include "shapetonExceptions.h"
#include "shapetonReadOptions.h"
#include "shapetonToolVolumes.h"

namespace
{
using shapeton::CommandLine;

void
CheckUsage(const CommandLine & commandLine)
{
  shapeton::RequireParameter(!commandLine.GetFlag("inputIsLumen") || !commandLine.IsGiven("lumen"),
                             "--lumen requires a CT; with --inputIsLumen the input itself is the lumen");
  shapeton::RequireParameter(!commandLine.GetFlag("inputIsLumen") || !commandLine.IsGiven("position"),
                             "--position has no effect with --inputIsLumen: it determines where fluid pools");
  shapeton::RequireParameter(!commandLine.GetFlag("inputIsLumen") || !commandLine.IsGiven("cleansedVolume"),
                             "--cleansedVolume requires a CT; with --inputIsLumen nothing is cleansed");
  shapeton::RequireFacesOfWall(commandLine.GetInteger("faces"));
}

shapeton::ColonModelSettings
SettingsOf(CommandLine & commandLine, const shapeton::Volume & volume)
{
  shapeton::ColonModelSettings settings;
  shapeton::ReadOptions(commandLine, settings);
  if (settings.position == "auto")
  {
    settings.position = volume.patientPosition;
  }
  settings.sliceThickness = volume.sliceThickness;
  settings.progress = commandLine.PartOfProgress(0.0, 0.9); // the rest: writing the files
  return settings;
}

shapeton::ColonModel
ModelOf(CommandLine & commandLine, const shapeton::Volume & volume, const shapeton::ColonModelSettings & settings)
{
  if (commandLine.GetFlag("inputIsLumen"))
  {
    return shapeton::BuildColonModelOfLumen(shapeton::MaskOfVolume(volume, commandLine.GetString("inputVolume")),
                                            settings);
  }
  shapeton::WarnUnlessCT(commandLine, volume);
  if (commandLine.IsGiven("lumen"))
  {
    const auto mask = shapeton::ReadLabelMask(commandLine, "lumen", volume.image);
    return shapeton::BuildColonModel(volume.image, mask.GetPointer(), settings);
  }
  return shapeton::BuildColonModel(volume.image, settings);
}

void
Segment(CommandLine & commandLine)
{
  CheckUsage(commandLine);
  shapeton::ColonModelFiles        files(commandLine, commandLine.GetString("outputFolder"));
  const shapeton::ColonModelReport report(commandLine, commandLine.GetString("report"));
  const shapeton::Volume           volume = shapeton::ReadVolume(commandLine, "inputVolume");
  shapeton::ColonModelSettings     settings = SettingsOf(commandLine, volume);
  files.WriteBeside(settings, volume.image);
  shapeton::ColonModel model = ModelOf(commandLine, volume, settings);
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
    throw shapeton::InputError(commandLine.GetString("inputVolume") + ": " + model.failure);
  }
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, Segment);
}
