#ifndef shapetonCenterlineStations_h
#define shapetonCenterlineStations_h

#include "shapetonColonPictures.h"
#include "shapetonPictureAnnotation.h"

#include <Eigen/Core>

namespace shapeton
{
/** A point of the centerline. */
struct CenterlineStation
{
  Eigen::Vector3d point;
  int             vertex;
  double          distance; ///< from the anal verge, mm
  double          caliber;  ///< mm
  bool            isGap;
};

/** Points of all curves, in order. Throws InputError if there are none, or if the array arcLength or radius is
 * missing. */
std::vector<CenterlineStation>
StationsOf(const CurveSet & centerline);

/** Colors for the distance from the anal verge, in every picture of a colon. */
ColorScale
DistanceScale(const std::vector<CenterlineStation> & stations);

/** Color of bridges over gaps, in every picture. */
RGBColor
GapColor();
} // namespace shapeton

#endif
