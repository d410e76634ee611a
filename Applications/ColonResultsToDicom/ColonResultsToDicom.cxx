#include "ColonResultsToDicomXML.h"

#include "shapetonColonDicomResults.h"
#include "shapetonColonExamination.h"
#include "shapetonCommandLine.h"
#include "shapetonExceptions.h"
#include "shapetonReadOptions.h"

#include <filesystem>

namespace
{
using namespace shapeton;

/** Writes the results of a position, 0 or 1; [begin, end] is its part of the progress. */
void
Write(CommandLine &       commandLine,
      std::size_t         position,
      const std::string & source,
      const std::string & folder,
      double              begin,
      double              end)
{
  const std::string run = commandLine.GetString("exam");
  const std::string exam = position == 0 ? run : run + '/' + secondPositionFolder;
  CommandLine::RequireApart(source, folder, "use the folder with the DICOM series from which the run was computed");
  ColonDicomOptions options;
  ReadOptions(commandLine, options);
  options.reader = { commandLine.GetString("verdicts"), run, position, commandLine.GetString("observer") };
  options.progress = commandLine.PartOfProgress(begin, end);
  commandLine.MakeFolder(folder);
  commandLine.Warn(WriteColonDicomResults(
    exam, source, folder, options, [&](const std::string & path) { return commandLine.Output(path); }));
}

void
WriteResults(CommandLine & commandLine)
{
  RequireParameter(!commandLine.GetString("source").empty(),
                   "the parameter \"source\" is missing: results must refer to their series");
  RequireParameter(!commandLine.IsGiven("observer") || !commandLine.GetString("verdicts").empty(),
                   "the parameter \"observer\" requires \"verdicts\"");
  const std::string exam = commandLine.GetString("exam");
  const std::string folder = commandLine.GetString("outputFolder");
  const bool        hasSecond = commandLine.IsGiven("secondSource");
  if (!hasSecond && std::filesystem::exists(exam + '/' + secondPositionFolder))
  {
    commandLine.Warn("the results of the second series are skipped; set its folder with the parameter "
                     "\"secondSource\"");
  }
  Write(commandLine, 0, commandLine.GetString("source"), folder, 0.0, hasSecond ? 0.5 : 1.0);
  if (hasSecond)
  {
    Write(commandLine, 1, commandLine.GetString("secondSource"), folder + '/' + secondPositionFolder, 0.5, 1.0);
  }
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, WriteResults);
}
