#ifndef shapetonSurfaceConnectivity_h
#define shapetonSurfaceConnectivity_h

#include "shapetonSurfaceMesh.h"

#include <array>
#include <optional>

namespace shapeton
{
/** Some numbers that lie one after another in an array of a SurfaceConnectivity. \ingroup SurfaceMesh */
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

/** A connected component by edges: numbers of one component. \ingroup SurfaceMesh */
struct SurfaceComponent
{
  int faces{ 0 };
  int vertices{ 0 };
  int edges{ 0 };
  int boundaryLoops{ 0 };
  /** vertices - edges + faces. */
  int eulerCharacteristic{ 0 };
  /** No non-manifold edge, and one fan at each vertex. */
  bool isManifold{ true };
  /** The faces can be turned so that all neighbours agree; false for a Moebius strip. */
  bool isOrientable{ true };
  /** Handles, (2 - boundaryLoops - eulerCharacteristic) / 2; nothing where the component is not manifold or not
   * orientable. */
  std::optional<int> genus;
  /** The least index of its faces. */
  int firstFace{ 0 };
};

/** \class SurfaceConnectivity
 * \brief Which vertices, edges and faces of a triangle surface meet; built once, never changed.
 *
 * An edge is a pair of vertices, whatever the number of its faces. A degenerate face, one that names a vertex twice,
 * takes part in nothing: it has no edges and no component. Faces are connected where they share an edge; two that share
 * only a vertex do not. Everything is in the order of the indices, so equal input gives equal output. Memory: about 100
 * bytes for each face.
 *
 * \ingroup SurfaceMesh
 */
class SurfaceMesh_EXPORT SurfaceConnectivity
{
public:
  /** \pre The indices in F are in [0, numberOfVertices); else std::out_of_range. */
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
  /** The two vertices, the lesser one first. */
  const std::array<int, 2> &
  VerticesOfEdge(int edge) const
  {
    return m_EdgeVertices[edge];
  }
  /** One for a boundary, two inside a surface, more where it is not manifold. In ascending order. */
  IndexRange
  FacesOfEdge(int edge) const
  {
    return { m_EdgeFaces.data() + m_EdgeBegin[edge], m_EdgeFaces.data() + m_EdgeBegin[edge + 1] };
  }
  /** The edge from corner k to the next corner of a face; -1 for a degenerate face. */
  int
  EdgeOfFace(int face, int k) const
  {
    return m_FaceEdges[3 * face + k];
  }
  /** The edge between two vertices; -1 where there is none. */
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
  /** Two faces that run along the edge in the same direction: one of them is turned over. */
  bool
  IsInconsistentEdge(int edge) const;
  ///@}

  /** \name Vertices */
  ///@{
  /** In ascending order; none for a vertex that only degenerate faces name. */
  IndexRange
  FacesOfVertex(int vertex) const
  {
    return { m_VertexFaces.data() + m_VertexBegin[vertex], m_VertexFaces.data() + m_VertexBegin[vertex + 1] };
  }
  /** The vertices at the other ends of its edges, ascending. */
  std::vector<int>
  NeighboursOfVertex(int vertex) const;
  bool
  IsBoundaryVertex(int vertex) const;
  /** For each of FacesOfVertex() the number, from 0 on, of the fan that it belongs to: faces that are connected by
   * edges at this vertex; with `throughManifoldEdges` only by edges of two faces. */
  std::vector<int>
  FanOfFaces(int vertex, bool throughManifoldEdges = false) const;
  /** The number of these fans: 1 where the surface is manifold, 0 where there is no face. */
  int
  FansOfVertex(int vertex) const;
  /** At a non-manifold edge, or with several fans. */
  bool
  IsNonManifoldVertex(int vertex) const;
  ///@}

  /** Closed walks of vertices along the edges that have one face, in the direction of the first face met, each from its
   * least vertex on, in the order of these. At a vertex with several fans a walk stays in its fan. A walk that meets a
   * non-manifold edge ends there and is an open chain. */
  const std::vector<std::vector<int>> &
  BoundaryLoops() const
  {
    return m_Loops;
  }

  /** In the order of their first faces. */
  const std::vector<SurfaceComponent> &
  Components() const
  {
    return m_Components;
  }
  /** Of each face; -1 for a degenerate one. */
  const std::vector<int> &
  ComponentOfFaces() const
  {
    return m_ComponentOfFace;
  }
  /** For each face whether it must be turned over to agree with the first face of its component. */
  const std::vector<bool> &
  TurnedFaces() const
  {
    return m_IsTurned;
  }
  /** Each edge has one or two faces and each vertex at most one fan. */
  bool
  IsManifold() const;
  /** IsManifold() without boundary, degenerate faces or unreferenced vertices left aside. */
  bool
  IsClosed() const;
  /** No inconsistent edge. */
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
  std::vector<int>                m_FirstEdgeOfVertex; ///< edges by their lesser vertex
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
