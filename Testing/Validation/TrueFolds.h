#ifndef TrueFolds_h
#define TrueFolds_h

#include "shapetonColonAnatomy.h"

#include <vector>

/** The folds of a phantom, to tell which one a fold that was found is. */
class TrueFolds
{
public:
  explicit TrueFolds(const shapeton::ColonAnatomy & anatomy);

  /** Index of the fold whose crest, where it stands at least 1 mm above the wall, lies nearest, within 6 mm; -1 where
   * there is none. */
  int
  NearestTo(const Eigen::Vector3d & point) const;
  /** The same in all positions of one patient. */
  int
  NumberOf(int index) const;
  /** Of the colon, 1 to 6, of the fold with this number. */
  int
  SegmentOf(int number) const;

private:
  shapeton::CurveSet m_Folds;
  Eigen::VectorXd    m_Height;
};

#endif
