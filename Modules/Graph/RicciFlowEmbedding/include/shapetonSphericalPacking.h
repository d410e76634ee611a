#ifndef shapetonSphericalPacking_h
#define shapetonSphericalPacking_h

#include "RicciFlowEmbeddingExport.h"
#include "shapetonCombinatorialMap.h"
#include "shapetonProgress.h"

#include <array>
#include <vector>

namespace shapeton
{
/** \brief An oriented circle on the unit sphere as a point of de Sitter space: (n, t) with |n|^2 - t^2 = 1.
 *
 * n points to the centre of the cap, t is the cotangent of its angle: the cap holds the points p with n p > t. A
 * Moebius transformation of the sphere is a linear map of these vectors. The products of two are -1 for tangent caps
 * that do not overlap and 0 for orthogonal circles. \ingroup RicciFlowEmbedding */
using SphereCircle = std::array<double, 4>;

/** The centre of the cap, a unit vector. \ingroup RicciFlowEmbedding */
RicciFlowEmbedding_EXPORT std::array<double, 3>
                          CentreOf(const SphereCircle & circle);
/** The angle of the cap, in (0, pi). \ingroup RicciFlowEmbedding */
RicciFlowEmbedding_EXPORT double
RadiusOf(const SphereCircle & circle);

/** How the plane of the flow and the sphere fit together. \ingroup RicciFlowEmbedding */
enum class PointAtInfinity
{
  Circle,  ///< the circle of the longest face becomes the ideal boundary of the hyperbolic plane
  EdgeNode ///< the touch point of four circles, which become straight lines: as published
};

/** \brief A circle packing of the unit sphere. \ingroup RicciFlowEmbedding */
struct SphericalPacking
{
  std::vector<SphereCircle> nodes;
  std::vector<SphereCircle> faces;
  /** What rounding has taken off the circles, for further transformations; empty where nothing but doubles was used. */
  std::vector<SphereCircle> nodeRests;
  std::vector<SphereCircle> faceRests;
  /** Of each edge: where the circles of its ends touch, a unit vector. */
  std::vector<std::array<double, 3>> touchPoints;
  /** See CirclePacking. */
  double residual{ 0.0 };
  int    steps{ 0 };
};

/** A barycentre that leaves a visible cap smaller than this one, in radians, is given up for larger caps.
 * \ingroup RicciFlowEmbedding */
constexpr double smallestCapOfBarycentre = 1e-5;

/** \brief Packs a 3-connected map of genus 0.
 *
 * Moved by a Moebius transformation so that the touch points of `edges` have their centre of mass at the centre of the
 * sphere (conformal barycentre; of all edges where these are fewer than three). Where a cap of the nodes that
 * `isVisible` marks would be smaller than smallestCapOfBarycentre, the sum of the fourth roots of cot(angle / 2) over
 * these nodes is made least instead: the smallest caps grow, but one of them alone does not take the place of all
 * others, as it would with greater exponents. Then what is left free is a rotation. The packing is laid out again from
 * the circle that has become largest on the sphere, as the transformation may enlarge a small part of the plane. Throws
 * InputError as PackCircles() does. \ingroup RicciFlowEmbedding */
RicciFlowEmbedding_EXPORT SphericalPacking
PackOnSphere(const CombinatorialMap &  map,
             PointAtInfinity           infinity,
             std::vector<int>          edges = {},
             const std::vector<char> & isVisible = {},
             const Progress &          progress = {});

/** Turns the sphere so that two sums of the centres of the nodes, with weights by `rank`, point to the north pole and
 * to the meridian of the x axis. Nodes without a rank, beyond the end of the list, have no weight.
 * \ingroup RicciFlowEmbedding */
RicciFlowEmbedding_EXPORT void
TurnToCanonicalPosition(SphericalPacking & packing, const std::vector<int> & rank);
} // namespace shapeton

#endif
