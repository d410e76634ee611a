#ifndef shapetonSphericalPacking_h
#define shapetonSphericalPacking_h

#include "ShapetonRicciFlowEmbeddingExport.h"
#include "shapetonCombinatorialMap.h"
#include "shapetonProgress.h"

#include <array>
#include <vector>

namespace shapeton
{
/** \brief An oriented circle on the unit sphere as a point of de Sitter space: (n, t) with |n|^2 - t^2 = 1.
 *
 * n points to the center of the cap, and t is the cotangent of its angle: the cap contains the points p with n p > t. A
 * Moebius transformation of the sphere is a linear map of these vectors. The inner product of two of these vectors is
 * -1 for tangent caps that do not overlap and 0 for orthogonal circles. \ingroup ShapetonRicciFlowEmbedding */
using SphereCircle = std::array<double, 4>;

/** Center of the cap, a unit vector. \ingroup ShapetonRicciFlowEmbedding */
ShapetonRicciFlowEmbedding_EXPORT std::array<double, 3>
                                  CenterOf(const SphereCircle & circle);
/** Angle of the cap, in (0, pi). \ingroup ShapetonRicciFlowEmbedding */
ShapetonRicciFlowEmbedding_EXPORT double
RadiusOf(const SphereCircle & circle);

/** Correspondence between the plane of the flow and the sphere. \ingroup ShapetonRicciFlowEmbedding */
enum class PointAtInfinity
{
  Circle,  ///< the circle of the longest face becomes the ideal boundary of the hyperbolic plane
  EdgeNode ///< the touch point of four circles, which become straight lines: as published
};

/** \brief A circle packing of the unit sphere. \ingroup ShapetonRicciFlowEmbedding */
struct SphericalPacking
{
  std::vector<SphereCircle> nodes;
  std::vector<SphereCircle> faces;
  /** Rounding residuals of the circles, for subsequent transformations; empty if only doubles were used. */
  std::vector<SphereCircle> nodeRests;
  std::vector<SphereCircle> faceRests;
  /** Touch point of the end circles of each edge, a unit vector. */
  std::vector<std::array<double, 3>> touchPoints;
  /** See CirclePacking. */
  double residual{ 0.0 };
  int    steps{ 0 };
};

/** If the barycenter leaves a visible cap smaller than this (radians), larger caps are preferred over the barycenter.
 * \ingroup ShapetonRicciFlowEmbedding */
constexpr double smallestCapOfBarycenter = 1e-5;

/** \brief Packs a 3-connected map of genus 0 on the unit sphere.
 *
 * A Moebius transformation moves the center of mass of the tangency points of `edges` to the center of the sphere
 * (conformal barycenter). If `edges` has fewer than three elements, all edges of the map are used. If a cap of a node
 * marked in `isVisible` would be smaller than smallestCapOfBarycenter, the sum of the fourth roots of cot(angle / 2)
 * over these nodes is minimized instead. This enlarges the smallest caps; larger exponents would let a single one of
 * them displace all others. The remaining freedom is a rotation. The packing is laid out again from the circle that
 * became largest on the sphere, because the transformation may enlarge a small part of the plane. Throws InputError as
 * PackCircles() does.
 * \ingroup ShapetonRicciFlowEmbedding */
ShapetonRicciFlowEmbedding_EXPORT SphericalPacking
PackOnSphere(const CombinatorialMap &  map,
             PointAtInfinity           infinity,
             std::vector<int>          edges = {},
             const std::vector<char> & isVisible = {},
             const Progress &          progress = {});

/** Rotates the sphere so that two sums of the node centers, weighted by `rank`, point to the north pole and to the
 * meridian of the x axis. Nodes beyond the end of the rank list have zero weight. \ingroup ShapetonRicciFlowEmbedding
 */
ShapetonRicciFlowEmbedding_EXPORT void
TurnToCanonicalPosition(SphericalPacking & packing, const std::vector<int> & rank);
} // namespace shapeton

#endif
