#ifndef shapetonParticleMoments_h
#define shapetonParticleMoments_h

namespace shapeton
{
/** The integrals over theta in [0, pi/2] used by the shape distribution of an octant. */
namespace ParticleMoments
{

/** binomial(3, j) times the integral of (1 - u)^(3-j) u^j sin(theta), u = 2 theta / pi; they sum to 1. Combinations of
 * 2/pi, 8/pi^2 (pi/2 - 1) and 24/pi^3 (pi^2/4 - 2) in closed form. */
constexpr double moment[4] = { 0.11636524537746896620,
                               0.21919585645148658675,
                               0.30265323386187589868,
                               0.36178566430916854837 };
} // namespace ParticleMoments
} // namespace shapeton

#endif
