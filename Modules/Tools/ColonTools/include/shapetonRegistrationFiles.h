#ifndef shapetonRegistrationFiles_h
#define shapetonRegistrationFiles_h

#include "ColonToolsExport.h"
#include "shapetonCsvTable.h"
#include "shapetonRegistrationResults.h"
#include "shapetonSceneFiles.h"

namespace shapeton
{
class CommandLine;

/** \class RegistrationFiles
 * \brief The files of a registration in a folder: map-supine-to-prone.vtp, map-prone-to-supine.vtp, matches.csv,
 * registration.json, and errors.csv where points were given.
 *
 * Surfaces and document state the provenance. An errors.csv of an earlier run is removed where there are no points.
 *
 * \ingroup ColonTools */
class ColonTools_EXPORT RegistrationFiles
{
public:
  /** Makes the folder. Throws OutputError where nothing can be written, ParameterError where the folder is one of the
   * examinations, or that of one of their stages; within them it may lie. */
  RegistrationFiles(CommandLine &                    commandLine,
                    const std::string &              folder,
                    const std::vector<std::string> & examinations);

  /** The warnings of the command line go into registration.json. */
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
 * \ingroup ColonTools */
///@{
ColonTools_EXPORT CsvTable
TableOfMatches(const RegistrationResults & results);

/** A row for each point: coordinates, counted, excluded or offSurface, distance in space (mm) and on the map (width
 * 1). */
ColonTools_EXPORT CsvTable
TableOfErrors(const RegistrationResults & results);

/** Reads points of the wall in both positions: a table with the columns sx, sy, sz (supine) and px, py, pz (prone),
 * LPS, mm. Throws InputError with file and line, also where there are no points. */
ColonTools_EXPORT std::vector<PointPair>
                  ReadPointPairs(const std::string & path);

/** Reads a folder back, for reports and for what goes on from a registration. Throws InputError for a file that is
 * missing or not what RegistrationFiles writes. */
ColonTools_EXPORT RegistrationResults
ReadRegistrationResults(const std::string & folder);

/** How far a registration in a folder can be trusted, 0 to 1; 0 where it is flagged. Throws InputError for a document
 * that does not tell. */
ColonTools_EXPORT double
ConfidenceOfRegistration(const std::string & folder);
///@}
} // namespace shapeton

#endif
