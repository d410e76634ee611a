#include "shapetonColonoscopySceneFiles.h"

#include "shapetonCommandLine.h"
#include "shapetonExceptions.h"

#include <filesystem>

namespace fs = std::filesystem;

namespace shapeton
{
namespace
{
struct SceneFile
{
  const char * parameter;
  const char * result;
  const char * extension;
};

constexpr SceneFile sceneFiles[]{ { "cleansedVolume", "segmentation/cleansed.nrrd", ".nrrd" },
                                  { "lumenLabels", "segmentation/lumen.nrrd", ".nrrd" },
                                  { "wallModel", "landmarks/segments.vtp", ".vtp" },
                                  { "centrelineCurve", "slicer/centreline.mrk.json", ".json" },
                                  { "candidatePoints", "polyps/candidates.mrk.json", ".json" },
                                  { "candidateTable", "polyps/candidates.csv", ".csv" },
                                  { "flatPicture", "flattening/flat.png", ".png" } };
} // namespace

ColonoscopySceneFiles::ColonoscopySceneFiles(CommandLine & commandLine)
{
  for (const SceneFile & file : sceneFiles)
  {
    const std::string path = commandLine.OutputOf(file.parameter);
    if (path.empty())
    {
      continue;
    }
    RequireParameter(fs::path(path).extension() == file.extension,
                     std::string("the parameter \"") + file.parameter + "\" takes a file name that ends with " +
                       file.extension);
    m_Files.push_back({ file.result, path });
  }
  const bool isLumen = commandLine.GetFlag("inputIsLumen");
  RequireParameter(
    !isLumen || !(commandLine.IsGiven("cleansedVolume") || commandLine.IsGiven("lumenLabels")),
    "the input is a lumen: nothing is cleansed or labelled for the parameters \"cleansedVolume\" and \"lumenLabels\"");
}

void
ColonoscopySceneFiles::Copy(const std::string & folder) const
{
  for (const File & file : m_Files)
  {
    std::error_code error;
    fs::copy_file(fs::path(folder) / file.source, file.copy, error);
    if (error)
    {
      throw OutputError("cannot copy " + file.source + ": " + error.message());
    }
  }
}
} // namespace shapeton
