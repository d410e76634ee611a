#include "shapetonRunRecords.h"

#include "shapetonExceptions.h"
#include "shapetonSha256.h"
#include "shapetonStageRecord.h"

#include <algorithm>
#include <filesystem>
#include <set>

namespace fs = std::filesystem;

namespace shapeton
{
namespace
{
[[noreturn]] void
Refuse(const std::string & what)
{
  throw InputError(what + "; let the run finish");
}

StageRecord
ReadFinished(const std::string & path)
{
  const auto record = ReadStageRecord(path);
  if (!record || record->result.status != 0)
  {
    Refuse("the stage of \"" + path + "\" has not finished");
  }
  return *record;
}

/** SHA-256 of the file; "" if the stage did not write it. */
std::string
HashOf(const StageRecord & record, const std::string & file)
{
  const auto & files = record.result.files;
  const auto   found = std::find_if(files.begin(), files.end(), [&](const auto & one) { return one.first == file; });
  return found == files.end() ? std::string() : found->second;
}

/** Checks that each stage read the current results of the earlier stages. */
class ChainOfStages
{
public:
  void
  Check(const std::string & recordPath, const StageRecord & record)
  {
    if (!m_Checked.insert(recordPath).second)
    {
      return;
    }
    const fs::path run = fs::path(recordPath).parent_path().parent_path();
    for (const auto & [name, hash] : record.inputs)
    {
      const fs::path    input = (run / name).lexically_normal();
      const std::string path = RecordPathOf(input.string());
      const StageRecord maker = ReadFinished(path);
      if (HashOf(maker, input.filename().string()) != hash)
      {
        Refuse("the results of the stage " + record.result.name + " in \"" + run.string() +
               "\" were computed from an outdated \"" + name + "\"");
      }
      this->Check(path, maker);
    }
  }

private:
  std::set<std::string> m_Checked;
};
} // namespace

RunRecords::RunRecords(const std::string & folder) : m_Folder(folder) {}

std::string
RunRecords::PathOf(const std::string & stage) const
{
  return RecordPathOf(m_Folder + '/' + stage + "/any");
}

void
RunRecords::RequireCurrent(const std::string & stage, const std::string & file) const
{
  const std::string path = m_Folder + '/' + stage + '/' + file;
  const StageRecord record = ReadFinished(this->PathOf(stage));
  if (!fs::is_regular_file(path) || Sha256OfFile(path) != HashOf(record, file))
  {
    Refuse('"' + path + "\" was changed after the stage " + stage + " wrote it");
  }
  ChainOfStages().Check(this->PathOf(stage), record);
}

void
RunRecords::RequireCurrent(const std::string & stage) const
{
  const auto record = ReadStageRecord(this->PathOf(stage));
  if (record && record->result.status == 0)
  {
    ChainOfStages().Check(this->PathOf(stage), *record);
  }
}

Remarks
RunRecords::WarningsOf(const std::string & stage) const
{
  const auto record = ReadStageRecord(this->PathOf(stage));
  return record ? record->result.warnings : Remarks();
}
} // namespace shapeton
