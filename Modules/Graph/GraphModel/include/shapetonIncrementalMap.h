#ifndef shapetonIncrementalMap_h
#define shapetonIncrementalMap_h

#include "ShapetonGraphModelExport.h"

#include "shapetonCombinatorialMap.h"

#include <vector>

namespace shapeton
{
/** \class IncrementalMap
 * \brief A rotation system with edge insertion and removal and incrementally updated faces.
 *
 * A corner is identified by the half-edge before it, counter-clockwise: an edge inserted "after a" has its half-edge
 * between a and NextAround(a), within the face Face(a), a label in [0, FaceLabels()). Inserting an edge between two
 * corners of one face splits the face. Inserting it between two faces merges them, which adds a handle if both are in
 * one component. The shorter part is relabeled, so a change costs the length of the shorter face. Existing loops are
 * kept, but loops cannot be inserted or removed.
 *
 * \ingroup ShapetonGraphModel
 */
class ShapetonGraphModel_EXPORT IncrementalMap : public RotationSystem
{
public:
  /** Creates a map with these edges, not yet inserted. */
  IncrementalMap(int nodes, const std::vector<std::array<int, 2>> & edges);

  /** Creates a map with all edges inserted as in `map`. */
  explicit IncrementalMap(const CombinatorialMap & map);

  int
  Nodes() const
  {
    return static_cast<int>(m_Any.size());
  }
  /** Number of faces of the map formed by the inserted edges. */
  int
  Faces() const
  {
    return m_Faces;
  }
  bool
  Contains(int edge) const
  {
    return m_Next[2 * edge] >= 0;
  }
  int
  Degree(int node) const
  {
    return m_Degree[node];
  }
  /** A half-edge of the node, or -1. */
  int
  Any(int node) const
  {
    return m_Any[node];
  }
  int
  FaceLabels() const
  {
    return static_cast<int>(m_Length.size());
  }
  int
  FaceLength(int label) const
  {
    return m_Length[label];
  }

  /** Appends an edge without inserting it; returns its index. */
  int
  AddEdge(int node0, int node1);

  /** Inserts an edge between the corner after `a`, at its first node, and the corner after `b`, at its second one; -1
   * for a node without half-edges. */
  void
  Insert(int edge, int a, int b);

  void
  Remove(int edge);

  /** The permutation for CombinatorialMap; -1 for edges that are not inserted. */
  const std::vector<int> &
  GetNextAround() const
  {
    return m_Next;
  }

private:
  void
  Link(int halfEdge, int after);
  void
  Unlink(int halfEdge);
  int
  NewLabel();
  void
  Relabel(int start, int label);
  int
  Join(int one, int other);
  void
  Divide(int one, int other);

  std::vector<int> m_Any;
  std::vector<int> m_Degree;
  std::vector<int> m_Length;
  std::vector<int> m_FreeLabels;
  int              m_Faces{ 0 };
};
} // namespace shapeton

#endif
