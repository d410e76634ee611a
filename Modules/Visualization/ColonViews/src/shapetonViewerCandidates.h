#ifndef shapetonViewerCandidates_h
#define shapetonViewerCandidates_h

#include "shapetonJson.h"

namespace shapeton
{
/** Reads polyps/candidates.csv as JSON for the page: numbers in the units of the table, unknown ones are null, words as
 * in the report, and whether the report lists the candidate as a polyp. Throws InputError for an invalid file. */
Json
CandidatesForViewer(const std::string & path);
} // namespace shapeton

#endif
