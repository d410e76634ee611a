#ifndef shapetonFoldSplitting_h
#define shapetonFoldSplitting_h

#include "shapetonFoldLabels.h"

namespace shapeton
{
/** What splits folds that have grown together. */
struct FoldSplittingRule
{
  /** Two ridges are two folds where the saddle between them has less than this share of the curvature of the lower one
   * of them. */
  double saddle{ 0.5 };
  /** The same for a saddle on a taenia, where most folds end; some go on across. */
  double saddleOnTaenia{ 0.6 };
  /** Ridges below this area are none, mm^2. */
  double leastArea{ 6.0 };
  /** 1 for pixels of taeniae; may be empty. */
  std::vector<char> isTaenia;
};

/** Floods a fold from its ridges downwards: the watershed of curvature, in which ridges that the rule does not tell
 * apart become one. The parts in the order of their first pixels. */
std::vector<FoldPixels>
SplitFold(const FoldPicture & picture, const FoldPixels & pixels, const FoldSplittingRule & rule);

/** 1 for the pixels within `distance` mm of the taeniae on the map, by the nearest place on the surface of points along
 * them. Throws InputError where most of the points lie more than 15 mm from the surface. */
std::vector<char>
MaskOfTaeniae(const FlatColonGrid & grid, const CurveSet & taeniae, double distance);
} // namespace shapeton

#endif
