#ifndef shapetonViewerDetails_h
#define shapetonViewerDetails_h

#include "shapetonJson.h"
#include "shapetonPageBlocks.h"
#include "shapetonSurfaceMesh.h"

namespace shapeton
{
/** Adds the wall at full resolution where the flat wall does not show it: around candidates, which are elements of
 * CandidatesForViewer(), and in pouches that were cut off. `prefix`detailPoints and `prefix`detailFaces hold these
 * parts of `wall`, counterclockwise from outside the lumen; `prefix`replaced holds a byte per vertex of `flat`: 1 where
 * these parts replace it. They overlap by 1 mm. */
void
PutViewerDetails(PageBlocks &        blocks,
                 const std::string & prefix,
                 const SurfaceMesh & flat,
                 const SurfaceMesh & wall,
                 const Json &        candidates);
} // namespace shapeton

#endif
