#ifndef shapetonFoldTruth_h
#define shapetonFoldTruth_h

#include "shapetonRegistrationResults.h"

namespace shapeton
{
/** True fold correspondence, from points with known correspondence. Computed on the unrolled walls, so the height of
 * folds does not matter: each place of a supine crest moves with the points within 10 mm. Two folds are the same if the
 * mean distance of the shorter crest from the longer one is at most 8 mm (folds slide some mm on the wall, and are at
 * least 15 mm apart). A fold detected in two pieces is the same as both. */
class FoldTruth
{
public:
  FoldTruth(const ColonPositionFiles &      supine,
            const ColonPositionFiles &      prone,
            const SupineProneRegistration & registration,
            const std::vector<PointPair> &  points);

  /** Verdict on each supine fold for these pairs of indices. A fold without a partner is unmatched if a prone fold is
   * the same and is in no correct pair. */
  std::vector<FoldVerdict>
  Judge(const std::vector<FoldMatch> & matches) const;

private:
  /** For each supine fold: whether points are nearby, and the prone folds that are the same. */
  std::vector<char>             m_IsKnown;
  std::vector<std::vector<int>> m_Same;
};
} // namespace shapeton

#endif
