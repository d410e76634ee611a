#ifndef shapetonRegistrationFolder_h
#define shapetonRegistrationFolder_h

#include "ShapetonColonExaminationExport.h"
#include "shapetonCsvTable.h"
#include "shapetonIleocecalValve.h"
#include "shapetonRegistrationResults.h"

#include <array>
#include <optional>

namespace shapeton
{
/** \defgroup RegistrationTables Tables of a registration
 * \ingroup ShapetonColonExamination */
///@{
ShapetonColonExamination_EXPORT CsvTable
TableOfMatches(const RegistrationResults & results);

/** One row per point: coordinates, status (counted, excluded or offSurface), distance in space (mm) and on the map
 * (width 1). */
ShapetonColonExamination_EXPORT CsvTable
TableOfErrors(const RegistrationResults & results);

/** Reads points of the wall in both positions: a table with the columns sx, sy, sz (supine) and px, py, pz (prone),
 * LPS, mm. Throws an InputError that states the file and line; also if the table has no points. */
ShapetonColonExamination_EXPORT std::vector<PointPair>
                                ReadPointPairs(const std::string & path);

/** Reads the results in a folder, for reports and later stages. Throws InputError if a file is missing or was not
 * written by ColonRegistration. */
ShapetonColonExamination_EXPORT RegistrationResults
ReadRegistrationResults(const std::string & folder);

/** Confidence of a registration in a folder, 0 to 1; 0 if the registration was flagged as doubtful. Throws InputError
 * if the JSON file does not state it. */
ShapetonColonExamination_EXPORT double
ConfidenceOfRegistration(const std::string & folder);

/** The prone numbers of the supine taeniae 1 to 3 in a file registration.json; see CommonTaeniae. None if they are
 * unknown, or the file does not state them. Throws InputError as ConfidenceOfRegistration(). */
ShapetonColonExamination_EXPORT std::optional<std::array<int, 3>>
                                TaeniaNumbersOfRegistration(const std::string & path);

/** The valve that was decided from both positions, of the supine (0) or prone (1) one. None if the registration is
 * unreliable, or was written before it stated the valve. Throws InputError as ConfidenceOfRegistration(). */
ShapetonColonExamination_EXPORT std::optional<ValveSearch>
                                ValveOfRegistration(const std::string & folder, int position);
///@}
} // namespace shapeton

#endif
