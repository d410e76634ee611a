#ifndef shapetonCombinatorialMap_h
#define shapetonCombinatorialMap_h

#include "shapetonGraph.h"

#include <array>
#include <vector>

namespace shapeton
{
/** For each node the half-edges that leave it, counter-clockwise. \ingroup GraphModel */
using Rotation = std::vector<std::vector<int>>;

/** \class CombinatorialMap
 * \brief A graph drawn on closed orientable surfaces, one for each component, given by the order of the half-edges
 * around each node (rotation system).
 *
 * Half-edge 2e leaves edges[e][0], 2e + 1 leaves edges[e][1]; Twin(h) = h ^ 1. The order around a node is
 * counter-clockwise, as seen from outside. The face of a half-edge lies to its left:
 * FaceNext(h) = PreviousAround(Twin(h)), so a walk along FaceNext goes counter-clockwise around its face. A loop has
 * both of its half-edges at one node.
 *
 * Faces are numbered in the order of their smallest half-edges. A node without edges is a component of genus 0 and
 * counts no face, for no half-edge bounds it.
 *
 * \ingroup GraphModel
 */
class GraphModel_EXPORT CombinatorialMap
{
public:
  /** The empty map. */
  CombinatorialMap() = default;

  /** Throws InputError when `rotation` is no rotation system of `graph`: each half-edge once, at its own node. */
  CombinatorialMap(const Graph & graph, const Rotation & rotation);

  /** By the permutation that gives the half-edge after each one, counter-clockwise; without a list for each node.
   * Throws InputError when the cycles of `nextAround` are not the half-edges of one node each. */
  CombinatorialMap(int nodes, const std::vector<std::array<int, 2>> & edges, std::vector<int> nextAround);

  int
  Nodes() const
  {
    return static_cast<int>(m_FirstAround.size());
  }
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
  int
  Faces() const
  {
    return static_cast<int>(m_FirstOfFace.size());
  }
  static int
  Twin(int halfEdge)
  {
    return halfEdge ^ 1;
  }
  /** The node that the half-edge leaves. */
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
  /** The smallest half-edge that leaves the node; -1 when there is none. */
  int
  FirstAround(int node) const
  {
    return m_FirstAround[node];
  }
  /** The smallest half-edge of the face. */
  int
  FirstOfFace(int face) const
  {
    return m_FirstOfFace[face];
  }
  /** Half-edges of a node, counter-clockwise from the smallest one. */
  std::vector<int>
  Around(int node) const;
  /** Half-edges of a face in the order of FaceNext, from the smallest one. */
  std::vector<int>
  Boundary(int face) const;
  /** Of each node: the number of half-edges that leave it; a loop counts twice. */
  std::vector<int>
  Degrees() const;
  /** Of each face: the number of its half-edges. */
  std::vector<int>
  FaceLengths() const;

  /** The component of each node, numbered in the order of their smallest nodes. */
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
  /** The genus of the surface of each component, by Euler's formula V - E + F = 2 - 2g. */
  const std::vector<int> &
  GenusOfComponent() const
  {
    return m_GenusOfComponent;
  }
  /** The sum over the components. */
  int
  Genus() const;

  /** The map whose nodes are the faces: half-edge h of the dual leaves Face(h) and crosses h from left to right. Its
   * node f is this map's face f. The dual of the dual has half-edge h where this map has Twin(h). Nodes without edges
   * have no face and are lost. */
  CombinatorialMap
  Dual() const;

  /** The map as seen from the other side: every order is reversed. */
  CombinatorialMap
  Mirrored() const;

  Rotation
  GetRotation() const;
  /** The graph that is drawn, without names. */
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

  std::vector<int> m_Node;
  std::vector<int> m_Next;
  std::vector<int> m_Previous;
  std::vector<int> m_Face;
  std::vector<int> m_FirstAround;
  std::vector<int> m_FirstOfFace;
  std::vector<int> m_ComponentOfNode;
  std::vector<int> m_GenusOfComponent;
};

/** The overlap graph of a map and its dual (vertex-face-edge graph): the nodes are the map's nodes, then its faces,
 * then its edges. Edge h of it, for a half-edge h of the map, joins Node(h) with the node of edge h / 2; edge
 * HalfEdges() + h joins Face(h) with it. All its faces are kites of four half-edges: node, edge, face, edge.
 * \ingroup GraphModel */
struct GraphModel_EXPORT OverlapGraph
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
