#ifndef shapetonCentrelineStations_h
#define shapetonCentrelineStations_h

#include "shapetonColonPictures.h"
#include "shapetonPictureAnnotation.h"

#include <Eigen/Core>

namespace shapeton
{
/** A point of the centreline. */
struct CentrelineStation
{
  Eigen::Vector3d point;
  int             vertex;
  double          distance; ///< from the anal verge, mm
  double          calibre;  ///< mm
  bool            isGap;
};

/** Points of all curves, in order. Throws InputError if there are none, or if the array arcLength or radius is
 * missing. */
std::vector<CentrelineStation>
StationsOf(const CurveSet & centreline);

/** Colors for the distance from the anal verge, in every picture of a colon. */
ColorScale
DistanceScale(const std::vector<CentrelineStation> & stations);

/** Color of bridges over gaps, in every picture. */
RGBColor
GapColor();
} // namespace shapeton

#endif
