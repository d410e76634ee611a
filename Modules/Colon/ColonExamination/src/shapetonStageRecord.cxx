#include "shapetonStageRecord.h"

#include "shapetonJson.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <filesystem>

namespace shapeton
{
namespace
{
FileHashes
HashesIn(const Json & json)
{
  FileHashes hashes;
  for (const auto & file : json.items())
  {
    hashes.emplace_back(file.key(), file.value().get<std::string>());
  }
  return hashes;
}

Json
JsonOf(const FileHashes & hashes)
{
  Json json = Json::object();
  for (const auto & [name, hash] : hashes)
  {
    json[name] = hash;
  }
  return json;
}

/** Files with these names are removed, so no name may refer to a file outside the stage's folder. */
void
RequireInside(const std::string & name)
{
  const std::filesystem::path path = name;
  if (path.is_absolute() || path.lexically_normal().string().rfind("..", 0) == 0)
  {
    throw InputError("a record contains the file \"" + name +
                     "\", which does not belong to its stage; remove the record");
  }
}

StageRecord
RecordOf(const Json & json)
{
  StageRecord record;
  record.signature = json.at("signature").dump();
  record.result.name = json.at("stage").get<std::string>();
  record.result.program = json.at("signature").at("program").get<std::string>();
  record.result.version = json.at("signature").at("version").get<std::string>();
  record.result.status = json.at("status").get<int>();
  record.result.message = json.at("message").get<std::string>();
  record.result.warnings = json.at("warnings").get<std::vector<std::string>>();
  record.inputs = HashesIn(json.value("inputs", Json::object()));
  record.result.files = HashesIn(json.at("files"));
  for (const auto & file : record.result.files)
  {
    RequireInside(file.first);
  }
  return record;
}
} // namespace

bool
StageResult::Has(const std::string & file) const
{
  return std::any_of(files.begin(), files.end(), [&](const auto & one) { return one.first == file; });
}

std::string
StageRecord::IdentityOfInput() const
{
  const Json parsed = Json::parse(signature);
  for (const Json & argument : parsed.at("arguments"))
  {
    const auto value = argument.at(1).get<std::string>();
    if (argument.at(0) == "" && value.rfind("sha256:", 0) == 0) // a positional output is not an identity
    {
      return value;
    }
  }
  return "";
}

std::string
RecordPathOf(const std::string & file)
{
  const std::filesystem::path stage = std::filesystem::path(file).parent_path();
  return (stage.parent_path() / "stages" / (stage.filename().string() + ".json")).lexically_normal().string();
}

std::optional<StageRecord>
ReadStageRecord(const std::string & path)
{
  if (!std::filesystem::exists(path))
  {
    return std::nullopt;
  }
  try
  {
    return RecordOf(ReadJson(path));
  }
  catch (const InputError &)
  {
    return std::nullopt;
  }
  catch (const Json::exception &)
  {
    return std::nullopt;
  }
}

void
WriteStageRecord(const StageRecord & record, const std::string & path)
{
  const StageResult & result = record.result;
  Json                json;
  json["stage"] = result.name;
  json["signature"] = Json::parse(record.signature);
  json["status"] = result.status;
  json["message"] = result.message;
  json["warnings"] = result.warnings;
  json["inputs"] = JsonOf(record.inputs);
  json["files"] = JsonOf(result.files);
  const std::filesystem::path target = path;
  const std::filesystem::path temporary = target.parent_path() / ('.' + target.filename().string() + ".part");
  std::error_code             error;
  std::filesystem::create_directories(target.parent_path(), error);
  WriteJson(json, temporary.string());
  std::filesystem::rename(temporary, target, error);
  if (error)
  {
    throw OutputError("cannot write \"" + path + "\" (" + error.message() + "); check the folder and its disk");
  }
}
} // namespace shapeton
