#ifndef shapetonGraphEmbedding_h
#define shapetonGraphEmbedding_h

#include "shapetonEmbeddingCertificate.h"
#include "shapetonPackedMap.h"
#include "shapetonProgress.h"
#include "shapetonSphericalPacking.h"

namespace shapeton
{
/** How a graph is embedded. \ingroup RicciFlowEmbedding */
struct GraphEmbeddingOptions
{
  Augmentation    augmentation{ Augmentation::Ring };
  PointAtInfinity infinity{ PointAtInfinity::Circle }; ///< genus 0 alone
  /** Nobody has chosen the rotation system: blocks may be arranged anew (see ArrangeBlocks). */
  bool isRotationFree{ false };
  /** With that, a map of genus 0 may be seen from its other side, so that which of the two it is does not depend on
   * numbers. */
  bool isSideFree{ true };
  /** See AugmentationOptions. */
  int longestFace{ AugmentationOptions().longestFace };
  /** It may throw in order to abort. */
  Progress progress;
};

/** Below this radius, of a cap in radians or of a circle in the hyperbolic plane or as part of the lattice's shorter
 * period, a circle of the graph is not legible in any picture: a warning. \ingroup RicciFlowEmbedding */
constexpr double smallestLegibleRadius = 1e-9;

/** \brief Embeds a graph, whose map says how it lies on a surface, by the circle packing of that map: on the unit
 * sphere for genus 0, a flat torus for genus 1, a hyperbolic surface for genus 2 and more.
 *
 * On the sphere the packing is unique but for Moebius transformations; the conformal barycentre of the touch points of
 * the graph's edges is at the centre, and a rotation that the map alone determines, not the numbering, stands the
 * sphere up (see TurnToCanonicalPosition). A graph of several components is embedded on the connected sum of their
 * surfaces.
 *
 * The certificate has all but the provenance. Throws InputError where no packing exists or none is found.
 * \pre `map` is one of `graph`. \ingroup RicciFlowEmbedding */
RicciFlowEmbedding_EXPORT EmbeddingCertificate
EmbedGraph(const Graph & graph, const CombinatorialMap & map, const GraphEmbeddingOptions & options = {});

/** The same by a packed map that is given. \pre `packed` is one of `map`, which is one of `graph`.
 * \ingroup RicciFlowEmbedding */
RicciFlowEmbedding_EXPORT EmbeddingCertificate
EmbedPackedGraph(const Graph & graph, const CombinatorialMap & map, const PackedMap & packed, PointAtInfinity infinity);

/** The packed map of a certificate. \ingroup RicciFlowEmbedding */
RicciFlowEmbedding_EXPORT PackedMap
PackedMapOf(const EmbeddingCertificate & certificate);
} // namespace shapeton

#endif
