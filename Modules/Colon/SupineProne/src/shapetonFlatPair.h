#ifndef shapetonFlatPair_h
#define shapetonFlatPair_h

#include "shapetonColonPair.h"
#include "shapetonCylinderMap.h"
#include "shapetonQuasiConformalMap.h"

namespace shapeton
{
/** The flat walls of a pair, which are conformal, and nodes on the source in rows of even distance along its
 * centreline. Maps between the flat walls have values in mm of the target's; nodes and places are in mm along the
 * centrelines. The pair must outlive it. */
class FlatPair
{
public:
  explicit FlatPair(const ColonPair & pair);

  const BeltramiEquations &
  Equations() const
  {
    return m_Equations;
  }
  /** mm along the centreline of the source. */
  double
  SOfRow(int row) const
  {
    return m_Source.Begin() + row * m_Step;
  }
  double
  TurnOfAngle(int angle) const
  {
    return static_cast<double>(angle) / m_Equations.Angles();
  }
  CylinderValues
  ValuesOf(const CylinderMap & map) const;
  CylinderNodes
  NodesOf(const CylinderValues & values) const;
  BeltramiEquations::Place
  PlaceOf(const CylinderPlace & place) const;
  /** Where a map takes a place of the source. */
  CylinderPlace
  Mapped(const CylinderPlace & place, const CylinderValues & values) const;
  /** The place goes to `s` of the target. Between nodes a map is straight in mm of the centreline, in which `s` is
   * known, while the condition is one of mm of the flat wall: each corner counts for as much as the first grows with
   * the second from `s` to where the values have the corner. */
  MapCondition
  Along(const CylinderPlace & place, double s, const CylinderValues & values) const;
  /** The place goes to `turn` of the target, by the shorter way from where the values have it. */
  MapCondition
  Around(const CylinderPlace & place, double turn, const CylinderValues & values) const;

private:
  const ColonCylinder & m_Source;
  const ColonCylinder & m_Target;
  double                m_Step; ///< mm
  BeltramiEquations     m_Equations;
};
} // namespace shapeton

#endif
