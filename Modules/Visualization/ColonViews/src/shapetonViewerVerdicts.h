#ifndef shapetonViewerVerdicts_h
#define shapetonViewerVerdicts_h

#include "shapetonJson.h"
#include "shapetonSlicerMarkups.h"

namespace shapeton
{
/** Reads verdicts saved by the page. Throws InputError if the format is unknown, or the examination is not `exam`,
 * which has the member sha256. */
Json
ReadVerdicts(const std::string & path, const Json & exam);

/** One point per candidate with a verdict and per finding. `positions` are the positions on the page. */
Markup
MarkupOfVerdicts(const Json & verdicts, const Json & positions);
} // namespace shapeton

#endif
