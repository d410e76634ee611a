#ifndef TrueFolds_h
#define TrueFolds_h

#include "shapetonColonAnatomy.h"

#include <vector>

/** True folds of a phantom, to identify detected ones. */
class TrueFolds
{
public:
  explicit TrueFolds(const shapeton::ColonAnatomy & anatomy);

  /** Index of the fold with the nearest crest (at least 1 mm above the wall) within 6 mm; -1 if there is
   * none. */
  int
  NearestTo(const Eigen::Vector3d & point) const;
  /** Number of the fold, identical in all positions of one patient. */
  int
  NumberOf(int index) const;
  /** Colon segment, 1 to 6, of the fold with this number. */
  int
  SegmentOf(int number) const;

private:
  shapeton::CurveSet m_Folds;
  Eigen::VectorXd    m_Height;
};

#endif
