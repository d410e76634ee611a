#ifndef shapetonColonLandmarkPictures_h
#define shapetonColonLandmarkPictures_h

#include "ColonViewsExport.h"

#include "shapetonColonLandmarkDocument.h"
#include "shapetonColonLandmarks.h"
#include "shapetonFlatColonPage.h"
#include "shapetonPatientView.h"
#include "shapetonPicture.h"

namespace shapeton
{
/** What pictures of landmarks are made of. Nothing is owned. \ingroup ColonViews */
struct ColonLandmarkParts
{
  const FlatColon *      flat{ nullptr };
  const ColonLandmarks * landmarks{ nullptr };
};

/** Grey for 0, where the segment is not known. \ingroup ColonViews */
ColonViews_EXPORT RGBColor
ColorOfSegment(int segment);

/** The colour of a taenia, from 1 to 3, in all pictures. \ingroup ColonViews */
ColonViews_EXPORT RGBColor
ColorOfTaenia(int taenia);

/** Where segments begin on a flat page, with their names. \ingroup ColonViews */
ColonViews_EXPORT std::vector<FlatAnnotation>
                  SegmentAnnotations(const std::vector<ColonSegmentExtent> & segments);

/** The wall from a side, coloured by segments, with taeniae, loops and names of the flexures, and markers.
 * \ingroup ColonViews */
ColonViews_EXPORT Picture::Pointer
                  DrawColonLandmarks(const ColonLandmarkParts & parts, PatientSide side);

/** The wall from a side with the folds that were found on the surface. \ingroup ColonViews */
ColonViews_EXPORT Picture::Pointer
                  DrawSurfaceFolds(const ColonLandmarkParts & parts, PatientSide side);

/** The flat colon in rows with taeniae, loops of the flexures, markers and the names of segments.
 * \ingroup ColonViews */
ColonViews_EXPORT Picture::Pointer
                  DrawFlatLandmarks(const ColonLandmarkParts & parts, int greatestColumns = 1500);
} // namespace shapeton

#endif
