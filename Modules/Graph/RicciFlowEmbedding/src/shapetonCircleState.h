#ifndef shapetonCircleState_h
#define shapetonCircleState_h

#include "shapetonParallelFor.h"
#include "shapetonPi.h"
#include "shapetonRicciUnknowns.h"

#include <cmath>
#include <limits>
#include <type_traits>

namespace shapeton
{
/** A circle, given by sinh and cosh of its radius, or in Euclidean geometry by the radius and 1. The same formulas then
 * hold in both geometries. */
template <typename TReal>
struct CircleSize
{
  TReal sinh{ 1 };
  TReal cosh{ 1 };
};

/** Circles at a point u of the flow and the energy gradient there, in double or extended precision. */
template <typename TReal>
class CircleState
{
public:
  using Size = CircleSize<TReal>;
  using Kind = RicciUnknowns::Kind;

  explicit CircleState(const RicciUnknowns & unknowns)
    : m_Unknowns(unknowns)
    , m_Map(unknowns.map)
    , m_Node(unknowns.map.Nodes())
    , m_Face(unknowns.map.Faces())
    , m_Gradient(unknowns.number)
  {}
  const Size &
  Node(int node) const
  {
    return m_Node[node];
  }
  const Size &
  Face(int face) const
  {
    return m_Face[face];
  }
  const std::vector<TReal> &
  Gradient() const
  {
    return m_Gradient;
  }
  TReal
  Residual() const
  {
    TReal largest = 0;
    for (const TReal k : m_Gradient)
    {
      largest = std::abs(k) <= largest ? largest : std::abs(k); // propagates NaN
    }
    return largest;
  }
  void
  Evaluate(const std::vector<TReal> & u);
  /** The radii, in extended precision with the residuals. */
  CirclePacking
  Packing() const;

private:
  Size
  SizeOf(TReal u) const;
  Size
  SizeOfEliminated(int face) const;
  TReal
  RadiusOf(const Size & size) const
  {
    return this->IsEuclidean() ? size.sinh : std::asinh(size.sinh);
  }
  static void
  Append(TReal radius, std::vector<double> & radii, std::vector<double> & rests)
  {
    radii.push_back(static_cast<double>(radius));
    if (!std::is_same<TReal, double>::value)
    {
      rests.push_back(std::isinf(radius) ? 0.0 : static_cast<double>(radius - static_cast<TReal>(radii.back())));
    }
  }
  bool
  IsEuclidean() const
  {
    return m_Unknowns.geometry == FlowGeometry::Euclidean;
  }
  /** Rounding error of pi. The fixed circle accumulates all curvatures, so a bias would matter. */
  static constexpr TReal restOfPi = std::is_same<TReal, double>::value ? TReal(1.2246467991473532e-16L) : TReal(0);
  /** \equation{6.2} without boundary terms (closed surfaces), by half kite angles. */
  static TReal
  CurvatureOf(TReal halfAngles)
  {
    return 2 * ((PiOf<TReal> - halfAngles) + restOfPi);
  }
  TReal
  CurvatureOfNode(int node) const;
  TReal
  CurvatureOfFace(int face) const;

