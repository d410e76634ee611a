#ifndef shapetonViewerPosition_h
#define shapetonViewerPosition_h

#include "shapetonColonViewer.h"
#include "shapetonPageBlocks.h"

namespace shapeton
{
/** One number in a JSON document for a page: two places after the point. */
Json
Hundredths(double value);

/** Reads the files of one position that a run of VirtualColonoscopy left in `exam`, puts their data into blocks with
 * this prefix, and returns what is told in words: name, seriesUID, circumference, candidates, taeniae, flexures, and
 * `missing`, the stages that left no file. Throws InputError where wall, centreline or lumen are missing. */
Json
PutViewerPosition(PageBlocks &               blocks,
                  const std::string &        prefix,
                  const std::string &        exam,
                  const ColonViewerOptions & options);

/** Puts the map from the position in the folder `exam` to the other one: `prefix`mapped, the place (LPS, mm) of each
 * point, and `prefix`trust, its confidence times 200, 255 where the wall is not seen in a position. Throws InputError
 * for a map of another wall. */
void
PutViewerMap(PageBlocks & blocks, const std::string & prefix, const std::string & exam, const std::string & path);
} // namespace shapeton

#endif
