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

/** 1 for each pixel of the flat map's grid where tagged residue coats the wall; empty if there is no CT from before
 * cleansing. */
std::vector<unsigned short>
CoatedPixels(const ColonoscopyResults & results);

/** The flat colon in rows, with segments, taeniae and folds. */
Picture::Pointer
DrawFlat(const ColonoscopyResults & results, const std::vector<unsigned short> & coated, FlatColoring coloring);
} // namespace shapeton

#endif
