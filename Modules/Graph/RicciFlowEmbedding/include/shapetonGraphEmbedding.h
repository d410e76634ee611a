#ifndef shapetonGraphEmbedding_h
#define shapetonGraphEmbedding_h

#include "shapetonEmbeddingCertificate.h"
#include "shapetonGraphEmbeddingOptions.h"
#include "shapetonPackedMap.h"
#include "shapetonProgress.h"
#include "shapetonSphericalPacking.h"

namespace shapeton
{
/** Options of EmbedGraph(), its permitted changes, and its progress callback.
 * \ingroup ShapetonRicciFlowEmbedding */
struct GraphEmbeddingSettings : GraphEmbeddingOptions
{
  /** True if the user did not choose the rotation system; blocks may then be rearranged (see ArrangeBlocks). */
  bool isRotationFree{ false };
  /** Whether a map of genus 0 may be mirrored to make the result independent of the numbering. */
  bool isSideFree{ true };
  /** See AugmentationOptions. */
  int longestFace{ AugmentationOptions().longestFace };
  /** May throw to abort. */
  Progress progress;
};

/** Circles of the graph below this radius are not legible; a warning is issued. Units: cap angle in
 * radians, hyperbolic radius, or fraction of the shorter lattice period. \ingroup ShapetonRicciFlowEmbedding */
constexpr double smallestLegibleRadius = 1e-9;

/** \brief Embeds a graph by the circle packing of its map: on the unit sphere for genus 0, a flat torus for genus 1, a
 * hyperbolic surface for genus 2 or higher.
 *
 * On the sphere the packing is unique up to Moebius transformations. It is normalized so that the conformal barycenter
 * of the touch points of the graph's edges is at the center, and by a rotation determined by the map, not the numbering
 * (see TurnToCanonicalPosition). A graph with several components is embedded on the connected sum of their surfaces.
 *
 * The certificate is complete except for the provenance. Throws InputError if no packing exists or none is found.
 * \pre `map` is a map of `graph`. \ingroup ShapetonRicciFlowEmbedding */
ShapetonRicciFlowEmbedding_EXPORT EmbeddingCertificate
EmbedGraph(const Graph & graph, const CombinatorialMap & map, const GraphEmbeddingSettings & options = {});

/** Embeds a graph with a given packed map. \pre `packed` is a packed map of `map`, which is a map of `graph`.
 * \ingroup ShapetonRicciFlowEmbedding
 */
ShapetonRicciFlowEmbedding_EXPORT EmbeddingCertificate
EmbedPackedGraph(const Graph & graph, const CombinatorialMap & map, const PackedMap & packed, PointAtInfinity infinity);

/** Packed map of a certificate. \ingroup ShapetonRicciFlowEmbedding */
ShapetonRicciFlowEmbedding_EXPORT PackedMap
PackedMapOf(const EmbeddingCertificate & certificate);
} // namespace shapeton

#endif
