#ifndef shapetonPackedMap_h
#define shapetonPackedMap_h

#include "RicciFlowEmbeddingExport.h"
#include "shapetonCombinatorialMap.h"

#include <limits>
#include <string>
#include <vector>

namespace shapeton
{
/** What is added to a map that has no circle packing of its own. \ingroup RicciFlowEmbedding */
enum class Augmentation
{
  None,
  Ring ///< hierarchical rings of dummy nodes in the faces that need them
};

/** \brief A map that carries a circle packing, and what of it belongs to the graph.
 *
 * Nodes and edges of the graph keep their numbers, all above them are dummies. An edge that is a loop, or parallel to
 * an edge of a smaller number, becomes a path: `subdivided` holds its half-edges from the start node of edge e, the
 * first of them 2e. \ingroup RicciFlowEmbedding */
struct PackedMap
{
  CombinatorialMap              map;
  int                           graphNodes{ 0 };
  int                           graphEdges{ 0 };
  std::vector<std::vector<int>> subdivided;
  int                           rings{ 0 }; ///< faces that meet a node twice, with an innermost ring of their own
};

/** \brief The faces that stand in the way of a circle packing: those that meet a node twice, and those that share two
 * nodes with another face but not as the ends of one common edge.
 *
 * A map has a packing of circles for its nodes and faces when it is 3-connected (Koebe, Andreev, Thurston), or, on a
 * surface of genus 1 and more, its universal cover is (Bobenko and Springborn, Trans. AMS 356, 2004). A map of 4 nodes
 * or more without loops, parallel edges and such faces is. Otherwise a residual that vanishes proves nothing: on K4
 * without an edge and on K2,3 Newton's method runs to a degenerate limit. On genus 1 and more the condition is
 * sufficient, and a map that needs all of its handles to be told apart from a worse one may fail it.
 *
 * All such pairs are found as 4-cycles of the graph of nodes and faces, from each node of highest degree (Chiba and
 * Nishizeki 1985), in linear time for bounded genus. \pre Triangles have no parallel edges. \ingroup RicciFlowEmbedding
 */
struct RicciFlowEmbedding_EXPORT FaceConflicts
{
  /** `names` of the nodes for the reason; empty for their numbers. */
  explicit FaceConflicts(const CombinatorialMap & map, const std::vector<std::string> & names = {});

  std::vector<char> meetsANodeTwice; ///< one for each face
  std::vector<char> sharesTwoNodes;
  /** Empty, or says which face meets which. */
  std::string reason;
};

/** How a map is made packable. \ingroup RicciFlowEmbedding */
struct AugmentationOptions
{
  AugmentationOptions(Augmentation kind = Augmentation::Ring) : augmentation(kind) {}

  Augmentation augmentation;
  /** Of a ring in a face that meets a node twice: the most half-edges for one dummy, >= 1. */
  int halfEdgesOfDummy{ 2 };
  /** Faces with more half-edges are filled, too. */
  int longestFace{ std::numeric_limits<int>::max() };
  /** See FaceConflicts. */
  std::vector<std::string> names;
};

/** \brief Makes a map that has a circle packing.
 *
 * With Augmentation::Ring: components are joined by a dummy node that sees the longest face of each; loops and parallel
 * edges are divided by dummy nodes; a face in conflict (see FaceConflicts) is filled with rings: where it meets a node
 * twice, first with one dummy for each two half-edges, or for one where two would meet a node twice; then with rings of
 * half the number of nodes each, while more than six are left, then with one dummy in the centre. So radii fall by a
 * constant factor from ring to ring, not from node to node. Faces without conflict and triangles stay as they are,
 * hence a 3-connected map does. Any genus.
 *
 * With Augmentation::None the map must be connected and free of conflicts; else InputError says what is in the way.
 * \ingroup RicciFlowEmbedding */
RicciFlowEmbedding_EXPORT PackedMap
MakePackedMap(const CombinatorialMap & map, const AugmentationOptions & options = {});
} // namespace shapeton

#endif
