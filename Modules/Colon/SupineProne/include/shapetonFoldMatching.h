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

/** Matched pairs of folds, and a bound on the optimal energy. See MatchFolds().
 * \ingroup ShapetonSupineProne */
struct FoldMatching
{
  /** Fold indices in the source (ascending) and in the target. */
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
 * The objective printed in 4.3.1 lacks a pairwise term, so the Hungarian method is exact; its term for unmatched
 * features, |q|^2, is a distance to the origin, here replaced by a constant. Dual decomposition (Torresani, Kolmogorov,
 * Rother 2008) uses one assignment subproblem, one subproblem per pair of neighbors, and multipliers updated by
 * subgradients.
 * \param turn circumference of the plane, mm. \ingroup ShapetonSupineProne */
ShapetonSupineProne_EXPORT FoldMatching
MatchFolds(const std::vector<FoldFeature> & source,
           const std::vector<FoldFeature> & target,
           double                           turn,
           const FoldMatchingOptions &      options = {});
} // namespace shapeton

#endif
