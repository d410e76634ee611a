#ifndef shapetonProvenance_h
#define shapetonProvenance_h

#include "ShapetonCommonExport.h"

#include <string>
#include <utility>
#include <vector>

namespace shapeton
{
/** How a result was computed, as names and values in the order of writing: program, version, inputs, repairs,
 * options that affect the result. Never threads, paths, dates, host or run times, so that equal runs give equal
 * bytes. \ingroup ShapetonCommon */
using Provenance = std::vector<std::pair<std::string, std::string>>;

/** The provenance with "Shapeton." before each name, to distinguish it from other metadata of a file. \ingroup ShapetonCommon */
ShapetonCommon_EXPORT Provenance
ProvenanceMetadata(const Provenance & provenance);

/** "name=value; name=value", for files with a single comment field. \ingroup ShapetonCommon */
ShapetonCommon_EXPORT std::string
            ProvenanceComment(const Provenance & provenance);
} // namespace shapeton

#endif
