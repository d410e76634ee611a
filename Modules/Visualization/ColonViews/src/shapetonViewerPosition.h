#ifndef shapetonViewerPosition_h
#define shapetonViewerPosition_h

#include "shapetonColonViewer.h"
#include "shapetonExaminationFolder.h"
#include "shapetonPageBlocks.h"

namespace shapeton
{
/** A number in a JSON document for a page, with two decimals. */
Json
Hundredths(double value);

/** Reads one position of an examination and adds its data as blocks with this prefix. Returns the JSON values: name,
 * seriesUID, circumference, candidates, taeniae, flexures, and `missing`, the stages without a file. Throws InputError
 * if wall, centerline or lumen are missing. */
Json
PutViewerPosition(PageBlocks &               blocks,
                  const std::string &        prefix,
                  const ExaminationFolder &  exam,
                  const ColonViewerOptions & options);

/** Adds the map from the position in `exam` to the other one: `prefix`mapped, the mapped position (LPS, mm)
 * of each point, and `prefix`trust, its confidence times 200, or 255 if the wall is not visible in one position. Throws
 * InputError if the map belongs to another wall. */
void
PutViewerMap(PageBlocks & blocks, const std::string & prefix, const ExaminationFolder & exam, const std::string & path);
} // namespace shapeton

#endif
