#include "shapetonFanWalk.h"
#include "shapetonInterruption.h"
#include "shapetonParallelFor.h"

#include <algorithm>
#include <atomic>
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
      throw std::out_of_range("SurfaceConnectivity: face " + std::to_string(i / 3) + " refers to vertex " +
                              std::to_string(F.data()[i]) + " of " + std::to_string(numberOfVertices));
    }
  }
}

/** Converts bucket counts, each stored one position later, to bucket starts. */
void
Accumulate(std::vector<int> & counts)
{
  for (std::size_t i = 1; i < counts.size(); ++i)
  {
    counts[i] += counts[i - 1];
  }
}

constexpr int VerticesOfBlock = 8192; // of a parallel task; chosen

/** A side of a face, from its lower vertex to the other one; corner k is its start or end. */
struct Side
{
  int vertex, other, face, k;
};

/** Sorted by vertices, then by face. */
std::vector<Side>
SidesOfBlock(const SurfaceConnectivity & connectivity, const FaceMatrix & F, int block)
{
  const int             last = std::min(connectivity.NumberOfVertices(), (block + 1) * VerticesOfBlock);
  std::vector<Side>     sides;
  constexpr std::size_t sidesOfVertex = 7; // at most six on average
  sides.reserve(sidesOfVertex * VerticesOfBlock);
  for (int v = block * VerticesOfBlock; v < last; ++v)
  {
    const auto first = static_cast<std::ptrdiff_t>(sides.size());
    for (const int f : connectivity.FacesOfVertex(v))
    {
      for (int k = 0; k < 3; ++k)
      {
        const int a = F(f, k);
        const int b = F(f, (k + 1) % 3);
        if (std::min(a, b) == v)
        {
          sides.push_back({ v, std::max(a, b), f, k });
        }
      }
    }
    std::sort(sides.begin() + first, sides.end(), [](const Side & p, const Side & q) {
      return p.other != q.other ? p.other < q.other : p.face < q.face;
    });
  }
  return sides;
}

bool
BeginsEdge(const std::vector<Side> & sides, std::size_t i)
{
  return i == 0 || sides[i].vertex != sides[i - 1].vertex || sides[i].other != sides[i - 1].other;
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
  Interruption::Check();
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

// Vertex blocks find their edges in parallel, which determines the first edge number of each block.
void
SurfaceConnectivity::BuildEdges()
{
  const int                      blocks = (m_NumberOfVertices + VerticesOfBlock - 1) / VerticesOfBlock;
  std::vector<std::vector<Side>> sides(blocks);
  std::vector<int>               firstEdge(blocks + 1, 0);
  std::vector<int>               firstSide(blocks + 1, 0);
  ParallelFor(blocks, [&](std::size_t block) {
    sides[block] = SidesOfBlock(*this, m_Faces, static_cast<int>(block));
    firstSide[block + 1] = static_cast<int>(sides[block].size());
    for (std::size_t i = 0; i < sides[block].size(); ++i)
    {
      firstEdge[block + 1] += BeginsEdge(sides[block], i) ? 1 : 0;
    }
  });
  Accumulate(firstEdge);
  Accumulate(firstSide);
  m_FaceEdges.assign(3 * m_Faces.rows(), -1);
  m_FirstEdgeOfVertex.assign(m_NumberOfVertices + 1, 0);
  m_EdgeVertices.resize(firstEdge.back());
  m_EdgeBegin.assign(firstEdge.back() + 1, 0);
  m_EdgeFaces.resize(firstSide.back());
  ParallelFor(blocks, [&](std::size_t block) {
    const std::vector<Side> & ofBlock = sides[block];
    int                       edge = firstEdge[block] - 1;
    for (std::size_t i = 0; i < ofBlock.size(); ++i)
    {
      const Side & side = ofBlock[i];
      const int    place = firstSide[block] + static_cast<int>(i);
      edge += BeginsEdge(ofBlock, i) ? 1 : 0;
      m_EdgeVertices[edge] = { side.vertex, side.other };
      m_EdgeBegin[edge + 1] = place + 1;
      m_EdgeFaces[place] = side.face;
      m_FaceEdges[3 * side.face + side.k] = edge;
      m_FirstEdgeOfVertex[side.vertex + 1] = edge + 1;
    }
  });
  for (int v = 0; v < m_NumberOfVertices; ++v) // vertices that are not the lower vertex of any edge
  {
    m_FirstEdgeOfVertex[v + 1] = std::max(m_FirstEdgeOfVertex[v + 1], m_FirstEdgeOfVertex[v]);
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
SurfaceConnectivity::NeighborsOfVertex(int vertex) const
{
  std::vector<int> neighbors;
  for (const int f : this->FacesOfVertex(vertex))
  {
    for (int k = 0; k < 3; ++k)
    {
      if (m_Faces(f, k) != vertex)
      {
        neighbors.push_back(m_Faces(f, k));
      }
    }
  }
  std::sort(neighbors.begin(), neighbors.end());
  neighbors.erase(std::unique(neighbors.begin(), neighbors.end()), neighbors.end());
  return neighbors;
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
  std::atomic<bool> isManifold{ true };
  ParallelForBlocks(m_EdgeVertices.size(), [&](std::size_t e) {
    if (this->IsNonManifoldEdge(static_cast<int>(e)))
    {
      isManifold = false;
    }
  });
  ParallelForBlocks(isManifold ? m_NumberOfVertices : 0, [&](std::size_t v) {
    if (this->FansOfVertex(static_cast<int>(v)) > 1)
    {
      isManifold = false;
    }
  });
  return isManifold;
}

bool
SurfaceConnectivity::IsClosed() const
{
  return m_Loops.empty() && !m_Components.empty() && this->IsManifold();
}

bool
SurfaceConnectivity::IsOriented() const
{
  std::atomic<bool> isOriented{ true };
  ParallelForBlocks(m_EdgeVertices.size(), [&](std::size_t e) {
    if (this->IsInconsistentEdge(static_cast<int>(e)))
    {
      isOriented = false;
    }
  });
  return isOriented;
}
} // namespace shapeton
