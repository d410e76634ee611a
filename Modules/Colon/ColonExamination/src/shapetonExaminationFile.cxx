#include "shapetonExaminationFiles.h"

#include <sstream>
#include <stdexcept>

namespace shapeton
{
std::string
ExaminationFile::Path() const
{
  return *stage == '\0' ? name : std::string(stage) + '/' + name;
}

bool
ExaminationFile::IsReadBy(const std::string & reader) const
{
  std::istringstream words(readers);
  for (std::string word; words >> word;)
  {
    if (word == reader)
    {
      return true;
    }
  }
  return false;
}

std::vector<std::string>
FilesReadBy(const std::string & tool)
{
  std::vector<std::string> paths;
  for (const ExaminationFile & file : examination::all)
  {
    if (file.IsReadBy(tool))
    {
      paths.push_back(file.Path());
    }
  }
  return paths;
}

std::vector<std::string>
FilesAlwaysWrittenBy(const std::string & stage)
{
  std::vector<std::string> names;
  for (const ExaminationFile & file : examination::all)
  {
    if (file.stage == stage && file.isAlways)
    {
      names.push_back(file.name);
    }
  }
  return names;
}

std::string
ToolOfStage(const std::string & stage)
{
  for (const auto & [name, tool] : colonoscopystage::stageTools)
  {
    if (stage == name)
    {
      return tool;
    }
  }
  throw std::logic_error("format/files.json does not declare the stage \"" + stage + '"');
}
} // namespace shapeton
