#ifndef shapetonCornerTable_h
#define shapetonCornerTable_h

#include "shapetonSurfaceConnectivity.h"

namespace shapeton
{
/** \class CornerTable
 * \brief An oriented manifold triangle surface with edge collapses, flips and splits.
 *
 * Half-edge h of face h / 3 runs from its corner h to the next corner. The caller stores the positions. Removed faces
 * and vertices keep their indices; Faces() skips and renumbers them.
 *
 * A boundary vertex stores the outgoing half-edge without a twin; a walk around it then visits all of its faces.
 */
class CornerTable
{
public:
  /** \pre RequireManifold() returned the connectivity. */
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
  /** The opposite half-edge in the adjacent face, -1 on a boundary. */
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
  /** Whether this half-edge represents its edge. */
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

  /** Calls visit(h) for each edge at a live vertex, with one half-edge per edge. */
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

  /** Calls visit(w) for each neighbor of a live vertex. */
  template <typename TVisit>
  void
  ForEachNeighbor(int v, TVisit && visit) const
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
  /** The half-edge from v to w, or from w to v if only that one exists; -1 if they are not neighbors. */
  int
  FindHalfEdge(int v, int w) const;

  /** Link condition (Dey, Edelsbrunner, Guha, Nekhayev 1999): whether collapsing the edge preserves a manifold with the
   * same genus, boundary loops and components. */
  bool
  CanCollapse(int h) const;
  /** Collapses the edge: removes its one or two faces and the vertex From(h); keeps To(h). \pre CanCollapse(h). */
  void
  Collapse(int h);
  /** Whether the edge has two faces and their other diagonal is not yet an edge. */
  bool
  CanFlip(int h) const;
  /** Replaces the edge by the other diagonal of its two faces. \pre CanFlip(h). */
  void
  Flip(int h);
  /** Splits the edge and its faces by a new vertex. Returns the vertex. */
  int
  Split(int h);

  /** Remaining vertices and faces, renumbered in their order. */
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
