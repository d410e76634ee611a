#ifndef shapetonColonModelFiles_h
#define shapetonColonModelFiles_h

#include "ColonToolsExport.h"
#include "shapetonColonModel.h"
#include "shapetonSceneFiles.h"

#include <functional>
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

  /** Writes the volumes, which need nothing of the wall: see ColonModelOptions::besideWall. No other output may be
   * asked for meanwhile. */
  void
  WriteVolumes(const ColonModel & model);

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
  std::vector<File>
  VolumesOf(const ColonModel & model) const;
  /** All but the volumes. Those that take long come first, as several are written at a time. */
  std::vector<File>
  FilesOf(const ColonModel & model) const;
  void
  WriteFiles(const std::vector<File> & files);

  CommandLine &            m_CommandLine;
  std::string              m_Folder;
  SceneFiles               m_Scene;
  std::vector<std::string> m_Written;
};
} // namespace shapeton

#endif
