#ifndef shapetonContentIdentity_h
#define shapetonContentIdentity_h

#include "ShapetonColonToolsExport.h"

#include <string>

namespace shapeton
{
/** Content identity of a file or folder, "sha256:...". The identity of a file covers its bytes; the identity of a
 * folder, the names below it and the bytes of all files except hidden ones. For a NRRD or MetaImage header with
 * detached data (.nhdr, .mhd) it includes the files in the same folder that share its stem. Files are read by several
 * threads; file times and the location of the folder do not affect the identity. Throws InputError if a file cannot be
 * read.
 * \ingroup ShapetonColonTools */
ShapetonColonTools_EXPORT std::string
                          IdentityOf(const std::string & path);
} // namespace shapeton

#endif
