#include "shapetonDiffusionTime.h"

#include "shapetonExceptions.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
double
MeanEdgeAt55000Faces(const SurfaceConnectivity & connectivity, const Eigen::VectorXd & edgeLengths)
{
  return edgeLengths.mean() * std::sqrt(connectivity.NumberOfFaces() / 55000.0);
}

double
DefaultDiffusionTime(const SurfaceConnectivity & connectivity,
                     const Eigen::VectorXd &     edgeLengths,
                     double                      narrowestRadius)
{
  if (!(narrowestRadius > 0.0))
  {
    throw InputError("the narrowest radius of the lumen must be positive, not " + std::to_string(narrowestRadius));
  }
  const double h = MeanEdgeAt55000Faces(connectivity, edgeLengths);
  return std::min(8.0 * h * h, 0.6 * narrowestRadius * narrowestRadius);
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
