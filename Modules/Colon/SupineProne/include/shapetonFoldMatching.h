#ifndef shapetonFoldMatching_h
#define shapetonFoldMatching_h

#include "SupineProneExport.h"

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace shapeton
{
/** A fold as matching sees it: places in mm on a plane cut open from the cylinder, after the start map has carried them
 * to the target; y is periodic. \ingroup SupineProne */
struct FoldFeature
{
  double x{ 0.0 };
  double y{ 0.0 };
  /** mm. */
  double length{ 1.0 };
  /** mm^2. */
  double area{ 1.0 };
  /** Folds of different groups, such as segments of the colon, are never matched. */
  int group{ 0 };
};

/** How pairs of folds are chosen. \ingroup SupineProne */
enum class FoldMatchingMethod
{
  /** Each fold by itself: exact, by the Hungarian method with dustbins. */
  Hungarian,
  /** Neighbouring folds are to move alike: graph matching by dual decomposition. */
  DualDecomposition
};

/** Reach, tolerances and costs for MatchFolds(). \ingroup SupineProne */
struct FoldMatchingOptions
{
  FoldMatchingMethod method{ FoldMatchingMethod::Hungarian };
  /** Folds farther apart than this are no candidates: along and around, mm. */
  double reachAlong{ 25.0 };
  double reachAround{ 16.0 };
  /** Standard deviations, mm, of the places, and of the logarithms of length and area. */
  double deviationAlong{ 8.0 };
  double deviationAround{ 6.0 };
  double deviationLength{ 0.5 };
  double deviationArea{ 0.7 };
  /** Cost of a fold that stays alone. */
  double alone{ 4.0 };
  /** \name DualDecomposition */
  ///@{
  /** Neighbours of each fold, and weight and standard deviation (mm) of the difference of their displacements; a pair
   * costs at most `truncation`. */
  int    neighbours{ 6 };
  double pairWeight{ 1.0 };
  double pairDeviation{ 6.0 };
  double truncation{ 3.0 };
  int    iterations{ 250 };
  ///@}
};

/** Pairs of folds of two positions, and how far from the best matching they can be. See MatchFolds().
 * \ingroup SupineProne */
struct FoldMatching
{
  /** Numbers of folds, of the source in ascending order and of the target. */
  std::vector<std::pair<int, int>> pairs;
  /** Of each pair, without that of its neighbours. */
  std::vector<double> costs;
  /** Energy of the matching, and the greatest lower bound found for any matching; equal for Hungarian. */
  double primal{ 0.0 };
  double bound{ 0.0 };
  int    iterations{ 0 };

  /** Difference, over the energy that the matching saves against none at all: 0 proves that no matching is better. */
  double
  Gap() const
  {
    return savable > 0.0 ? (primal - bound) / savable : 0.0;
  }
  double savable{ 0.0 };
};

/** One-to-one matching of folds with dustbins (dissertation 4.3.1). A pair costs the squared differences of places,
 * length and area over their variances, a fold that stays alone `alone`; DualDecomposition adds for neighbouring folds
 * the squared difference of their displacements, truncated.
 *
 * The printed objective of 4.3.1 has no term for pairs, so that the Hungarian method solves it exactly; its term for
 * features that stay alone, |q|^2, is a distance to the origin and is taken as a constant here. Dual decomposition
 * (Torresani, Kolmogorov, Rother 2008): one subproblem of assignment, one for each pair of neighbours, multipliers by
 * subgradients.
 * \param turn circumference of the plane, mm. \ingroup SupineProne */
SupineProne_EXPORT FoldMatching
MatchFolds(const std::vector<FoldFeature> & source,
           const std::vector<FoldFeature> & target,
           double                           turn,
           const FoldMatchingOptions &      options = {});
} // namespace shapeton

#endif
