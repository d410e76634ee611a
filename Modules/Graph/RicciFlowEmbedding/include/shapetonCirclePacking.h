#ifndef shapetonCirclePacking_h
#define shapetonCirclePacking_h

#include "ShapetonRicciFlowEmbeddingExport.h"
#include "shapetonCombinatorialMap.h"
#include "shapetonProgress.h"

#include <cmath>
#include <vector>

namespace shapeton
{
/** The background geometry of a Ricci flow. \ingroup ShapetonRicciFlowEmbedding */
enum class FlowGeometry
{
  Euclidean,
  Hyperbolic
};

/** Circles of infinite radius: one flag for each node or face, or empty lists for none. A straight line (a geodesic in
 * hyperbolic geometry) subtends the angle pi at the center of each circle orthogonal to it. A horocycle is tangent to
 * the ideal boundary. \ingroup ShapetonRicciFlowEmbedding */
struct CirclesAtInfinity
{
  std::vector<char> lineNodes;
  std::vector<char> lineFaces;
  std::vector<char> horocycleFaces; ///< hyperbolic geometry only
};

/** \brief Radii of the node and face circles: circles of adjacent nodes are tangent, as are the two face circles of
 * their edge, at the same point; the two pairs are orthogonal. Infinite radii are stored as infinity.
 * \ingroup ShapetonRicciFlowEmbedding */
struct CirclePacking
{
  FlowGeometry        geometry{ FlowGeometry::Euclidean };
  std::vector<double> nodeRadii;
  std::vector<double> faceRadii;
  std::vector<char>   horocycleFaces; ///< see CirclesAtInfinity
  /** Rounding residuals of the radii; empty if the last steps were in double precision. */
  std::vector<double> nodeRests;
  std::vector<double> faceRests;
  /** Largest remaining curvature (2 pi minus the angle sum) of a circle, in radians. */
  double residual{ 0.0 };
  int    steps{ 0 };
};

/** Precision of the last steps and of the layout. Along a chain of n circles around another one, errors grow as n^2:
 * some maps with thousands of nodes require extended precision, which is several times slower.
 * \ingroup ShapetonRicciFlowEmbedding */
enum class PackingPrecision
{
  Double, ///< extended if the Hessian requires it
  Extended
};

/** \brief The limit of the discrete Ricci flow du/dt = -K of a map, by Newton's method.
 *
 * u = log r in Euclidean, log tanh(r / 2) in hyperbolic geometry; K = 2 pi minus the sum of the angles at a circle,
 * with one kite of angle 2 atan(r_f / r_v), or 2 atan2(tanh r_f, sinh r_v), for each half-edge: a node and the face to
 * the left. The energy with gradient K is convex. Its Hessian has h / l = 2 r_v r_f / (r_v^2 + r_f^2) for each kite, or
 * (6.7) and (6.8) of the dissertation with the signs of dK/du, where cosh^2 a cosh^2 b - 1 is computed as sinh^2 a
 * cosh^2 b + sinh^2 b. A face of three finite nodes is eliminated: r_f^2 = abc / (a + b + c), or tanh^2 r_f = sinh a
 * sinh b sinh c / sinh(a + b + c). The symbolic analysis is reused for all steps. A step is halved while the slope of
 * the energy at its end exceeds half of the initial descent; in hyperbolic geometry a step covers at most 95 % of the
 * way to u = 0.
 *
 * Throws InputError if the curvature does not vanish: the map has no packing, or none in double precision.
 *
 * \pre `map` is connected, without loops and parallel edges, and no face meets a node twice. The genus is 1 for
 * Euclidean geometry without circles at infinity, and at least 2 for hyperbolic geometry. 3-connectivity (see
 * FaceConflicts) is not checked here. \ingroup ShapetonRicciFlowEmbedding */
ShapetonRicciFlowEmbedding_EXPORT CirclePacking
PackCircles(const CombinatorialMap &  map,
            FlowGeometry              geometry,
            const CirclesAtInfinity & infinite = {},
            PackingPrecision          precision = PackingPrecision::Double,
            const Progress &          progress = {});

/** Half the kite angle of two circles at the center of the first, which is finite. If the second radius is infinite,
 * the second circle is a straight line, or a horocycle if `isHorocycle` is set. \ingroup ShapetonRicciFlowEmbedding */
template <typename TReal>
TReal
HalfKiteAngle(FlowGeometry geometry, TReal radius, TReal otherRadius, bool isHorocycle = false)
{
  if (isHorocycle)
  {
    return std::atan2(TReal(1), std::sinh(radius));
  }
  if (std::isinf(otherRadius))
  {
    return std::acos(TReal(-1)) / 2;
  }
  return geometry == FlowGeometry::Euclidean ? std::atan2(otherRadius, radius)
                                             : std::atan2(std::tanh(otherRadius), std::sinh(radius));
}

/** \name Radii with their rounding residuals, if TReal can represent them \ingroup ShapetonRicciFlowEmbedding */
///@{
template <typename TReal>
TReal
NodeRadius(const CirclePacking & packing, int node)
{
  return TReal(packing.nodeRadii[node]) + (packing.nodeRests.empty() ? TReal(0) : TReal(packing.nodeRests[node]));
}
template <typename TReal>
TReal
FaceRadius(const CirclePacking & packing, int face)
{
  return TReal(packing.faceRadii[face]) + (packing.faceRests.empty() ? TReal(0) : TReal(packing.faceRests[face]));
}
///@}

/** Curvatures of given radii: nodes, then faces; 0 for infinite circles. \ingroup ShapetonRicciFlowEmbedding */
ShapetonRicciFlowEmbedding_EXPORT std::vector<double>
                                  CurvaturesOf(const CombinatorialMap & map, const CirclePacking & packing);

/** Whether the circle of a face is a horocycle. \ingroup ShapetonRicciFlowEmbedding */
inline bool
IsHorocycle(const CirclePacking & packing, int face)
{
  return !packing.horocycleFaces.empty() && packing.horocycleFaces[face] != 0;
}
} // namespace shapeton

#endif
