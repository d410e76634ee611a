#include "ColonRegistrationXML.h"

#include "itkCommandLine.h"
#include "itkRegistrationFiles.h"
#include "itkRegistrationReport.h"
#include "itkSha256.h"

namespace
{
using itk::CommandLine;

itk::ColonPositionFiles
Read(CommandLine & commandLine, const std::string & parameter, const std::string & name)
{
  itk::ColonPositionFiles files = itk::ReadColonPosition(commandLine.GetString(parameter), name);
  commandLine.AddInput(parameter, files.identity);
  commandLine.Warn(files.warnings);
  return files;
}

std::vector<itk::PointPair>
ReadTruth(CommandLine & commandLine)
{
  const std::string path = commandLine.GetString("evaluate");
  if (path.empty())
  {
    return {};
  }
  commandLine.AddInput("evaluate", "sha256:" + itk::Sha256OfFile(path));
  return itk::ReadPointPairs(path);
}

itk::SupineProneOptions
OptionsOf(const CommandLine & commandLine)
{
  itk::SupineProneOptions options;
  options.matching = commandLine.GetString("matching") == "dualDecomposition"
                       ? itk::FoldMatchingMethod::DualDecomposition
                       : itk::FoldMatchingMethod::Hungarian;
  options.refines = commandLine.GetFlag("refine");
  options.isSegmentWise = commandLine.GetFlag("segmentWise");
  return options;
}

void
WarnOf(CommandLine & commandLine, const itk::SupineProneRegistration & registration)
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
  const itk::RegistrationFiles      files(commandLine,
                                     commandLine.GetString("outputFolder"),
                                     { commandLine.GetString("supineFolder"), commandLine.GetString("proneFolder") });
  const itk::RegistrationReport     report(commandLine, commandLine.GetString("report"));
  const std::vector<itk::PointPair> truth = ReadTruth(commandLine);
  commandLine.Progress("Reading", 0.0);
  const itk::ColonPositionFiles supine = Read(commandLine, "supineFolder", "supine");
  const itk::ColonPositionFiles prone = Read(commandLine, "proneFolder", "prone");
  if (supine.identity == prone.identity)
  {
    commandLine.Warn("both folders hold the same examination: it is registered with itself");
  }
  commandLine.Progress("Registering", 0.2);
  const itk::SupineProneRegistration registration =
    itk::RegisterColonPositions(supine.position, prone.position, OptionsOf(commandLine));
  WarnOf(commandLine, registration);
  commandLine.Progress("Writing", 0.8);
  const itk::RegistrationResults results = itk::MakeRegistrationResults(supine, prone, registration, truth);
  files.Write(results);
  report.Write({ &supine, &prone, &results });
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, Register);
}
