#include "shapetonFileParserPath.h"

#include "shapetonOperatingSystem.h"

#include <cstdlib>
#include <filesystem>
#include <stdexcept>

namespace shapeton
{
namespace
{
/** Folders that may contain the program, relative to the library or program that contains this code. */
const char * const parserFolders[] = {
  SHAPETON_PROGRAM_FOLDER,           // shared libraries, built or installed, also in a 3D Slicer extension
  ".",                               // the Python package with static libraries, and programs of other projects
  "..",                              // installed tools with static libraries
  "../lib/" SHAPETON_PROGRAM_FOLDER, // built tools with static libraries
};
} // namespace

std::string
FileParserPath()
{
  constexpr const char * name = "ShapetonFileParser";
  const char * const     given = std::getenv("SHAPETON_FILE_PARSER");
  if (given)
  {
    if (!std::filesystem::is_regular_file(given))
    {
      throw std::runtime_error("the environment variable SHAPETON_FILE_PARSER names \"" + std::string(given) +
                               "\", which is not a file; set it to the program " + name);
    }
    return given;
  }
  const std::filesystem::path library = FolderOfThisLibrary();
  std::string                 missing;
  for (const std::filesystem::path folder : parserFolders)
  {
    const std::string path = (library / folder / name).lexically_normal().string();
    if (!library.empty() && std::filesystem::is_regular_file(path))
    {
      return path;
    }
    missing += missing.find(path + ", ") == std::string::npos ? path + ", " : "";
  }
  const std::string installed = std::string(SHAPETON_PROGRAM_INSTALL_FOLDER) + '/' + name;
  if (!std::filesystem::is_regular_file(installed))
  {
    throw std::runtime_error("the program that reads files is missing: " + missing + installed +
                             "; install it, or set the environment variable SHAPETON_FILE_PARSER to its path");
  }
  return installed;
}
} // namespace shapeton
