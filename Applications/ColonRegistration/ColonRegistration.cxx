#include "ColonRegistrationXML.h"

#include "shapetonCommandLine.h"
#include "shapetonExaminationInputs.h"
#include "shapetonReadOptions.h"
#include "shapetonRegistrationFiles.h"
#include "shapetonRegistrationFolder.h"
#include "shapetonRegistrationReport.h"
#include "shapetonSha256.h"

namespace
{
using shapeton::CommandLine;

shapeton::ColonPositionFiles
Read(CommandLine & commandLine, const std::string & parameter, const std::string & name)
{
  shapeton::ColonPositionFiles files = shapeton::ReadColonPosition(
    shapeton::ExaminationFolder(commandLine.GetString(parameter), "ColonRegistration"), name);
  commandLine.AddInput(parameter, files.identity);
  commandLine.Warn(files.warnings);
  return files;
}

std::vector<shapeton::PointPair>
ReadTruth(CommandLine & commandLine)
{
  const std::string path = commandLine.GetString("evaluate");
  if (path.empty())
  {
    return {};
  }
  commandLine.AddInput("evaluate", "sha256:" + shapeton::Sha256OfFile(path));
  return shapeton::ReadPointPairs(path);
}

void
WarnOf(CommandLine & commandLine, const shapeton::SupineProneRegistration & registration)
{
  commandLine.Warn(registration.warnings);
  for (const std::string & reason : registration.confidence.reasons)
  {
    commandLine.Warn("the registration is flagged as doubtful: " + reason);
  }
}

void
Register(CommandLine & commandLine)
{
  const shapeton::RegistrationFiles files(
    commandLine,
    commandLine.GetString("outputFolder"),
    { commandLine.GetString("supineFolder"), commandLine.GetString("proneFolder") });
  const shapeton::RegistrationReport     report(commandLine, commandLine.GetString("report"));
  const std::vector<shapeton::PointPair> truth = ReadTruth(commandLine);
  commandLine.Progress("Reading", 0.0);
  const shapeton::ColonPositionFiles supine = Read(commandLine, "supineFolder", "supine");
  const shapeton::ColonPositionFiles prone = Read(commandLine, "proneFolder", "prone");
  if (supine.identity == prone.identity)
  {
    commandLine.Warn("both folders contain the same examination, which is registered to itself");
  }
  shapeton::SupineProneSettings settings;
  shapeton::ReadOptions(commandLine, settings);
  commandLine.Progress("Registering", 0.2);
  const shapeton::SupineProneRegistration registration =
    shapeton::RegisterColonPositions(supine.position, prone.position, settings);
  WarnOf(commandLine, registration);
  commandLine.Progress("Writing", 0.8);
  const shapeton::RegistrationResults results = shapeton::MakeRegistrationResults(supine, prone, registration, truth);
  files.Write(results);
  report.Write({ &supine, &prone, &results });
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, Register);
}
