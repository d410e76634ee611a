#ifndef shapetonFoldMatching_h
#define shapetonFoldMatching_h

#include "ShapetonSupineProneExport.h"

#include <utility>
#include <vector>

namespace shapeton
{
/** A fold to match, with coordinates in mm on the unrolled target cylinder after the initial map; y is periodic.
 * \ingroup ShapetonSupineProne */
struct FoldFeature
{
  double x{ 0.0 };
  double y{ 0.0 };
  /** Length, mm. */
  double length{ 1.0 };
  /** Area, mm^2. */
  double area{ 1.0 };
  /** Folds of different groups, such as segments of the colon, are never matched. */
  int group{ 0 };
};

/** Method that matches folds. \ingroup ShapetonSupineProne */
enum class FoldMatchingMethod
{
  /** Folds are independent: exact solution by the Hungarian method with dustbins. */
  Hungarian,
  /** Neighboring folds have similar displacements: graph matching by dual decomposition. */
  DualDecomposition
};

/** Options of MatchFolds(). \ingroup ShapetonSupineProne */
struct FoldMatchingOptions
{
  FoldMatchingMethod method{ FoldMatchingMethod::Hungarian };
  /** Maximum distance of candidate pairs along and around, mm. */
  double reachAlong{ 25.0 };
  double reachAround{ 16.0 };
  /** Standard deviations of the positions along and around (mm), and of the logarithms of length and area. */
  double deviationAlong{ 8.0 };
  double deviationAround{ 6.0 };
  double deviationLength{ 0.5 };
  double deviationArea{ 0.7 };
  /** Cost of an unmatched fold. */
  double alone{ 4.0 };
  /** \name DualDecomposition */
  ///@{
  /** Number of neighbors of each fold; weight and standard deviation (mm) of the difference between the displacements
   * of neighbors. The cost of a pair is truncated at `truncation`. */
  int    neighbors{ 6 };
  double pairWeight{ 1.0 };
  double pairDeviation{ 6.0 };
  double truncation{ 3.0 };
  int    iterations{ 250 };
  ///@}
};

/** A feature point of MatchFeaturePoints(), with coordinates as in FoldFeature.
 * \ingroup ShapetonSupineProne */
struct FeaturePoint
{
  double x{ 0.0 };
  double y{ 0.0 };
  /** Distance (mm) from the center of the flat segment, |q| of the printed energy. */
  double fromCenter{ 0.0 };
  /** Points of different groups are never matched. */
  int group{ 0 };
};

/** Matched pairs of folds, and a bound on the optimal energy. See MatchFolds().
 * \ingroup ShapetonSupineProne */
struct FoldMatching
{
  /** Indices in the source (ascending) and in the target. */
  std::vector<std::pair<int, int>> pairs;
  /** Cost of each pair, excluding neighbor terms. */
  std::vector<double> costs;
  /** Energy of the matching, and best lower bound; they are equal for Hungarian. */
  double primal{ 0.0 };
  double bound{ 0.0 };
  int    iterations{ 0 };

  /** Duality gap relative to the energy reduction achieved by the matching; 0 proves optimality. */
  double
  Gap() const
  {
    return savable > 0.0 ? (primal - bound) / savable : 0.0;
  }
  double savable{ 0.0 };
};

/** One-to-one matching of folds with dustbins (dissertation 4.3.1). The cost of a pair is the sum of the squared
 * differences in position, log length and log area, each divided by its variance; the cost of an unmatched fold is
 * `alone`. DualDecomposition adds the truncated squared difference between the displacements of neighboring folds.
 *
 * Dual decomposition (Torresani, Kolmogorov, Rother 2008) uses one assignment subproblem, one subproblem per pair of
 * neighbors, and multipliers updated by subgradients. MatchFeaturePoints() has the energy that the dissertation prints.
 * \param turn circumference of the plane, mm. \ingroup ShapetonSupineProne */
ShapetonSupineProne_EXPORT FoldMatching
MatchFolds(const std::vector<FoldFeature> & source,
           const std::vector<FoldFeature> & target,
           double                           turn,
           const FoldMatchingOptions &      options = {});

/** Matching with the energy printed in 4.3.1 of the dissertation, minimized exactly:
 * E = lambda sum |p - phi(p)|^2 over matched p + (1 - lambda) sum |q|^2 over unmatched q.
 *
 * The source states neither the origin of q nor the size of the neighborhood of p. The origin is the center of the
 * segment, so that unmatched points near its border cost most, as the text asks; the neighborhood is that of
 * FoldMatchingOptions. Without pairwise terms, dual decomposition is its assignment subproblem.
 * \param lambda weight of the distances, in (0, 1). \ingroup ShapetonSupineProne */
ShapetonSupineProne_EXPORT FoldMatching
MatchFeaturePoints(const std::vector<FeaturePoint> & source,
                   const std::vector<FeaturePoint> & target,
                   double                            turn,
                   double                            lambda);
} // namespace shapeton

#endif
