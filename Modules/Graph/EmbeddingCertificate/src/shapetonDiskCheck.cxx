#include "shapetonChecks.h"
#include "shapetonPi.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace shapeton
{
namespace
{
// Products of disk transformations lose as many digits as their entries have before the decimal point.
using Real = long double;
using LongComplex = std::complex<Real>;

constexpr double MostPlaceError = 1e-9; // a hyperbolic length
/** Bounds on the smallest radius, absolute and relative to the largest one; see shapetonPlaneCheck.cxx. */
constexpr double LeastRadius = 1e-11;

/** z -> (a z + b) / (conj(b) z + conj(a)). */
struct Isometry
{
  LongComplex a{ 1.0L };
  LongComplex b{ 0.0L };

  Isometry
  operator*(const Isometry & other) const
  {
    return { a * other.a + b * std::conj(other.b), a * other.b + b * std::conj(other.a) };
  }

  Isometry
  Inverse() const
  {
    return { std::conj(a), -b };
  }

  /** Distance from the identity; a transformation and its negative are equivalent. */
  double
  Deviation() const
  {
    const Real plus = std::max(std::abs(a - LongComplex(1.0L)), std::abs(b));
    const Real minus = std::max(std::abs(a + LongComplex(1.0L)), std::abs(b));
    return static_cast<double>(std::min(plus, minus));
  }
};

Isometry
Turn(double angle)
{
  return { std::polar<Real>(1.0, Real{ 0.5 } * angle), 0.0L };
}

Isometry
Walk(double length)
{
  return { std::cosh(Real{ 0.5 } * length), std::sinh(Real{ 0.5 } * length) };
}

class DiskCheck
{
public:
  DiskCheck(const EmbeddingCertificate & certificate, const TracedMap & packed)
    : m_Certificate(certificate), m_Packed(packed)
  {}

  void
  Check(Measures & measures);

private:
  void
  CheckRadii(Measures & measures) const;
  /** Angle at the end of the first leg in the right triangle with these legs. */
  static double
  HalfAngle(double r, double s)
  {
    return std::atan2(std::tanh(s), std::sinh(r));
  }

  /** Hypotenuse of the right triangle with these legs: cosh l = cosh r cosh s, without cancellation for small circles.
   */
  static double
  Diagonal(double r, double s)
  {
    const double a = std::sinh(0.5 * r) * std::sinh(0.5 * r);
    const double b = std::sinh(0.5 * s) * std::sinh(0.5 * s);
    return 2.0 * std::asinh(std::sqrt(a + b + 2.0 * a * b));
  }

  void
  CheckPlaces() const;
  static LongComplex
  Place(const std::vector<double> & places, int index)
  {
    return { places[2 * static_cast<std::size_t>(index)], places[2 * static_cast<std::size_t>(index) + 1] };
  }

  Isometry
  Frame(int node, double angle) const;
  /** Frame of the end node, with its axis along the twin, reached by following the half-edge. */
  Isometry
  Reached(int h) const
  {
    const double length = m_Certificate.nodeRadii[m_Packed.node[h]] + m_Certificate.nodeRadii[m_Packed.node[h ^ 1]];
    return this->Frame(m_Packed.node[h], m_Direction[h]) * Walk(length) * Turn(Pi);
  }

  /** Deck transformation across a half-edge. */
  Isometry
  Transformation(int h) const
  {
    return this->Reached(h) * this->Frame(m_Packed.node[h ^ 1], m_Direction[h ^ 1]).Inverse();
  }

  /** Near the rim, rounding moves a place by a large hyperbolic distance. */
  static double
  Tolerance(LongComplex z)
  {
    constexpr long double rounding = 1e-14L; // of a place
    return MostPlaceError + static_cast<double>(rounding / ((1.0 - std::abs(z)) * (1.0 + std::abs(z))));
  }

  double
  ToleranceOf(int node) const
  {
    return Tolerance(Place(m_Certificate.nodePositions, node));
  }

  void
  CheckTree(Measures & measures) const;
  void
  CheckFaces(Measures & measures) const;
  static Real
  Norm(const Isometry & isometry)
  {
    return std::abs(isometry.a) + std::abs(isometry.b);
  }

  static Isometry
  IsometryOf(const DeckTransformation & generator)
  {
    return { { generator.a.real(), generator.a.imag() }, { generator.b.real(), generator.b.imag() } };
  }

  double
  GeneratorTolerance(int halfEdge, const Isometry & transformation) const;
  /** Rounding error of |a|^2 - |b|^2 = 1. */
  static Real
  DriftOfFactor(const Isometry & transformation)
  {
    constexpr Real rounding = 2e-15L;
    return rounding * std::norm(transformation.a);
  }

  void
  CheckGenerators(Measures & measures) const;
  void
  CheckWord(Measures & measures) const;

  const EmbeddingCertificate & m_Certificate;
  const TracedMap &            m_Packed;
  std::vector<double>          m_Direction; // direction of each half-edge at its node
};

void
DiskCheck::Check(Measures & measures)
{
  this->CheckRadii(measures);
  this->CheckPlaces();
  m_Direction = DirectionsOfHalfEdges(m_Certificate, m_Packed, HalfAngle);
  this->CheckTree(measures);
  this->CheckFaces(measures);
  this->CheckGenerators(measures);
  this->CheckWord(measures);
}

void
DiskCheck::CheckRadii(Measures & measures) const
{
  RequireRadii(m_Certificate.nodeRadii, LeastRadius, 100.0, "node");
  RequireRadii(m_Certificate.faceRadii, LeastRadius, 100.0, "face");
  CheckKiteAngles(m_Certificate, m_Packed, HalfAngle, measures);
}

void
DiskCheck::CheckPlaces() const
{
  for (const auto * places : { &m_Certificate.nodePositions, &m_Certificate.facePositions })
  {
    for (std::size_t i = 0; i < places->size(); i += 2)
    {
      if (!(std::hypot((*places)[i], (*places)[i + 1]) < 1.0))
      {
        throw Refusal(std::string("the place of ") + (places == &m_Certificate.nodePositions ? "node " : "face ") +
                      std::to_string(i / 2) + " is outside the disk");
      }
    }
  }
}

/** Maps the disk center to the place of a node, and the direction of the real axis to `angle` there. */
Isometry
DiskCheck::Frame(int node, double angle) const
{
  const LongComplex z = Place(m_Certificate.nodePositions, node);
  const Real        scale = 1.0L / std::sqrt((1.0L - std::abs(z)) * (1.0L + std::abs(z)));
  const LongComplex turn = std::polar<Real>(1.0L, 0.5L * angle);
  return { scale * turn, scale * z * std::conj(turn) };
}

/** Checks each node against its parent in the tree: the circles touch, and its direction points back to the parent. */
void
DiskCheck::CheckTree(Measures & measures) const
{
  double largest = 0.0;
  for (int node = 0; node < m_Packed.nodes; ++node)
  {
    const int h = m_Certificate.tree[node];
    if (h < 0)
    {
      continue;
    }
    const double error = (this->Frame(node, m_Direction[h ^ 1]).Inverse() * this->Reached(h)).Deviation();
    if (!(error <= std::max(ToleranceOf(node), ToleranceOf(m_Packed.node[h]))))
    {
      throw Refusal("the circles of nodes " + std::to_string(m_Packed.node[h]) + " and " + std::to_string(node) +
                    " are not tangent: they miss by " + Figure(error));
    }
    largest = std::max(largest, error);
  }
  measures.emplace_back("tangency", largest);
}

/** Checks each face circle against the position given by the kite of its lowest half-edge. */
void
DiskCheck::CheckFaces(Measures & measures) const
{
  double largest = 0.0;
  for (std::size_t f = 0; f < m_Packed.firstOfFace.size(); ++f)
  {
    const int    h = m_Packed.firstOfFace[f];
    const int    v = m_Packed.node[h];
    const double r = m_Certificate.nodeRadii[v];
    const double s = m_Certificate.faceRadii[f];
    const double length = Diagonal(r, s);
    const auto   kite = this->Frame(v, m_Direction[h] + HalfAngle(r, s)) * Walk(length);
    const auto   expected = kite.b / std::conj(kite.a);
    const auto   place = Place(m_Certificate.facePositions, static_cast<int>(f));
    const Real   gap = std::abs(place - expected) / std::abs(LongComplex(1.0L) - std::conj(place) * expected);
    const double error = 2.0 * static_cast<double>(std::atanh(std::min<Real>(gap, 0.999L)));
    if (!(error <= std::max(ToleranceOf(v), Tolerance(place))))
    {
      throw Refusal("the circles of node " + std::to_string(v) + " and face " + std::to_string(f) +
                    " are not orthogonal: the face is " + Figure(error) + " from its expected position");
    }
    largest = std::max(largest, error);
  }
  measures.emplace_back("orthogonality", largest);
}

/** Tolerated error, relative to the entries of the transformation F L G^-1 between the end frames F and G. Rounding a
 * place changes its frame by about |F|^2 times the spacing of doubles, amplified by F and G^-1. */
double
DiskCheck::GeneratorTolerance(int halfEdge, const Isometry & transformation) const
{
  constexpr Real rounding = 2e-15L;
  const Real     start = Norm(this->Frame(m_Packed.node[halfEdge], 0.0));
  const Real     end = Norm(this->Frame(m_Packed.node[halfEdge ^ 1], 0.0));
  const Real     enlarged = start * end * (start * start + end * end) / Norm(transformation);
  return MostPlaceError + static_cast<double>(rounding * enlarged);
}

void
DiskCheck::CheckGenerators(Measures & measures) const
{
  double largest = 0.0;
  for (const DeckTransformation & generator : m_Certificate.generators)
  {
    const Isometry stated = IsometryOf(generator);
    const Isometry measured = this->Transformation(generator.halfEdge);
    const Real     size = std::abs(measured.a);
    // A common real factor has no effect; for transformations between distant places, doubles cannot distinguish it
    // from 1.
    const Real   factor = std::real(stated.a * std::conj(measured.a)) / (size * size);
    const Real   drift = std::abs(std::abs(factor) - 1.0L);
    const double error = static_cast<double>(
      std::max(std::abs(stated.a - factor * measured.a), std::abs(stated.b - factor * measured.b)) / size);
    if (!(drift <= MostPlaceError + DriftOfFactor(measured)))
    {
      throw Refusal("the generator of half-edge " + std::to_string(generator.halfEdge) + " has |a|^2 - |b|^2 = 1 + " +
                    Figure(static_cast<double>(2.0 * drift)));
    }
    if (!(error <= this->GeneratorTolerance(generator.halfEdge, measured)))
    {
      throw Refusal("the generator of half-edge " + std::to_string(generator.halfEdge) +
                    " is not its deck transformation: they differ by " + Figure(error));
    }
    largest = std::max(largest, error);
  }
  measures.emplace_back("generatorError", largest);
}

/** Product along the word. The other checks imply that it is the identity, so any deviation must be explained by the
 * rounding errors of the generators: one error factor between two partial products, where the second is nearly the
 * inverse of the remaining product. */
void
DiskCheck::CheckWord(Measures & measures) const
{
  constexpr Real rounding = 1e-14L; // relative to the entries of a generator, including its places
  Isometry       product;
  Real           explained = 1e-10L;
  for (const int letter : m_Certificate.word)
  {
    const Isometry generator = IsometryOf(m_Certificate.generators[std::abs(letter) - 1]);
    const Isometry factor = letter > 0 ? generator : generator.Inverse();
    const Isometry next = product * factor;
    explained += (rounding + DriftOfFactor(factor)) * Norm(product) * Norm(factor) * Norm(next);
    product = next;
  }
  const double error = product.Deviation();
  if (!(error <= static_cast<double>(explained)))
  {
    throw Refusal("the product of the generators along the word differs from the identity by " + Figure(error));
  }
  measures.emplace_back("wordError", error);
}
} // namespace

void
CheckDisk(const EmbeddingCertificate & certificate, const TracedMap & packed, Measures & measures)
{
  DiskCheck(certificate, packed).Check(measures);
}
} // namespace shapeton
