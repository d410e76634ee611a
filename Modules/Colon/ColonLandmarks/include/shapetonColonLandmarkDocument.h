#ifndef shapetonColonLandmarkDocument_h
#define shapetonColonLandmarkDocument_h

#include "ShapetonColonLandmarksExport.h"

#include "shapetonJsonForward.h"

#include <array>
#include <limits>
#include <string>
#include <vector>

namespace shapeton
{
/** \defgroup ColonLandmarkDocument Reading landmarks.json
 * \ingroup ShapetonColonLandmarks */
///@{

/** A radiological segment of the colon. */
struct ColonSegmentExtent
{
  /** 1 rectum, 2 sigmoid, 3 descending, 4 transverse, 5 ascending, 6 cecum. */
  int         label{ 0 };
  std::string name;
  /** Range along the centerline from the anal verge, mm. */
  double begin{ 0.0 };
  double end{ 0.0 };
  /** Wall area, mm^2. */
  double area{ 0.0 };
};

/** The segments in landmarks.json for which both ends are known. The rectum begins at 0; the cecum ends with the
 * centerline. Throws InputError for an invalid document. */
ShapetonColonLandmarks_EXPORT std::vector<ColonSegmentExtent>
                              SegmentsOf(const Json & landmarks, double lengthOfCenterline);

/** The segment at a distance (mm) along the centerline from the anal verge; null outside all segments. The end of the
 * centerline is part of the last segment. */
ShapetonColonLandmarks_EXPORT const ColonSegmentExtent *
FindSegment(const std::vector<ColonSegmentExtent> & segments, double arcLength);

/** A flexure in the document. */
struct ColonFlexurePlace
{
  /** mm along the centerline; NaN if not found. */
  double arcLength{ std::numeric_limits<double>::quiet_NaN() };
  /** Probability that the flexure is within 30 mm, 0 to 1; 0 if not found. */
  double confidence{ 0.0 };
};

/** Rectosigmoid, descending-sigmoid, splenic, hepatic. Throws InputError for an invalid document. */
ShapetonColonLandmarks_EXPORT std::array<ColonFlexurePlace, 4>
                              FlexuresOf(const Json & landmarks);
///@}
} // namespace shapeton

#endif
