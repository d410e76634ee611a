#ifndef shapetonHeatDiffusionMetric_h
#define shapetonHeatDiffusionMetric_h

#include "shapetonDiffusionTime.h"
#include "shapetonProgress.h"
#include "shapetonSelectedInversion.h"
#include "shapetonSurfaceSpectrum.h"

namespace shapeton
{
/** The heat diffusion distance (HDD) of the ends of each edge, as new lengths of edges. \ingroup HeatDiffusionMetric */
struct HeatDiffusionMetric
{
  /** 1/mm, in the order of SurfaceLaplacian::edges. */
  Eigen::VectorXd edgeLengths;
  /** The time of diffusion, mm^2. */
  double time{ 0.0 };
  /** The number of eigenpairs; 0 for all of them, without computing any. */
  int eigenpairs{ 0 };
  /** A bound of |r(x) - exp(-x)| (1 + x)^2, r the rational function used for all x >= 0; 0 where none was used. */
  double rationalError{ 0.0 };
  /** Edges whose distance is below 1e-6 of the heat at their ends, as at the tip of a needle, so that rounding leaves
   * none of its digits: they have that length, as the true one is not longer. Also those that are too short for the
   * triangles beside them by what errors leave of their digits, and are lengthened: see LengthenShortestSides(). An
   * edge may count as both. */
  int drownedEdges{ 0 };
};

/** \class HeatDiffusionMetricSolver
 * \brief Heat diffusion distances of all edges without eigenvectors.
 *
 * The square of a distance is H_pp + H_qq - 2 H_pq with H = exp(-2 t M^-1 L) M^-1 (5.5, all pairs). The exponential is
 * replaced by a rational function, the sum over few complex poles, in conjugate pairs, of c / (z + 2 t M^-1 L), so that
 * H = Re sum c (z M + 2 t L)^-1, of which SelectedInversion gives the elements on edges and diagonal. Such sums come
 * from quadrature on Talbot's contour and from the approximations of Caratheodory and Fejer (Trefethen, Weideman and
 * Schmelzer, 2006). A square is many orders smaller than H is at t = 0, and what is left of an error at large x is
 * magnified as much. So the poles and residues here were optimised with the weight (1 + x)^2: for a smooth spectrum the
 * relative error is then independent of t and of the lengths of edges, and 6 pairs do more than 8 on Talbot's contour.
 *
 * One object serves any number of times; it holds the order of elimination and the symbolic analysis.
 *
 * \ingroup HeatDiffusionMetric
 */
class HeatDiffusionMetric_EXPORT HeatDiffusionMetricSolver
{
public:
  static constexpr int leastPoles = 3;
  static constexpr int defaultPoles = 6;
  static constexpr int mostPoles = 8;

  explicit HeatDiffusionMetricSolver(SurfaceLaplacian laplacian);

  /** \param t time of diffusion, mm^2.
   * \param poles pairs of conjugate poles, leastPoles to mostPoles; each costs one factorisation.
   * \param atOnce factorisations in memory at the same time.
   * Throws InputError where t is not positive, or so large that more than a thousandth of the distances drown in
   * rounding. */
  HeatDiffusionMetric
  Compute(double t, int poles = defaultPoles, int atOnce = 2, const Progress & progress = {}) const;

  const SurfaceLaplacian &
  Laplacian() const
  {
    return m_Laplacian;
  }
  const SelectedInversion &
  Inversion() const
  {
    return m_Inversion;
  }

private:
  SurfaceLaplacian  m_Laplacian;
  Eigen::VectorXd   m_Diagonal;
  SelectedInversion m_Inversion;
};

/** The metric of one surface with its straight edges. \pre RequireOneManifold(); else InputError.
 * \ingroup HeatDiffusionMetric */
HeatDiffusionMetric_EXPORT HeatDiffusionMetric
ComputeHeatDiffusionMetric(const SurfaceMesh & mesh, double t, const Progress & progress = {});

/** The metric of a surface with this Laplacian, in which all faces are triangles: deep within pouches distances may be
 * as small as the error of the default number of poles, which then breaks the triangle inequality, and mostPoles are
 * taken; what is still no triangle is made one by LengthenShortestSides(). \ingroup HeatDiffusionMetric */
HeatDiffusionMetric_EXPORT HeatDiffusionMetric
ComputeHeatDiffusionMetric(const SurfaceConnectivity & connectivity,
                           const SurfaceLaplacian &    laplacian,
                           double                      t,
                           const Progress &            progress = {});

/** The metric as published: from the first `pairs` eigenpairs of the spectrum alone (the dissertation takes 50). Too
 * short where exp(-2 lambda t) of the last pair is not small. Throws InputError where t is not positive, or the
 * spectrum has not so many pairs. \ingroup HeatDiffusionMetric */
HeatDiffusionMetric_EXPORT HeatDiffusionMetric
TruncatedHeatDiffusionMetric(const SurfaceLaplacian & laplacian, const SurfaceSpectrum & spectrum, double t, int pairs);
} // namespace shapeton

#endif
