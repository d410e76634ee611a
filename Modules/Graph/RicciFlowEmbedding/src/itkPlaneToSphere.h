#ifndef itkPlaneToSphere_h
#define itkPlaneToSphere_h

#include "itkCirclePacking.h"
#include "itkSphericalPacking.h"

#include <complex>

namespace itk
{
/** The centres of the finite circles of a packing of the plane, and the directions of the half-edges of finite nodes.
 */
struct PlaneLayout
{
  PlaneLayout(const CombinatorialMap & map, const CirclePacking & packing);

  std::vector<std::complex<double>> nodes;
  std::vector<std::complex<double>> faces;
  std::vector<double>               directions;
};

/** Stereographic projection, (6.3.3) of the dissertation, of the plane after a similarity that puts most touch points
 * near the equator. */
SphericalPacking
ToSphere(const CombinatorialMap & map, const CirclePacking & packing, const PlaneLayout & layout);
/** The disk as the lower hemisphere, for a hyperbolic packing whose ideal boundary is the circle of a face. A circle
 * with the centre (x, y, w) on the hyperboloid and radius r is (x, y, -cosh r, w) / sinh r. */
SphericalPacking
DiskToSphere(const CombinatorialMap & map, const CirclePacking & packing, int boundaryFace);
} // namespace itk

#endif
