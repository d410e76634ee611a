#ifndef shapetonRowCosts_h
#define shapetonRowCosts_h

#include "shapetonCylindricalWarping.h"

namespace shapeton
{
/** Costs of assigning rows of the source to rows of the target, for states of offset and rotation. The pictures must
 * outlive it. */
class RowCosts
{
public:
  /** Offsets are 0 to 2 reach: at offset `reach` a row is in the frame. */
  RowCosts(const CylinderPicture &           source,
           const CylinderPicture &           target,
           int                               reach,
           const CylindricalWarpingOptions & options);

  /** Costs of all offsets with `rotations` steps of rotation each, from `firstRotation`. */
  std::vector<float>
  OfRow(int row, int firstRotation, int rotations) const;
  /** Cost of the spring to the frame. */
  double
  SpringOf(int offset) const;

private:
  int
  SegmentOf(const CylinderPicture & picture, int row) const;

  const CylinderPicture &   m_Source;
  const CylinderPicture &   m_Target;
  CylindricalWarpingOptions m_Options;
  int                       m_Reach;
  bool                      m_HasTaeniae;
};
} // namespace shapeton

#endif
