#include "shapetonSurfaceCut.h"

#include "shapetonExceptions.h"

#include <algorithm>

namespace shapeton
{
namespace
{
int
RequireEdge(const SurfaceConnectivity & connectivity, int a, int b)
{
  const bool exist = std::min(a, b) >= 0 && std::max(a, b) < connectivity.NumberOfVertices();
  const int  edge = exist ? connectivity.FindEdge(a, b) : -1;
  if (edge == -1)
  {
    throw InputError("the cut runs from vertex " + std::to_string(a) + " to vertex " + std::to_string(b) +
                     ", which no edge joins");
  }
  if (connectivity.IsNonManifoldEdge(edge) || connectivity.IsInconsistentEdge(edge) ||
      connectivity.FansOfVertex(a) != 1 || connectivity.FansOfVertex(b) != 1)
  {
    throw InputError("the surface is not manifold, or not oriented, at the cut near vertex " + std::to_string(a) +
                     "; repair the surface");
  }
  return edge;
}

int
CornerOfVertex(const FaceMatrix & F, int face, int vertex)
{
  return F(face, 0) == vertex ? 0 : F(face, 1) == vertex ? 1 : 2;
}

/** Steps around a vertex from face to face, counterclockwise or clockwise. */
class Fan
{
public:
  Fan(const FaceMatrix & F, const SurfaceConnectivity & connectivity, int vertex)
    : m_F(F), m_Connectivity(connectivity), m_Vertex(vertex)
  {}
  int
  Corner(int face) const
  {
    return CornerOfVertex(m_F, face, m_Vertex);
  }
  /** The edge at the start or end of the face, counterclockwise. */
  int
  FirstEdge(int face) const
  {
    return m_Connectivity.EdgeOfFace(face, this->Corner(face));
  }
  int
  LastEdge(int face) const
  {
    return m_Connectivity.EdgeOfFace(face, (this->Corner(face) + 2) % 3);
  }
  /** The face that starts, or ends, at this edge of the vertex; -1 at a boundary. */
  int
  FaceFrom(int edge) const
  {
    for (const int face : m_Connectivity.FacesOfEdge(edge))
    {
      if (this->FirstEdge(face) == edge)
      {
        return face;
      }
    }
    return -1;
  }
  int
  FaceTo(int edge) const
  {
    for (const int face : m_Connectivity.FacesOfEdge(edge))
    {
      if (this->LastEdge(face) == edge)
      {
        return face;
      }
    }
    return -1;
  }
  /** Corners from the edge `from` counterclockwise to the edge `to` or a boundary; reports if a boundary was reached.
   */
  bool
  Sweep(int from, int to, std::vector<int> & corners) const
  {
    for (int face = this->FaceFrom(from); face != -1; face = this->FaceFrom(this->LastEdge(face)))
    {
      corners.push_back(3 * face + this->Corner(face));
      if (this->LastEdge(face) == to || this->LastEdge(face) == from)
      {
        return false;
      }
    }
    return true;
  }
  /** Clockwise version of the above. */
  bool
  SweepBack(int from, int to, std::vector<int> & corners) const
  {
    for (int face = this->FaceTo(from); face != -1; face = this->FaceTo(this->FirstEdge(face)))
    {
      corners.push_back(3 * face + this->Corner(face));
      if (this->FirstEdge(face) == to || this->FirstEdge(face) == from)
      {
        return false;
      }
    }
    return true;
  }

private:
  const FaceMatrix &          m_F;
  const SurfaceConnectivity & m_Connectivity;
  int                         m_Vertex;
};

/** Corners left of a path at a vertex, given the incoming and outgoing edges; -1 at the path ends. */
std::vector<int>
LeftAtVertex(const Fan & fan, int entered, int left)
{
  std::vector<int> corners;
  if (left != -1 && !fan.Sweep(left, entered, corners))
  {
    return entered == -1 ? std::vector<int>{} : corners;
  }
  // The left side ends at a boundary, and may continue beyond it.
  if (entered != -1 && !fan.SweepBack(entered, left, corners))
  {
    return left == -1 ? std::vector<int>{} : corners;
  }
  return corners;
}

std::vector<int>
EdgesOfPath(const SurfaceConnectivity & connectivity, const std::vector<int> & path)
{
  std::vector<int> edges;
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
  {
    edges.push_back(RequireEdge(connectivity, path[i], path[i + 1]));
  }
  return edges;
}

/** Fan number of each face of a vertex if fans end at cut edges. */
std::vector<int>
FansBetweenCuts(const FaceMatrix &          F,
                const SurfaceConnectivity & connectivity,
                int                         vertex,
                const std::vector<char> &   isCut)
{
  const IndexRange faces = connectivity.FacesOfVertex(vertex);
  const Fan        around(F, connectivity, vertex);
  std::vector<int> fans(faces.size(), -1);
  int              number = 0;
  for (int i = 0; i < faces.size(); ++i)
  {
    if (fans[i] != -1)
    {
      continue;
    }
    std::vector<int> open{ faces[i] };
    while (!open.empty())
    {
      const int face = open.back();
      open.pop_back();
      int & fan = fans[std::find(faces.begin(), faces.end(), face) - faces.begin()];
      if (fan != -1)
      {
        continue;
      }
      fan = number;
      const int first = around.FirstEdge(face);
      const int last = around.LastEdge(face);
      const int before = isCut[first] ? -1 : around.FaceTo(first);
      const int after = isCut[last] ? -1 : around.FaceFrom(last);
      for (const int next : { before, after })
      {
        if (next != -1)
        {
          open.push_back(next);
        }
      }
    }
    ++number;
  }
  return fans;
}

void
AppendRows(SurfaceArray::ValueMatrix & values, const std::vector<int> & sources)
{
  const Eigen::Index before = values.rows();
  values.conservativeResize(static_cast<Eigen::Index>(sources.size()), Eigen::NoChange);
  for (Eigen::Index i = before; i < values.rows(); ++i)
  {
    values.row(i) = values.row(sources[i]).eval();
  }
}
} // namespace

std::vector<int>
LeftCorners(const FaceMatrix & F, const SurfaceConnectivity & connectivity, const std::vector<int> & vertexPath)
{
  const std::vector<int> edges = EdgesOfPath(connectivity, vertexPath);
  const bool             isClosed = edges.size() > 1 && vertexPath.front() == vertexPath.back();
  std::vector<int>       corners;
  for (std::size_t i = isClosed ? 1 : 0; i < vertexPath.size() && !edges.empty(); ++i)
  {
    const bool             isLast = i == edges.size();
    const int              entered = i > 0 ? edges[i - 1] : -1;
    const int              left = !isLast ? edges[i] : isClosed ? edges[0] : -1;
    const std::vector<int> here = LeftAtVertex(Fan(F, connectivity, vertexPath[i]), entered, left);
    corners.insert(corners.end(), here.begin(), here.end());
  }
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  return corners;
}

CutSurface
CutAlongPaths(const SurfaceMesh &                   mesh,
              const SurfaceConnectivity &           connectivity,
              const std::vector<std::vector<int>> & vertexPaths)
{
  CutSurface        cut{ mesh, std::vector<int>(mesh.NumberOfVertices()), {} };
  std::vector<char> isCut(connectivity.NumberOfEdges(), 0);
  std::vector<int>  vertices;
  for (const std::vector<int> & path : vertexPaths)
  {
    for (const int edge : EdgesOfPath(connectivity, path))
    {
      isCut[edge] = 1;
      const auto & ends = connectivity.VerticesOfEdge(edge);
      vertices.insert(vertices.end(), ends.begin(), ends.end());
    }
    cut.leftCorners.push_back(LeftCorners(mesh.F, connectivity, path));
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    cut.sourcePointId[v] = v;
  }
  for (const int vertex : vertices)
  {
    const std::vector<int> fans = FansBetweenCuts(mesh.F, connectivity, vertex, isCut);
    const int              first = static_cast<int>(cut.sourcePointId.size()) - 1;
    const int              last = *std::max_element(fans.begin(), fans.end());
    for (std::size_t i = 0; i < fans.size(); ++i)
    {
      const int face = connectivity.FacesOfVertex(vertex)[static_cast<int>(i)];
      cut.mesh.F(face, CornerOfVertex(mesh.F, face, vertex)) = fans[i] == 0 ? vertex : first + fans[i];
    }
    cut.sourcePointId.insert(cut.sourcePointId.end(), last, vertex);
  }
  SurfaceArray::ValueMatrix positions = cut.mesh.V;
  AppendRows(positions, cut.sourcePointId);
  cut.mesh.V = positions;
  for (SurfaceArray & array : cut.mesh.pointArrays)
  {
    AppendRows(array.values, cut.sourcePointId);
  }
  return cut;
}
} // namespace shapeton
