#ifndef shapetonPackedMap_h
#define shapetonPackedMap_h

#include "ShapetonRicciFlowEmbeddingExport.h"
#include "shapetonCombinatorialMap.h"

#include <limits>
#include <string>
#include <vector>

namespace shapeton
{
/** Augmentation of a map without a circle packing. \ingroup ShapetonRicciFlowEmbedding */
enum class Augmentation
{
  None,
  Ring ///< hierarchical rings of dummy nodes in the faces that need them
};

/** \brief A map that has a circle packing, and its relation to the graph.
 *
 * Nodes and edges of the graph keep their numbers; higher numbers are dummies. An edge that is a loop, or parallel to
 * an edge with a lower number, becomes a path: `subdivided` contains its half-edges from the start node of edge e, the
 * first of them 2e. \ingroup ShapetonRicciFlowEmbedding */
struct PackedMap
{
  CombinatorialMap              map;
  int                           graphNodes{ 0 };
  int                           graphEdges{ 0 };
  std::vector<std::vector<int>> subdivided;
  int                           rings{ 0 }; ///< faces that meet a node twice and get a separate innermost ring
};

/** \brief The faces that prevent a circle packing: those that meet a node twice, and those that share two nodes with
 * another face, unless these nodes are the ends of one common edge.
 *
 * A map has a circle packing for its nodes and faces if it is 3-connected (Koebe, Andreev, Thurston), or, on a surface
 * of genus 1 or higher, if its universal cover is (Bobenko and Springborn, Trans. AMS 356, 2004). A map with at least 4
 * nodes and without loops, parallel edges and such faces is 3-connected. Otherwise a vanishing residual is not a proof:
 * on K4 minus an edge and on K2,3, Newton's method converges to a degenerate limit. For genus 1 or higher the condition
 * is sufficient, not necessary: some maps that use all of their handles fail it although they have a packing.
 *
 * All such pairs are found as 4-cycles of the graph of nodes and faces, each from its node of highest degree (Chiba and
 * Nishizeki 1985), in linear time for bounded genus. \pre Triangles have no parallel edges.
 * \ingroup ShapetonRicciFlowEmbedding
 */
struct ShapetonRicciFlowEmbedding_EXPORT FaceConflicts
{
  /** \param names node names to use in `reason`; empty to use node numbers. */
  explicit FaceConflicts(const CombinatorialMap & map, const std::vector<std::string> & names = {});

  std::vector<char> meetsANodeTwice; ///< one flag for each face
  std::vector<char> sharesTwoNodes;
  /** Description of the first conflict; empty if there is none. */
  std::string reason;
};

/** Options for making a map packable. \ingroup ShapetonRicciFlowEmbedding */
struct AugmentationOptions
{
  AugmentationOptions(Augmentation kind = Augmentation::Ring) : augmentation(kind) {}

  Augmentation augmentation;
  /** Maximum number of half-edges per dummy (>= 1), for a ring in a face that meets a node twice. */
  int halfEdgesOfDummy{ 2 };
  /** Faces with more half-edges are also filled. */
  int longestFace{ std::numeric_limits<int>::max() };
  /** See FaceConflicts. */
  std::vector<std::string> names;
};

/** \brief Augments a map to make it packable.
 *
 * With Augmentation::Ring, components are joined by a dummy node in the longest face of each; loops and parallel edges
 * are subdivided by dummy nodes. A face in conflict (see FaceConflicts) is filled with rings. If it meets a node twice,
 * the first ring has one dummy for every two half-edges, or for one half-edge where two would meet a node twice. Each
 * further ring has half as many nodes as the previous one; once at most six are left, a single dummy fills the center.
 * Radii therefore decrease by a constant factor from ring to ring, not from node to node. Triangles and faces without
 * conflict are unchanged, and therefore so is a 3-connected map. Maps of any genus are supported.
 *
 * With Augmentation::None the map must be connected and free of conflicts; otherwise throws InputError with the reason.
 * \ingroup ShapetonRicciFlowEmbedding */
ShapetonRicciFlowEmbedding_EXPORT PackedMap
MakePackedMap(const CombinatorialMap & map, const AugmentationOptions & options = {});
} // namespace shapeton

#endif
