#include "shapetonCirclePacking.h"

#include "shapetonNearbyOrder.h"
#include "shapetonPi.h"
#include "shapetonRicciEnergy.h"
#include "shapetonSparseCholesky.h"
#include "shapetonExceptions.h"
#include "shapetonOpenEndedProgress.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace shapeton
{
namespace
{
Eigen::Map<Eigen::VectorXd>
AsVector(std::vector<double> & values)
{
  return { values.data(), static_cast<Eigen::Index>(values.size()) };
}

constexpr double restOfPi = 1.2246467991473532e-16; // see RicciEnergy
/** Target residual curvature, and the largest one attributed to rounding (radians). */
constexpr double wantedResidual = 1e-12;
constexpr double worstResidual = 1e-10;
constexpr int    mostSteps = 200;
constexpr double usualSteps = 10.0;
/** Maximum number of steps without a better residual, far from the solution and at the rounding limit. */
constexpr int mostStepsInVain = 60;
constexpr int mostStepsAtTheLimit = 2;
/** Uncertainty of log r that triggers extended precision, and the maximum number of steps in it. */
constexpr double mostUncertainty = 1e-13;
constexpr int    mostRefinements = 6;
/** Largest change of log r in one step. */
constexpr double longestStep = 8.0;
/** A step covers at most this fraction of the distance to the border of the domain. */
constexpr double insideDomain = 0.95;
/** Largest ratio of successive residuals that counts as progress, and the residual below which rounding limits
 * progress. */
constexpr double clearlyBetter = 0.9;
constexpr double nearSolution = 1e-8;

double
Dot(const std::vector<double> & a, const std::vector<double> & b)
{
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

double
LargestOf(const std::vector<double> & list)
{
  double largest = 0.0;
  for (const double x : list)
  {
    largest = std::max(largest, std::abs(x));
  }
  return largest;
}

std::string
ShortNumber(double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.1e", value);
  return text;
}

/** Newton's method for one energy. \equation{6.5} in its limit, with target curvature 0. */
class NewtonFlow
{
public:
  NewtonFlow(const RicciUnknowns & unknowns, const Progress & progress)
    : m_Unknowns(unknowns)
    , m_Steps(progress, usualSteps)
    , m_Energy(unknowns)
    , m_IsHyperbolic(unknowns.geometry == FlowGeometry::Hyperbolic)
    , m_Solver(SymbolicFactorization(unknowns.number, m_Energy.TakePattern(), EliminationOrder::NestedDissection))
    , m_Point(unknowns.StartingPoint())
  {}

  CirclePacking
  Run(PackingPrecision precision);

private:
  bool
  IsDone();
  void
  FindDirection();
  void
  SolveForDirection(std::vector<double> gradient);
  double
  LongestStep() const;
  void
  Step();
  double
  Polish();
  CirclePacking
  Refined();
  void
  MoveTo(const std::vector<double> & from, double length);

  const RicciUnknowns & m_Unknowns;
  OpenEndedProgress     m_Steps;
  RicciEnergy           m_Energy;
  bool                  m_IsHyperbolic;
  SparseCholesky        m_Solver;
  std::vector<double>   m_Point;
  std::vector<double>   m_Direction;
  std::vector<double>   m_Diagonal;
  std::vector<double>   m_OffDiagonal;
  double                m_Best{ 1e300 };
  int                   m_StepsInVain{ 0 };
};

void
NewtonFlow::FindDirection()
{
  m_Energy.Hessian(m_Diagonal, m_OffDiagonal);
  if (!m_Solver.Factorize(AsVector(m_Diagonal), AsVector(m_OffDiagonal), m_Steps.NextStep()))
  {
    throw InputError("the Hessian of the Ricci energy is not positive definite to working accuracy at a curvature of " +
                     ShortNumber(m_Energy.Residual()) +
                     " rad: the circle sizes differ too much; check that the map is 3-connected or use "
                     "the parameter \"augmentation\" = ring");
  }
  this->SolveForDirection(m_Energy.Gradient());
}

void
NewtonFlow::SolveForDirection(std::vector<double> gradient)
{
  m_Direction = std::move(gradient);
  for (double & d : m_Direction)
  {
    d = -d;
  }
  m_Solver.SolveInPlace(AsVector(m_Direction));
}

/** The part of the Newton step that is inside the domain and at most longestStep long. */
double
NewtonFlow::LongestStep() const
{
  double length = 1.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < m_Point.size(); ++i)
  {
    largest = std::max(largest, std::abs(m_Direction[i]));
    if (m_IsHyperbolic && m_Direction[i] > 0.0)
    {
      length = std::min(length, -insideDomain * m_Point[i] / m_Direction[i]);
    }
  }
  return largest * length > longestStep ? longestStep / largest : length;
}

void
NewtonFlow::MoveTo(const std::vector<double> & from, double length)
{
  for (std::size_t i = 0; i < from.size(); ++i)
  {
    m_Point[i] = from[i] + length * m_Direction[i];
  }
  m_Energy.Evaluate(m_Point);
  m_Steps.Step();
}

void
NewtonFlow::Step()
{
  this->FindDirection();
  const double              fall = -Dot(m_Energy.Gradient(), m_Direction);
  const std::vector<double> from = m_Point;
  double                    length = this->LongestStep();
  for (int halvings = 0; halvings < 40; ++halvings, length *= 0.5)
  {
    this->MoveTo(from, length);
    if (-Dot(m_Energy.Gradient(), m_Direction) >= -0.5 * std::abs(fall) && std::isfinite(m_Energy.Residual()))
    {
      return;
    }
  }
}

bool
NewtonFlow::IsDone()
{
  const double residual = m_Energy.Residual();
  m_StepsInVain = residual < clearlyBetter * m_Best ? 0 : m_StepsInVain + 1;
  m_Best = std::min(m_Best, residual);
  return residual <= wantedResidual ||
         m_StepsInVain >= (residual < nearSolution ? mostStepsAtTheLimit : mostStepsInVain);
}

/** Performs one more step with the last factor, which is accurate to about the square of the residual and needs no
 * factorization. Returns its length: the effect of curvature rounding on the unknowns. */
double
NewtonFlow::Polish()
{
  const double              before = m_Energy.Residual();
  const std::vector<double> from = m_Point;
  this->SolveForDirection(m_Energy.Gradient());
  this->MoveTo(from, 1.0);
  if (!(m_Energy.Residual() < before))
  {
    this->MoveTo(from, 0.0);
  }
  return LargestOf(m_Direction);
}

/** Last steps in extended precision, for Hessians with eigenvalues so small that curvature rounding would be visible in
 * the layout. */
CirclePacking
NewtonFlow::Refined()
{
  CircleState<long double> state(m_Unknowns);
  std::vector<long double> point(m_Point.begin(), m_Point.end());
  state.Evaluate(point);
  double length = 1e300;
  for (int step = 0; step < mostRefinements; ++step)
  {
    this->SolveForDirection({ state.Gradient().begin(), state.Gradient().end() });
    const double next = LargestOf(m_Direction);
    if (!(next < 0.5 * length))
    {
      break;
    }
    length = next;
    for (std::size_t i = 0; i < point.size(); ++i)
    {
      point[i] += m_Direction[i];
    }
    state.Evaluate(point);
    m_Steps.Step();
  }
  return state.Packing();
}

CirclePacking
NewtonFlow::Run(PackingPrecision precision)
{
  m_Steps.Step(); // analysis
  m_Energy.Evaluate(m_Point);
  int steps = 0;
  while (steps < mostSteps && !this->IsDone())
  {
    this->Step();
    ++steps;
  }
  bool needsRefinement = false;
  if (steps > 0)
  {
    this->Polish();
    needsRefinement = this->Polish() > mostUncertainty || precision == PackingPrecision::Extended;
  }
  CirclePacking packing = needsRefinement ? this->Refined() : m_Energy.Packing();
  packing.steps = steps;
  return packing;
}
} // namespace

std::vector<double>
CurvaturesOf(const CombinatorialMap & map, const CirclePacking & packing)
{
  std::vector<double> angles(map.Nodes() + map.Faces(), 0.0);
  for (int h = 0; h < map.HalfEdges(); ++h)
  {
    const double node = packing.nodeRadii[map.Node(h)];
    const double face = packing.faceRadii[map.Face(h)];
    angles[map.Node(h)] += HalfKiteAngle(packing.geometry, node, face, IsHorocycle(packing, map.Face(h)));
    angles[map.Nodes() + map.Face(h)] += HalfKiteAngle(packing.geometry, face, node);
  }
  for (std::size_t i = 0; i < angles.size(); ++i)
  {
    const double radius =
      i < packing.nodeRadii.size() ? packing.nodeRadii[i] : packing.faceRadii[i - packing.nodeRadii.size()];
    angles[i] = std::isinf(radius) ? 0.0 : 2.0 * ((Pi - angles[i]) + restOfPi);
  }
  return angles;
}

namespace
{
CirclePacking
PackInGivenOrder(const CombinatorialMap &  map,
                 FlowGeometry              geometry,
                 const CirclesAtInfinity & infinite,
                 PackingPrecision          precision,
                 const Progress &          progress)
{
  const RicciUnknowns unknowns(map, geometry, infinite);
  CirclePacking       packing = NewtonFlow(unknowns, progress).Run(precision);
  for (const double curvature : CurvaturesOf(map, packing))
  {
    packing.residual = std::abs(curvature) <= packing.residual ? packing.residual : std::abs(curvature);
  }
  if (!(packing.residual <= worstResidual))
  {
    throw InputError("the Ricci flow does not converge: after " + std::to_string(packing.steps) +
                     " Newton steps the curvature is " + ShortNumber(packing.residual) +
                     " rad; check that the map is 3-connected or use the parameter \"augmentation\" = ring");
  }
  return packing;
}

CirclePacking
PackInNearbyOrder(const CombinatorialMap &  map,
                  FlowGeometry              geometry,
                  const CirclesAtInfinity & infinite,
                  PackingPrecision          precision,
                  const Progress &          progress)
{
  const NearbyOrder       order(map);
  const CirclesAtInfinity there{ order.NodesThere(infinite.lineNodes),
                                 order.FacesThere(infinite.lineFaces),
                                 order.FacesThere(infinite.horocycleFaces) };
  CirclePacking           packing = PackInGivenOrder(order.Map(), geometry, there, precision, progress);
  packing.nodeRadii = order.NodesBack(packing.nodeRadii);
  packing.faceRadii = order.FacesBack(packing.faceRadii);
  packing.horocycleFaces = order.FacesBack(packing.horocycleFaces);
  if (!packing.nodeRests.empty())
  {
    packing.nodeRests = order.NodesBack(packing.nodeRests);
    packing.faceRests = order.FacesBack(packing.faceRests);
  }
  return packing;
}
} // namespace

CirclePacking
PackCircles(const CombinatorialMap &  map,
            FlowGeometry              geometry,
            const CirclesAtInfinity & infinite,
            PackingPrecision          precision,
            const Progress &          progress)
{
  return NearbyOrder::Pays(map) ? PackInNearbyOrder(map, geometry, infinite, precision, progress)
                                : PackInGivenOrder(map, geometry, infinite, precision, progress);
}
} // namespace shapeton
