#ifndef shapetonSurfaceConnectivity_h
#define shapetonSurfaceConnectivity_h

#include "shapetonSurfaceMesh.h"

#include <array>
#include <optional>

namespace shapeton
{
/** A contiguous range of numbers in an array of a SurfaceConnectivity. \ingroup ShapetonSurfaceMesh */
class IndexRange
{
public:
  IndexRange(const int * first, const int * last) : m_First(first), m_Last(last) {}
  const int *
  begin() const
  {
    return m_First;
  }
  const int *
  end() const
  {
    return m_Last;
  }
  int
  size() const
  {
    return static_cast<int>(m_Last - m_First);
  }
  int
  operator[](int i) const
  {
    return m_First[i];
  }

private:
  const int * m_First;
  const int * m_Last;
};

/** Statistics of one edge-connected component. \ingroup ShapetonSurfaceMesh */
struct SurfaceComponent
{
  int faces{ 0 };
  int vertices{ 0 };
  int edges{ 0 };
  int boundaryLoops{ 0 };
  /** vertices - edges + faces. */
  int eulerCharacteristic{ 0 };
  /** Whether no edge is non-manifold and each vertex has a single fan. */
  bool isManifold{ true };
  /** Whether the faces can be oriented consistently; false for a Moebius strip. */
  bool isOrientable{ true };
  /** Handles, (2 - boundaryLoops - eulerCharacteristic) / 2; not set if the component is not manifold or not
   * orientable. */
  std::optional<int> genus;
  /** Lowest index of its faces. */
  int firstFace{ 0 };
};

/** \class SurfaceConnectivity
 * \brief Vertex, edge and face adjacency of a triangle surface; immutable.
 *
 * An edge is a pair of vertices with any number of faces. Degenerate faces (with a repeated vertex) are ignored: they
 * have no edges and no component. Faces are connected through a shared edge, not through a shared vertex. All lists are
 * in index order, so output is deterministic. Memory: about 100 bytes per face.
 *
 * \ingroup ShapetonSurfaceMesh
 */
class ShapetonSurfaceMesh_EXPORT SurfaceConnectivity
{
public:
  /** \pre The indices in F are in [0, numberOfVertices); otherwise throws std::out_of_range. */
  SurfaceConnectivity(const FaceMatrix & F, int numberOfVertices);
  explicit SurfaceConnectivity(const SurfaceMesh & mesh);
  ~SurfaceConnectivity();

  int
  NumberOfVertices() const
  {
    return m_NumberOfVertices;
  }
  int
  NumberOfFaces() const
  {
    return static_cast<int>(m_Faces.rows());
  }
  int
  NumberOfEdges() const
  {
    return static_cast<int>(m_EdgeVertices.size());
  }

  /** \name Edges, in the order of their vertices */
  ///@{
  /** The two vertices, the lower index first. */
  const std::array<int, 2> &
  VerticesOfEdge(int edge) const
  {
    return m_EdgeVertices[edge];
  }
  /** Faces of an edge, ascending: one on a boundary, two inside a surface, more if non-manifold. */
  IndexRange
  FacesOfEdge(int edge) const
  {
    return { m_EdgeFaces.data() + m_EdgeBegin[edge], m_EdgeFaces.data() + m_EdgeBegin[edge + 1] };
  }
  /** The edge from corner k of a face to its next corner; -1 for a degenerate face. */
  int
  EdgeOfFace(int face, int k) const
  {
    return m_FaceEdges[3 * face + k];
  }
  /** The edge between two vertices, or -1. */
  int
  FindEdge(int a, int b) const;
  bool
  IsBoundaryEdge(int edge) const
  {
    return this->FacesOfEdge(edge).size() == 1;
  }
  bool
  IsNonManifoldEdge(int edge) const
  {
    return this->FacesOfEdge(edge).size() > 2;
  }
  /** Whether two faces run along the edge in the same direction, so that one of them is flipped. */
  bool
  IsInconsistentEdge(int edge) const;
  ///@}

  /** \name Vertices */
  ///@{
  /** Faces of a vertex, ascending; empty for a vertex used only by degenerate faces. */
  IndexRange
  FacesOfVertex(int vertex) const
  {
    return { m_VertexFaces.data() + m_VertexBegin[vertex], m_VertexFaces.data() + m_VertexBegin[vertex + 1] };
  }
  /** Vertices at the other ends of its edges, ascending. */
  std::vector<int>
  NeighborsOfVertex(int vertex) const;
  bool
  IsBoundaryVertex(int vertex) const;
  /** For each face in FacesOfVertex(), the number of its fan, from 0. Faces connected by edges at this vertex form a
   * fan. With `throughManifoldEdges`, only edges with two faces count. */
  std::vector<int>
  FanOfFaces(int vertex, bool throughManifoldEdges = false) const;
  /** Number of these fans: 1 if the surface is manifold, 0 if the vertex has no faces. */
  int
  FansOfVertex(int vertex) const;
  /** Whether the vertex is at a non-manifold edge or has several fans. */
  bool
  IsNonManifoldVertex(int vertex) const;
  ///@}

  /** Closed walks along edges with one face, in the direction of the first face met, each starting at its lowest
   * vertex; ordered by these vertices. At a vertex with several fans a walk stays in its fan. A walk that reaches a
   * non-manifold edge ends there as an open chain. */
  const std::vector<std::vector<int>> &
  BoundaryLoops() const
  {
    return m_Loops;
  }

  /** Components in the order of their first faces. */
  const std::vector<SurfaceComponent> &
  Components() const
  {
    return m_Components;
  }
  /** Component of each face; -1 for a degenerate one. */
  const std::vector<int> &
  ComponentOfFaces() const
  {
    return m_ComponentOfFace;
  }
  /** Whether each face must be flipped to agree with the first face of its component. */
  const std::vector<bool> &
  TurnedFaces() const
  {
    return m_IsTurned;
  }
  /** Whether each edge has one or two faces and each vertex at most one fan. */
  bool
  IsManifold() const;
  /** Whether the surface is manifold without boundary; degenerate faces and unreferenced vertices are ignored. */
  bool
  IsClosed() const;
  /** Whether no edge is inconsistent. */
  bool
  IsOriented() const;

private:
  void
  BuildVertexFaces();
  void
  BuildEdges();
  void
  BuildComponents();
  void
  TurnFaces();
  void
  CountVertices();
  void
  CountComponents();
  void
  BuildLoops();
  bool
  RunsForward(int face, int edge) const;
  int
  NextBoundaryEdge(int edge, int vertex) const;

  FaceMatrix                      m_Faces;
  int                             m_NumberOfVertices;
  std::vector<int>                m_VertexBegin;
  std::vector<int>                m_VertexFaces;
  std::vector<std::array<int, 2>> m_EdgeVertices;
  std::vector<int>                m_FirstEdgeOfVertex; ///< edges by their lower vertex
  std::vector<int>                m_EdgeBegin;
  std::vector<int>                m_EdgeFaces;
  std::vector<int>                m_FaceEdges;
  std::vector<int>                m_ComponentOfFace;
  std::vector<bool>               m_IsTurned;
  std::vector<SurfaceComponent>   m_Components;
  std::vector<std::vector<int>>   m_Loops;
};
} // namespace shapeton

#endif
