#ifndef shapetonFoldTruth_h
#define shapetonFoldTruth_h

#include "shapetonRegistrationResults.h"

namespace shapeton
{
/** Which folds are the same, as points with known correspondence tell. All on the unrolled walls, so that the height of
 * folds is of no account: each place of a supine crest moves as the points within 10 mm do. Two folds are the same
 * where the shorter crest lies within 8 mm of the longer one in the mean (folds slide some mm against the wall, and lie
 * 15 mm apart or more); one that was found in two pieces is the same as both. */
class FoldTruth
{
public:
  FoldTruth(const ColonPositionFiles &      supine,
            const ColonPositionFiles &      prone,
            const SupineProneRegistration & registration,
            const std::vector<PointPair> &  points);

  /** Of each supine fold, with these pairs of indices. A fold without a partner is unmatched where a prone one is the
   * same that is in no correct pair. */
  std::vector<FoldVerdict>
  Judge(const std::vector<FoldMatch> & matches) const;

private:
  /** Of supine folds: whether points are near, and the prone folds that are the same. */
  std::vector<char>             m_IsKnown;
  std::vector<std::vector<int>> m_Same;
};
} // namespace shapeton

#endif
