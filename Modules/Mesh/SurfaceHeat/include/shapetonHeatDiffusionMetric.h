#ifndef shapetonHeatDiffusionMetric_h
#define shapetonHeatDiffusionMetric_h

#include "shapetonDiffusionTime.h"
#include "shapetonProgress.h"
#include "shapetonSelectedInversion.h"
#include "shapetonSurfaceSpectrum.h"

namespace shapeton
{
/** Heat diffusion distance (HDD) between the ends of each edge, used as new edge lengths.
 * \ingroup ShapetonSurfaceHeat
 */
struct HeatDiffusionMetric
{
  /** Distances (1/mm) in the order of SurfaceLaplacian::edges. */
  Eigen::VectorXd edgeLengths;
  /** Diffusion time (mm^2). */
  double time{ 0.0 };
  /** Number of eigenpairs; 0 for all of them (without computing any). */
  int eigenpairs{ 0 };
  /** Bound on |r(x) - exp(-x)| (1 + x)^2 over all x >= 0, where r is the rational function; 0 if none was used. */
  double rationalError{ 0.0 };
  /** Edges with a distance below 1e-6 of the heat at their ends, as at the tip of a needle. Rounding leaves no valid
   * digits, so these edges are set to that length, an upper bound on the true one. Also counts edges that
   * LengthenShortestSides() lengthened because an error made them too short for the adjacent triangles. An edge may
   * count twice. */
  int drownedEdges{ 0 };
};

/** \class HeatDiffusionMetricSolver
 * \brief Heat diffusion distances of all edges without eigenvectors.
 *
 * The squared distance is H_pp + H_qq - 2 H_pq with H = exp(-2 t M^-1 L) M^-1 (5.5, all pairs). The exponential is
 * replaced by a rational function: a sum over a few complex poles, in conjugate pairs, of c / (z + 2 t M^-1 L). So H =
 * Re sum c (z M + 2 t L)^-1, and SelectedInversion computes its elements on the edges and the diagonal. Such sums are
 * known from quadrature on Talbot's contour and from Caratheodory-Fejer approximations (Trefethen, Weideman and
 * Schmelzer, 2006). Squared distances are orders of magnitude smaller than H at t = 0, which magnifies approximation
 * errors at large x. Therefore poles and residues are optimized with the weight (1 + x)^2: for a smooth spectrum the
 * relative error is independent of t and of the edge lengths, and 6 pairs are more accurate than 8 on Talbot's contour.
 *
 * A solver can be reused; it stores the elimination order and the symbolic analysis.
 *
 * \ingroup ShapetonSurfaceHeat
 */
class ShapetonSurfaceHeat_EXPORT HeatDiffusionMetricSolver
{
public:
  static constexpr int leastPoles = 3;   // pairs for which poles are tabulated
  static constexpr int defaultPoles = 6; // pairs; more accurate than 8 on Talbot's contour
  static constexpr int mostPoles = 8;    // pairs for which poles are tabulated

  explicit HeatDiffusionMetricSolver(SurfaceLaplacian laplacian);

  /** \param t diffusion time (mm^2).
   * \param poles number of pairs of conjugate poles, leastPoles to mostPoles; each costs one factorization.
   * \param atOnce number of factorizations in memory at the same time.
   * Throws InputError if t is not positive, or so large that rounding errors dominate more than a thousandth of the
   * distances.
   */
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

/** Heat diffusion metric of a surface, from its Euclidean edge lengths. \pre RequireOneManifold() accepts the surface;
 * otherwise throws InputError.
 * \ingroup ShapetonSurfaceHeat */
ShapetonSurfaceHeat_EXPORT HeatDiffusionMetric
ComputeHeatDiffusionMetric(const SurfaceMesh & mesh, double t, const Progress & progress = {});

/** Metric of a surface with this Laplacian; it satisfies the triangle inequality in all faces. Deep within pouches,
 * distances may be as small as the error of the default number of poles and violate it; then mostPoles is used, and
 * LengthenShortestSides() fixes the remaining faces. \ingroup ShapetonSurfaceHeat */
ShapetonSurfaceHeat_EXPORT HeatDiffusionMetric
ComputeHeatDiffusionMetric(const SurfaceConnectivity & connectivity,
                           const SurfaceLaplacian &    laplacian,
                           double                      t,
                           const Progress &            progress = {});

/** The published metric: uses only the first `pairs` eigenpairs of the spectrum (50 in the dissertation). Distances are
 * too short unless exp(-2 lambda t) of the last pair is small. Throws InputError if t is not positive or the spectrum
 * has fewer pairs. \ingroup ShapetonSurfaceHeat */
ShapetonSurfaceHeat_EXPORT HeatDiffusionMetric
TruncatedHeatDiffusionMetric(const SurfaceLaplacian & laplacian, const SurfaceSpectrum & spectrum, double t, int pairs);
} // namespace shapeton

#endif
