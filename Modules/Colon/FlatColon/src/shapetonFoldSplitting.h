#ifndef shapetonFoldSplitting_h
#define shapetonFoldSplitting_h

#include "shapetonFoldLabels.h"

namespace shapeton
{
/** Rule for splitting merged folds. */
struct FoldSplittingRule
{
  /** Two ridges are two folds if the saddle between them has less than this share of the curvature of the lower
   * ridge. */
  double saddle{ 0.5 };
  /** The same for a saddle on a taenia, where most folds end but some continue. */
  double saddleOnTaenia{ 0.6 };
  /** Minimum area of a ridge, mm^2. */
  double leastArea{ 6.0 };
  /** 1 for pixels of taeniae; may be empty. */
  std::vector<char> isTaenia;
};

/** Watershed of curvature: floods a fold from its ridges downward and merges ridges that the rule does not separate.
 * The parts are ordered by their first pixels. */
std::vector<FoldPixels>
SplitFold(const FoldPicture & picture, const FoldPixels & pixels, const FoldSplittingRule & rule);

/** 1 for the pixels within `distance` mm of the taeniae on the map, from the nearest surface points of samples along
 * them. Throws InputError when most of the points are more than 15 mm from the surface. */
std::vector<char>
MaskOfTaeniae(const FlatColonGrid & grid, const CurveSet & taeniae, double distance);
} // namespace shapeton

#endif
