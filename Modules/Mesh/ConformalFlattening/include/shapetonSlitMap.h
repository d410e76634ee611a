#ifndef shapetonSlitMap_h
#define shapetonSlitMap_h

#include "shapetonBoundaryLoops.h"
#include "shapetonHarmonicSolver.h"

#include <memory>

namespace shapeton
{
/** The conformal map of a surface onto an annulus with concentric circular slits, as its logarithm.
 * \ingroup ConformalFlattening */
struct SlitMap
{
  /** The element of the loops that becomes the inner circle. */
  int inner{ -1 };
  /** For each vertex the logarithm of the radius; 0 on the outer circle, negative inside, constant on each loop. */
  Eigen::VectorXd logRadius;
  /** For each vertex its angle in radians, 0 at the first vertex of the outer loop. Counterclockwise as seen from
   * outside the surface. In the corners `left` it is larger by 2 pi; the angle itself is not reduced to one turn. */
  Eigen::VectorXd angle;
  /** Vertices from the outer to the inner loop, where the angle jumps; they go around as little as edges can. */
  std::vector<int> cut;
  /** The corners left of the cut, see LeftCorners(). */
  std::vector<int> left;
  /** For each loop its value of logRadius. */
  Eigen::VectorXd logRadiusOfLoops;
  /** For each loop the flux of grad logRadius through it, outwards of the surface, in turns: 1 for the outer loop, -1
   * for the inner one, 0 for the slits (5.16). */
  Eigen::VectorXd turnsOfLoops;
  /** Two values of the modulus 2 pi / ln(R / r) of the annulus, circumference over length of the strip: from logRadius,
   * not less than the true one, and from the energy of the angle, not greater (on a surface of genus 0). */
  double modulusU{ 0.0 };
  double modulusV{ 0.0 };
};

/** \class SlitMapSolver
 * \brief Slit maps of a surface with an outer and n >= 1 inner boundaries (dissertation 5.2.3).
 *
 * n harmonic functions f_j, 1 on inner loop j and 0 on the others (5.12), have the fluxes P_ij = f_i^T L f_j through
 * the loops. -logRadius = sum lambda_j f_j with P lambda = 2 pi e_k has one turn around inner loop k and none around
 * the others (5.16), which holds exactly for the discrete flux. As it is constant on each loop, these become two
 * circles and n - 1 circular slits.
 *
 * The angle is the conjugate function: a second harmonic function, which jumps by 2 pi across one path from the outer
 * loop to loop k and has natural boundaries elsewhere. No path of integration is chosen, and the angle has no turn
 * around slits by itself. (The dissertation integrates an averaged Hodge star along a tree.)
 *
 * With handles the angle has no period around them either, and the map is conformal away from them as far as they are
 * small (5.2.2); the gap of the two moduli tells.
 *
 * \ingroup ConformalFlattening
 */
class ConformalFlattening_EXPORT SlitMapSolver
{
public:
  /** \param edgeLengths in any metric, such as that of heat diffusion.
   * \param outer the element of `loops` that becomes the outer circle.
   * \param weightLevels for each vertex 0, or from 1 to 6 how near to 1 the weights of its edges are brought so that no
   * face is flipped; empty: 0. Fluxes and moduli are those of these weights.
   * \pre One manifold, oriented component; the loops are those of BoundaryLoopsByLength(). Throws InputError where
   * there are fewer than two loops or no such outer one, and as MakeSurfaceLaplacian() does. */
  SlitMapSolver(const SurfaceMesh &         mesh,
                const SurfaceConnectivity & connectivity,
                const Eigen::VectorXd &     edgeLengths,
                std::vector<BoundaryLoop>   loops,
                int                         outer = 0,
                const std::vector<int> &    weightLevels = {},
                const Progress &            progress = {});
  ~SlitMapSolver();

  /** Throws InputError where there is no such loop or it is the outer one. */
  SlitMap
  Map(int inner, const Progress & progress = {}) const;

  /** f_j in columns, in the order of InnerLoops(). */
  const Eigen::MatrixXd &
  HarmonicFunctions() const;
  /** P, n x n, symmetric positive definite. */
  const Eigen::MatrixXd &
  Fluxes() const;
  /** The elements of the loops without the outer one, ascending. */
  const std::vector<int> &
  InnerLoops() const;
  const std::vector<BoundaryLoop> &
  Loops() const;
  int
  OuterLoop() const;

private:
  struct State;
  std::unique_ptr<const State> m_State;
};
} // namespace shapeton

#endif
