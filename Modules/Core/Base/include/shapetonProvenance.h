#ifndef shapetonProvenance_h
#define shapetonProvenance_h

#include "BaseExport.h"

#include <string>
#include <utility>
#include <vector>

namespace shapeton
{
/** How a result was made, as names and values in the order in which they are written: program, version, inputs,
 * repairs, options that change the result. Never threads, paths, dates, host or durations, so that equal runs give
 * equal bytes. \ingroup Base */
using Provenance = std::vector<std::pair<std::string, std::string>>;

/** The same with "Shapeton." before each name, as it stands among the other facts of a file. \ingroup Base */
Base_EXPORT Provenance
ProvenanceMetadata(const Provenance & provenance);

/** "name=value; name=value", for files with room for one text. \ingroup Base */
Base_EXPORT std::string
            ProvenanceComment(const Provenance & provenance);
} // namespace shapeton

#endif
