#include "shapetonChecks.h"
#include "shapetonPi.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace shapeton
{
namespace
{
using Complex = std::complex<double>;

constexpr double MostErrorOfPeriod = 1e-9; // relative to the shorter period of the lattice
/** Ratio of the smallest to the largest radius; below it, a degenerate solution cannot be ruled out. */
constexpr double LeastRatio = 1e-11;

class PlaneCheck
{
public:
  PlaneCheck(const EmbeddingCertificate & certificate, const TracedMap & packed)
    : m_Certificate(certificate)
    , m_Packed(packed)
    , m_First(certificate.periods[0], certificate.periods[1])
    , m_Second(certificate.periods[2], certificate.periods[3])
    , m_Area((std::conj(m_First) * m_Second).imag())
  {}

  void
  Check(Measures & measures)
  {
    this->CheckRadii(measures);
    this->CheckLattice(measures);
    m_Direction = DirectionsOfHalfEdges(m_Certificate, m_Packed, HalfAngle);
    this->CheckEdges(measures);
    this->CheckFaces(measures);
    this->CheckGenerators();
  }

private:
  static double
  HalfAngle(double r, double s)
  {
    return std::atan2(s, r);
  }

  void
  CheckRadii(Measures & measures) const
  {
    const double largest = std::max(*std::max_element(m_Certificate.nodeRadii.begin(), m_Certificate.nodeRadii.end()),
                                    *std::max_element(m_Certificate.faceRadii.begin(), m_Certificate.faceRadii.end()));
    RequireRadii(m_Certificate.nodeRadii, LeastRatio * largest, 1e300, "node");
    RequireRadii(m_Certificate.faceRadii, LeastRatio * largest, 1e300, "face");
    CheckKiteAngles(m_Certificate, m_Packed, HalfAngle, measures);
  }

  /** Checks that the periods are a reduced basis, and that their parallelogram has the area of all kites, so that it
   * covers the torus once. */
  void
  CheckLattice(Measures & measures) const
  {
    const double shear = (std::conj(m_First) * m_Second).real();
    const double slack = 1.0 + 1e-9;
    if (!(m_Area > 0.0) || !(std::abs(m_First) <= slack * std::abs(m_Second)) ||
        !(std::abs(shear) <= 0.5 * slack * std::norm(m_First)))
    {
      throw Refusal("the periods are not a reduced basis of a lattice");
    }
    double kites = 0.0;
    for (int h = 0; h < m_Packed.HalfEdges(); ++h)
    {
      kites += m_Certificate.nodeRadii[m_Packed.node[h]] * m_Certificate.faceRadii[m_Packed.face[h]];
    }
    const double error = std::abs(kites / m_Area - 1.0);
    if (!(error <= MostErrorOfPeriod))
    {
      throw Refusal("the kites cover " + Figure(kites / m_Area) + " times the parallelogram of the periods");
    }
    measures.emplace_back("areaError", error);
  }

  static Complex
  Place(const std::vector<double> & places, int index)
  {
    return { places[2 * static_cast<std::size_t>(index)], places[2 * static_cast<std::size_t>(index) + 1] };
  }

  /** Translation across a half-edge. */
  Complex
  Translation(int h) const
  {
    const double length = m_Certificate.nodeRadii[m_Packed.node[h]] + m_Certificate.nodeRadii[m_Packed.node[h ^ 1]];
    return Place(m_Certificate.nodePositions, m_Packed.node[h]) + std::polar(length, m_Direction[h]) -
           Place(m_Certificate.nodePositions, m_Packed.node[h ^ 1]);
  }

  /** Distance of a vector from the lattice. */
  double
  LatticeError(Complex vector) const
  {
    const double first = std::round((std::conj(vector) * m_Second).imag() / m_Area);
    const double second = std::round((std::conj(m_First) * vector).imag() / m_Area);
    return std::abs(vector - first * m_First - second * m_Second);
  }

  /** Checks that crossing an edge is a lattice translation without rotation, and the identity for tree edges. */
  void
  CheckEdges(Measures & measures) const
  {
    const double tolerance = MostErrorOfPeriod * std::abs(m_First);
    double       largest = 0.0;
    for (int h = 0; h < m_Packed.HalfEdges(); ++h)
    {
      const double  turn = std::remainder(m_Direction[h ^ 1] - m_Direction[h] - Pi, 2.0 * Pi);
      const Complex translation = this->Translation(h);
      const bool    isOfTree = m_Certificate.tree[m_Packed.node[h ^ 1]] == h;
      const double  error = isOfTree ? std::abs(translation) : this->LatticeError(translation);
      if (!(std::abs(turn) <= MostErrorOfPeriod))
      {
        throw Refusal("the directions at the ends of half-edge " + std::to_string(h) + " differ by " + Figure(turn));
      }
      if (!(error <= tolerance))
      {
        throw Refusal("the circles of the nodes of half-edge " + std::to_string(h) + " are not tangent: they miss by " +
                      Figure(error));
      }
      largest = std::max(largest, error);
    }
    measures.emplace_back("tangency", largest);
  }

  /** Checks each face circle against its kites, up to the lattice; exactly for the kite of its lowest half-edge. */
  void
  CheckFaces(Measures & measures) const
  {
    const double tolerance = MostErrorOfPeriod * std::abs(m_First);
    double       largest = 0.0;
    for (int h = 0; h < m_Packed.HalfEdges(); ++h)
    {
      const int     v = m_Packed.node[h];
      const int     f = m_Packed.face[h];
      const Complex kite =
        std::polar(1.0, m_Direction[h]) * Complex(m_Certificate.nodeRadii[v], m_Certificate.faceRadii[f]);
      const Complex miss = Place(m_Certificate.nodePositions, v) + kite - Place(m_Certificate.facePositions, f);
      const double  error = m_Packed.firstOfFace[f] == h ? std::abs(miss) : this->LatticeError(miss);
      if (!(error <= tolerance))
      {
        throw Refusal("the circles of node " + std::to_string(v) + " and face " + std::to_string(f) +
                      " are not orthogonal: the face is " + Figure(error) + " from its expected position");
      }
      largest = std::max(largest, error);
    }
    measures.emplace_back("orthogonality", largest);
  }

  void
  CheckGenerators() const
  {
    const double tolerance = MostErrorOfPeriod * std::abs(m_First);
    for (const DeckTransformation & generator : m_Certificate.generators)
    {
      const double error = std::abs(generator.b - this->Translation(generator.halfEdge));
      if (!(error <= tolerance) || generator.a != Complex(1.0))
      {
        throw Refusal("the generator of half-edge " + std::to_string(generator.halfEdge) + " is not its translation");
      }
    }
    const double     area = std::abs((std::conj(m_Certificate.generators[0].b) * m_Certificate.generators[1].b).imag());
    constexpr double sameArea = 1e-6;
    if (!(std::abs(area / m_Area - 1.0) <= sameArea))
    {
      throw Refusal("the generators do not span the lattice of the periods");
    }
  }

  const EmbeddingCertificate & m_Certificate;
  const TracedMap &            m_Packed;
  Complex                      m_First;
  Complex                      m_Second;
  double                       m_Area;
  std::vector<double>          m_Direction; // direction of each half-edge at its node
};
} // namespace

void
CheckPlane(const EmbeddingCertificate & certificate, const TracedMap & packed, Measures & measures)
{
  PlaneCheck(certificate, packed).Check(measures);
}
} // namespace shapeton
