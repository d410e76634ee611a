#ifndef shapetonRegistrationFiles_h
#define shapetonRegistrationFiles_h

#include "ShapetonColonToolsExport.h"
#include "shapetonCsvTable.h"
#include "shapetonRegistrationResults.h"
#include "shapetonSceneFiles.h"

namespace shapeton
{
class CommandLine;

/** \class RegistrationFiles
 * \brief Files of a registration in a folder: map-supine-to-prone.vtp, map-prone-to-supine.vtp, matches.csv,
 * registration.json, and errors.csv if points were given.
 *
 * Surfaces and the JSON file state the provenance. Without points, an errors.csv of an earlier run is removed.
 *
 * \ingroup ShapetonColonTools */
class ShapetonColonTools_EXPORT RegistrationFiles
{
public:
  /** Creates the folder. Throws OutputError if it cannot be written to, ParameterError if the folder is an examination
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

/** \defgroup RegistrationTables Tables of a registration
 * \ingroup ShapetonColonTools */
///@{
ShapetonColonTools_EXPORT CsvTable
TableOfMatches(const RegistrationResults & results);

/** One row per point: coordinates, status (counted, excluded or offSurface), distance in space (mm) and on the map
 * (width 1). */
ShapetonColonTools_EXPORT CsvTable
TableOfErrors(const RegistrationResults & results);

/** Reads points of the wall in both positions: a table with the columns sx, sy, sz (supine) and px, py, pz (prone),
 * LPS, mm. Throws InputError with file and line; also if the table has no points. */
ShapetonColonTools_EXPORT std::vector<PointPair>
                          ReadPointPairs(const std::string & path);

/** Reads a folder back, for reports and later stages. Throws InputError if a file is missing or not written by
 * RegistrationFiles. */
ShapetonColonTools_EXPORT RegistrationResults
ReadRegistrationResults(const std::string & folder);

/** Confidence of a registration in a folder, 0 to 1; 0 if flagged as doubtful. Throws InputError if the JSON file does
 * not state it. */
ShapetonColonTools_EXPORT double
ConfidenceOfRegistration(const std::string & folder);
///@}
} // namespace shapeton

#endif
