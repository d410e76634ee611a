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

  /** Writes what the model has. With `atOnce` the files get their names now, even if the run fails later. */
  void
  Write(const ColonModel & model, bool atOnce = false) const;

private:
  struct File
  {
    std::string                                   name;
    std::function<void(const std::string & path)> write;
  };
  /** Those that take long come first, as several are written at a time. */
  std::vector<File>
  FilesOf(const ColonModel & model) const;

  CommandLine & m_CommandLine;
  std::string   m_Folder;
  SceneFiles    m_Scene;
};
} // namespace shapeton

#endif
