#ifndef shapetonContentIdentity_h
#define shapetonContentIdentity_h

#include "StagedRunExport.h"

#include <string>

namespace shapeton
{
/** What a file or a folder holds, as "sha256:...": of a file its bytes; of a folder the names below it and the bytes of
 * all files, hidden ones left out. A header of NRRD or MetaImage with its voxels beside it (.nhdr, .mhd) counts with
 * the files beside it that have its name but for the extension. Files are read on several threads; neither times nor
 * the place of the folder count. Throws InputError for what cannot be read. \ingroup StagedRun */
StagedRun_EXPORT std::string
                 IdentityOf(const std::string & path);
} // namespace shapeton

#endif
