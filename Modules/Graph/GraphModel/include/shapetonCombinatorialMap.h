#ifndef shapetonCombinatorialMap_h
#define shapetonCombinatorialMap_h

#include "shapetonGraph.h"

#include <array>
#include <vector>

namespace shapeton
{
/** For each node, its outgoing half-edges, counter-clockwise. \ingroup ShapetonGraphModel */
using Rotation = std::vector<std::vector<int>>;

/** \class RotationSystem
 * \brief Half-edges of a graph with their order around each node and the face to the left of each.
 *
 * Half-edge 2e starts at edges[e][0], 2e + 1 at edges[e][1]; Twin(h) = h ^ 1. The order around a node is
 * counter-clockwise, as seen from outside. The face of a half-edge is to its left: FaceNext(h) =
 * PreviousAround(Twin(h)), so FaceNext traverses a face counter-clockwise. Both half-edges of a loop start at the same
 * node.
 *
 * \ingroup ShapetonGraphModel
 */
class RotationSystem
{
public:
  int
  Edges() const
  {
    return HalfEdges() / 2;
  }
  int
  HalfEdges() const
  {
    return static_cast<int>(m_Next.size());
  }
  static int
  Twin(int halfEdge)
  {
    return halfEdge ^ 1;
  }
  /** Start node of the half-edge. */
  int
  Node(int halfEdge) const
  {
    return m_Node[halfEdge];
  }
  /** The face to the left of the half-edge. */
  int
  Face(int halfEdge) const
  {
    return m_Face[halfEdge];
  }
  int
  NextAround(int halfEdge) const
  {
    return m_Next[halfEdge];
  }
  int
  PreviousAround(int halfEdge) const
  {
    return m_Previous[halfEdge];
  }
  int
  FaceNext(int halfEdge) const
  {
    return m_Previous[Twin(halfEdge)];
  }
  int
  FacePrevious(int halfEdge) const
  {
    return Twin(m_Next[halfEdge]);
  }

protected:
  std::vector<int> m_Node;
  std::vector<int> m_Next;
  std::vector<int> m_Previous;
  std::vector<int> m_Face;
};

/** \class CombinatorialMap
 * \brief A graph embedded in closed orientable surfaces, one for each component, given by the order of the half-edges
 * around each node (rotation system).
 *
 * Faces are numbered by their lowest half-edge. A node without edges is a component of genus 0 without faces.
 *
 * \ingroup ShapetonGraphModel
 */
class ShapetonGraphModel_EXPORT CombinatorialMap : public RotationSystem
{
public:
  /** The empty map. */
  CombinatorialMap() = default;

  /** Throws InputError if `rotation` is not a rotation system of `graph`: each half-edge once, at its own node. */
  CombinatorialMap(const Graph & graph, const Rotation & rotation);

  /** Creates the map from the counter-clockwise permutation of half-edges around their nodes, without a list for each
   * node. Throws InputError unless each cycle of `nextAround` consists of the half-edges of one node. */
  CombinatorialMap(int nodes, const std::vector<std::array<int, 2>> & edges, std::vector<int> nextAround);

  int
  Nodes() const
  {
    return static_cast<int>(m_FirstAround.size());
  }
  int
  Faces() const
  {
    return static_cast<int>(m_FirstOfFace.size());
  }
  /** Lowest half-edge that leaves the node, or -1. */
  int
  FirstAround(int node) const
  {
    return m_FirstAround[node];
  }
  /** Lowest half-edge of the face. */
  int
  FirstOfFace(int face) const
  {
    return m_FirstOfFace[face];
  }
  /** Half-edges of a node, counter-clockwise from the lowest one. */
  std::vector<int>
  Around(int node) const;
  /** Half-edges of a face in the order of FaceNext, from the lowest one. */
  std::vector<int>
  Boundary(int face) const;
  /** Degree of each node; a loop counts twice. */
  std::vector<int>
  Degrees() const;
  /** Number of half-edges of each face. */
  std::vector<int>
  FaceLengths() const;

  /** Component of each node, numbered by the lowest node. */
  const std::vector<int> &
  ComponentOfNode() const
  {
    return m_ComponentOfNode;
  }
  int
  Components() const
  {
    return static_cast<int>(m_GenusOfComponent.size());
  }
  /** Genus of each component, by Euler's formula V - E + F = 2 - 2g. */
  const std::vector<int> &
  GenusOfComponent() const
  {
    return m_GenusOfComponent;
  }
  /** Total genus of all components. */
  int
  Genus() const;

  /** The dual map: half-edge h of the dual starts at Face(h) and crosses h from left to right; its node f is face f of
   * this map. In the dual of the dual, half-edge h corresponds to Twin(h) of this map. Isolated nodes are lost because
   * they have no face. */
  CombinatorialMap
  Dual() const;

  /** The mirror image of the map: every order is reversed. */
  CombinatorialMap
  Mirrored() const;

  Rotation
  GetRotation() const;
  /** The embedded graph, without names. */
  Graph
  ToGraph() const;

private:
  void
  Build();
  void
  LinkNodes();
  void
  TraceFaces();
  void
  FindComponents();

  std::vector<int> m_FirstAround;
  std::vector<int> m_FirstOfFace;
  std::vector<int> m_ComponentOfNode;
  std::vector<int> m_GenusOfComponent;
};

/** Overlap graph of a map and its dual (vertex-face-edge graph): its nodes are the nodes of the map, then its faces,
 * then its edges. For each half-edge h of the map, edge h joins Node(h) and edge HalfEdges() + h joins Face(h) with
 * the node of edge h / 2. All faces are kites of four half-edges: node, edge, face, edge. \ingroup ShapetonGraphModel
 */
struct ShapetonGraphModel_EXPORT OverlapGraph
{
  explicit OverlapGraph(const CombinatorialMap & original);

  int
  NodeOfFace(int face) const
  {
    return firstFaceNode + face;
  }
  int
  NodeOfEdge(int edge) const
  {
    return firstEdgeNode + edge;
  }

  CombinatorialMap map;
  int              firstFaceNode;
  int              firstEdgeNode;
};
} // namespace shapeton

#endif
