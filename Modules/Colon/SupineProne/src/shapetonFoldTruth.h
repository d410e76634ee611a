#ifndef shapetonFoldTruth_h
#define shapetonFoldTruth_h

#include "shapetonRegistrationResults.h"

namespace shapeton
{
/** True fold correspondence, derived from points with known correspondence. Each position on a supine crest is mapped
 * by the points within 10 mm of it on the unrolled walls, regardless of fold height. Two folds correspond if the mean
 * distance from one crest to the other, in the direction where it is smaller, is below 8 mm (folds slide by a few mm on
 * the wall and are at least 15 mm apart). A fold that was detected in two pieces corresponds to both pieces. */
class FoldTruth
{
public:
  FoldTruth(const ColonPositionFiles &      supine,
            const ColonPositionFiles &      prone,
            const SupineProneRegistration & registration,
            const std::vector<PointPair> &  points);

  /** Verdict on each supine fold for these matches. A fold without a partner is unmatched if a corresponding prone fold
   * exists that is not in a correct pair. */
  std::vector<FoldVerdict>
  Judge(const std::vector<FoldMatch> & matches) const;

private:
  /** For each supine fold: whether points are nearby, and the corresponding prone folds. */
  std::vector<char>             m_IsKnown;
  std::vector<std::vector<int>> m_Same;
};
} // namespace shapeton

#endif
