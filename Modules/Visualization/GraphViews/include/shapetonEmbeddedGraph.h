#ifndef shapetonEmbeddedGraph_h
#define shapetonEmbeddedGraph_h

#include "shapetonModelSpace.h"

#include <array>

namespace shapeton
{
/** What a picture shows of a certificate: all of it local to the lifts of the nodes, dummies hidden. */
struct GraphViews_EXPORT EmbeddedGraph
{
  explicit EmbeddedGraph(const EmbeddingCertificate & certificate);

  using Segment = std::array<Place, 2>;

  const EmbeddingCertificate & certificate;
  ModelSpace                   space;
  CombinatorialMap             map; ///< packed
  std::vector<Place>           nodes;
  std::vector<Place>           faces;
  /** Of each packed half-edge: where the circles of its ends touch, and the centre of the face to its left, both seen
   * from the lift of its start node. */
  std::vector<Place> touch;
  std::vector<Place> corner;
  /** Packed edges that belong to edges of the graph. */
  std::vector<char> isVisibleEdge;
  /** Of the graph: each half, from a node or a dummy of a path to the touching point. */
  std::vector<Segment> halfEdges;
  /** Of the dual: from edge nodes to the representatives of faces. */
  std::vector<Segment> dual;
  /** Of each edge of the graph: the packed half-edge where it and its dual cross. */
  std::vector<int> crossings;
  /** Packed faces that represent the faces of the graph; those that are a face of the graph have visible circles. */
  std::vector<int>  representatives;
  std::vector<char> isVisibleFace;
  /** On the sphere: the centre of the largest circle within the face of the graph that covers most of it. */
  Place pole;
  /** On the sphere: from where most of the graph is seen, as a unit vector. */
  Place front;

private:
  void
  FindPlaces();
  void
  FindVisibleEdges();
  void
  FindDual();
  void
  DrawDual(const std::vector<int> & parent);
  void
  FindPole(const std::vector<int> & owner);
  void
  FindFront();
  void
  AddDualCrossing(int halfEdge);
};
} // namespace shapeton

#endif
