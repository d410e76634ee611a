#include "DynamicGraphXML.h"

#include "shapetonCommandLine.h"
#include "shapetonGraphComparisonPictures.h"
#include "shapetonGraphReader.h"
#include "shapetonJson.h"
#include "shapetonReadOptions.h"
#include "shapetonSha256.h"
#include "shapetonExceptions.h"

#include <filesystem>
#include <set>

namespace
{
using namespace shapeton;

/** Reads and embeds all steps. */
DynamicSequence
EmbedAll(CommandLine & commandLine)
{
  GenusSettings genus;
  ReadOptions(commandLine, genus);
  DynamicEmbedding dynamic(genus);
  DynamicSequence  sequence;
  std::string      identities;
  const auto       files = GraphFilesOf(commandLine.GetString("sequenceFolder"));
  for (const auto & file : files)
  {
    GraphFile read = ReadGraph(file);
    sequence.files.push_back(std::filesystem::path(file).filename().string());
    identities += sequence.files.back() + ' ' + read.identity + '\n';
    try
    {
      sequence.steps.push_back(dynamic.Add(read.graph));
    }
    catch (const InputError & error)
    {
      throw InputError(sequence.files.back() + ": " + error.what());
    }
    for (const auto * remarks : { &read.notes, &sequence.steps.back().certificate.warnings })
    {
      for (const std::string & remark : *remarks)
      {
        commandLine.Warn(sequence.files.back() + ": " + remark);
      }
    }
    commandLine.Progress("Embedding", 0.9 * sequence.steps.size() / files.size());
  }
  commandLine.AddInput("sequenceFolder", "sha256:" + Sha256OfBytes(identities));
  return sequence;
}

/** The two steps of --compare; empty without it. */
std::vector<int>
ComparedSteps(const CommandLine & commandLine)
{
  std::vector<int> steps = commandLine.GetIntegers("compare");
  RequireParameter(steps.empty() || steps.size() == 2, "--compare requires two steps, for example 0,4");
  return steps;
}

void
WriteComparison(CommandLine & commandLine, const DynamicSequence & sequence, const std::vector<int> & steps)
{
  for (const int step : steps)
  {
    RequireParameter(step >= 0 && step < static_cast<int>(sequence.steps.size()),
                     "--compare contains step " + std::to_string(step) + ", but the steps are 0 to " +
                       std::to_string(sequence.steps.size() - 1));
  }
  const auto & a = sequence.steps[steps[0]].certificate;
  const auto & b = sequence.steps[steps[1]].certificate;
  const Json   content{ { "steps", steps },
                      { "files", { sequence.files[steps[0]], sequence.files[steps[1]] } },
                      { "changes", ChangesToJson(ChangesBetween(a, b), a.graph, b.graph) } };
  commandLine.WriteDocument(content, commandLine.Output(commandLine.GetString("outputFolder") + "/compare.json"));
}

/** Results of an earlier run must not stay beside those of this one. */
void
RequireNoOtherResults(const std::string & folder, const std::set<std::string> & steps, bool isCompared, bool isTracked)
{
  using Names = std::set<std::string>;
  CommandLine::RequireNoOthers(folder, "step-", steps);
  CommandLine::RequireNoOthers(folder, "compare.", isCompared ? Names{ "compare.json", "compare.svg" } : Names{});
  CommandLine::RequireNoOthers(folder, "tracked.", isTracked ? Names{ "tracked.csv" } : Names{});
}

void
Embed(CommandLine & commandLine)
{
  const std::vector<int>         compared = ComparedSteps(commandLine);
  const std::vector<std::string> tracked = commandLine.GetStrings("track");
  const std::string              folder = commandLine.GetString("outputFolder");
  CommandLine::RequireApart(commandLine.GetString("sequenceFolder"), folder, "use a folder of graph files");
  commandLine.MakeFolder(folder);
  const std::string documentPath = commandLine.Output(folder + "/dynamic.json");
  const std::string stepsPath = commandLine.Output(folder + "/steps.csv");
  commandLine.RecordRun(folder + "/run.json");
  commandLine.LeaveOutOfProvenance("labels"); // affects pictures only

  DynamicSequence sequence = EmbedAll(commandLine);
  commandLine.Progress("Writing", 0.9);
  commandLine.WriteDocument(SequenceToJson(sequence), documentPath);
  TableOfSteps(sequence).Write(stepsPath);
  if (!tracked.empty())
  {
    TableOfTrackedNodes(sequence, tracked).Write(commandLine.Output(folder + "/tracked.csv"));
  }
  if (!compared.empty())
  {
    WriteComparison(commandLine, sequence, compared);
  }
  std::set<std::string> names;
  for (std::size_t i = 0; i < sequence.steps.size(); ++i)
  {
    const std::string number = std::to_string(10000 + i).substr(i < 10000 ? 1 : 0); // sorts by name
    const std::string name = "step-" + number + ".json";
    names.insert(name);
    sequence.steps[i].certificate.provenance = commandLine.GetProvenance();
    WriteEmbeddingCertificate(sequence.steps[i].certificate, commandLine.Output(folder + '/' + name));
  }
  RequireNoOtherResults(folder, names, !compared.empty(), !tracked.empty());
  commandLine.Progress("Painting", 0.95);
  const GraphSideBySide sheet{
    folder, commandLine.GetFlag("labels"), commandLine.GetProvenance(), commandLine.GetWarnings()
  };
  WriteSequencePictures(
    sequence, compared, tracked, sheet, [&](const std::string & path) { return commandLine.Output(path); });
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, Embed);
}
