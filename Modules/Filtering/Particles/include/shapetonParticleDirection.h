#ifndef shapetonParticleDirection_h
#define shapetonParticleDirection_h

namespace shapeton
{
/** How the direction of a shapeton is sampled from the six edge weights of its voxel.
 *
 * The weights w1, w2, w3 >= 0 of the edges along the three axes of an octant define a body whose radius in the
 * direction (theta, phi) is
 *
 *   R = w1 (1 - u) + W u,  W = w2 (1 - s) + w3 s,  u = 2 theta / pi,  s = 2 phi / pi             (8.3, 8.4)
 *
 * theta in [0, pi/2] is the angle from the first axis, phi in [0, pi/2] the angle from the second axis in the plane
 * of the other two. \ingroup ShapetonParticles */
enum class DirectionSampling
{
  /** Density over the sphere of directions proportional to R^3: octant by volume (8.6), phi by partial volume (8.5),
   * theta by the volume per unit of phi. Six equal weights result in the uniform distribution. */
  SolidAngle,
  /** As published (3.2.1): theta by sector area (8.7), which favors the first axis: for six equal weights the mean
   * squared components are .50, .25, .25. */
  SectorArea,
  /** As published, including the search for both angles: bisection until partial volume (8.5) and partial area (8.7)
   * are within 0.01 of their random share, (8.8) and (8.9). Where the weights are small, both angles remain 45 degrees.
   */
  BinarySearch,
  /** Uniform over all directions, regardless of the weights; needed for the comparison with heat (see
   * PathRule::Traversal). */
  Uniform
};
} // namespace shapeton

#endif
