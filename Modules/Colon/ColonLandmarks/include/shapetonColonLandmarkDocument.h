#ifndef shapetonColonLandmarkDocument_h
#define shapetonColonLandmarkDocument_h

#include "ColonLandmarksExport.h"

#include "shapetonJsonForward.h"

#include <array>
#include <limits>
#include <string>
#include <vector>

namespace shapeton
{
/** \defgroup ColonLandmarkDocument What landmarks.json tells, read back
 * \ingroup ColonLandmarks */
///@{

/** A part of the colon, as radiologists name them. */
struct ColonSegmentExtent
{
  /** 1 rectum, 2 sigmoid, 3 descending, 4 transverse, 5 ascending, 6 caecum. */
  int         label{ 0 };
  std::string name;
  /** mm along the centreline from the anal verge. */
  double begin{ 0.0 };
  double end{ 0.0 };
  /** mm^2. */
  double area{ 0.0 };
};

/** The segments that landmarks.json names, where both their ends are known: the rectum begins at 0, the caecum ends
 * with the centreline. Throws InputError for another document. */
ColonLandmarks_EXPORT std::vector<ColonSegmentExtent>
                      SegmentsOf(const Json & landmarks, double lengthOfCentreline);

/** The segment in which a place on the centreline lies, mm from the anal verge; the last one holds its end. Null
 * outside of all. */
ColonLandmarks_EXPORT const ColonSegmentExtent *
FindSegment(const std::vector<ColonSegmentExtent> & segments, double arcLength);

/** A flexure as the document has it. */
struct ColonFlexurePlace
{
  /** mm along the centreline; not a number where it was not found. */
  double arcLength{ std::numeric_limits<double>::quiet_NaN() };
  /** The probability that it lies within 30 mm, 0 to 1; 0 where it was not found. */
  double confidence{ 0.0 };
};

/** Rectosigmoid, descending-sigmoid, splenic, hepatic. Throws InputError for another document. */
ColonLandmarks_EXPORT std::array<ColonFlexurePlace, 4>
                      FlexuresOf(const Json & landmarks);
///@}
} // namespace shapeton

#endif
