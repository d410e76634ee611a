#include "shapetonFlatPair.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
constexpr int    pairAngles = 48; // nodes around; chosen, the source gives no number
constexpr double pairStep = 3.0;  // mm; chosen, the source gives no number

/** Converts mm along the centerline to mm along the flat wall. */
double
FlatOfArc(const ColonCylinder & cylinder, double s)
{
  return cylinder.ColumnOfArc(s) * cylinder.Grid().PixelSize();
}

double
ArcOfFlat(const ColonCylinder & cylinder, double u)
{
  return cylinder.ArcOfColumn(u / cylinder.Grid().PixelSize());
}

/** mm along the centerline per mm of the flat wall, between two positions. */
double
SlopeOf(const ColonCylinder & cylinder, double from, double to)
{
  constexpr double least = 1e-3; // mm
  const double     end = std::abs(to - from) > least ? to : from + least;
  return (ArcOfFlat(cylinder, end) - ArcOfFlat(cylinder, from)) / (end - from);
}

int
RowsOf(const ColonCylinder & source)
{
  return std::max(2, static_cast<int>(std::ceil((source.End() - source.Begin()) / pairStep)) + 1);
}

std::vector<double>
HeightsOf(const ColonCylinder & source, double step)
{
  std::vector<double> heights;
  for (int row = 0; row + 1 < RowsOf(source); ++row)
  {
    const double s = source.Begin() + row * step;
    heights.push_back(FlatOfArc(source, s + step) - FlatOfArc(source, s));
  }
  return heights;
}
} // namespace

FlatPair::FlatPair(const ColonPair & pair)
  : m_Source(*pair.sourceCylinder)
  , m_Target(*pair.targetCylinder)
  , m_Step((m_Source.End() - m_Source.Begin()) / (RowsOf(m_Source) - 1))
  , m_Equations(HeightsOf(m_Source, m_Step),
                pairAngles,
                m_Source.Grid().Circumference(),
                m_Target.Grid().Circumference())
{}

CylinderValues
FlatPair::ValuesOf(const CylinderMap & map) const
{
  const int      nodes = m_Equations.Nodes();
  CylinderValues values{ Eigen::VectorXd(nodes), Eigen::VectorXd(nodes) };
  for (int node = 0; node < nodes; ++node)
  {
    const CylinderPlace place = map.Forward({ this->SOfRow(node / pairAngles), this->TurnOfAngle(node % pairAngles) });
    values.along[node] = FlatOfArc(m_Target, place.s);
    values.around[node] = place.turn * m_Equations.TargetAround();
  }
  return values;
}

CylinderNodes
FlatPair::NodesOf(const CylinderValues & values) const
{
  const int     rows = m_Equations.Rows();
  CylinderNodes nodes{ m_Source.Begin(), m_Step, Eigen::MatrixXd(rows, pairAngles), Eigen::MatrixXd(rows, pairAngles) };
  for (int node = 0; node < m_Equations.Nodes(); ++node)
  {
    nodes.s(node / pairAngles, node % pairAngles) = ArcOfFlat(m_Target, values.along[node]);
    nodes.turn(node / pairAngles, node % pairAngles) = values.around[node] / m_Equations.TargetAround();
  }
  return nodes;
}

BeltramiEquations::Place
FlatPair::PlaceOf(const CylinderPlace & place) const
{
  return m_Equations.PlaceOf(std::clamp((place.s - m_Source.Begin()) / m_Step, 0.0, m_Equations.Rows() - 1.0),
                             (place.turn - std::floor(place.turn)) * pairAngles);
}

CylinderPlace
FlatPair::Mapped(const CylinderPlace & place, const CylinderValues & values) const
{
  const BeltramiEquations::Place    within = this->PlaceOf(place);
  const BeltramiEquations::Triangle triangle = m_Equations.TriangleOf(within.triangle);
  CylinderPlace                     mapped{ 0.0, std::floor(place.turn) };
  for (int k = 0; k < 3; ++k)
  {
    mapped.s += within.share[k] * ArcOfFlat(m_Target, values.along[triangle.node[k]]);
    mapped.turn += within.share[k] * (values.around[triangle.node[k]] / m_Equations.TargetAround() + triangle.turns[k]);
  }
  return mapped;
}

MapCondition
FlatPair::Along(const CylinderPlace & place, double s, const CylinderValues & values) const
{
  const BeltramiEquations::Place    within = this->PlaceOf(place);
  const BeltramiEquations::Triangle triangle = m_Equations.TriangleOf(within.triangle);
  MapCondition                      condition{ triangle.node, within.share, FlatOfArc(m_Target, s) };
  double                            sum = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    condition.share[k] *= SlopeOf(m_Target, condition.value, values.along[triangle.node[k]]);
    sum += condition.share[k];
  }
  for (double & share : condition.share)
  {
    share /= sum;
  }
  return condition;
}

MapCondition
FlatPair::Around(const CylinderPlace & place, double turn, const CylinderValues & values) const
{
  const BeltramiEquations::Place    within = this->PlaceOf(place);
  const BeltramiEquations::Triangle triangle = m_Equations.TriangleOf(within.triangle);
  MapCondition                      condition{ triangle.node, within.share, 0.0 };
  double                            turns = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    condition.value += within.share[k] * values.around[triangle.node[k]];
    turns += within.share[k] * triangle.turns[k];
  }
  const double now = condition.value / m_Equations.TargetAround() + turns;
  condition.value += TurnDifference(turn, now) * m_Equations.TargetAround();
  return condition;
}
} // namespace shapeton
