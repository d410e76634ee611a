#include "shapetonRicciEnergy.h"

namespace shapeton
{
namespace
{
/** 2 sinh a sinh b / (cosh^2 a cosh^2 b - 1), without overflow. \equation{6.7} without its sign, doubled for the two
 * triangles of a kite. */
double
KiteElement(const CircleSize<double> & a, const CircleSize<double> & b)
{
  return 2.0 / (a.sinh * b.cosh * (b.cosh / b.sinh) + b.sinh / a.sinh);
}
} // namespace

RicciEnergy::RicciEnergy(const RicciUnknowns & unknowns)
  : m_Unknowns(unknowns)
  , m_Map(unknowns.map)
  , m_State(unknowns)
  , m_KiteDiagonal(unknowns.map.HalfEdges())
  , m_KiteElement(unknowns.map.HalfEdges())
{
  this->BuildPattern();
}

void
RicciEnergy::BuildPattern()
{
  for (int edge = 0; edge < m_Map.Edges(); ++edge)
  {
    const std::array<int, 2> ends{ m_Unknowns.ofNode[m_Map.Node(2 * edge)],
                                   m_Unknowns.ofNode[m_Map.Node(2 * edge + 1)] };
    if (ends[0] >= 0 && ends[1] >= 0 &&
        (m_Unknowns.IsEliminated(m_Map.Face(2 * edge)) || m_Unknowns.IsEliminated(m_Map.Face(2 * edge + 1))))
    {
      m_Pattern.push_back(ends);
      m_Source.push_back(edge);
    }
  }
  m_EdgeElements = m_Pattern.size();
  for (int h = 0; h < m_Map.HalfEdges(); ++h)
  {
    const std::array<int, 2> ends{ m_Unknowns.ofNode[m_Map.Node(h)], m_Unknowns.ofFace[m_Map.Face(h)] };
    if (ends[0] >= 0 && ends[1] >= 0)
    {
      m_Pattern.push_back(ends);
      m_Source.push_back(h);
    }
  }
}

/** \equation{6.8} doubled for the two triangles of a kite; with the sign of dK/du. */
void
RicciEnergy::KitesOfFace(int face)
{
  const RicciUnknowns::Kind  kind = m_Unknowns.faceKind[face];
  const CircleSize<double> & f = m_State.Face(face);
  const int                  first = m_Map.FirstOfFace(face);
  int                        h = first;
  do
  {
    const CircleSize<double> & v = m_State.Node(m_Map.Node(h));
    m_KiteElement[h] = 0.0;
    m_KiteDiagonal[h] = 0.0;
    if (kind == RicciUnknowns::Kind::Horocycle)
    {
      m_KiteDiagonal[h] = 2.0 * v.sinh / v.cosh;
    }
    else if (kind != RicciUnknowns::Kind::Line && m_Unknowns.nodeKind[m_Map.Node(h)] != RicciUnknowns::Kind::Line)
    {
      m_KiteElement[h] = -KiteElement(v, f);
      m_KiteDiagonal[h] = -m_KiteElement[h] * v.cosh * f.cosh;
    }
    h = m_Map.FaceNext(h);
  } while (h != first);
}

/** Schur complement of the kites of a triangle when its face is eliminated from the Hessian. */
void
RicciEnergy::KitesOfEliminated(int face)
{
  const CircleSize<double> & f = m_State.Face(face);
  std::array<int, 3>         h{};
  std::array<double, 3>      element{};
  std::array<double, 3>      diagonal{};
  std::array<double, 3>      excess{}; // diagonal^2 - element^2
  h[0] = m_Map.FirstOfFace(face);
  h[1] = m_Map.FaceNext(h[0]);
  h[2] = m_Map.FaceNext(h[1]);
  for (int k = 0; k < 3; ++k)
  {
    const CircleSize<double> & v = m_State.Node(m_Map.Node(h[k]));
    const double               w = v.sinh * v.sinh * f.cosh * f.cosh + f.sinh * f.sinh;
    element[k] = 2.0 * v.sinh * f.sinh / w;
    diagonal[k] = element[k] * v.cosh * f.cosh;
    excess[k] = m_Unknowns.geometry == FlowGeometry::Euclidean ? 0.0 : 2.0 * element[k] * v.sinh * f.sinh;
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
    if (m_Unknowns.ofNode[node] < 0)
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
    diagonal[m_Unknowns.ofNode[node]] = sum;
  });
  ParallelForBlocks(m_Map.Faces(), [&](std::size_t face) {
    if (m_Unknowns.ofFace[face] < 0)
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
    diagonal[m_Unknowns.ofFace[face]] = sum;
  });
}

void
RicciEnergy::Hessian(std::vector<double> & diagonal, std::vector<double> & offDiagonal)
{
  ParallelForBlocks(m_Map.Faces(), [&](std::size_t face) {
    if (m_Unknowns.IsEliminated(static_cast<int>(face)))
    {
      this->KitesOfEliminated(static_cast<int>(face));
    }
    else
    {
      this->KitesOfFace(static_cast<int>(face));
    }
  });
  diagonal.assign(m_Unknowns.number, 0.0);
  this->GatherDiagonal(diagonal);
  offDiagonal.resize(m_Source.size());
  ParallelForBlocks(m_Source.size(), [&](std::size_t i) {
    if (i >= m_EdgeElements)
    {
      offDiagonal[i] = m_KiteElement[m_Source[i]];
      return;
    }
    const int h = 2 * m_Source[i];
    offDiagonal[i] = (m_Unknowns.IsEliminated(m_Map.Face(h)) ? m_KiteElement[h] : 0.0) +
                     (m_Unknowns.IsEliminated(m_Map.Face(h + 1)) ? m_KiteElement[h + 1] : 0.0);
  });
}
} // namespace shapeton
