#ifndef shapetonCornerTable_h
#define shapetonCornerTable_h

#include "shapetonSurfaceConnectivity.h"

namespace shapeton
{
/** \class CornerTable
 * \brief An oriented manifold triangle surface that changes by collapses, flips and splits of edges.
 *
 * Half-edge h of face h / 3 runs from its corner h to the next corner. Positions are kept by the caller. Removed faces
 * and vertices keep their indices until Faces() and a renumbering leave them out.
 *
 * The half-edge that a vertex keeps is, on a boundary, the one without a twin, so that walking around the vertex meets
 * all of its faces.
 */
class CornerTable
{
public:
  /** Of the faces that RequireManifold() has given the connectivity of. */
  CornerTable(const FaceMatrix & F, const SurfaceConnectivity & connectivity);
  ~CornerTable();

  static int
  Next(int h)
  {
    return h % 3 == 2 ? h - 2 : h + 1;
  }
  static int
  Previous(int h)
  {
    return h % 3 == 0 ? h + 2 : h - 1;
  }
  int
  From(int h) const
  {
    return m_Corner[h];
  }
  int
  To(int h) const
  {
    return m_Corner[Next(h)];
  }
  /** The vertex opposite to the half-edge in its face. */
  int
  Apex(int h) const
  {
    return m_Corner[Previous(h)];
  }
  /** The half-edge of the other face, -1 on a boundary. */
  int
  Twin(int h) const
  {
    return m_Twin[h];
  }
  int
  NumberOfHalfEdges() const
  {
    return static_cast<int>(m_Corner.size());
  }
  int
  NumberOfVertices() const
  {
    return static_cast<int>(m_Outgoing.size());
  }
  int
  NumberOfLiveFaces() const
  {
    return m_LiveFaces;
  }
  bool
  IsLive(int h) const
  {
    return m_Corner[h] >= 0;
  }
  bool
  IsLiveVertex(int v) const
  {
    return m_Outgoing[v] >= 0;
  }
  bool
  IsBoundary(int v) const
  {
    return m_Twin[m_Outgoing[v]] < 0;
  }
  /** One of the two half-edges of an edge stands for it. */
  bool
  StandsForEdge(int h) const
  {
    return this->IsLive(h) && (m_Twin[h] < 0 || h < m_Twin[h]);
  }

  /** Calls visit(h) for each half-edge that starts at a live vertex, once for each of its faces. */
  template <typename TVisit>
  void
  ForEachOutgoing(int v, TVisit && visit) const
  {
    const int start = m_Outgoing[v];
    for (int h = start;;)
    {
      const int next = m_Twin[Previous(h)];
      visit(h);
      if (next < 0 || next == start)
      {
        return;
      }
      h = next;
    }
  }

  /** Calls visit(h) for each edge at a live vertex, with one of its half-edges. */
  template <typename TVisit>
  void
  ForEachEdge(int v, TVisit && visit) const
  {
    int last = -1;
    this->ForEachOutgoing(v, [&](int h) {
      visit(h);
      last = h;
    });
    if (m_Twin[Previous(last)] < 0)
    {
      visit(Previous(last));
    }
  }

  /** Calls visit(w) for each neighbour of a live vertex. */
  template <typename TVisit>
  void
  ForEachNeighbour(int v, TVisit && visit) const
  {
    int last = -1;
    this->ForEachOutgoing(v, [&](int h) {
      visit(this->To(h));
      last = h;
    });
    if (m_Twin[Previous(last)] < 0)
    {
      visit(this->Apex(last));
    }
  }

  /** The number of edges at a live vertex. */
  int
  Valence(int v) const;
  /** The half-edge from v to w, or from w to v where only that one exists; -1 when they are no neighbours. */
  int
  FindHalfEdge(int v, int w) const;

  /** The link condition (Dey, Edelsbrunner, Guha, Nekhayev 1999): whether collapsing the edge leaves a manifold of the
   * same topology: same genus, boundary loops and components. */
  bool
  CanCollapse(int h) const;
  /** Removes the edge, the one or two faces beside it and the vertex From(h); To(h) stays. \pre CanCollapse(h). */
  void
  Collapse(int h);
  /** Whether the edge has two faces and the other diagonal of them is no edge yet. */
  bool
  CanFlip(int h) const;
  /** Replaces the edge by the other diagonal of its two faces. \pre CanFlip(h). */
  void
  Flip(int h);
  /** Puts a new vertex into the edge and cuts its faces in two. Returns the vertex. */
  int
  Split(int h);

  /** Vertices and faces that are left, renumbered in their order. */
  SurfaceMesh
  ToSurface(const std::vector<Eigen::Vector3d> & positions) const;

private:
  void
  Link(int a, int b);
  void
  KeepOutgoing(int h);
  void
  RemoveFace(int f);
  int
  AddFace(int a, int b, int c);

  std::vector<int>              m_Corner; ///< -1 in a removed face
  std::vector<int>              m_Twin;
  std::vector<int>              m_Outgoing; ///< -1 for a removed vertex
  int                           m_LiveFaces{ 0 };
  mutable std::vector<unsigned> m_Mark;
  mutable unsigned              m_Stamp{ 0 };
};
} // namespace shapeton

#endif
