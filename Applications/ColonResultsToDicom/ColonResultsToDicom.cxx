#include "ColonResultsToDicomXML.h"

#include "shapetonColonDicomResults.h"
#include "shapetonCommandLine.h"
#include "shapetonExceptions.h"

namespace
{
using shapeton::CommandLine;

shapeton::ColonDicomOptions
OptionsOf(CommandLine & commandLine, double begin, double end)
{
  shapeton::ColonDicomOptions options;
  for (const auto & [name, value] : commandLine.GetProvenance())
  {
    options.tool = name == "tool" ? value : options.tool;
    options.version = name == "version" ? value : options.version;
  }
  options.isDeflated = commandLine.GetFlag("deflate");
  options.progress = commandLine.PartOfProgress(begin, end);
  return options;
}

void
Write(CommandLine & commandLine, const std::string & exam, const std::string & source, const std::string & folder)
{
  commandLine.MakeFolder(folder);
  commandLine.Warn(shapeton::WriteColonDicomResults(
    exam, source, folder, OptionsOf(commandLine, 0.0, 1.0), [&](const std::string & path) {
      return commandLine.Output(path);
    }));
}

void
WriteResults(CommandLine & commandLine)
{
  shapeton::RequireParameter(!commandLine.GetString("source").empty(),
                             "the parameter \"source\" is missing: results belong to the series that they come from");
  const std::string exam = commandLine.GetString("exam");
  const std::string folder = commandLine.GetString("outputFolder");
  Write(commandLine, exam, commandLine.GetString("source"), folder);
  if (commandLine.IsGiven("secondSource"))
  {
    Write(commandLine, exam + "/second", commandLine.GetString("secondSource"), folder + "/second");
  }
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, WriteResults);
}
