#include "shapetonFanWalk.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace shapeton
{
namespace
{
bool
IsDegenerate(const FaceMatrix & F, int f)
{
  return F(f, 0) == F(f, 1) || F(f, 1) == F(f, 2) || F(f, 2) == F(f, 0);
}

void
RequireIndices(const FaceMatrix & F, int numberOfVertices)
{
  for (Eigen::Index i = 0; i < F.size(); ++i)
  {
    if (F.data()[i] < 0 || F.data()[i] >= numberOfVertices)
    {
      throw std::out_of_range("SurfaceConnectivity: face " + std::to_string(i / 3) + " names vertex " +
                              std::to_string(F.data()[i]) + " of " + std::to_string(numberOfVertices));
    }
  }
}

/** Turns counts of each bucket, which stand one place too far, into the beginnings of the buckets. */
void
Accumulate(std::vector<int> & counts)
{
  for (std::size_t i = 1; i < counts.size(); ++i)
  {
    counts[i] += counts[i - 1];
  }
}
} // namespace

SurfaceConnectivity::SurfaceConnectivity(const FaceMatrix & F, int numberOfVertices)
  : m_Faces(F), m_NumberOfVertices(numberOfVertices)
{
  RequireIndices(F, numberOfVertices);
  this->BuildVertexFaces();
  this->BuildEdges();
  this->BuildComponents();
  this->BuildLoops();
  this->CountComponents();
}

SurfaceConnectivity::SurfaceConnectivity(const SurfaceMesh & mesh)
  : SurfaceConnectivity(mesh.F, mesh.NumberOfVertices())
{}

SurfaceConnectivity::~SurfaceConnectivity() = default;

void
SurfaceConnectivity::BuildVertexFaces()
{
  m_VertexBegin.assign(m_NumberOfVertices + 1, 0);
  for (int f = 0; f < this->NumberOfFaces(); ++f)
  {
    for (int k = 0; k < 3 && !IsDegenerate(m_Faces, f); ++k)
    {
      ++m_VertexBegin[m_Faces(f, k) + 1];
    }
  }
  Accumulate(m_VertexBegin);
  m_VertexFaces.resize(m_VertexBegin.back());
  std::vector<int> next(m_VertexBegin.begin(), m_VertexBegin.end() - 1);
  for (int f = 0; f < this->NumberOfFaces(); ++f)
  {
    for (int k = 0; k < 3 && !IsDegenerate(m_Faces, f); ++k)
    {
      m_VertexFaces[next[m_Faces(f, k)]++] = f;
    }
  }
}

void
SurfaceConnectivity::BuildEdges()
{
  struct Side
  {
    int other, face, k;
  };
  std::vector<Side> sides; // those of one vertex, towards greater vertices
  m_FaceEdges.assign(3 * m_Faces.rows(), -1);
  m_FirstEdgeOfVertex.assign(m_NumberOfVertices + 1, 0);
  m_EdgeBegin.assign(1, 0);
  for (int v = 0; v < m_NumberOfVertices; ++v)
  {
    sides.clear();
    for (const int f : this->FacesOfVertex(v))
    {
      for (int k = 0; k < 3; ++k)
      {
        const int a = m_Faces(f, k);
        const int b = m_Faces(f, (k + 1) % 3);
        if (std::min(a, b) == v)
        {
          sides.push_back({ std::max(a, b), f, k });
        }
      }
    }
    std::stable_sort(sides.begin(), sides.end(), [](const Side & p, const Side & q) { return p.other < q.other; });
    for (std::size_t i = 0; i < sides.size(); ++i)
    {
      if (i == 0 || sides[i].other != sides[i - 1].other)
      {
        m_EdgeVertices.push_back({ v, sides[i].other });
        m_EdgeBegin.push_back(m_EdgeBegin.back());
      }
      m_EdgeFaces.push_back(sides[i].face);
      ++m_EdgeBegin.back();
      m_FaceEdges[3 * sides[i].face + sides[i].k] = this->NumberOfEdges() - 1;
    }
    m_FirstEdgeOfVertex[v + 1] = this->NumberOfEdges();
  }
}

int
SurfaceConnectivity::FindEdge(int a, int b) const
{
  if (a > b)
  {
    std::swap(a, b);
  }
  const auto begin = m_EdgeVertices.begin() + m_FirstEdgeOfVertex[a];
  const auto end = m_EdgeVertices.begin() + m_FirstEdgeOfVertex[a + 1];
  const auto found = std::lower_bound(begin, end, std::array<int, 2>{ a, b });
  return found != end && (*found)[1] == b ? static_cast<int>(found - m_EdgeVertices.begin()) : -1;
}

bool
SurfaceConnectivity::RunsForward(int face, int edge) const
{
  const auto [a, b] = m_EdgeVertices[edge];
  for (int k = 0; k < 3; ++k)
  {
    if (m_Faces(face, k) == a)
    {
      return m_Faces(face, (k + 1) % 3) == b;
    }
  }
  return false;
}

bool
SurfaceConnectivity::IsInconsistentEdge(int edge) const
{
  const IndexRange faces = this->FacesOfEdge(edge);
  return faces.size() == 2 && this->RunsForward(faces[0], edge) == this->RunsForward(faces[1], edge);
}

std::vector<int>
SurfaceConnectivity::NeighboursOfVertex(int vertex) const
{
  std::vector<int> neighbours;
  for (const int f : this->FacesOfVertex(vertex))
  {
    for (int k = 0; k < 3; ++k)
    {
      if (m_Faces(f, k) != vertex)
      {
        neighbours.push_back(m_Faces(f, k));
      }
    }
  }
  std::sort(neighbours.begin(), neighbours.end());
  neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
  return neighbours;
}

bool
SurfaceConnectivity::IsBoundaryVertex(int vertex) const
{
  for (const int f : this->FacesOfVertex(vertex))
  {
    for (int k = 0; k < 3; ++k)
    {
      const auto & ends = m_EdgeVertices[m_FaceEdges[3 * f + k]];
      if ((ends[0] == vertex || ends[1] == vertex) && this->IsBoundaryEdge(m_FaceEdges[3 * f + k]))
      {
        return true;
      }
    }
  }
  return false;
}

std::vector<int>
SurfaceConnectivity::FanOfFaces(int vertex, bool throughManifoldEdges) const
{
  const IndexRange faces = this->FacesOfVertex(vertex);
  std::vector<int> fan(faces.size(), -1);
  std::vector<int> open;
  int              fans = 0;
  for (int i = 0; i < faces.size(); ++i)
  {
    if (fan[i] >= 0)
    {
      continue;
    }
    fan[i] = fans;
    open.assign(1, faces[i]);
    while (!open.empty())
    {
      const int f = open.back();
      open.pop_back();
      for (int k = 0; k < 3; ++k)
      {
        const IndexRange sides = this->FacesOfEdge(m_FaceEdges[3 * f + k]);
        const bool       isOpposite = m_Faces(f, k) != vertex && m_Faces(f, (k + 1) % 3) != vertex;
        if (isOpposite || (throughManifoldEdges && sides.size() > 2))
        {
          continue;
        }
        for (const int g : sides)
        {
          const auto place = std::lower_bound(faces.begin(), faces.end(), g) - faces.begin();
          if (fan[place] < 0)
          {
            fan[place] = fans;
            open.push_back(g);
          }
        }
      }
    }
    ++fans;
  }
  return fan;
}

int
SurfaceConnectivity::FansOfVertex(int vertex) const
{
  if (IsOneFan(*this, m_Faces, vertex))
  {
    return 1;
  }
  const std::vector<int> fan = this->FanOfFaces(vertex);
  return fan.empty() ? 0 : *std::max_element(fan.begin(), fan.end()) + 1;
}

bool
SurfaceConnectivity::IsNonManifoldVertex(int vertex) const
{
  if (this->FansOfVertex(vertex) > 1)
  {
    return true;
  }
  for (const int f : this->FacesOfVertex(vertex))
  {
    for (int k = 0; k < 3; ++k)
    {
      const auto & ends = m_EdgeVertices[m_FaceEdges[3 * f + k]];
      if ((ends[0] == vertex || ends[1] == vertex) && this->IsNonManifoldEdge(m_FaceEdges[3 * f + k]))
      {
        return true;
      }
    }
  }
  return false;
}

bool
SurfaceConnectivity::IsManifold() const
{
  for (int e = 0; e < this->NumberOfEdges(); ++e)
  {
    if (this->IsNonManifoldEdge(e))
    {
      return false;
    }
  }
  for (int v = 0; v < m_NumberOfVertices; ++v)
  {
    if (this->FansOfVertex(v) > 1)
    {
      return false;
    }
  }
  return true;
}

bool
SurfaceConnectivity::IsClosed() const
{
  return m_Loops.empty() && !m_Components.empty() && this->IsManifold();
}

bool
SurfaceConnectivity::IsOriented() const
{
  for (int e = 0; e < this->NumberOfEdges(); ++e)
  {
    if (this->IsInconsistentEdge(e))
    {
      return false;
    }
  }
  return true;
}
} // namespace shapeton
