#ifndef shapetonIntrinsicTriangulation_h
#define shapetonIntrinsicTriangulation_h

#include "ShapetonSurfaceRicciFlowExport.h"

#include "shapetonSurfaceConnectivity.h"

namespace shapeton
{
/** \class IntrinsicTriangulation
 * \brief Faces glued along their sides, without positions in space: two sides of a face may be glued together, and
 * several edges may join the same two vertices.
 *
 * Side 3 f + k starts at corner k of face f and ends at the next corner; faces are counterclockwise as seen from
 * outside. Flips reuse the faces, sides and edges, so that they can be undone in reverse order.
 *
 * \ingroup ShapetonSurfaceRicciFlow */
class ShapetonSurfaceRicciFlow_EXPORT IntrinsicTriangulation
{
public:
  /** The triangulation of a surface, with its numbers of vertices, edges and faces.
   * \pre The surface is manifold and consistently oriented, without degenerate faces. */
  IntrinsicTriangulation(const FaceMatrix & F, const SurfaceConnectivity & connectivity);

  /** The double of a surface: a mirrored copy is glued to its boundaries. Side s of the surface has the mirrored side 3
   * (faces + s / 3) + 2 - s % 3. The additional vertices and edges are numbered in the order of their originals. */
  static IntrinsicTriangulation
  Double(const FaceMatrix & F, const SurfaceConnectivity & connectivity);

  int
  NumberOfVertices() const
  {
    return m_NumberOfVertices;
  }
  int
  NumberOfEdges() const
  {
    return static_cast<int>(m_SideOfEdge.size());
  }
  int
  NumberOfFaces() const
  {
    return static_cast<int>(m_Origins.size() / 3);
  }
  int
  NumberOfSides() const
  {
    return static_cast<int>(m_Origins.size());
  }

  /** The next side of the face. */
  static int
  Next(int side)
  {
    return side % 3 == 2 ? side - 2 : side + 1;
  }
  static int
  Previous(int side)
  {
    return side % 3 == 0 ? side + 2 : side - 1;
  }
  int
  Origin(int side) const
  {
    return m_Origins[side];
  }
  int
  End(int side) const
  {
    return m_Origins[Next(side)];
  }
  /** The side of the neighboring face, or -1 on a boundary. */
  int
  Twin(int side) const
  {
    return m_Twins[side];
  }
  int
  EdgeOf(int side) const
  {
    return m_Edges[side];
  }
  /** One side of an edge. */
  int
  SideOf(int edge) const
  {
    return m_SideOfEdge[edge];
  }
  bool
  IsBoundary(int edge) const
  {
    return m_Twins[m_SideOfEdge[edge]] == -1;
  }
  /** Vertices of the faces. */
  FaceMatrix
  Faces() const;

  /** Replaces the diagonal a b of the quadrilateral a d b c by d c: the face a b c of `side` becomes d c a, and the
   * face b a d of its twin becomes c d b. Other sides move to other places in the two faces. Lengths are not stored
   * here.
   * \pre The side has a twin in another face. */
  void
  Flip(int side);
  /** Undoes Flip(side). */
  void
  FlipBack(int side);

  /** Deletes the faces with a corner at this vertex; the vertex remains without faces. Faces, sides and edges are
   * renumbered in their order. */
  IntrinsicTriangulation
  WithoutStar(int vertex, std::vector<int> & keptFaces, std::vector<int> & keptEdges) const;

private:
  IntrinsicTriangulation() = default;
  void
  Move(const std::array<int, 4> & from, const std::array<int, 4> & to);

  int              m_NumberOfVertices{ 0 };
  std::vector<int> m_Origins, m_Twins, m_Edges, m_SideOfEdge;
};
} // namespace shapeton

#endif
