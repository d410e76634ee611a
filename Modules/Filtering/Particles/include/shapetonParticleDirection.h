#ifndef shapetonParticleDirection_h
#define shapetonParticleDirection_h

#include "ShapetonParticlesExport.h"

#include <array>

namespace shapeton
{
/** \name The shape distribution of an octant (appendix of the dissertation).
 *
 * The weights w1, w2, w3 >= 0 of the edges along the three axes of an octant define a body whose radius in the
 * direction (theta, phi) is
 *
 *   R = w1 (1 - u) + W u,  W = w2 (1 - s) + w3 s,  u = 2 theta / pi,  s = 2 phi / pi             (8.3, 8.4)
 *
 * theta in [0, pi/2] is the angle from the first axis, phi in [0, pi/2] the angle from the second axis in the plane
 * of the other two. Angles in radians. The closed forms are equivalent to the printed ones; (8.5) and (8.6) are
 * written as Bernstein polynomials, whose terms are all positive, to avoid the cancellation in the printed ones. */
///@{

/** The volume of the whole body (3.4, 8.6): integral of R^3 / 3 sin(theta). pi / 6 for unit weights.
 * \ingroup ShapetonParticles */
ShapetonParticles_EXPORT double
OctantVolume(double w1, double w2, double w3);

/** The volume of the part with an angle of at most `phi` (8.5). \ingroup ShapetonParticles */
ShapetonParticles_EXPORT double
PartialOctantVolume(double w1, double w2, double w3, double phi);

/** The angle phi with PartialOctantVolume() == volume; `volume` in [0, OctantVolume()], clamped. pi/4 for an empty
 * octant. The source uses bisection with an absolute tolerance of 0.01, which freezes the angle for small weights
 * (appendix 8.3); this implementation is accurate to rounding. \ingroup ShapetonParticles */
ShapetonParticles_EXPORT double
PhiOfPartialVolume(double w1, double w2, double w3, double volume);

/** The area of the sector from the first axis to `theta` in the plane of the first axis and a direction of weight
 * `w2` (8.7): integral of R^2 / 2. \ingroup ShapetonParticles */
ShapetonParticles_EXPORT double
SectorArea(double w1, double w2, double theta);

/** The angle theta with SectorArea() == area; `area` in [0, SectorArea(pi/2)], clamped. A cube root; pi/4 for an empty
 * sector. \ingroup ShapetonParticles */
ShapetonParticles_EXPORT double
ThetaOfSectorArea(double w1, double w2, double area);

/** The volume per unit of phi from the first axis to `theta`: integral of R^3 / 3 sin(theta), the contribution of
 * one half-plane to (3.4). \ingroup ShapetonParticles */
ShapetonParticles_EXPORT double
SectorVolume(double w1, double w2, double theta);

/** The angle theta with SectorVolume() == volume; `volume` in [0, SectorVolume(pi/2)], clamped. pi/4 for an empty
 * sector. \ingroup ShapetonParticles */
ShapetonParticles_EXPORT double
ThetaOfSectorVolume(double w1, double w2, double volume);
///@}

/** How the direction of a shapeton is sampled from the six edge weights of its voxel.
 * \ingroup ShapetonParticles */
enum class DirectionSampling
{
  /** Density over the sphere of directions proportional to R^3: octant by volume (8.6), phi by partial volume (8.5),
   * theta by the volume per unit of phi. Six equal weights result in the uniform distribution. */
  SolidAngle,
  /** As published (3.2.1): theta by sector area (8.7), which favors the first axis: for six equal weights the mean
   * squared components are .50, .25, .25. */
  SectorArea,
  /** Uniform over all directions, regardless of the weights; needed for the comparison with heat (see
   * PathRule::Traversal). */
  Uniform
};

/** The weights of the edges to the neighbors at -x, +x, -y, +y, -z, +z. \ingroup ShapetonParticles */
using EdgeWeights = std::array<double, 6>;

/** A unit vector sampled from the shape distribution of six weights by the inverse of its distribution function, in
 * double precision: the reference for the single-precision implementation. The random numbers, in (0, 1], choose
 * octant, phi and theta. Returns the zero vector if all weights are 0; the shapeton does not move.
 * \ingroup ShapetonParticles */
ShapetonParticles_EXPORT std::array<double, 3>
DrawDirection(const EdgeWeights & weights, DirectionSampling sampling, const std::array<double, 3> & random);
} // namespace shapeton

#endif
