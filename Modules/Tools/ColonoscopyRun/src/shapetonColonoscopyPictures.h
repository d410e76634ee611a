#ifndef shapetonColonoscopyPictures_h
#define shapetonColonoscopyPictures_h

#include "shapetonColonoscopyResults.h"
#include "shapetonColonPictures.h"
#include "shapetonFlatColonPictures.h"

namespace shapeton
{
/** The centreline's segments with the share that is distended, for the chart; what the segmentation guesses where there
 * are no landmarks. */
std::vector<ColonSegment>
ChartSegmentsOf(const ColonoscopyResults & results);

/** The wall coloured by segments with taeniae and flexures. */
Picture::Pointer
DrawSegments(const ColonoscopyResults & results, PatientSide side);

/** See-through, with the centreline, taeniae and the places of the flexures. */
Picture::Pointer
DrawInside(const ColonoscopyResults & results, PatientSide side);

/** The flat colon in rows with segments, taeniae and folds. */
Picture::Pointer
DrawFlat(const ColonoscopyResults & results, FlatColoring coloring);
} // namespace shapeton

#endif
