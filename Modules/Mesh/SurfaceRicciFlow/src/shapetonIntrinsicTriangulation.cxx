#include "shapetonIntrinsicTriangulation.h"

namespace shapeton
{
IntrinsicTriangulation::IntrinsicTriangulation(const FaceMatrix & F, const SurfaceConnectivity & connectivity)
  : m_NumberOfVertices(connectivity.NumberOfVertices())
  , m_Origins(F.data(), F.data() + F.size())
  , m_Twins(F.size(), -1)
  , m_Edges(F.size())
  , m_SideOfEdge(connectivity.NumberOfEdges(), -1)
{
  for (int side = 0; side < this->NumberOfSides(); ++side)
  {
    const int edge = connectivity.EdgeOfFace(side / 3, side % 3);
    m_Edges[side] = edge;
    int & first = m_SideOfEdge[edge];
    if (first == -1)
    {
      first = side;
    }
    else
    {
      m_Twins[first] = side;
      m_Twins[side] = first;
    }
  }
}

IntrinsicTriangulation
IntrinsicTriangulation::Double(const FaceMatrix & F, const SurfaceConnectivity & connectivity)
{
  IntrinsicTriangulation result(F, connectivity);
  const int              sides = result.NumberOfSides();
  std::vector<int>       copyOfVertex(result.m_NumberOfVertices);
  for (int v = 0; v < connectivity.NumberOfVertices(); ++v)
  {
    copyOfVertex[v] = connectivity.IsBoundaryVertex(v) ? v : result.m_NumberOfVertices++;
  }
  std::vector<int> copyOfEdge(connectivity.NumberOfEdges());
  for (int e = 0; e < connectivity.NumberOfEdges(); ++e)
  {
    copyOfEdge[e] = e;
    if (!connectivity.IsBoundaryEdge(e))
    {
      copyOfEdge[e] = result.NumberOfEdges();
      result.m_SideOfEdge.push_back(-1);
    }
  }
  const auto mirror = [sides](int side) { return sides + side - side % 3 + 2 - side % 3; };
  result.m_Origins.resize(2 * sides);
  result.m_Twins.resize(2 * sides);
  result.m_Edges.resize(2 * sides);
  for (int side = 0; side < sides; ++side)
  {
    const int copy = mirror(side);
    const int edge = copyOfEdge[result.m_Edges[side]];
    result.m_Origins[copy] = copyOfVertex[result.m_Origins[Next(side)]];
    result.m_Edges[copy] = edge;
    result.m_SideOfEdge[edge] = result.m_SideOfEdge[edge] == -1 ? copy : result.m_SideOfEdge[edge];
    const int twin = result.m_Twins[side];
    result.m_Twins[copy] = twin == -1 ? side : mirror(twin);
    result.m_Twins[side] = twin == -1 ? copy : twin;
  }
  return result;
}

FaceMatrix
IntrinsicTriangulation::Faces() const
{
  return Eigen::Map<const FaceMatrix>(m_Origins.data(), this->NumberOfFaces(), 3);
}

void
IntrinsicTriangulation::Move(const std::array<int, 4> & from, const std::array<int, 4> & to)
{
  std::array<int, 4> twins{}, edges{};
  for (int i = 0; i < 4; ++i)
  {
    edges[i] = m_Edges[from[i]];
    twins[i] = m_Twins[from[i]];
    for (int j = 0; j < 4; ++j) // two of the four sides may be glued together
    {
      if (m_Twins[from[i]] == from[j])
      {
        twins[i] = to[j];
      }
    }
  }
  for (int i = 0; i < 4; ++i)
  {
    m_Edges[to[i]] = edges[i];
    m_SideOfEdge[edges[i]] = to[i];
    m_Twins[to[i]] = twins[i];
    if (twins[i] != -1)
    {
      m_Twins[twins[i]] = to[i];
    }
  }
}

void
IntrinsicTriangulation::Flip(int side)
{
  const int s = side, s1 = Next(s), s2 = Previous(s);
  const int t = m_Twins[side], t1 = Next(t), t2 = Previous(t);
  const int a = m_Origins[s], b = m_Origins[t], c = m_Origins[s2], d = m_Origins[t2];
  this->Move({ s1, s2, t1, t2 }, { t2, s1, s2, t1 });
  m_Origins[s] = d;
  m_Origins[s1] = c;
  m_Origins[s2] = a;
  m_Origins[t] = c;
  m_Origins[t1] = d;
  m_Origins[t2] = b;
}

void
IntrinsicTriangulation::FlipBack(int side)
{
  const int s = side, s1 = Next(s), s2 = Previous(s);
  const int t = m_Twins[side], t1 = Next(t), t2 = Previous(t);
  const int d = m_Origins[s], c = m_Origins[s1], a = m_Origins[s2], b = m_Origins[t2];
  this->Move({ t2, s1, s2, t1 }, { s1, s2, t1, t2 });
  m_Origins[s] = a;
  m_Origins[s1] = b;
  m_Origins[s2] = c;
  m_Origins[t] = b;
  m_Origins[t1] = a;
  m_Origins[t2] = d;
}

IntrinsicTriangulation
IntrinsicTriangulation::WithoutStar(int vertex, std::vector<int> & keptFaces, std::vector<int> & keptEdges) const
{
  IntrinsicTriangulation result;
  result.m_NumberOfVertices = m_NumberOfVertices;
  std::vector<int> place(m_Origins.size(), -1), placeOfEdge(m_SideOfEdge.size(), -1);
  keptFaces.clear();
  keptEdges.clear();
  for (int f = 0; f < this->NumberOfFaces(); ++f)
  {
    if (m_Origins[3 * f] != vertex && m_Origins[3 * f + 1] != vertex && m_Origins[3 * f + 2] != vertex)
    {
      for (int k = 0; k < 3; ++k)
      {
        place[3 * f + k] = static_cast<int>(3 * keptFaces.size()) + k;
        placeOfEdge[m_Edges[3 * f + k]] = 0;
      }
      keptFaces.push_back(f);
    }
  }
  for (int e = 0; e < this->NumberOfEdges(); ++e)
  {
    if (placeOfEdge[e] == 0)
    {
      placeOfEdge[e] = static_cast<int>(keptEdges.size());
      keptEdges.push_back(e);
    }
  }
  result.m_SideOfEdge.resize(keptEdges.size());
  for (const int f : keptFaces)
  {
    for (int side = 3 * f; side < 3 * f + 3; ++side)
    {
      result.m_Origins.push_back(m_Origins[side]);
      result.m_Twins.push_back(m_Twins[side] == -1 ? -1 : place[m_Twins[side]]);
      result.m_Edges.push_back(placeOfEdge[m_Edges[side]]);
      result.m_SideOfEdge[placeOfEdge[m_Edges[side]]] = place[side];
    }
  }
  return result;
}
} // namespace shapeton
