#include "shapetonStagedRun.h"

#include "shapetonChildTool.h"
#include "shapetonContentIdentity.h"
#include "shapetonFolderLock.h"
#include "shapetonJson.h"
#include "shapetonStageFolder.h"
#include "shapetonStageRecord.h"
#include "shapetonExceptions.h"
#include "shapetonOperatingSystem.h"
#include "shapetonSha256.h"

#include <algorithm>
#include <filesystem>

namespace fs = std::filesystem;

namespace shapeton
{
namespace
{
using Kind = Stage::Argument::Kind;

FileHashes
WithoutRecordsOfOneRun(FileHashes files)
{
  files.erase(
    std::remove_if(files.begin(), files.end(), [](const auto & file) { return IsRecordOfOneRun(file.first); }),
    files.end());
  return files;
}

/** Fails a stage if its tool reports success but a file is missing. */
void
RequireExpected(const Stage & stage, const std::string & folder, StageResult & result)
{
  for (const std::string & name : stage.GetExpected())
  {
    if (result.status == 0 && !fs::exists(folder + '/' + name))
    {
      result.status = 1;
      result.message = "ended without \"" + name + "\"; report this as a bug";
    }
  }
}

/** Returns the existing files. */
std::vector<std::string>
FilesReadOf(const Stage::Argument & argument)
{
  std::vector<std::string> paths;
  if (argument.kind == Kind::Input && argument.files.empty())
  {
    paths.push_back(argument.value);
  }
  for (const std::string & name : argument.files)
  {
    paths.push_back(argument.value + '/' + name);
  }
  paths.erase(std::remove_if(paths.begin(), paths.end(), [](const std::string & path) { return !fs::exists(path); }),
              paths.end());
  return paths;
}

/** Returns the identity without its prefix, such as "sha256:". */
std::string
HashIn(const std::string & identity)
{
  return identity.substr(identity.find(':') + 1);
}

StageResult
CannotStart(const Stage & stage, const OutputError & error)
{
  return { stage.GetName(), stage.GetProgram(), {}, 1, error.what(), {}, {} };
}
} // namespace

StagedRun::StagedRun(const std::string & folder, const std::string & toolFolder)
  : m_Lock(std::make_unique<Lock>(folder)), m_Folder(folder), m_ToolFolder(toolFolder)
{}

StagedRun::~StagedRun() = default;

std::string
StagedRun::PathOf(const std::string & stage, const std::string & file) const
{
  return m_Folder + '/' + stage + (file.empty() ? "" : '/' + file);
}

std::string
StagedRun::VersionOf(const std::string & program)
{
  const ChildOutcome outcome = RunChildTool(m_ToolFolder + '/' + program, { "--version" });
  if (outcome.status != 0)
  {
    throw OutputError("the program \"" + m_ToolFolder + '/' + program + "\" does not work (" + outcome.message +
                      "); install it again");
  }
  return outcome.text.substr(0, outcome.text.find('\n'));
}

std::string
StagedRun::IdentityOfInput(const Stage::Argument & argument)
{
  if (argument.identity)
  {
    return argument.identity(argument.value);
  }
  if (argument.files.empty())
  {
    return this->Identify(argument.value);
  }
  std::string lines;
  for (const std::string & path : FilesReadOf(argument))
  {
    lines += this->Identify(path) + ' ' + path.substr(argument.value.size() + 1) + '\n';
  }
  return "sha256:" + Sha256OfBytes(lines);
}

/** Inputs that are results of stages, either of this run or of another one. */
FileHashes
StagedRun::ResultsReadBy(const Stage & stage)
{
  std::map<std::string, std::string> results;
  for (const Stage::Argument & argument : stage.GetArguments())
  {
    for (const std::string & path : FilesReadOf(argument))
    {
      if (fs::exists(RecordPathOf(path)))
      {
        results[fs::path(path).lexically_relative(m_Folder).string()] = HashIn(this->Identify(path));
      }
    }
  }
  return { results.begin(), results.end() };
}

std::string
StagedRun::Identify(const std::string & path)
{
  {
    const std::lock_guard lock(m_Mutex);
    const auto            known = m_Identities.find(path);
    if (known != m_Identities.end())
    {
      return known->second;
    }
  }
  const std::string     identity = IdentityOf(path); // expensive
  const std::lock_guard lock(m_Mutex);
  return m_Identities[path] = identity;
}

std::string
StagedRun::SignatureOf(const Stage & stage, const std::string & version)
{
  Json signature;
  signature["program"] = stage.GetProgram();
  signature["version"] = version;
  signature["arguments"] = Json::array();
  for (const Stage::Argument & argument : stage.GetArguments())
  {
    if (argument.kind != Kind::Idle)
    {
      const std::string value = argument.kind == Kind::Input ? this->IdentityOfInput(argument) : argument.value;
      signature["arguments"].push_back({ argument.flag, value });
    }
  }
  return signature.dump();
}

bool
StagedRun::IsUnchanged(const StageResult & result) const
{
  const FileHashes now = HashesOfFolder(this->PathOf(result.name, ""));
  return std::includes(now.begin(), now.end(), result.files.begin(), result.files.end());
}

StageResult
StagedRun::Compute(const Stage & stage, const std::string & scratch, const Progress & progress) const
{
  MakeEmptyFolder(scratch);
  ChildOutcome outcome = RunChildTool(m_ToolFolder + '/' + stage.GetProgram(), stage.CommandIn(scratch), progress);
  StageResult  result;
  result.name = stage.GetName();
  result.program = stage.GetProgram();
  result.status = outcome.status;
  result.message = outcome.status == 0 ? "" : outcome.message;
  result.warnings = std::move(outcome.warnings);
  RequireExpected(stage, scratch, result);
  result.files = WithoutRecordsOfOneRun(HashesOfFolder(scratch));
  return result;
}

StageResult
StagedRun::Run(const Stage & stage, const Progress & progress)
{
  const std::string recordPath = m_Folder + "/stages/" + stage.GetName() + ".json";
  const std::string scratch = m_Folder + "/." + stage.GetName() + ".part";
  std::string       version;
  try
  {
    version = this->VersionOf(stage.GetProgram());
  }
  catch (const OutputError & error)
  {
    return CannotStart(stage, error);
  }
  const std::string signature = this->SignatureOf(stage, version);
  const auto        old = ReadStageRecord(recordPath);
  const bool        isDone = old && old->result.name == stage.GetName() && old->result.status == 0 &&
                      old->signature == signature && this->IsUnchanged(old->result);
  StageResult      result = isDone ? old->result : this->Compute(stage, scratch, progress);
  const FileHashes inputs = this->ResultsReadBy(stage);
  result.isResumed = isDone;
  result.version = version;
  const bool hasNew = !isDone && (result.status == 0 || !result.files.empty());
  if (hasNew)
  {
    ReplaceFiles(scratch, this->PathOf(stage.GetName(), ""), old ? old->result.files : FileHashes());
  }
  else if (!isDone)
  {
    RemoveFolder(scratch);
  }
  if (hasNew || (isDone && old->inputs != inputs)) // inputs with equal identity may differ in their bytes
  {
    WriteStageRecord({ signature, inputs, result }, recordPath);
  }
  const std::lock_guard lock(m_Mutex);
  for (const auto & [name, hash] : result.files)
  {
    m_Identities[this->PathOf(stage.GetName(), name)] = "sha256:" + hash;
  }
  return result;
}

std::string
FolderOfThisProgram()
{
  std::error_code error;
  const fs::path  program = PathOfThisProgram(error);
  if (error)
  {
    throw OutputError("cannot locate this program (" + error.message() + "); mount /proc");
  }
  return program.parent_path().string();
}
} // namespace shapeton
