#include "itkCirclePacking.h"

#include "itkRicciEnergy.h"
#include "itkSparseCholesky.h"
#include "itkToolError.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace itk
{
namespace
{
constexpr double pi = 3.14159265358979323846;
constexpr double restOfPi = 1.2246467991473532e-16; // see RicciEnergy
/** The curvature that is asked for, and the largest that rounding may leave. Radians. */
constexpr double wantedResidual = 1e-12;
constexpr double worstResidual = 1e-10;
constexpr int    mostSteps = 200;
/** Steps without a better residual, far from the solution and at the limit of rounding. */
constexpr int mostStepsInVain = 25;
constexpr int mostStepsAtTheLimit = 2;
/** The largest change of a logarithm in one step. */
constexpr double longestStep = 8.0;

double
Dot(const std::vector<double> & a, const std::vector<double> & b)
{
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

std::string
ShortNumber(double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.1e", value);
  return text;
}

/** Newton's method for one energy. */
class NewtonFlow
{
public:
  NewtonFlow(RicciEnergy & energy, bool isHyperbolic)
    : m_Energy(energy)
    , m_IsHyperbolic(isHyperbolic)
    , m_Solver(energy.Unknowns(), energy.Pattern())
    , m_Point(energy.StartingPoint())
  {}

  int
  Run();

private:
  bool
  IsDone();
  void
  FindDirection();
  double
  LongestStep() const;
  void
  Step();
  void
  Polish();
  void
  MoveTo(const std::vector<double> & from, double length);

  RicciEnergy &       m_Energy;
  bool                m_IsHyperbolic;
  SparseCholesky      m_Solver;
  std::vector<double> m_Point;
  std::vector<double> m_Direction;
  std::vector<double> m_Diagonal;
  std::vector<double> m_OffDiagonal;
  double              m_Best{ 1e300 };
  int                 m_StepsInVain{ 0 };
};

void
NewtonFlow::FindDirection()
{
  m_Energy.Hessian(m_Diagonal, m_OffDiagonal);
  if (!m_Solver.Factorise(m_Diagonal, m_OffDiagonal))
  {
    throw InputError("the Hessian of the Ricci energy is not positive to working accuracy, with a curvature of " +
                     ShortNumber(m_Energy.Residual()) +
                     " left: the circles become too different in size; check that the map is 3-connected or use "
                     "--augmentation ring");
  }
  m_Direction = m_Energy.Gradient();
  for (double & d : m_Direction)
  {
    d = -d;
  }
  m_Solver.Solve(m_Direction);
}

/** The part of the Newton step that stays in the domain and is not longer than longestStep. */
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
      length = std::min(length, -0.95 * m_Point[i] / m_Direction[i]);
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
  m_StepsInVain = residual < 0.9 * m_Best ? 0 : m_StepsInVain + 1;
  m_Best = std::min(m_Best, residual);
  return residual <= wantedResidual || m_StepsInVain >= (residual < 1e-8 ? mostStepsAtTheLimit : mostStepsInVain);
}

/** One more step by the last factor, which is good to about the square of the residual and costs no factorisation. */
void
NewtonFlow::Polish()
{
  const double              before = m_Energy.Residual();
  const std::vector<double> from = m_Point;
  m_Direction = m_Energy.Gradient();
  for (double & d : m_Direction)
  {
    d = -d;
  }
  m_Solver.Solve(m_Direction);
  this->MoveTo(from, 1.0);
  if (!(m_Energy.Residual() < before))
  {
    this->MoveTo(from, 0.0);
  }
}

int
NewtonFlow::Run()
{
  m_Energy.Evaluate(m_Point);
  int steps = 0;
  while (steps < mostSteps && !this->IsDone())
  {
    this->Step();
    ++steps;
  }
  if (steps > 0)
  {
    this->Polish();
  }
  return steps;
}
} // namespace

double
HalfKiteAngle(FlowGeometry geometry, double radius, double otherRadius, bool isHorocycle)
{
  if (isHorocycle)
  {
    return std::atan2(1.0, std::sinh(radius));
  }
  if (std::isinf(otherRadius))
  {
    return 0.5 * pi;
  }
  return geometry == FlowGeometry::Euclidean ? std::atan2(otherRadius, radius)
                                             : std::atan2(std::tanh(otherRadius), std::sinh(radius));
}

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
    angles[i] = std::isinf(radius) ? 0.0 : 2.0 * ((pi - angles[i]) + restOfPi);
  }
  return angles;
}

CirclePacking
PackCircles(const CombinatorialMap & map, FlowGeometry geometry, const CirclesAtInfinity & infinite)
{
  RicciEnergy   energy(map, geometry, infinite);
  const int     steps = NewtonFlow(energy, geometry == FlowGeometry::Hyperbolic).Run();
  CirclePacking packing = energy.Packing();
  packing.steps = steps;
  for (const double curvature : CurvaturesOf(map, packing))
  {
    packing.residual = std::abs(curvature) <= packing.residual ? packing.residual : std::abs(curvature);
  }
  if (!(packing.residual <= worstResidual))
  {
    throw InputError("the Ricci flow does not reach its target: after " + std::to_string(steps) +
                     " steps of Newton's method a curvature of " + ShortNumber(packing.residual) +
                     " rad is left; check that the map is 3-connected or use --augmentation ring");
  }
  return packing;
}
} // namespace itk
