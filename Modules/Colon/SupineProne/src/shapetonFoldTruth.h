#ifndef shapetonFoldTruth_h
#define shapetonFoldTruth_h

#include "shapetonRegistrationResults.h"

#include <array>

namespace shapeton
{
/** Index of a landmark that is in the list. */
int
IndexOf(const std::vector<FoldLandmark> & landmarks, const FoldLandmark & landmark);

/** True fold correspondence, derived from points with known correspondence. Each position on a supine crest is mapped
 * by the points within 10 mm of it on the unrolled walls, regardless of fold height. Two folds correspond if the mean
 * distance from one crest to the other, in the direction where it is smaller, is below 8 mm (folds slide by a few mm on
 * the wall and are at least 15 mm apart). A fold that was detected in two pieces corresponds to both pieces. Ends
 * correspond if their folds do and no other end of the prone fold is nearer. */
class FoldTruth
{
public:
  FoldTruth(const ColonPositionFiles &      supine,
            const ColonPositionFiles &      prone,
            const SupineProneRegistration & registration,
            const std::vector<PointPair> &  points);

  /** Verdict on each supine landmark for these matches. A landmark without a partner is unmatched if a corresponding
   * prone landmark exists that is not in a correct pair. */
  std::vector<FoldVerdict>
  Judge(const std::vector<FoldMatch> & matches) const;

private:
  using Crest = std::array<CylinderPlace, 3>;

  /** Whether prone fold `fold` has the crest `moved`. */
  bool
  IsSameFold(const Crest & moved, const HaustralFold & fold) const;

  /** Whether `end` of a fold is the one nearer to the end `supineEnd` of the crest `moved`. */
  bool
  IsSameEnd(const Crest & moved, int supineEnd, const HaustralFold & fold, int end) const;

  const SupineProneRegistration & m_Registration;
  /** For each supine landmark: whether points are nearby, and the corresponding prone landmarks. */
  std::vector<char>             m_IsKnown;
  std::vector<std::vector<int>> m_Same;
};
} // namespace shapeton

#endif
