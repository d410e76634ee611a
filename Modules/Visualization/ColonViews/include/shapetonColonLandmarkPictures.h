#ifndef shapetonColonLandmarkPictures_h
#define shapetonColonLandmarkPictures_h

#include "ShapetonColonViewsExport.h"

#include "shapetonColonLandmarkDocument.h"
#include "shapetonColonLandmarks.h"
#include "shapetonFlatColonPage.h"
#include "shapetonPatientView.h"
#include "shapetonPicture.h"

namespace shapeton
{
/** Inputs of landmark pictures. Not owned. \ingroup ShapetonColonViews */
struct ColonLandmarkParts
{
  const FlatColon *      flat{ nullptr };
  const ColonLandmarks * landmarks{ nullptr };
};

/** Color of a segment; gray for 0 (unknown). \ingroup ShapetonColonViews */
ShapetonColonViews_EXPORT RGBColor
ColorOfSegment(int segment);

/** Color of a taenia, 1 to 3, in all pictures. \ingroup ShapetonColonViews */
ShapetonColonViews_EXPORT RGBColor
ColorOfTaenia(int taenia);

/** Segment boundaries on a flat page, with the segment names. \ingroup ShapetonColonViews */
ShapetonColonViews_EXPORT std::vector<FlatAnnotation>
                          SegmentAnnotations(const std::vector<ColonSegmentExtent> & segments);

/** The wall from one side, colored by segment, with taeniae, loops and names of the flexures, and markers.
 * \ingroup ShapetonColonViews */
ShapetonColonViews_EXPORT Picture::Pointer
                          DrawColonLandmarks(const ColonLandmarkParts & parts, PatientSide side);

/** The wall from one side, with the folds found on the surface. \ingroup ShapetonColonViews */
ShapetonColonViews_EXPORT Picture::Pointer
                          DrawSurfaceFolds(const ColonLandmarkParts & parts, PatientSide side);

/** The flat colon in rows, with taeniae, loops of the flexures, markers and segment names.
 * \ingroup ShapetonColonViews */
ShapetonColonViews_EXPORT Picture::Pointer
                          DrawFlatLandmarks(const ColonLandmarkParts & parts, int greatestColumns = 1500);
} // namespace shapeton

#endif
