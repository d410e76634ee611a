#ifndef shapetonColonoscopyPictures_h
#define shapetonColonoscopyPictures_h

#include "shapetonColonoscopyResults.h"
#include "shapetonColonPictures.h"
#include "shapetonFlatColonPictures.h"

namespace shapeton
{
/** Segments of the centerline with their distended fraction, for the chart. Without landmarks, the segments estimated
 * by the segmentation. */
std::vector<ColonSegment>
ChartSegmentsOf(const ColonoscopyResults & results);

/** The wall colored by segment, with taeniae and flexures. */
Picture::Pointer
DrawSegments(const ColonoscopyResults & results, PatientSide side);

/** Transparent wall with the centerline, taeniae and flexures. */
Picture::Pointer
DrawInside(const ColonoscopyResults & results, PatientSide side);

/** WallCover of each pixel of the flat map's grid; empty without a CT from before cleansing. */
std::vector<unsigned short>
CoverPixels(const ColonoscopyResults & results);

/** The flat colon in rows, with segments, taeniae and folds. */
Picture::Pointer
DrawFlat(const ColonoscopyResults & results, const std::vector<unsigned short> & covers, FlatColoring coloring);
} // namespace shapeton

#endif
