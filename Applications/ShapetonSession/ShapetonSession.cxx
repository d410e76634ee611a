#include "ShapetonSessionXML.h"

#include "shapetonCommandLine.h"
#include "shapetonLiveSession.h"
#include "shapetonParticlePreset.h"
#include "shapetonReadOptions.h"
#include "shapetonSessionServer.h"
#include "shapetonToolDevice.h"
#include "shapetonToolVolumes.h"

#include <algorithm>
#include <iostream>

namespace
{
using namespace shapeton;

/** Sets the options of the walk: those that are given; the others are those of the preset. Keeps the choice of window,
 * p, smoothing and time if nothing of it is given. */
void
ChooseOptions(CommandLine & commandLine, const Volume & volume, LiveSessionSettings & settings)
{
  ShapetonPresetOptions options;
  const auto            given = ReadGivenOptions(commandLine, options);
  const auto            choice = ChooseShapetonParameters(VolumeView(volume.image.GetPointer()), options, given);
  settings.walk = choice.options;
  settings.walk.device = ReadDevice(commandLine);
  const auto fixed = GivenAmong(given, options);
  const bool isChosen = options.preset != ShapetonPreset::Published;
  if (isChosen && !fixed.intensityWindow && !fixed.p && !fixed.smoothing && !fixed.timeSteps)
  {
    settings.choice = choice.heat;
  }
}

/** The read options, for the script that repeats the session. */
std::vector<std::string>
ReadingArguments(const CommandLine & commandLine)
{
  std::vector<std::string> arguments;
  if (commandLine.IsGiven("seriesUID"))
  {
    arguments = { "--seriesUID", commandLine.GetString("seriesUID") };
  }
  for (const std::string name : { "resampleGaps", "deshear", "dropDuplicates" })
  {
    if (commandLine.GetFlag(name))
    {
      arguments.push_back("--" + name);
    }
  }
  return arguments;
}

void
Serve(CommandLine & commandLine)
{
  RequireIntensityWindow(commandLine);
  const std::string   chosen = commandLine.MakeFolderOf("folder");
  const SessionFolder folder(chosen.empty() ? "." : chosen);
  Volume              volume = ReadVolume(commandLine, "inputVolume", true);
  LiveSessionSettings settings;
  settings.input = commandLine.GetString("inputVolume");
  settings.readingArguments = ReadingArguments(commandLine);
  settings.folder = folder.GetPath().string();
  ChooseOptions(commandLine, volume, settings);
  LiveSession           session(std::move(volume), settings);
  SessionServerSettings connection;
  connection.address = commandLine.GetString("address");
  connection.port = static_cast<unsigned short>(commandLine.GetInteger("port"));
  connection.secondsAfterLoss = commandLine.GetDouble("patience");
  connection.secondsAfterClose = std::min(connection.secondsAfterClose, connection.secondsAfterLoss);
  SessionServer server(session, connection);
  std::cout << server.GetUrl() << std::endl;
  server.Run();
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, Serve);
}
