#ifndef shapetonConformalType_h
#define shapetonConformalType_h

#include "ShapetonGraphCurvatureExport.h"

#include "shapetonCombinatorialMap.h"
#include "shapetonConformalTypeOptions.h"
#include "shapetonProgress.h"

#include <vector>

namespace shapeton
{
/** Conformal type of a sequence of growing planar graphs. \ingroup ShapetonGraphCurvature */
enum class ConformalType
{
  Parabolic,  ///< the limit is the plane
  Hyperbolic, ///< the limit is the disk
  NotDecided
};

/** "parabolic", "hyperbolic" or "not decided". \ingroup ShapetonGraphCurvature */
ShapetonGraphCurvature_EXPORT const char *
NameOf(ConformalType type);

/** \brief Measurements of one graph of the sequence: a disk around the root, with its boundary. Its maximal circle
 * packing fills the hyperbolic plane, and its boundary circles are horocycles. \ingroup ShapetonGraphCurvature */
struct PackedBall
{
  int    radius{ 0 }; ///< edges from the root to the boundary
  int    nodes{ 0 };
  int    boundaryNodes{ 0 };
  int    dummies{ 0 };      ///< nodes added in faces that prevent a packing
  double rootRadius{ 0.0 }; ///< hyperbolic radius of the circle of the root
  /** -log tanh(rootRadius / 2): logarithm of the disk radius divided by the radius of the root circle, if that circle
   * is at the center of the disk. */
  double modulus{ 0.0 };
  /** Effective resistance between root and boundary, all edges having resistance 1. */
  double resistance{ 0.0 };
};

/** \brief Growth of a quantity with the radius n of the ball, and its extrapolation to infinite n.
 *
 * d quantity / d log n is fitted by c n^-decay over the second half of the sequence. If the decay is 0, the quantity
 * grows like log n, as on a lattice of the plane; if it is positive, the quantity has a limit.
 * \ingroup ShapetonGraphCurvature */
struct TypeEvidence
{
  ConformalType type{ ConformalType::NotDecided };
  double        decay{ 0.0 }; ///< NaN if fewer than 4 balls
  /** Extrapolated limit; infinity if parabolic, NaN if not decided. `limit` continues the last two increments
   * geometrically, `farLimit` continues the fitted power; the first applies if the balls grow exponentially. */
  double limit{ 0.0 };
  double farLimit{ 0.0 };
};

/** Bounds on the decay for a verdict, see TypeEvidence. For lattices the true exponent is 0; for exponential growth the
 * decay exceeds any bound as the radius grows. Between the bounds, the radii are too small for a verdict.
 * \ingroup ShapetonGraphCurvature */
///@{
constexpr double mostDecayOfParabolic = 0.25;
constexpr double leastDecayOfHyperbolic = 1.0;
///@}

/** \brief Result of FindConformalType(). \ingroup ShapetonGraphCurvature */
struct ConformalTypeResult
{
  int                     root{ 0 }; ///< node of the (first) graph
  std::vector<PackedBall> balls;
  TypeEvidence            packing;    ///< growth of the modulus
  TypeEvidence            resistance; ///< growth of the resistance
  /** The common verdict; NotDecided if they differ. */
  ConformalType type{ ConformalType::NotDecided };
  /** Hyperbolic radius of the root circle, extrapolated from `limit` and `farLimit` of the modulus: 0 if parabolic, NaN
   * if not decided. */
  double limitRadius{ 0.0 };
  double leastLimitRadius{ 0.0 };
};

/** Options of FindConformalType() and its progress callback. \ingroup ShapetonGraphCurvature */
struct ConformalTypeSettings : ConformalTypeOptions
{
  /** Node at the center of the balls; -1 for the first of the nodes farthest from the outer face. */
  int root{ -1 };
  /** May throw to abort. */
  Progress progress;
};

/** \brief Decides whether balls of growing radius around a node look parabolic or hyperbolic.
 *
 * An infinite triangulation of the plane packs the plane (parabolic) or the disk (hyperbolic), not both (Beardon and
 * Stephenson, Indiana Univ. Math. J. 39, 1990; He and Schramm, Discrete Comput. Geom. 14, 1995). In maximal packings of
 * growing balls in the hyperbolic plane, the circle of the root shrinks to 0 or to a positive limit. If degrees are
 * bounded, the type is hyperbolic if and only if the vertex extremal length from the root to infinity is finite; the
 * simple random walk is then transient, so that the effective resistance to the boundary stays bounded. A finite graph
 * has no type: the verdict is about the sequence of balls, and no finite sequence proves it.
 *
 * The outer face is the longest face. The ball of radius n consists of the faces with a node at distance at most n - 1
 * and everything that they separate from the outer face; n is at most the distance of the outer face. Balls are packed
 * for every n up to 8, then for radii that grow by a fifth to a quarter. If the boundary of a ball is farther away than
 * n, that distance is the radius of the ball. Faces with four or more nodes also have circles, orthogonal to those of
 * their nodes; dummies fill faces that prevent a packing.
 *
 * Throws ParameterError for options out of range; InputError if the graph is not connected and planar, or the outer
 * face contains the root or all nodes. \ingroup ShapetonGraphCurvature */
ShapetonGraphCurvature_EXPORT ConformalTypeResult
FindConformalType(const Graph & graph, const ConformalTypeSettings & settings = ConformalTypeSettings());

/** Overload for growing graphs, each of which is one disk bounded by its longest face. The radius of each is the
 * distance of the outer face from the root; it must increase. `roots` contains the root of each graph. `maximumRadius`
 * does not apply. \ingroup ShapetonGraphCurvature */
ShapetonGraphCurvature_EXPORT ConformalTypeResult
FindConformalType(const std::vector<Graph> & graphs, const std::vector<int> & roots, const Progress & progress = {});

/** Fits the growth of a quantity that increases with the radius, see TypeEvidence. \ingroup ShapetonGraphCurvature */
ShapetonGraphCurvature_EXPORT TypeEvidence
JudgeGrowth(const std::vector<double> & radii, const std::vector<double> & quantities);
} // namespace shapeton

#endif
