#include "ColonViewerXML.h"

#include "shapetonColonExamination.h"
#include "shapetonColonViewer.h"
#include "shapetonCommandLine.h"
#include "shapetonReaderReport.h"
#include "shapetonRunRecords.h"

namespace
{
using namespace shapeton;

ColonViewerOptions
OptionsOf(const CommandLine & commandLine)
{
  ColonViewerOptions options;
  options.isSingle = commandLine.GetFlag("single");
  options.bits = std::stoi(commandLine.GetString("bits"));
  options.near = commandLine.GetDouble("near");
  options.isFull = commandLine.GetFlag("full");
  options.isSecondReader = commandLine.GetFlag("secondReader");
  options.isAnonymous = commandLine.GetFlag("anonymous");
  options.verdicts = commandLine.GetString("verdicts");
  options.second = commandLine.GetString("second");
  options.registration = commandLine.GetString("registration");
  return options;
}

/** Rejects an interrupted run, which may mix parts of two examinations. */
void
RequireCurrent(const std::string & run)
{
  namespace stages = colonoscopystage;
  for (const char * const stage : { stages::landmarks, stages::folds, stages::polyps })
  {
    RunRecords(run).RequireCurrent(stage);
  }
}

/** Adds the warnings of all stages of a run, in their order. */
void
AddWarnings(const std::string & run, const std::string & position, std::vector<std::string> & warnings)
{
  namespace stages = colonoscopystage;
  const RunRecords records(run);
  for (const char * const stage : { stages::inspection,
                                    stages::segmentation,
                                    stages::flattening,
                                    stages::landmarks,
                                    stages::folds,
                                    stages::search,
                                    stages::registration,
                                    stages::polyps })
  {
    for (const std::string & warning : records.WarningsOf(stage))
    {
      warnings.push_back(std::string(position).append(stage).append(": ").append(warning));
    }
  }
}

void
MakeViewer(CommandLine & commandLine)
{
  const std::string  folder = commandLine.GetString("outputFolder");
  const std::string  exam = commandLine.GetString("exam");
  ColonViewerOptions options = OptionsOf(commandLine);
  const std::string  second = options.second.empty() ? exam + '/' + secondPositionFolder : options.second;
  RequireCurrent(exam);
  RequireCurrent(second);
  AddWarnings(exam, "", options.warnings);
  AddWarnings(second, "second: ", options.warnings);
  commandLine.MakeFolder(folder);
  if (!options.isSingle)
  {
    commandLine.MakeFolder(folder + "/data");
  }
  commandLine.Progress("Packing", 0.1);
  const OutputPath outputPath = [&](const std::string & path) { return commandLine.Output(path); };
  WriteColonViewer(exam, folder, options, outputPath);
  if (!options.verdicts.empty())
  {
    commandLine.Progress("Reader's report", 0.9);
    commandLine.Warn(
      WriteReaderReport({ exam, options.second, options.verdicts, options.isAnonymous }, folder, outputPath));
  }
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, MakeViewer);
}
