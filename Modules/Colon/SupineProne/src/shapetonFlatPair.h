#ifndef shapetonFlatPair_h
#define shapetonFlatPair_h

#include "shapetonColonPair.h"
#include "shapetonCylinderMap.h"
#include "shapetonQuasiConformalMap.h"

namespace shapeton
{
/** The conformal flat walls of a pair, and nodes on the source in equidistant rows along its centerline. Maps between
 * the flat walls have values in mm of the target wall; nodes and places are in mm along the centerlines. The pair must
 * outlive it. */
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
  /** Image of a place of the source under a map. */
  CylinderPlace
  Mapped(const CylinderPlace & place, const CylinderValues & values) const;
  /** Condition that the place maps to `s` of the target. Between nodes a map is linear in mm of the centerline, in
   * which `s` is known, while the condition is in mm of the flat wall. So each corner is weighted by the ratio of the
   * two between `s` and its current value. */
  MapCondition
  Along(const CylinderPlace & place, double s, const CylinderValues & values) const;
  /** Condition that the place maps to `turn` of the target, by the shorter way from its current value. */
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
