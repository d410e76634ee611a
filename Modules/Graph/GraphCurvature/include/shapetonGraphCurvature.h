#ifndef shapetonGraphCurvature_h
#define shapetonGraphCurvature_h

#include "ShapetonGraphCurvatureExport.h"

#include "shapetonGraph.h"
#include "shapetonGraphCurvatureOptions.h"
#include "shapetonProgress.h"

#include <cstdint>
#include <string>
#include <vector>

namespace shapeton
{
/** Options of MeasureCurvature() and its progress callback. \ingroup ShapetonGraphCurvature */
struct GraphCurvatureSettings : GraphCurvatureOptions
{
  /** May throw to abort. */
  Progress progress;
};

/** A rational number in lowest terms; the denominator is positive, or 0 if the number is undefined.
 * \ingroup ShapetonGraphCurvature */
struct ShapetonGraphCurvature_EXPORT ExactNumber
{
  std::int64_t numerator{ 0 };
  std::int64_t denominator{ 0 };

  bool
  IsDefined() const
  {
    return denominator != 0;
  }
  /** The nearest double up to rounding; NaN if undefined. */
  double
  Value() const;
  /** Such as "-2/3" or "1"; empty if undefined. */
  std::string
  Text() const;
};

/** \brief Discrete Ricci curvature of a graph; dimensionless. \ingroup ShapetonGraphCurvature */
struct GraphCurvature
{
  /** For each edge; undefined for loops. */
  std::vector<ExactNumber> edges;
  /** For each edge, the number of common neighbors of its ends; 0 for loops. */
  std::vector<int> triangles;
  /** For each node: mean curvature of its edges without loops, the scalar curvature of Jost and Liu. NaN without
   * edges. */
  std::vector<double> nodeMeans;
  /** For each node: sum over its edges without loops, the node curvature of Sreejith et al.; 0 without edges. */
  std::vector<double> nodeSums;
};

/** \brief Computes the Ricci curvature of each edge exactly, as a rational number.
 *
 * Ollivier (J. Funct. Anal. 256, 2009): kappa = 1 - W(m_x, m_y) for an edge xy. W is the transport distance of order 1,
 * where distances are numbers of edges. m_x is one step of a random walk: it stays at x with probability `idleness`;
 * otherwise it takes one of the half-edges of x with equal probability. Parallel edges thus act as integer weights; a
 * loop is two half-edges back to x. The masses are integers over a common denominator, and W is computed by minimum
 * cost flow in integers.
 *
 * Lin, Lu and Yau (Tohoku Math. J. 63, 2011): the limit of kappa / (1 - idleness) for idleness 1. kappa is linear for
 * idleness >= 1/2, even with parallel edges and loops, so the limit is 2 kappa at 1/2.
 *
 * Forman (Discrete Comput. Geom. 29, 2003), unit weights: 4 - deg(x) - deg(y), plus 3 for each triangle if triangles
 * are faces (Samal et al., Sci. Rep. 8, 2018). Degrees count half-edges; triangles count common neighbors.
 *
 * The idleness is interpreted as the simplest fraction with that double value, for example 0.1 as 1/10. Results are
 * identical for any number of threads. Throws ParameterError for an option out of range, for an idleness > 0 with a
 * method other than Ollivier's, and for an idleness whose fraction has a denominator above 2^31; InputError if the
 * graph is invalid or the masses of an edge exceed 64 bits. \ingroup ShapetonGraphCurvature */
ShapetonGraphCurvature_EXPORT GraphCurvature
MeasureCurvature(const Graph & graph, const GraphCurvatureSettings & settings = GraphCurvatureSettings());
} // namespace shapeton

#endif