  const RicciUnknowns &    m_Unknowns;
  const CombinatorialMap & m_Map;
  std::vector<Size>        m_Node;
  std::vector<Size>        m_Face;
  std::vector<TReal>       m_Gradient;
};

/** \equation{6.4} solved for the radius. */
template <typename TReal>
CircleSize<TReal>
CircleState<TReal>::SizeOf(TReal u) const
{
  const TReal t = std::exp(u);
  if (this->IsEuclidean())
  {
    return { t, 1 };
  }
  const TReal d = -std::expm1(2 * u); // 1 - t^2
  return { 2 * t / d, (1 + t * t) / d };
}

/** Circle orthogonal to three mutually tangent ones: with p = sinh a sinh b sinh c and sum = sinh(a + b + c) - p,
 * tanh^2 r = p / (sum + p), cosh^2 r = 1 + p / sum. */
template <typename TReal>
CircleSize<TReal>
CircleState<TReal>::SizeOfEliminated(int face) const
{
  const int    h = m_Map.FirstOfFace(face);
  const int    next = m_Map.FaceNext(h);
  const Size & a = m_Node[m_Map.Node(h)];
  const Size & b = m_Node[m_Map.Node(next)];
  const Size & c = m_Node[m_Map.Node(m_Map.FaceNext(next))];
  const TReal  cothA = a.cosh / a.sinh;
  const TReal  cothB = b.cosh / b.sinh;
  const TReal  cothC = c.cosh / c.sinh;
  const TReal  ratio = 1 / (cothB * cothC + cothC * cothA + cothA * cothB); // p / sum, since p alone might overflow
  return { std::sqrt(ratio), this->IsEuclidean() ? TReal(1) : std::sqrt(1 + ratio) };
}

template <typename TReal>
TReal
CircleState<TReal>::CurvatureOfNode(int node) const
{
  TReal     angles = 0;
  const int first = m_Map.FirstAround(node);
  int       h = first;
  do
  {
    const int face = m_Map.Face(h);
    angles += m_Unknowns.faceKind[face] == Kind::Line
                ? PiOf<TReal> / 2
                : std::atan2(m_Face[face].sinh, m_Node[node].sinh * m_Face[face].cosh);
    h = m_Map.NextAround(h);
  } while (h != first);
  return CurvatureOf(angles);
}

template <typename TReal>
TReal
CircleState<TReal>::CurvatureOfFace(int face) const
{
  TReal     angles = 0;
  const int first = m_Map.FirstOfFace(face);
  int       h = first;
  do
  {
    const int node = m_Map.Node(h);
    angles += m_Unknowns.nodeKind[node] == Kind::Line
                ? PiOf<TReal> / 2
                : std::atan2(m_Node[node].sinh, m_Face[face].sinh * m_Node[node].cosh);
    h = m_Map.FaceNext(h);
  } while (h != first);
  return CurvatureOf(angles);
}

template <typename TReal>
void
CircleState<TReal>::Evaluate(const std::vector<TReal> & u)
{
  const RicciUnknowns & unknowns = m_Unknowns;
  ParallelForBlocks(m_Map.Nodes(), [&](std::size_t node) {
    m_Node[node] = unknowns.ofNode[node] >= 0 ? this->SizeOf(u[unknowns.ofNode[node]]) : Size();
  });
  ParallelForBlocks(m_Map.Faces(), [&](std::size_t face) {
    if (unknowns.IsEliminated(static_cast<int>(face)))
    {
      m_Face[face] = this->SizeOfEliminated(static_cast<int>(face));
    }
    else
    {
      m_Face[face] = unknowns.ofFace[face] >= 0 ? this->SizeOf(u[unknowns.ofFace[face]]) : Size(); // horocycle: tanh 1
    }
  });
  ParallelForBlocks(m_Map.Nodes(), [&](std::size_t node) {
    if (unknowns.ofNode[node] >= 0)
    {
      m_Gradient[unknowns.ofNode[node]] = this->CurvatureOfNode(static_cast<int>(node));
    }
  });
  ParallelForBlocks(m_Map.Faces(), [&](std::size_t face) {
    if (unknowns.ofFace[face] >= 0)
    {
      m_Gradient[unknowns.ofFace[face]] = this->CurvatureOfFace(static_cast<int>(face));
    }
  });
}

template <typename TReal>
CirclePacking
CircleState<TReal>::Packing() const
{
  constexpr TReal infinity = std::numeric_limits<TReal>::infinity();
  CirclePacking   packing;
  packing.geometry = m_Unknowns.geometry;
  for (int node = 0; node < m_Map.Nodes(); ++node)
  {
    const bool isLine = m_Unknowns.nodeKind[node] == Kind::Line;
    Append(isLine ? infinity : this->RadiusOf(m_Node[node]), packing.nodeRadii, packing.nodeRests);
  }
  for (int face = 0; face < m_Map.Faces(); ++face)
  {
    const Kind kind = m_Unknowns.faceKind[face];
    const bool isInfinite = kind == Kind::Line || kind == Kind::Horocycle;
    packing.horocycleFaces.push_back(kind == Kind::Horocycle);
    Append(isInfinite ? infinity : this->RadiusOf(m_Face[face]), packing.faceRadii, packing.faceRests);
  }
  return packing;
}
} // namespace shapeton

#endif
