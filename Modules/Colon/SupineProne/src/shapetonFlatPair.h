#ifndef shapetonFlatPair_h
#define shapetonFlatPair_h

#include "shapetonColonPair.h"
#include "shapetonCylinderMap.h"
#include "shapetonQuasiConformalMap.h"

namespace shapeton
{
/** The conformal flat walls of a pair, with source nodes in rows equidistant along the centerline. Values of maps are
 * in mm of the flat target wall; nodes and positions are in mm along the centerlines. The pair must outlive this
 * object. */
class FlatPair
{
public:
  explicit FlatPair(const ColonPair & pair);

  const BeltramiEquations &
  Equations() const
  {
    return m_Equations;
  }
  /** mm along the centerline of the source. */
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
  /** Image of a source position under a map. */
  CylinderPlace
  Mapped(const CylinderPlace & place, const CylinderValues & values) const;
  /** Constraint that a position is mapped to `s` of the target. Between nodes, a map is linear in mm along the
   * centerline, but the constraint is in mm of the flat wall; the corner weights account for the local ratio. */
  MapCondition
  Along(const CylinderPlace & place, double s, const CylinderValues & values) const;
  /** Constraint that a position is mapped to `turn` of the target, which is unwrapped to the value closest to the
   * current one. */
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
