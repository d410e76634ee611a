#include "shapetonDiffusionTime.h"

#include "shapetonExceptions.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
/** Upper limit of the mean edge length used for the default time (mm). */
constexpr double greatestEdge = 3.0;
/** Bounds on the number of faces of a colon. */
constexpr double usualFaces = 55000.0;
constexpr double mostFaces = 500000.0;
/** Diffusion time in squared mean edges: loops of about eight edges vanish. */
constexpr double timeOfHandles = 8.0;
/** Default and maximum diffusion time, in squared smallest radii. Beyond the maximum, the angular shape of a tube of
 * this radius vanishes. On a real colon, removing mesh noise requires at least one squared mean edge, and preserving
 * the shape at most 1.3 squared radii. */
constexpr double timeOfTube = 0.6;
constexpr double longestTimeOfTube = 1.3;

void
RequireRadius(double radius)
{
  if (!(radius > 0.0))
  {
    throw InputError("the narrowest radius of the lumen must be positive, not " + std::to_string(radius));
  }
}
} // namespace

double
MeanEdgeAt55000Faces(const SurfaceConnectivity & connectivity, const Eigen::VectorXd & edgeLengths)
{
  return edgeLengths.mean() * std::sqrt(connectivity.NumberOfFaces() / usualFaces);
}

double
DefaultDiffusionTime(double meanEdge, double narrowestRadius)
{
  RequireRadius(narrowestRadius);
  const double ofHandles = timeOfHandles * std::pow(std::min(meanEdge, greatestEdge), 2);
  return std::min(ofHandles, std::max(timeOfTube * narrowestRadius * narrowestRadius, meanEdge * meanEdge));
}

bool
IsTooCoarseForDiffusion(double meanEdge, double narrowestRadius)
{
  RequireRadius(narrowestRadius);
  return meanEdge * meanEdge > longestTimeOfTube * narrowestRadius * narrowestRadius;
}

int
FacesForDiffusion(double area, double narrowestRadius)
{
  constexpr double areaOfFace = 0.42; // relative to the squared mean edge: most faces are nearly equilateral
  RequireRadius(narrowestRadius);
  constexpr double mappedWell = 2.0; // mm: at 2.5 mm the dilatation of 1 % of the faces of a patient's wall exceeds 1.9
  const double     edge = std::min(mappedWell, narrowestRadius);
  return static_cast<int>(std::clamp(area / (areaOfFace * edge * edge), usualFaces, mostFaces));
}

void
RequireDiffusionTime(double t)
{
  if (!std::isfinite(t) || t <= 0.0)
  {
    throw InputError("the diffusion time must be positive, in mm^2, not " + std::to_string(t));
  }
}
} // namespace shapeton
