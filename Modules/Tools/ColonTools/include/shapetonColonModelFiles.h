#ifndef shapetonColonModelFiles_h
#define shapetonColonModelFiles_h

#include "ColonToolsExport.h"
#include "shapetonColonModel.h"
#include "shapetonSceneFiles.h"

#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace shapeton
{
class CommandLine;

/** \class ColonModelFiles
 * \brief The files of a colon in a folder, as the tools write and read them.
 *
 * lumen.nrrd (1 gas, 2 fluid, 3 terminalIleum), cleansed.nrrd (HU; not of a mask alone), centreline.vtp, catheter.vtp
 * (where one is found), wall.vtp, wall-repaired.vtp, wall-simplified.vtp, quality.json. All state their provenance.
 *
 * \ingroup ColonTools
 */
class ColonTools_EXPORT ColonModelFiles
{
public:
  /** Makes the folder. Throws OutputError where nothing can be written. */
  ColonModelFiles(CommandLine & commandLine, const std::string & folder);

  /** Has the surfaces state their provenance, and the parts of the model written as soon as they are there, beside what
   * follows. To be called before the model is made; no other output may be asked for meanwhile. */
  void
  WriteBeside(ColonModelOptions & options);

  /** Writes what the model has, and is not written yet. With `atOnce` the files get their names now, even if the run
   * fails later. */
  void
  Write(const ColonModel & model, bool atOnce = false);

private:
  struct File
  {
    std::string                                   name;
    std::function<void(const std::string & path)> write;
  };
  File
  CleansedFile(const itk::Image<float, 3> * cleansed) const;
  File
  LumenFile(const ColonModel & model) const;
  static std::vector<File>
  WallsOf(const SurfaceMesh & raw, const SurfaceMesh & repaired);
  static File
  FileOf(const char * name, const SurfaceMesh & surface);
  /** All. Those that take long come first, as several are written at a time. */
  std::vector<File>
  FilesOf(const ColonModel & model) const;
  /** Even where they have been written. */
  void
  WriteFiles(const std::vector<File> & files);

  CommandLine &                      m_CommandLine;
  std::string                        m_Folder;
  SceneFiles                         m_Scene;
  std::mutex                         m_Mutex;   ///< of what follows, and of the outputs of the command line
  std::map<std::string, std::string> m_Outputs; ///< by their names
};
} // namespace shapeton

#endif
