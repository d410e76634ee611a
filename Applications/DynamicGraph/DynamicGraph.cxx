#include "DynamicGraphXML.h"

#include "itkCommandLine.h"
#include "itkGraphComparisonPictures.h"
#include "itkGraphReader.h"
#include "itkSha256.h"
#include "itkExceptions.h"

#include <filesystem>

namespace
{
using itk::CommandLine;

/** Reads and embeds all steps. */
itk::DynamicSequence
EmbedAll(CommandLine & commandLine)
{
  itk::GenusOptions genus;
  genus.seed = static_cast<std::uint64_t>(commandLine.GetInteger("seed"));
  itk::DynamicEmbedding dynamic(genus);
  itk::DynamicSequence  sequence;
  std::string           identities;
  const auto            files = itk::GraphFilesOf(commandLine.GetString("sequenceFolder"));
  for (const auto & file : files)
  {
    itk::GraphFile read = itk::ReadGraph(file);
    sequence.files.push_back(std::filesystem::path(file).filename().string());
    identities += sequence.files.back() + ' ' + read.identity + '\n';
    try
    {
      sequence.steps.push_back(dynamic.Add(read.graph));
    }
    catch (const itk::InputError & error)
    {
      throw itk::InputError(sequence.files.back() + ": " + error.what());
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
  commandLine.AddInput("sequenceFolder", "sha256:" + itk::Sha256OfBytes(identities));
  return sequence;
}

itk::Json
DocumentOf(const CommandLine & commandLine, const itk::Json & content)
{
  itk::Json document;
  document["provenance"] = itk::ProvenanceToJson(commandLine.GetProvenance());
  document["warnings"] = commandLine.GetWarnings();
  document.update(content);
  return document;
}

/** The two steps of --compare, or none. */
std::vector<int>
ComparedSteps(const CommandLine & commandLine)
{
  std::vector<int> steps = commandLine.GetIntegers("compare");
  itk::RequireParameter(steps.empty() || steps.size() == 2, "--compare takes two steps, for example 0,4");
  return steps;
}

void
WriteComparison(CommandLine & commandLine, const itk::DynamicSequence & sequence, const std::vector<int> & steps)
{
  for (const int step : steps)
  {
    itk::RequireParameter(step >= 0 && step < static_cast<int>(sequence.steps.size()),
                      "--compare names step " + std::to_string(step) + ", but the steps are 0 to " +
                        std::to_string(sequence.steps.size() - 1));
  }
  const auto &    a = sequence.steps[steps[0]].certificate;
  const auto &    b = sequence.steps[steps[1]].certificate;
  const itk::Json content{ { "steps", steps },
                           { "files", { sequence.files[steps[0]], sequence.files[steps[1]] } },
                           { "changes", itk::ChangesToJson(itk::ChangesBetween(a, b), a.graph, b.graph) } };
  itk::WriteJson(DocumentOf(commandLine, content),
                 commandLine.Output(commandLine.GetString("outputFolder") + "/compare.json"));
}

void
Embed(CommandLine & commandLine)
{
  const std::vector<int>         compared = ComparedSteps(commandLine);
  const std::vector<std::string> tracked = commandLine.GetStrings("track");
  const std::string              folder = commandLine.GetString("outputFolder");
  commandLine.MakeFolder(folder);
  const std::string documentPath = commandLine.Output(folder + "/dynamic.json");
  const std::string stepsPath = commandLine.Output(folder + "/steps.csv");
  commandLine.RecordRun(folder + "/run.json");
  commandLine.LeaveOutOfProvenance("labels"); // of pictures alone

  itk::DynamicSequence sequence = EmbedAll(commandLine);
  commandLine.Progress("Writing", 0.9);
  itk::WriteJson(DocumentOf(commandLine, itk::SequenceToJson(sequence)), documentPath);
  itk::TableOfSteps(sequence).Write(stepsPath);
  if (!tracked.empty())
  {
    itk::TableOfTrackedNodes(sequence, tracked).Write(commandLine.Output(folder + "/tracked.csv"));
  }
  if (!compared.empty())
  {
    WriteComparison(commandLine, sequence, compared);
  }
  for (std::size_t i = 0; i < sequence.steps.size(); ++i)
  {
    const std::string number = std::to_string(10000 + i).substr(i < 10000 ? 1 : 0); // in the order of names
    sequence.steps[i].certificate.provenance = commandLine.GetProvenance();
    itk::WriteEmbeddingCertificate(sequence.steps[i].certificate,
                                   commandLine.Output(folder + "/step-" + number + ".json"));
  }
  commandLine.Progress("Painting", 0.95);
  const itk::GraphSideBySide sheet{
    folder, commandLine.GetFlag("labels"), commandLine.GetProvenance(), commandLine.GetWarnings()
  };
  itk::WriteSequencePictures(
    sequence, compared, tracked, sheet, [&](const std::string & path) { return commandLine.Output(path); });
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, Embed);
}
