#include "shapetonSceneFiles.h"

#include "shapetonCommandLine.h"
#include "shapetonExceptions.h"

#include <filesystem>

namespace fs = std::filesystem;

namespace shapeton
{
SceneFiles::SceneFiles(CommandLine & commandLine, const std::vector<Choice> & choices)
{
  for (const Choice & choice : choices)
  {
    const std::string path = commandLine.GetString(choice.parameter);
    if (path.empty())
    {
      continue;
    }
    const fs::path extension = fs::path(choice.name).extension();
    RequireParameter(fs::path(path).extension() == extension,
                     "the parameter \"" + choice.parameter + "\" requires a file name that ends with " +
                       extension.string());
    m_Asked.push_back({ choice.name, commandLine.OutputOf(choice.parameter) });
  }
}

void
SceneFiles::Copy(const std::string & name, const std::string & path) const
{
  for (const Asked & asked : m_Asked)
  {
    std::error_code error;
    if (asked.name == name && !fs::copy_file(path, asked.copy, fs::copy_options::overwrite_existing, error))
    {
      throw OutputError("cannot copy " + path + " to " + asked.copy + ": " + error.message());
    }
  }
}

void
SceneFiles::CopyFrom(const std::string & folder) const
{
  for (const Asked & asked : m_Asked)
  {
    this->Copy(asked.name, folder + '/' + asked.name);
  }
}
} // namespace shapeton
