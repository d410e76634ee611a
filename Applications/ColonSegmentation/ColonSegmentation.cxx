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
using namespace shapeton;

void
CheckUsage(const CommandLine & commandLine)
{
  RequireParameter(!commandLine.GetFlag("inputIsLumen") || !commandLine.IsGiven("lumen"),
                   "--lumen requires a CT; with --inputIsLumen the input itself is the lumen");
  RequireParameter(!commandLine.GetFlag("inputIsLumen") || !commandLine.IsGiven("position"),
                   "--position has no effect with --inputIsLumen: it determines where fluid pools");
  RequireParameter(!commandLine.GetFlag("inputIsLumen") || !commandLine.IsGiven("cleansedVolume"),
                   "--cleansedVolume requires a CT; with --inputIsLumen nothing is cleansed");
  RequireFacesOfWall(commandLine.GetInteger("faces"));
}

ColonModelSettings
SettingsOf(CommandLine & commandLine, const Volume & volume)
{
  ColonModelSettings settings;
  ReadOptions(commandLine, settings);
  settings.sliceThickness = volume.sliceThickness;
  settings.progress = commandLine.PartOfProgress(0.0, 0.9); // the rest: writing the files
  return settings;
}

ColonModel
ModelOf(CommandLine & commandLine, const Volume & volume, const ColonModelSettings & settings)
{
  if (commandLine.GetFlag("inputIsLumen"))
  {
    return BuildColonModelOfLumen(MaskOfVolume(volume, commandLine.GetString("inputVolume")), settings);
  }
  WarnUnlessCT(commandLine, volume);
  if (commandLine.IsGiven("lumen"))
  {
    const auto mask = ReadLabelMask(commandLine, "lumen", volume.image);
    return BuildColonModel(volume.image, mask.GetPointer(), settings);
  }
  return BuildColonModel(volume.image, settings);
}

void
Segment(CommandLine & commandLine)
{
  CheckUsage(commandLine);
  ColonModelFiles    files(commandLine, commandLine.GetString("outputFolder"));
  const std::string  report = commandLine.MakeFolderOf("report");
  const Volume       volume = ReadVolume(commandLine, "inputVolume");
  ColonModelSettings settings = SettingsOf(commandLine, volume);
  files.WriteBeside(settings, volume.image);
  ColonModel model = ModelOf(commandLine, volume, settings);
  commandLine.Warn(model.warnings);
  const bool isPartial = !model.failure.empty();
  if (!isPartial || commandLine.GetFlag("keepPartial"))
  {
    commandLine.Progress("Writing", 0.92);
    files.Write(model, isPartial);
    WriteColonModelReport(commandLine, report, model, volume, isPartial);
  }
  if (isPartial)
  {
    throw InputError(commandLine.GetString("inputVolume") + ": " + model.failure);
  }
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, Segment);
}
