#ifndef shapetonRegistrationFiles_h
#define shapetonRegistrationFiles_h

#include "ShapetonColonToolsExport.h"
#include "shapetonRegistrationResults.h"
#include "shapetonSceneFiles.h"

namespace shapeton
{
class CommandLine;

/** \class RegistrationFiles
 * \brief Files of a registration in a folder: map-supine-to-prone.vtp, map-prone-to-supine.vtp, matches.csv,
 * registration.json, and errors.csv if points were given.
 *
 * The surfaces and the JSON file contain the provenance. Without points, an errors.csv of an earlier run is removed.
 *
 * \ingroup ShapetonColonTools */
class ShapetonColonTools_EXPORT RegistrationFiles
{
public:
  /** Creates the folder. Throws OutputError if the folder cannot be written to, ParameterError if it is an examination
   * or one of its stages; a new folder inside an examination is allowed. */
  RegistrationFiles(CommandLine &                    commandLine,
                    const std::string &              folder,
                    const std::vector<std::string> & examinations);

  /** The warnings of the command line are written to registration.json. */
  void
  Write(const RegistrationResults & results) const;

private:
  std::string
  PathOf(const std::string & name) const;
  void
  WriteFile(const std::string & name, const std::function<void(const std::string & path)> & write) const;
  void
  WriteErrors(const RegistrationResults & results) const;

  CommandLine & m_CommandLine;
  std::string   m_Folder;
  SceneFiles    m_Scene;
};
} // namespace shapeton

#endif
