#ifndef shapetonShapeDatabase_h
#define shapetonShapeDatabase_h

#include "ShapetonShapeSignatureExport.h"
#include "shapetonShapeSearch.h"
#include "shapetonShapeTable.h"

namespace shapeton
{
/** \defgroup ShapeDatabaseFile Named signatures in one SQLite file
 *
 * The table `shape` contains one row per shape: name, identity of the source table, label, numbers, and curves as JSON
 * lists. `PRAGMA application_id` is 0x53687074 ("Shpt"), `PRAGMA user_version` the version of the schema, 1. SQLite
 * keeps a rollback journal next to the file while rows are added: the next process that opens the file rolls back an
 * interrupted transaction.
 *
 * Both functions throw InputError and leave the file unchanged if it is not a shape database, has another version or
 * is damaged (PRAGMA quick_check).
 * \ingroup ShapetonShapeSignature */
///@{
/** Adds the rows of a table in one transaction: all or none. A single row is named `name`, several rows "name:label".
 * Creates the file if it does not exist. Several processes may add rows concurrently.
 *
 * The key of a row is the identity of its table and its label; adding a table twice throws InputError, even with
 * another name. Several shapes may share a name.
 *
 * \param identity identity of the table, "sha256:..." of its file.
 * \return the number of shapes now in the database. Throws OutputError if it cannot be written. */
ShapetonShapeSignature_EXPORT std::size_t
                              AddToShapeDatabase(const std::string & path,
                                                 const ShapeTable &  table,
                                                 const std::string & identity,
                                                 const std::string & name);

/** All shapes, in the order in which they were added. The file is opened read-only, or for writing if an interrupted
 * transaction has to be rolled back. Also throws InputError if the file does not exist or contains no shape. */
ShapetonShapeSignature_EXPORT std::vector<NamedShape>
                              ReadShapeDatabase(const std::string & path);
///@}
} // namespace shapeton

#endif
