#include "ColonViewerXML.h"

#include "shapetonColonViewer.h"
#include "shapetonCommandLine.h"
#include "shapetonReaderReport.h"
#include "shapetonRunRecords.h"

namespace
{
using shapeton::CommandLine;

shapeton::ColonViewerOptions
OptionsOf(const CommandLine & commandLine)
{
  shapeton::ColonViewerOptions options;
  options.isSingle = commandLine.GetFlag("single");
  options.bits = std::stoi(commandLine.GetString("bits"));
  options.near = commandLine.GetDouble("near");
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
  for (const char * const stage : { "landmarks", "folds", "polyps" })
  {
    shapeton::RunRecords(run).RequireCurrent(stage);
  }
}

void
MakeViewer(CommandLine & commandLine)
{
  const std::string                  folder = commandLine.GetString("outputFolder");
  const std::string                  exam = commandLine.GetString("exam");
  const shapeton::ColonViewerOptions options = OptionsOf(commandLine);
  RequireCurrent(exam);
  RequireCurrent(options.second.empty() ? exam + "/second" : options.second);
  commandLine.MakeFolder(folder);
  if (!options.isSingle)
  {
    commandLine.MakeFolder(folder + "/data");
  }
  commandLine.Progress("Packing", 0.1);
  const shapeton::OutputPath outputPath = [&](const std::string & path) { return commandLine.Output(path); };
  shapeton::WriteColonViewer(exam, folder, options, outputPath);
  if (!options.verdicts.empty())
  {
    commandLine.Progress("Reader's report", 0.9);
    commandLine.Warn(
      shapeton::WriteReaderReport({ exam, options.second, options.verdicts, options.isAnonymous }, folder, outputPath));
  }
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, MakeViewer);
}
