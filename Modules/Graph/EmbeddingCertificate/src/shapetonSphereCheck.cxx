#include "shapetonChecks.h"
#include "shapetonPi.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace shapeton
{
namespace
{
// On the unit sphere, limited by double precision: a cap of 1e-12 is 10^4 times the spacing of doubles.
constexpr double LeastSphereRadius = 1e-12;
constexpr double MostTangencyError = 1e-9;
constexpr double MostOrthogonalityError = 1e-10;
// Minimum sine of the right angle of a kite; rounding affects it for tiny caps.
constexpr double LeastSine = 0.5;

using Point = std::array<double, 3>;

double
Dot(const Point & a, const Point & b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Point
Cross(const Point & a, const Point & b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

Point
Sum(const Point & a, double factor, const Point & b)
{
  return { a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2] };
}

double
Length(const Point & a)
{
  return std::sqrt(Dot(a, a));
}

/** Angle between unit vectors, accurate for small and large angles. */
double
Angle(const Point & a, const Point & b)
{
  return 2.0 * std::atan2(Length(Sum(a, -1.0, b)), Length(Sum(a, 1.0, b)));
}

/** The direction at `from` of the arc to `to`: a unit vector tangent to the sphere. */
Point
Direction(const Point & from, const Point & to)
{
  const Point  chord = Sum(to, -1.0, from);
  const Point  tangent = Sum(chord, -Dot(chord, from), from);
  const double length = Length(tangent);
  return { tangent[0] / length, tangent[1] / length, tangent[2] / length };
}

std::string
Circles(const char * kind, int first, int second)
{
  return std::string(kind) + ' ' + std::to_string(first) + " and " + std::to_string(second);
}

class SphereCheck
{
public:
  SphereCheck(const EmbeddingCertificate & certificate, const TracedMap & packed)
    : m_Certificate(certificate), m_Packed(packed), m_Touch(packed.HalfEdges() / 2)
  {}

  void
  Check(Measures & measures)
  {
    RequireRadii(m_Certificate.nodeRadii, LeastSphereRadius, Pi, "node");
    RequireRadii(m_Certificate.faceRadii, LeastSphereRadius, Pi, "face");
    this->RequireUnitVectors(m_Certificate.nodePositions, "node");
    this->RequireUnitVectors(m_Certificate.facePositions, "face");
    this->CheckTangency(measures);
    this->CheckOrthogonality(measures);
    this->CheckKites();
    this->CheckWinding();
    this->CheckAngleSums(measures);
    double smallest = Pi;
    for (int node = 0; node < m_Certificate.graph.nodes; ++node)
    {
      smallest = std::min(smallest, m_Certificate.nodeRadii[node]);
    }
    measures.emplace_back("smallestRadius", smallest);
  }

private:
  static void
  RequireUnitVectors(const std::vector<double> & places, const char * kind)
  {
    constexpr double tolerance = 1e-12;
    for (std::size_t i = 0; i < places.size() / 3; ++i)
    {
      const double length = Length({ places[3 * i], places[3 * i + 1], places[3 * i + 2] });
      if (!(std::abs(length - 1.0) <= tolerance))
      {
        throw Refusal(std::string("the place of ") + kind + ' ' + std::to_string(i) +
                      " is not on the unit sphere: length 1 + " + Figure(length - 1.0));
      }
    }
  }

  Point
  NodePlace(int node) const
  {
    const double * const p = m_Certificate.nodePositions.data() + 3 * static_cast<std::size_t>(node);
    return { p[0], p[1], p[2] };
  }
  Point
  FacePlace(int face) const
  {
    const double * const p = m_Certificate.facePositions.data() + 3 * static_cast<std::size_t>(face);
    return { p[0], p[1], p[2] };
  }

  /** Checks that the two end circles of each edge touch, and also its two face circles. */
  void
  CheckTangency(Measures & measures)
  {
    double largest = 0.0;
    for (int h = 0; h < m_Packed.HalfEdges(); h += 2)
    {
      const int    v = m_Packed.node[h];
      const int    w = m_Packed.node[h + 1];
      const int    f = m_Packed.face[h];
      const int    g = m_Packed.face[h + 1];
      const double ofNodes =
        std::abs(Angle(NodePlace(v), NodePlace(w)) - m_Certificate.nodeRadii[v] - m_Certificate.nodeRadii[w]);
      const double ofFaces =
        std::abs(Angle(FacePlace(f), FacePlace(g)) - m_Certificate.faceRadii[f] - m_Certificate.faceRadii[g]);
      if (!(ofNodes <= MostTangencyError))
      {
        throw Refusal("the circles of " + Circles("nodes", v, w) + " are not tangent: they miss by " + Figure(ofNodes));
      }
      if (!(ofFaces <= MostTangencyError))
      {
        throw Refusal("the circles of " + Circles("faces", f, g) + " are not tangent: they miss by " + Figure(ofFaces));
      }
      largest = std::max({ largest, ofNodes, ofFaces });
      // Computed from the smaller circle for accuracy at its scale.
      const int    near = m_Certificate.nodeRadii[v] <= m_Certificate.nodeRadii[w] ? v : w;
      const double radius = m_Certificate.nodeRadii[near];
      const Point  center = NodePlace(near);
      const Point  direction = Direction(center, NodePlace(near == v ? w : v));
      // 1 - cos r without cancellation
      const double bend = -2.0 * std::sin(0.5 * radius) * std::sin(0.5 * radius);
      m_Touch[h / 2] = Sum(Sum(center, bend, center), std::sin(radius), direction);
    }
    measures.emplace_back("tangency", largest);
  }

  void
  CheckOrthogonality(Measures & measures) const
  {
    double largest = 0.0;
    for (int h = 0; h < m_Packed.HalfEdges(); ++h)
    {
      const int    v = m_Packed.node[h];
      const int    f = m_Packed.face[h];
      const double error = std::abs(Dot(NodePlace(v), FacePlace(f)) -
                                    std::cos(m_Certificate.nodeRadii[v]) * std::cos(m_Certificate.faceRadii[f]));
      if (!(error <= MostOrthogonalityError))
      {
        throw Refusal("the circles of node " + std::to_string(v) + " and face " + std::to_string(f) +
                      " are not orthogonal: the error is " + Figure(error));
      }
      largest = std::max(largest, error);
    }
    measures.emplace_back("orthogonality", largest);
  }

  /** Checks that both triangles of each kite, (node, touching point, face) and its mirror image, have the orientation
   * of the map.
   */
  void
  CheckKites() const
  {
    for (int h = 0; h < m_Packed.HalfEdges(); ++h)
    {
      const Point node = NodePlace(m_Packed.node[h]);
      const Point face = FacePlace(m_Packed.face[h]);
      for (const int side : { h, m_Packed.next[h] })
      {
        const Point  touch = m_Touch[side / 2];
        const Point  toNode = Direction(touch, node);
        const Point  toFace = Direction(touch, face);
        const double sine = Dot(touch, Cross(toFace, toNode)) * (side == h ? 1.0 : -1.0);
        if (!(sine >= LeastSine))
        {
          throw Refusal("the kite of node " + std::to_string(m_Packed.node[h]) + " and face " +
                        std::to_string(m_Packed.face[h]) + " is not positively oriented: edges cross there");
        }
      }
    }
  }

  /** Checks that the kites wind once around each node and each face. */
  void
  CheckWinding() const
  {
    std::vector<double> ofNodes(m_Certificate.nodeRadii.size(), 0.0);
    std::vector<double> ofFaces(m_Certificate.faceRadii.size(), 0.0);
    for (int h = 0; h < m_Packed.HalfEdges(); ++h)
    {
      const Point node = NodePlace(m_Packed.node[h]);
      const Point face = FacePlace(m_Packed.face[h]);
      for (const int side : { h, m_Packed.next[h] })
      {
        const Point touch = m_Touch[side / 2];
        ofNodes[m_Packed.node[h]] += Angle(Direction(node, touch), Direction(node, face));
        ofFaces[m_Packed.face[h]] += Angle(Direction(face, touch), Direction(face, node));
      }
    }
    RequireOneTurn(ofNodes, "node");
    RequireOneTurn(ofFaces, "face");
  }

  static void
  RequireOneTurn(const std::vector<double> & angles, const std::string & kind)
  {
    for (std::size_t i = 0; i < angles.size(); ++i)
    {
      if (!(std::abs(angles[i] - 2.0 * Pi) < Pi)) // a multiple of 2 pi up to rounding
      {
        throw Refusal("the kites wind " + Figure(angles[i] / (2.0 * Pi)) + " times around " + kind + ' ' +
                      std::to_string(i));
      }
    }
  }

  /** Uses the radii alone. On the sphere radii have the absolute error of a double, which matters for small caps. */
  void
  CheckAngleSums(Measures & measures) const
  {
    const auto halfAngle = [](double r, double s) { return std::atan2(std::sin(s), std::sin(r) * std::cos(s)); };
    std::vector<double> ofNodes;
    std::vector<double> ofFaces;
    SumKiteAngles(m_Certificate, m_Packed, halfAngle, ofNodes, ofFaces);
    std::vector<double> nodeTolerance(ofNodes.size(), 1e-9);
    std::vector<double> faceTolerance(ofFaces.size(), 1e-9);
    for (int h = 0; h < m_Packed.HalfEdges(); ++h)
    {
      constexpr double error = 4e-15;
      const double     v = m_Certificate.nodeRadii[m_Packed.node[h]];
      const double     f = m_Certificate.faceRadii[m_Packed.face[h]];
      const double     angle = error * std::min(v, f) / std::max(v, f) * (1.0 / v + 1.0 / f);
      nodeTolerance[m_Packed.node[h]] += angle;
      faceTolerance[m_Packed.face[h]] += angle;
    }
    const double atNodes = RequireAngleSums(ofNodes, nodeTolerance, "node");
    measures.emplace_back("angleSum", std::max(atNodes, RequireAngleSums(ofFaces, faceTolerance, "face")));
  }

  const EmbeddingCertificate & m_Certificate;
  const TracedMap &            m_Packed;
  std::vector<Point>           m_Touch; // touching point of each edge
};
} // namespace

void
CheckSphere(const EmbeddingCertificate & certificate, const TracedMap & packed, Measures & measures)
{
  SphereCheck(certificate, packed).Check(measures);
}
} // namespace shapeton
