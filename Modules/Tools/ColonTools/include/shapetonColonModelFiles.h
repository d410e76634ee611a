#ifndef shapetonColonModelFiles_h
#define shapetonColonModelFiles_h

#include "ShapetonColonToolsExport.h"
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
 * \brief Files of a colon model in a folder, as the tools write and read them.
 *
 * lumen.nrrd (1 gas, 2 fluid, 3 terminalIleum), cleansed.nrrd and cleansing.nrrd (HU, their sum is the CT; not for a
 * mask), centerline.vtp, catheter.vtp
 * (if one is found), wall.vtp, wall-repaired.vtp, wall-simplified.vtp, quality.json. All files state their provenance.
 *
 * \ingroup ShapetonColonTools
 */
class ShapetonColonTools_EXPORT ColonModelFiles
{
public:
  /** Creates the folder. Throws OutputError if the folder cannot be written to. */
  ColonModelFiles(CommandLine & commandLine, const std::string & folder);

  /** Adds the provenance to the surfaces, and writes each part of the model in parallel as soon as it is available.
   * Call it before the model is computed; do not register other outputs until the model is complete. \param ct HU, not
   * used for a mask; it must outlive the files. */
  void
  WriteBeside(ColonModelSettings & options, const itk::Image<float, 3> * ct);

  /** Writes the parts of the model that have not been written yet. With `atOnce` the files get their final names
   * immediately, even if the run fails later. */
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
  /** What cleansing removed. */
  File
  CleansingFile(const itk::Image<float, 3> * cleansed) const;
  File
  LumenFile(const ColonModel & model) const;
  static std::vector<File>
  WallsOf(const SurfaceMesh & raw, const SurfaceMesh & repaired);
  static File
  FileOf(const char * name, const SurfaceMesh & surface);
  /** All files, slowest first, because several are written in parallel. */
  std::vector<File>
  FilesOf(const ColonModel & model) const;
  /** Writes the files even if they were already written. */
  void
  WriteFiles(const std::vector<File> & files);

  CommandLine &                      m_CommandLine;
  std::string                        m_Folder;
  SceneFiles                         m_Scene;
  const itk::Image<float, 3> *       m_Ct{ nullptr };
  std::mutex                         m_Mutex;   ///< guards the next member and the command line's outputs
  std::map<std::string, std::string> m_Outputs; ///< by name
};
} // namespace shapeton

#endif
