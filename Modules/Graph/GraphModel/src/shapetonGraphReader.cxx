#include "shapetonGraphReader.h"
#include "shapetonFileBytes.h"
#include "shapetonGraphFormat.h"
#include "shapetonSha256.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <filesystem>

namespace shapeton
{
GraphFile
ReadGraph(const std::string & path)
{
  GraphText text{ path, ReadFileBytes(path) };
  GraphFile file;
  file.identity = "sha256:" + Sha256OfBytes(text.bytes);
  if (text.bytes.compare(0, 3, "\xEF\xBB\xBF") == 0) // byte order mark, written by some editors
  {
    text.bytes.erase(0, 3);
  }
  const GraphFormat format = FormatOf(text);
  file.format = format.name;
  file.graph = format.read(text, file.notes);
  RequireSound(file.graph, '"' + path + '"');
  return file;
}

std::vector<std::string>
GraphFilesOf(const std::string & folder)
{
  std::vector<std::string> files;
  std::error_code          error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
  {
    const std::filesystem::path path = entry->path();
    if (entry->is_regular_file() && path.filename().string()[0] != '.' && path.extension() != ".json")
    {
      files.push_back(path.string());
    }
  }
  if (error)
  {
    throw InputError('"' + folder + "\": " + error.message() + "; use a folder of graph files");
  }
  if (files.empty())
  {
    throw InputError('"' + folder + "\" has no files; use a folder with one graph file for each step");
  }
  std::sort(files.begin(), files.end());
  return files;
}
} // namespace shapeton
