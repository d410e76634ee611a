#include "shapetonConformalMetric.h"

#include "shapetonParallelFor.h"
#include "shapetonTrianglesOfGeometry.h"

#include <atomic>

namespace shapeton
{
namespace
{
/** Edges within this tolerance of the Delaunay condition are not flipped; it exceeds rounding errors, so that flipping
 * ends. */
constexpr double flipTolerance = 1e-12;

/** Cosine of the angle opposite to side e of a triangle with the other sides a and b; also defined if the triangle
 * inequality fails. */
double
OppositeCosine(double e, double a, double b)
{
  return 0.5 * (a / b + b / a - e / a * (e / b));
}

/** Length of the other diagonal of two Euclidean triangles with the common side e: a and b start at its ends and meet
 * on one side, c and d on the other; a and c meet. */
double
OtherDiagonal(double e, double a, double b, double c, double d)
{
  const auto corner = [e](double fromStart, double fromEnd) {
    const double x = 0.5 * (e + (fromStart - fromEnd) * (fromStart + fromEnd) / e);
    return std::array<double, 2>{ x, std::sqrt(std::max(0.0, (fromStart - x) * (fromStart + x))) };
  };
  const auto p = corner(a, b), q = corner(c, d);
  return std::hypot(p[0] - q[0], p[1] + q[1]);
}

/** Edges b c, c a, a d, d b of the quadrilateral with the diagonal a b. */
std::array<int, 4>
RimOf(const IntrinsicTriangulation & triangulation, int side)
{
  const int twin = triangulation.Twin(side);
  return { triangulation.EdgeOf(IntrinsicTriangulation::Next(side)),
           triangulation.EdgeOf(IntrinsicTriangulation::Previous(side)),
           triangulation.EdgeOf(IntrinsicTriangulation::Next(twin)),
           triangulation.EdgeOf(IntrinsicTriangulation::Previous(twin)) };
}

/** cosh x - 1 without cancellation. */
double
CoshMinusOne(double x)
{
  const double s = std::sinh(0.5 * x);
  return 2.0 * s * s;
}
} // namespace

ConformalMetric::ConformalMetric(IntrinsicTriangulation triangulation,
                                 Eigen::VectorXd        invariants,
                                 RicciScheme            scheme,
                                 RicciGeometry          geometry)
  : m_Triangulation(std::move(triangulation))
  , m_Invariants(std::move(invariants))
  , m_Scheme(scheme)
  , m_Geometry(geometry)
  , m_Chords(m_Invariants)
  , m_Lengths(m_Invariants.size())
  , m_LengthDerivatives(m_Invariants.size())
  , m_Tangents(m_Triangulation.NumberOfFaces())
{}

int
ConformalMetric::MakeDelaunay()
{
  m_Chords = m_Invariants;
  return this->FlipToDelaunay(true);
}

double
ConformalMetric::ConvexityOf(int edge) const
{
  double sum = 0.0;
  int    side = m_Triangulation.SideOf(edge);
  for (int i = 0; i < 2; ++i, side = m_Triangulation.Twin(side))
  {
    sum += OppositeCosine(m_Chords[edge],
                          m_Chords[m_Triangulation.EdgeOf(IntrinsicTriangulation::Next(side))],
                          m_Chords[m_Triangulation.EdgeOf(IntrinsicTriangulation::Previous(side))]);
  }
  return sum;
}

int
ConformalMetric::FlipToDelaunay(bool isEuclidean)
{
  std::vector<int>  waiting;
  std::vector<char> isWaiting(m_Triangulation.NumberOfEdges(), 1);
  for (int e = m_Triangulation.NumberOfEdges() - 1; e >= 0; --e)
  {
    waiting.push_back(e);
  }
  const std::size_t before = m_Flips.size();
  while (!waiting.empty())
  {
    const int edge = waiting.back();
    waiting.pop_back();
    isWaiting[edge] = 0;
    const int side = m_Triangulation.SideOf(edge);
    const int twin = m_Triangulation.Twin(side);
    if (twin == -1 || twin / 3 == side / 3 || this->ConvexityOf(edge) >= -flipTolerance)
    {
      continue;
    }
    const std::array<int, 4> rim = RimOf(m_Triangulation, side);
    const auto               flipped = [&](const Eigen::VectorXd & x) {
      return isEuclidean ? OtherDiagonal(x[edge], x[rim[1]], x[rim[0]], x[rim[2]], x[rim[3]])
                                       : PtolemyDiagonal(m_Triangulation, x, side);
    };
    const double invariant = flipped(m_Invariants);
    const double chord = flipped(m_Chords);
    m_Invariants[edge] = invariant;
    m_Chords[edge] = chord;
    m_Triangulation.Flip(side);
    m_Flips.push_back(side);
    for (const int e : rim)
    {
      if (!isWaiting[e])
      {
        isWaiting[e] = 1;
        waiting.push_back(e);
      }
    }
  }
  const int flips = static_cast<int>(m_Flips.size() - before);
  m_Changes += flips > 0 ? 1 : 0;
  return flips;
}

double
ConformalMetric::LengthOfEdge(int edge, const Eigen::VectorXd & u, std::array<double, 2> & derivatives) const
{
  const int  side = m_Triangulation.SideOf(edge);
  const int  a = m_Triangulation.Origin(side), b = m_Triangulation.End(side);
  const bool isHyperbolic = m_Geometry == RicciGeometry::Hyperbolic;
  if (m_Scheme == RicciScheme::VertexScaling)
  {
    const double length = isHyperbolic ? 2.0 * std::asinh(0.5 * m_Chords[edge]) : m_Chords[edge];
    derivatives.fill(isHyperbolic ? std::tanh(0.5 * length) : 0.5 * length);
    return length;
  }
  const double distance = m_Invariants[edge];
  if (!isHyperbolic)
  {
    const double p = std::exp(u[a]), q = std::exp(u[b]);
    const double length = std::sqrt(p * p + q * q + 2.0 * distance * p * q);
    derivatives = { p * (p + distance * q) / length, q * (q + distance * p) / length };
    return length;
  }
  const double p = 2.0 * std::atanh(std::exp(u[a])), q = 2.0 * std::atanh(std::exp(u[b]));
  const double sp = std::sinh(p), sq = std::sinh(q), cp = std::cosh(p), cq = std::cosh(q);
  const double half = 0.5 * (CoshMinusOne(p) * cq + CoshMinusOne(q) + distance * sp * sq); // sinh^2(length / 2)
  const double length = 2.0 * std::asinh(std::sqrt(half));
  const double s = std::sinh(length);
  derivatives = { sp * (sp * cq + distance * cp * sq) / s, sq * (sq * cp + distance * cq * sp) / s };
  return length;
}

bool
ConformalMetric::SetFactors(const Eigen::VectorXd & u)
{
  if (m_Scheme == RicciScheme::VertexScaling)
  {
    const Eigen::VectorXd scales = (0.5 * u).array().exp();
    for (int e = 0; e < m_Triangulation.NumberOfEdges(); ++e)
    {
      const int side = m_Triangulation.SideOf(e);
      m_Chords[e] = m_Invariants[e] * scales[m_Triangulation.Origin(side)] * scales[m_Triangulation.End(side)];
    }
    if (!m_Chords.allFinite() || m_Chords.minCoeff() <= 0.0)
    {
      return false;
    }
    this->FlipToDelaunay(false);
  }
  else if (m_Geometry == RicciGeometry::Hyperbolic && u.maxCoeff() >= 0.0)
  {
    return false;
  }
  ParallelForBlocks(m_Lengths.size(), [&](std::size_t e) {
    m_Lengths[e] = this->LengthOfEdge(static_cast<int>(e), u, m_LengthDerivatives[e]);
  });
  std::atomic<bool> isSound{ true };
  ParallelForBlocks(m_Tangents.size(), [&](std::size_t f) {
    const int            side = static_cast<int>(3 * f);
    const TriangleAngles angles = AnglesOfTriangle(m_Geometry,
                                                   { m_Lengths[m_Triangulation.EdgeOf(side)],
                                                     m_Lengths[m_Triangulation.EdgeOf(side + 1)],
                                                     m_Lengths[m_Triangulation.EdgeOf(side + 2)] });
    m_Tangents[f] = angles.tangents;
    if (!angles.isSound)
    {
      isSound = false;
    }
  });
  return isSound;
}

Eigen::VectorXd
ConformalMetric::AngleSums() const
{
  std::vector<std::array<double, 3>> angles(m_Tangents.size());
  ParallelForBlocks(angles.size(), [&](std::size_t f) {
    for (int k = 0; k < 3; ++k)
    {
      angles[f][k] = TriangleAngles{ m_Tangents[f] }.Angle(k);
    }
  });
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(m_Triangulation.NumberOfVertices());
  for (int side = 0; side < m_Triangulation.NumberOfSides(); ++side)
  {
    sums[m_Triangulation.Origin(side)] += angles[side / 3][side % 3];
  }
  return sums;
}

CurvatureDerivatives
ConformalMetric::Derivatives() const
{
  using Matrix = Eigen::Matrix3d;
  std::vector<Matrix, Eigen::aligned_allocator<Matrix>> ofFaces(m_Tangents.size());
  ParallelForBlocks(ofFaces.size(), [&](std::size_t f) {
    const TriangleAngles  angles{ m_Tangents[f], true };
    std::array<double, 3> s{};
    Matrix                byCorners = Matrix::Zero(); // row k: derivatives of side k with respect to u at the corners
    for (int k = 0; k < 3; ++k)
    {
      const int    side = static_cast<int>(3 * f) + k;
      const int    edge = m_Triangulation.EdgeOf(side);
      const bool   isForward = m_Triangulation.SideOf(edge) == side;
      const auto & d = m_LengthDerivatives[edge];
      s[k] = GeometricSine(m_Geometry, m_Lengths[edge]);
      byCorners(k, k) = d[isForward ? 0 : 1];
      byCorners(k, (k + 1) % 3) = d[isForward ? 1 : 0];
    }
    Matrix bySides; // row k: derivatives of the angle at corner k with respect to the sides
    for (int k = 0; k < 3; ++k)
    {
      const int    next = (k + 1) % 3, previous = (k + 2) % 3; // opposite to corner k is side `next`
      const double own = s[next] / (s[k] * s[previous] * angles.Sine(k));
      bySides(k, next) = own;
      bySides(k, k) = -own * angles.Cosine(next);
      bySides(k, previous) = -own * angles.Cosine(previous);
    }
    ofFaces[f] = bySides * byCorners;
  });
  CurvatureDerivatives result{ Eigen::VectorXd::Zero(m_Triangulation.NumberOfVertices()),
                               Eigen::VectorXd::Zero(m_Triangulation.NumberOfEdges()) };
  for (int side = 0; side < m_Triangulation.NumberOfSides(); ++side)
  {
    const Matrix & matrix = ofFaces[side / 3];
    const int      k = side % 3, next = (k + 1) % 3;
    result.diagonal[m_Triangulation.Origin(side)] -= matrix(k, k);
    result.ofEdges[m_Triangulation.EdgeOf(side)] -= 0.5 * (matrix(k, next) + matrix(next, k));
  }
  return result;
}

double
PtolemyDiagonal(const IntrinsicTriangulation & triangulation, const Eigen::VectorXd & lengths, int side)
{
  const std::array<int, 4> rim = RimOf(triangulation, side);
  return (lengths[rim[0]] * lengths[rim[2]] + lengths[rim[1]] * lengths[rim[3]]) / lengths[triangulation.EdgeOf(side)];
}

InversivePacking
MakeInversivePacking(const IntrinsicTriangulation & triangulation,
                     const Eigen::VectorXd &        lengths,
                     RicciGeometry                  geometry)
{
  Eigen::VectorXd radii = Eigen::VectorXd::Zero(triangulation.NumberOfVertices());
  Eigen::VectorXd faces = radii;
  for (int side = 0; side < triangulation.NumberOfSides(); ++side)
  {
    const double own = lengths[triangulation.EdgeOf(side)];
    const double opposite = lengths[triangulation.EdgeOf(IntrinsicTriangulation::Next(side))];
    const double previous = lengths[triangulation.EdgeOf(IntrinsicTriangulation::Previous(side))];
    radii[triangulation.Origin(side)] += 0.5 * (own + previous - opposite);
    faces[triangulation.Origin(side)] += 1.0;
  }
  InversivePacking result{ Eigen::VectorXd(lengths.size()), Eigen::VectorXd::Zero(radii.size()) };
  const bool       isHyperbolic = geometry == RicciGeometry::Hyperbolic;
  for (Eigen::Index v = 0; v < radii.size(); ++v)
  {
    radii[v] /= std::max(1.0, faces[v]);
    result.u[v] = std::log(isHyperbolic ? std::tanh(0.5 * radii[v]) : radii[v]);
  }
  for (int e = 0; e < triangulation.NumberOfEdges(); ++e)
  {
    const double p = radii[triangulation.Origin(triangulation.SideOf(e))];
    const double q = radii[triangulation.End(triangulation.SideOf(e))];
    const double l = lengths[e];
    result.distances[e] = isHyperbolic ? (CoshMinusOne(l) - CoshMinusOne(p) * std::cosh(q) - CoshMinusOne(q)) /
                                           (std::sinh(p) * std::sinh(q))
                                       : (l * l - p * p - q * q) / (2.0 * p * q);
  }
  return result;
}
} // namespace shapeton
