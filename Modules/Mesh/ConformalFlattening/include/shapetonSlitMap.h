#ifndef shapetonSlitMap_h
#define shapetonSlitMap_h

#include "shapetonBoundaryLoops.h"
#include "shapetonHarmonicSolver.h"

#include <memory>

namespace shapeton
{
/** Logarithm of the conformal map of a surface onto an annulus with concentric circular slits.
 * \ingroup ShapetonConformalFlattening */
struct SlitMap
{
  /** Index of the loop that becomes the inner circle. */
  int inner{ -1 };
  /** Logarithm of the radius at each vertex: 0 on the outer circle, negative inside, constant on each loop. */
  Eigen::VectorXd logRadius;
  /** Angle at each vertex in radians, 0 at the first vertex of the outer loop, counterclockwise as seen from outside
   * the surface. It is 2 pi larger at the corners `left`; it is not reduced to one turn. */
  Eigen::VectorXd angle;
  /** Vertices of the cut from the outer to the inner loop, across which the angle jumps; chosen to wind as little as
   * possible. */
  std::vector<int> cut;
  /** Corners left of the cut, see LeftCorners(). */
  std::vector<int> left;
  /** Value of logRadius on each loop. */
  Eigen::VectorXd logRadiusOfLoops;
  /** Outward flux of grad logRadius through each loop, in turns: 1 for the outer loop, -1 for the inner one, 0 for the
   * slits (5.16). */
  Eigen::VectorXd turnsOfLoops;
  /** Two estimates of the annulus modulus 2 pi / ln(R / r) (strip circumference over length). On a surface of genus 0,
   * modulusU is an upper bound and modulusV a lower bound. modulusU is computed from logRadius, modulusV from the
   * energy of the angle. */
  double modulusU{ 0.0 };
  double modulusV{ 0.0 };
};

/** \class SlitMapSolver
 * \brief Slit maps of a surface with an outer and n >= 1 inner boundaries (dissertation 5.2.3).
 *
 * n harmonic functions f_j, 1 on inner loop j and 0 on the others (5.12), have the fluxes P_ij = f_i^T L f_j through
 * the loops. -logRadius = sum lambda_j f_j with P lambda = 2 pi e_k has one turn around inner loop k and none around
 * the others (5.16), which holds exactly for the discrete flux. Because the logarithm is constant on each loop, the
 * loops become two circles and n - 1 circular slits.
 *
 * The angle is the conjugate function: a second harmonic function that jumps by 2 pi across one path from the outer
 * loop to loop k and has natural boundaries elsewhere. No integration path is needed, and the angle has no period
 * around slits. (The dissertation integrates an averaged Hodge star along a tree.)
 *
 * With handles the angle has no period around them either, and the map is conformal away from small handles (5.2.2);
 * the gap between the two moduli measures the error.
 *
 * \ingroup ShapetonConformalFlattening
 */
class ShapetonConformalFlattening_EXPORT SlitMapSolver
{
public:
  /** \param edgeLengths in any metric, such as that of heat diffusion.
   * \param outer index of the loop that becomes the outer circle.
   * \param weightLevels for each vertex, how close to 1 the weights of its edges are clamped to avoid flipped faces: 1
   * to 6, or 0 for no clamping. Empty means 0 everywhere. Fluxes and moduli use these weights.
   * \pre One oriented manifold component; the loops come from BoundaryLoopsByLength(). Throws InputError if there are
   * fewer than two loops or the outer loop does not exist, and as MakeSurfaceLaplacian() does. */
  SlitMapSolver(const SurfaceMesh &         mesh,
                const SurfaceConnectivity & connectivity,
                const Eigen::VectorXd &     edgeLengths,
                std::vector<BoundaryLoop>   loops,
                int                         outer = 0,
                const std::vector<int> &    weightLevels = {},
                const Progress &            progress = {});
  ~SlitMapSolver();

  /** Throws InputError if the loop does not exist or is the outer one. */
  SlitMap
  Map(int inner, const Progress & progress = {}) const;

  /** f_j in columns, in the order of InnerLoops(). */
  const Eigen::MatrixXd &
  HarmonicFunctions() const;
  /** P, n x n, symmetric positive definite. */
  const Eigen::MatrixXd &
  Fluxes() const;
  /** Indices of all loops except the outer one, ascending. */
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
