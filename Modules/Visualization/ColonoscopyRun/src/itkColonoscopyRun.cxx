#include "itkColonoscopyRun.h"

#include "itkColonoscopyReport.h"
#include "itkColonoscopyStages.h"
#include "itkCommandLine.h"
#include "itkContentIdentity.h"
#include "itkSha256.h"
#include "itkToolError.h"

#include <filesystem>

namespace fs = std::filesystem;

namespace itk
{
namespace
{
std::string
Joined(const std::vector<std::string> & words)
{
  std::string text;
  for (const std::string & word : words)
  {
    text += (text.empty() ? "" : ", ") + word;
  }
  return text;
}

/** Results inside of the input would change what the input holds. */
void
RequireApart(const std::string & input, const std::string & output)
{
  if (!fs::exists(input))
  {
    throw InputError("\"" + input + "\" does not exist; give a folder with a DICOM series, a DICOM file or a volume");
  }
  const fs::path relative = fs::weakly_canonical(output).lexically_relative(fs::weakly_canonical(input));
  RequireUsage(!fs::is_directory(input) || relative.empty() || *relative.begin() == "..",
               "the output folder lies in the input folder; name one beside it");
}

/** All stages up to the first that fails. */
std::vector<StageResult>
RunStages(CommandLine & commandLine, StagedRun & run)
{
  std::vector<StageResult> results;
  double                   begin = 0.0;
  for (const ColonoscopyStage & stage : StagesOfColonoscopy(commandLine))
  {
    commandLine.Progress(stage.name, begin);
    results.push_back(run.Run(stage.make(run), [&](const std::string & step, double share) {
      commandLine.Progress(stage.name + ": " + step, begin + share * stage.share);
    }));
    begin += stage.share;
    for (const std::string & warning : results.back().warnings)
    {
      commandLine.Warn(stage.name + ": " + warning);
    }
    if (results.back().status != 0)
    {
      return results;
    }
  }
  return results;
}

/** "" where all is well. */
std::string
FailureOf(const std::vector<StageResult> & stages)
{
  const StageResult & last = stages.back();
  if (last.status == 0)
  {
    return "";
  }
  std::vector<std::string> kept;
  for (const StageResult & stage : stages)
  {
    kept.push_back(stage.status == 0 ? stage.name : "a part of " + stage.name);
  }
  if (last.files.empty())
  {
    kept.pop_back();
  }
  return "the stage " + last.name + " (" + last.program + ") failed: " + last.message +
         "; kept: " + (kept.empty() ? "nothing" : Joined(kept)) + ", report.html";
}

/** Report and files for Slicer; written again when a stage or one of these files has changed. */
class Presentation
{
public:
  Presentation(CommandLine & commandLine, const std::string & folder) : m_CommandLine(commandLine), m_Folder(folder) {}

  void
  Update(const std::vector<StageResult> & stages, const std::string & failure)
  {
    const Json signature = this->SignatureOf(stages, failure);
    if (!this->IsUnchanged(signature))
    {
      this->Write(stages, failure, signature);
    }
  }

private:
  Json
  SignatureOf(const std::vector<StageResult> & stages, const std::string & failure) const
  {
    Json signature;
    for (const auto & [key, value] : m_CommandLine.GetProvenance())
    {
      signature[key] = value;
    }
    signature["failure"] = failure;
    signature["warnings"] = m_CommandLine.GetWarnings();
    for (const StageResult & stage : stages)
    {
      std::string files;
      for (const auto & [name, hash] : stage.files)
      {
        files += name + ' ' + hash + '\n';
      }
      signature["stages"][stage.name] = stage.version + ' ' + Sha256OfBytes(files);
    }
    return signature;
  }

  bool
  IsUnchanged(const Json & signature) const
  {
    try
    {
      const Json record = ReadJson(m_Folder + "/stages/report.json");
      bool       isUnchanged = record.at("signature") == signature;
      for (const auto & file : record.at("files").items())
      {
        isUnchanged = isUnchanged && IdentityOf(m_Folder + '/' + file.key()) == file.value();
      }
      return isUnchanged;
    }
    catch (const InputError &) // a file is missing
    {
      return false;
    }
    catch (const Json::exception &)
    {
      return false;
    }
  }

  void
  Write(const std::vector<StageResult> & stages, const std::string & failure, const Json & signature)
  {
    m_CommandLine.Progress("report", 0.94);
    const ColonoscopyResults results = ReadColonoscopyResults(m_Folder, stages);
    ColonoscopyReportContent content;
    content.results = &results;
    content.failure = failure;
    content.warnings = m_CommandLine.GetWarnings();
    content.provenance = m_CommandLine.GetProvenance();
    Json record;
    record["signature"] = signature;
    const auto publish = [&](const std::string & name) {
      m_CommandLine.Publish(m_Folder + '/' + name); // the run may fail: the report is there all the same
      record["files"][name] = IdentityOf(m_Folder + '/' + name);
    };
    WriteColonoscopyReport(content, m_CommandLine.Output(m_Folder + "/report.html"), m_Folder + "/.report.part");
    publish("report.html");
    m_CommandLine.MakeFolder(m_Folder + "/slicer");
    const OutputPath outputPath = [&](const std::string & path) { return m_CommandLine.Output(path); };
    for (const std::string & name : WriteColonoscopySlicerFiles(results, m_Folder + "/slicer", outputPath))
    {
      publish("slicer/" + name);
    }
    WriteJson(record, m_CommandLine.Output(m_Folder + "/stages/report.json"));
    m_CommandLine.Publish(m_Folder + "/stages/report.json");
  }

  CommandLine & m_CommandLine;
  std::string   m_Folder;
};
} // namespace

void
RunColonoscopy(CommandLine & commandLine, const std::string & toolFolder)
{
  const std::string input = commandLine.GetString("inputVolume");
  const std::string folder = commandLine.GetString("outputFolder");
  RequireApart(input, folder);
  commandLine.MakeFolder(folder);
  commandLine.MakeFolder(folder + "/stages");
  StagedRun run(folder, toolFolder);
  commandLine.RecordRun(folder + "/run.json");
  commandLine.Progress("reading", 0.0);
  for (const char * const name : { "inputVolume", "lumen", "markers" })
  {
    if (commandLine.IsGiven(name))
    {
      commandLine.AddInput(name, run.Identify(commandLine.GetString(name)));
    }
  }
  const std::vector<StageResult> stages = RunStages(commandLine, run);
  const std::string              failure = FailureOf(stages);
  Presentation(commandLine, folder).Update(stages, failure);
  if (!failure.empty())
  {
    throw ToolError(stages.back().status, failure);
  }
}
} // namespace itk
