#ifndef shapetonProvenance_h
#define shapetonProvenance_h

#include "ShapetonCommonExport.h"

#include <string>
#include <utility>
#include <vector>

namespace shapeton
{
/** Provenance of a result, as names and values in output order: program, version, inputs, repairs, options that affect
 * the result. Excludes threads, paths, dates, host and run times, so that repeated runs give identical files.
 * \ingroup ShapetonCommon */
using Provenance = std::vector<std::pair<std::string, std::string>>;

/** The provenance with "Shapeton." before each name, to distinguish it from other metadata of a file.
 * \ingroup ShapetonCommon */
ShapetonCommon_EXPORT Provenance
ProvenanceMetadata(const Provenance & provenance);

/** "name=value; name=value", for files with a single comment field. \ingroup ShapetonCommon */
ShapetonCommon_EXPORT std::string
                      ProvenanceComment(const Provenance & provenance);
} // namespace shapeton

#endif
