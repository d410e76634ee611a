#ifndef shapetonEmbeddedGraph_h
#define shapetonEmbeddedGraph_h

#include "shapetonModelSpace.h"

#include <array>

namespace shapeton
{
/** Geometry of a certificate for pictures, relative to the lifts of the nodes; dummies are hidden. */
struct ShapetonGraphViews_EXPORT EmbeddedGraph
{
  explicit EmbeddedGraph(const EmbeddingCertificate & certificate);

  using Segment = std::array<Place, 2>;

  const EmbeddingCertificate & certificate;
  ModelSpace                   space;
  CombinatorialMap             map; ///< genus of the packed map
  std::vector<Place>           nodes;
  std::vector<Place>           faces;
  /** For each packed half-edge: the tangency point of the circles of its ends and the center of the face to its left,
   * as seen from the lift of its start node. */
  std::vector<Place> touch;
  std::vector<Place> corner;
  /** Edge of the graph to which each packed edge belongs; -1 for edges of dummies. */
  std::vector<int> edgeOf;
  /** Whether a packed edge belongs to an edge of the graph. */
  std::vector<char> isVisibleEdge;
  /** Halves of the graph's edges, each from a node or a dummy of a path to the tangency point. */
  std::vector<Segment> halfEdges;
  /** Halves of the dual's edges, from edge nodes to the representative faces. */
  std::vector<Segment> dual;
  /** For each edge of the graph: the packed half-edge where it crosses its dual. */
  std::vector<int> crossings;
  /** Packed faces that represent the faces of the graph; only the representatives have visible circles. */
  std::vector<int>  representatives;
  std::vector<char> isVisibleFace;
  /** Sphere only: center of the largest circle inside the graph face that covers the largest area. */
  Place pole;
  /** Sphere only: unit view direction that shows most of the graph. */
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
