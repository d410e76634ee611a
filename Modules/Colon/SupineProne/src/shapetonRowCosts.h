#ifndef shapetonRowCosts_h
#define shapetonRowCosts_h

#include "shapetonCylindricalWarping.h"

namespace shapeton
{
/** Costs of assigning source rows to target rows, for all states (offset, rotation). The pictures must outlive this
 * object. */
class RowCosts
{
public:
  /** Offsets are 0 to 2 * reach; `reach` is the offset of the frame. */
  RowCosts(const CylinderPicture &           source,
           const CylinderPicture &           target,
           int                               reach,
           const CylindricalWarpingOptions & options);

  /** Costs of all offsets for `rotations` rotation steps from `firstRotation`. */
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
