#ifndef itkFoldTruth_h
#define itkFoldTruth_h

#include "itkRegistrationResults.h"

namespace itk
{
/** Which folds are the same, as points with known correspondence tell. All on the unrolled walls, so that the height of
 * folds is of no account: a supine fold moves as the points within 10 mm of its middle do; its partner is the prone
 * fold with the nearest crest, if that is less than 8 mm away (folds slide some mm against the wall, and lie 15 mm
 * apart or more). */
class FoldTruth
{
public:
  FoldTruth(const ColonPositionFiles &      supine,
            const ColonPositionFiles &      prone,
            const SupineProneRegistration & registration,
            const std::vector<PointPair> &  points);

  /** Of a pair of indices. */
  FoldVerdict
  OfPair(int supine, int prone) const;
  /** Of a supine fold that has no partner. */
  FoldVerdict
  OfAlone(int supine) const;

private:
  enum : int
  {
    Unknown = -2,
    NotFound = -1
  };
  std::vector<int> m_Partner; ///< of each supine fold
};
} // namespace itk

#endif
