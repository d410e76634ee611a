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
using namespace shapeton;

ColonPositionFiles
Read(CommandLine & commandLine, const std::string & parameter, const std::string & name)
{
  ColonPositionFiles files =
    ReadColonPosition(ExaminationFolder(commandLine.GetString(parameter), "ColonRegistration"), name);
  commandLine.AddInput(parameter, files.identity);
  commandLine.Warn(files.warnings);
  return files;
}

std::vector<PointPair>
ReadTruth(CommandLine & commandLine)
{
  const std::string path = commandLine.GetString("evaluate");
  if (path.empty())
  {
    return {};
  }
  commandLine.AddInput("evaluate", "sha256:" + Sha256OfFile(path));
  return ReadPointPairs(path);
}

void
WarnOf(CommandLine & commandLine, const SupineProneRegistration & registration)
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
  const RegistrationFiles      files(commandLine,
                                commandLine.GetString("outputFolder"),
                                { commandLine.GetString("supineFolder"), commandLine.GetString("proneFolder") });
  const std::string            report = commandLine.MakeFolderOf("report");
  const std::vector<PointPair> truth = ReadTruth(commandLine);
  commandLine.Progress("Reading", 0.0);
  const ColonPositionFiles supine = Read(commandLine, "supineFolder", "supine");
  const ColonPositionFiles prone = Read(commandLine, "proneFolder", "prone");
  if (supine.identity == prone.identity)
  {
    commandLine.Warn("both folders contain the same examination, which is registered to itself");
  }
  SupineProneSettings settings;
  ReadOptions(commandLine, settings);
  commandLine.Progress("Registering", 0.2);
  const SupineProneRegistration registration = RegisterColonPositions(supine.position, prone.position, settings);
  WarnOf(commandLine, registration);
  commandLine.Progress("Writing", 0.8);
  const RegistrationResults results = MakeRegistrationResults(supine, prone, registration, truth);
  files.Write(results);
  WriteRegistrationReport(commandLine, report, { &supine, &prone, &results });
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, Register);
}
