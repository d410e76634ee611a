#ifndef shapetonShapeDatabase_h
#define shapetonShapeDatabase_h

#include "ShapeDatabaseExport.h"
#include "shapetonShapeSearch.h"
#include "shapetonShapeTable.h"

namespace shapeton
{
/** \defgroup ShapeDatabaseFile Named signatures in one SQLite file
 *
 * A row for each shape in the table `shape`: name, table (its identity) and label that it comes from, numbers, and
 * curves as JSON lists. `PRAGMA application_id` is 0x53687074 ("Shpt"), `PRAGMA user_version` the version of the
 * schema, 1. SQLite's rollback journal lies beside the file while something is added: what a killed process has begun
 * is undone by the next one that opens the file.
 *
 * Both functions throw InputError, and leave the file as it is, where it is no database of shapes, has another version
 * or is damaged (PRAGMA quick_check).
 * \ingroup ShapeDatabase */
///@{
/** Adds the rows of a table in one transaction: all, or none. The name of a single row is `name`, of several
 * "name:label". Makes the file where there is none. Several processes may add at a time.
 *
 * A row is stored once, by the identity of its table and its label: a table that has been added is refused with
 * InputError, whatever the name. Several shapes may have one name.
 *
 * \param identity of the table, "sha256:..." of its file.
 * \return how many shapes the database holds now. Throws OutputError where it cannot be written. */
ShapeDatabase_EXPORT std::size_t
                     AddToShapeDatabase(const std::string & path,
                                        const ShapeTable &  table,
                                        const std::string & identity,
                                        const std::string & name);

/** All shapes, in the order in which they were added. The file is opened for reading only; for writing where an
 * interrupted process has to be undone first. Throws InputError also where there is no file or no shape. */
ShapeDatabase_EXPORT std::vector<NamedShape>
                     ReadShapeDatabase(const std::string & path);
///@}
} // namespace shapeton

#endif
