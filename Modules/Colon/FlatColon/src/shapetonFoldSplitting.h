#ifndef shapetonFoldSplitting_h
#define shapetonFoldSplitting_h

#include "shapetonFoldLabels.h"

namespace shapeton
{
/** Rule for splitting merged folds. */
struct FoldSplittingRule
{
  /** Curvature of a saddle, relative to the lower ridge, below which two ridges are separate folds. */
  double saddle{ 0.5 };
  /** The same limit for a saddle on a taenia, where most folds end. */
  double saddleOnTaenia{ 0.6 };
  /** Minimum area of a ridge, mm^2. */
  double leastArea{ 6.0 };
  /** Mask of taeniae; may be empty. */
  std::vector<char> isTaenia;
};

/** Watershed of curvature: floods a fold from its ridges downward and merges ridges that the rule does not separate.
 * Parts are ordered by their first pixels. */
std::vector<FoldPixels>
SplitFold(const FoldPicture & picture, const FoldPixels & pixels, const FoldSplittingRule & rule);

/** Mask of the map pixels within `distance` mm of the taeniae, which are sampled and projected to the surface. Throws
 * InputError if most points are more than 15 mm from the surface. */
std::vector<char>
MaskOfTaeniae(const FlatColonGrid & grid, const CurveSet & taeniae, double distance);
} // namespace shapeton

#endif
