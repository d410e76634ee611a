#include "itkRicciEnergy.h"

#include "itkParallelFor.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace itk
{
namespace
{
constexpr double pi = 3.14159265358979323846;
/** What is missing in the double pi. The fixed circle has the sum of all curvatures, in which a bias would count. */
constexpr double restOfPi = 1.2246467991473532e-16;
/** tanh(r / 2) at the start in hyperbolic geometry. */
const double startingLog = std::log(std::tanh(0.25));

template <typename TKind>
bool
Flag(const std::vector<TKind> & flags, int i)
{
  return !flags.empty() && flags[i];
}
} // namespace

RicciEnergy::RicciEnergy(const CombinatorialMap & map, FlowGeometry geometry, const CirclesAtInfinity & infinite)
  : m_Map(map)
  , m_Geometry(geometry)
  , m_NodeKind(map.Nodes(), Kind::Unknown)
  , m_FaceKind(map.Faces(), Kind::Unknown)
  , m_NodeUnknown(map.Nodes(), -1)
  , m_FaceUnknown(map.Faces(), -1)
  , m_Node(map.Nodes())
  , m_Face(map.Faces())
  , m_KiteDiagonal(map.HalfEdges())
  , m_KiteElement(map.HalfEdges())
{
  this->FindKinds(infinite);
  this->NumberUnknowns();
  this->BuildPattern();
  m_Gradient.resize(m_Unknowns);
}

void
RicciEnergy::FindKinds(const CirclesAtInfinity & infinite)
{
  for (int node = 0; node < m_Map.Nodes(); ++node)
  {
    m_NodeKind[node] = Flag(infinite.lineNodes, node) ? Kind::Line : Kind::Unknown;
  }
  const std::vector<int> lengths = m_Map.FaceLengths();
  for (int face = 0; face < m_Map.Faces(); ++face)
  {
    bool isEliminated = lengths[face] == 3;
    int  h = m_Map.FirstOfFace(face);
    for (int i = 0; isEliminated && i < 3; ++i, h = m_Map.FaceNext(h))
    {
      isEliminated = m_NodeKind[m_Map.Node(h)] != Kind::Line;
    }
    m_FaceKind[face] = isEliminated ? Kind::Eliminated : Kind::Unknown;
    if (Flag(infinite.lineFaces, face))
    {
      m_FaceKind[face] = Kind::Line;
    }
    if (Flag(infinite.horocycleFaces, face))
    {
      m_FaceKind[face] = Kind::Horocycle;
    }
  }
  if (m_Geometry == FlowGeometry::Euclidean) // only ratios of radii count
  {
    const std::vector<int> degrees = m_Map.Degrees();
    int                    fixed = -1;
    for (int node = 0; node < m_Map.Nodes(); ++node)
    {
      if (m_NodeKind[node] == Kind::Unknown && (fixed < 0 || degrees[node] > degrees[fixed]))
      {
        fixed = node;
      }
    }
    if (fixed >= 0)
    {
      m_NodeKind[fixed] = Kind::Fixed;
    }
  }
}

void
RicciEnergy::NumberUnknowns()
{
  for (int node = 0; node < m_Map.Nodes(); ++node)
  {
    if (m_NodeKind[node] == Kind::Unknown)
    {
      m_NodeUnknown[node] = m_Unknowns++;
    }
  }
  for (int face = 0; face < m_Map.Faces(); ++face)
  {
    if (m_FaceKind[face] == Kind::Unknown)
    {
      m_FaceUnknown[face] = m_Unknowns++;
    }
  }
}

void
RicciEnergy::BuildPattern()
{
  for (int edge = 0; edge < m_Map.Edges(); ++edge)
  {
    const std::array<int, 2> ends{ m_NodeUnknown[m_Map.Node(2 * edge)], m_NodeUnknown[m_Map.Node(2 * edge + 1)] };
    if (ends[0] >= 0 && ends[1] >= 0 &&
        (this->IsEliminated(m_Map.Face(2 * edge)) || this->IsEliminated(m_Map.Face(2 * edge + 1))))
    {
      m_Pattern.push_back(ends);
      m_Source.push_back(edge);
    }
  }
  m_EdgeElements = m_Pattern.size();
  for (int h = 0; h < m_Map.HalfEdges(); ++h)
  {
    const std::array<int, 2> ends{ m_NodeUnknown[m_Map.Node(h)], m_FaceUnknown[m_Map.Face(h)] };
    if (ends[0] >= 0 && ends[1] >= 0)
    {
      m_Pattern.push_back(ends);
      m_Source.push_back(h);
    }
  }
}

std::vector<double>
RicciEnergy::StartingPoint() const
{
  return std::vector<double>(m_Unknowns, m_Geometry == FlowGeometry::Euclidean ? 0.0 : startingLog);
}

CircleSize
RicciEnergy::SizeOf(double u) const
{
  const double t = std::exp(u);
  if (m_Geometry == FlowGeometry::Euclidean)
  {
    return { t, 1.0 };
  }
  const double d = -std::expm1(2.0 * u); // 1 - t^2
  return { 2.0 * t / d, (1.0 + t * t) / d };
}

double
RicciEnergy::RadiusOf(const CircleSize & size) const
{
  return m_Geometry == FlowGeometry::Euclidean ? size.sinh : std::asinh(size.sinh);
}

/** The circle orthogonal to three that touch one another. */
CircleSize
RicciEnergy::SizeOfEliminated(int face) const
{
  const int          h = m_Map.FirstOfFace(face);
  const int          next = m_Map.FaceNext(h);
  const CircleSize & a = m_Node[m_Map.Node(h)];
  const CircleSize & b = m_Node[m_Map.Node(next)];
  const CircleSize & c = m_Node[m_Map.Node(m_Map.FaceNext(next))];
  const double       sum = a.sinh * b.cosh * c.cosh + a.cosh * b.sinh * c.cosh + a.cosh * b.cosh * c.sinh;
  if (m_Geometry == FlowGeometry::Euclidean)
  {
    return { std::sqrt(a.sinh / sum * b.sinh * c.sinh), 1.0 };
  }
  // tanh^2 r = p / (sum + p), cosh^2 r = 1 + p / sum
  const double ratio = a.sinh / sum * b.sinh * c.sinh;
  return { std::sqrt(ratio), std::sqrt(1.0 + ratio) };
}

double
RicciEnergy::CurvatureOfNode(int node) const
{
  double    angles = 0.0;
  const int first = m_Map.FirstAround(node);
  int       h = first;
  do
  {
    const int face = m_Map.Face(h);
    angles +=
      m_FaceKind[face] == Kind::Line ? 0.5 * pi : std::atan2(m_Face[face].sinh, m_Node[node].sinh * m_Face[face].cosh);
    h = m_Map.NextAround(h);
  } while (h != first);
  return 2.0 * ((pi - angles) + restOfPi);
}

double
RicciEnergy::CurvatureOfFace(int face) const
{
  double    angles = 0.0;
  const int first = m_Map.FirstOfFace(face);
  int       h = first;
  do
  {
    const int node = m_Map.Node(h);
    angles +=
      m_NodeKind[node] == Kind::Line ? 0.5 * pi : std::atan2(m_Node[node].sinh, m_Face[face].sinh * m_Node[node].cosh);
    h = m_Map.FaceNext(h);
  } while (h != first);
  return 2.0 * ((pi - angles) + restOfPi);
}

void
RicciEnergy::Evaluate(const std::vector<double> & u)
{
  ParallelForBlocks(m_Map.Nodes(), [&](std::size_t node) {
    const int i = m_NodeUnknown[node];
    m_Node[node] = i >= 0 ? this->SizeOf(u[i]) : CircleSize{ 1.0, 1.0 };
  });
  ParallelForBlocks(m_Map.Faces(), [&](std::size_t face) {
    const int i = m_FaceUnknown[face];
    if (this->IsEliminated(static_cast<int>(face)))
    {
      m_Face[face] = this->SizeOfEliminated(static_cast<int>(face));
    }
    else
    {
      m_Face[face] = i >= 0 ? this->SizeOf(u[i]) : CircleSize{ 1.0, 1.0 }; // a horocycle: tanh r = 1
    }
  });
  ParallelForBlocks(m_Map.Nodes(), [&](std::size_t node) {
    if (m_NodeUnknown[node] >= 0)
    {
      m_Gradient[m_NodeUnknown[node]] = this->CurvatureOfNode(static_cast<int>(node));
    }
  });
  ParallelForBlocks(m_Map.Faces(), [&](std::size_t face) {
    if (m_FaceUnknown[face] >= 0)
    {
      m_Gradient[m_FaceUnknown[face]] = this->CurvatureOfFace(static_cast<int>(face));
    }
  });
}

double
RicciEnergy::Residual() const
{
  double largest = 0.0;
  for (const double k : m_Gradient)
  {
    largest = std::abs(k) <= largest ? largest : std::abs(k); // keeps what is no number
  }
  return largest;
}

void
RicciEnergy::KitesOfFace(int face)
{
  const Kind         kind = m_FaceKind[face];
  const CircleSize & f = m_Face[face];
  const int          first = m_Map.FirstOfFace(face);
  int                h = first;
  do
  {
    const CircleSize & v = m_Node[m_Map.Node(h)];
    m_KiteElement[h] = 0.0;
    m_KiteDiagonal[h] = 0.0;
    if (kind == Kind::Horocycle)
    {
      m_KiteDiagonal[h] = 2.0 * v.sinh / v.cosh;
    }
    else if (kind != Kind::Line && m_NodeKind[m_Map.Node(h)] != Kind::Line)
    {
      m_KiteElement[h] = -2.0 * v.sinh * f.sinh / (v.sinh * v.sinh * f.cosh * f.cosh + f.sinh * f.sinh);
      m_KiteDiagonal[h] = -m_KiteElement[h] * v.cosh * f.cosh;
    }
    h = m_Map.FaceNext(h);
  } while (h != first);
}

/** What is left of the kites of a triangle when its face is eliminated from the Hessian (Schur's complement). */
void
RicciEnergy::KitesOfEliminated(int face)
{
  const CircleSize &    f = m_Face[face];
  std::array<int, 3>    h{};
  std::array<double, 3> element{};
  std::array<double, 3> diagonal{};
  std::array<double, 3> excess{}; // diagonal^2 - element^2
  h[0] = m_Map.FirstOfFace(face);
  h[1] = m_Map.FaceNext(h[0]);
  h[2] = m_Map.FaceNext(h[1]);
  for (int k = 0; k < 3; ++k)
  {
    const CircleSize & v = m_Node[m_Map.Node(h[k])];
    const double       w = v.sinh * v.sinh * f.cosh * f.cosh + f.sinh * f.sinh;
    element[k] = 2.0 * v.sinh * f.sinh / w;
    diagonal[k] = element[k] * v.cosh * f.cosh;
    excess[k] = m_Geometry == FlowGeometry::Euclidean ? 0.0 : element[k] * element[k] * w;
  }
  const double sum = diagonal[0] + diagonal[1] + diagonal[2];
  for (int k = 0; k < 3; ++k)
  {
    const int next = (k + 1) % 3;
    m_KiteElement[h[k]] = -element[k] * element[next] / sum;
    m_KiteDiagonal[h[k]] = (diagonal[k] * (diagonal[next] + diagonal[(k + 2) % 3]) + excess[k]) / sum;
  }
}

void
RicciEnergy::GatherDiagonal(std::vector<double> & diagonal) const
{
  ParallelForBlocks(m_Map.Nodes(), [&](std::size_t node) {
    if (m_NodeUnknown[node] < 0)
    {
      return;
    }
    double    sum = 0.0;
    const int first = m_Map.FirstAround(static_cast<int>(node));
    int       h = first;
    do
    {
      sum += m_KiteDiagonal[h];
      h = m_Map.NextAround(h);
    } while (h != first);
    diagonal[m_NodeUnknown[node]] = sum;
  });
  ParallelForBlocks(m_Map.Faces(), [&](std::size_t face) {
    if (m_FaceUnknown[face] < 0)
    {
      return;
    }
    double    sum = 0.0;
    const int first = m_Map.FirstOfFace(static_cast<int>(face));
    int       h = first;
    do
    {
      sum += m_KiteDiagonal[h];
      h = m_Map.FaceNext(h);
    } while (h != first);
    diagonal[m_FaceUnknown[face]] = sum;
  });
}

void
RicciEnergy::Hessian(std::vector<double> & diagonal, std::vector<double> & offDiagonal)
{
  ParallelForBlocks(m_Map.Faces(), [&](std::size_t face) {
    if (this->IsEliminated(static_cast<int>(face)))
    {
      this->KitesOfEliminated(static_cast<int>(face));
    }
    else
    {
      this->KitesOfFace(static_cast<int>(face));
    }
  });
  diagonal.assign(m_Unknowns, 0.0);
  this->GatherDiagonal(diagonal);
  offDiagonal.resize(m_Pattern.size());
  ParallelForBlocks(m_Pattern.size(), [&](std::size_t i) {
    if (i >= m_EdgeElements)
    {
      offDiagonal[i] = m_KiteElement[m_Source[i]];
      return;
    }
    const int h = 2 * m_Source[i];
    offDiagonal[i] = (this->IsEliminated(m_Map.Face(h)) ? m_KiteElement[h] : 0.0) +
                     (this->IsEliminated(m_Map.Face(h + 1)) ? m_KiteElement[h + 1] : 0.0);
  });
}

CirclePacking
RicciEnergy::Packing() const
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  CirclePacking    packing;
  packing.geometry = m_Geometry;
  packing.nodeRadii.resize(m_Map.Nodes());
  packing.faceRadii.resize(m_Map.Faces());
  packing.horocycleFaces.resize(m_Map.Faces());
  for (int node = 0; node < m_Map.Nodes(); ++node)
  {
    packing.nodeRadii[node] = m_NodeKind[node] == Kind::Line ? infinity : this->RadiusOf(m_Node[node]);
  }
  for (int face = 0; face < m_Map.Faces(); ++face)
  {
    const Kind kind = m_FaceKind[face];
    packing.horocycleFaces[face] = kind == Kind::Horocycle;
    packing.faceRadii[face] = kind == Kind::Line || kind == Kind::Horocycle ? infinity : this->RadiusOf(m_Face[face]);
  }
  return packing;
}
} // namespace itk
