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
using shapeton::CommandLine;

/** The options that are given; the others are those of the preset. */
shapeton::ParticleDiffusionOptions
WalkOptions(CommandLine & commandLine, const shapeton::Volume & volume)
{
  shapeton::ShapetonPresetOptions options;
  const auto                      given = shapeton::ReadGivenOptions(commandLine, options);
  auto                            choice = shapeton::ChooseShapetonParameters(
    shapeton::VolumeView(volume.image.GetPointer()), options, given, volume.modality);
  choice.options.device = shapeton::ReadDevice(commandLine);
  return choice.options;
}

/** The options of reading, for the script that repeats the session. */
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
  shapeton::RequireIntensityWindow(commandLine);
  const shapeton::SessionFolder folder(commandLine.GetString("folder"));
  shapeton::Volume              volume = shapeton::ReadVolume(commandLine, "inputVolume", true);
  shapeton::LiveSessionSettings settings;
  settings.input = commandLine.GetString("inputVolume");
  settings.readingArguments = ReadingArguments(commandLine);
  settings.folder = folder.GetPath().string();
  settings.walk = WalkOptions(commandLine, volume);
  shapeton::LiveSession           session(std::move(volume), settings);
  shapeton::SessionServerSettings connection;
  connection.address = commandLine.GetString("address");
  connection.port = static_cast<unsigned short>(commandLine.GetInteger("port"));
  connection.secondsWithoutPage = commandLine.GetDouble("patience");
  shapeton::SessionServer server(session, connection);
  std::cout << server.GetUrl() << std::endl;
  server.Run();
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, Serve);
}
