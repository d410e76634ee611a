#ifndef shapetonViewerVerdicts_h
#define shapetonViewerVerdicts_h

#include "shapetonJson.h"
#include "shapetonSlicerMarkups.h"

namespace shapeton
{
/** Reads what the page saved. Throws InputError for another form or another examination than `exam`, which has the
 * member sha256. */
Json
ReadVerdicts(const std::string & path, const Json & exam);

/** A point for each candidate with a verdict and for each finding. `positions` are those of the page. */
Markup
MarkupOfVerdicts(const Json & verdicts, const Json & positions);
} // namespace shapeton

#endif
