#ifndef shapetonPackedEmbedding_h
#define shapetonPackedEmbedding_h

#include "shapetonGraphEmbedding.h"

namespace shapeton
{
/** Packs circles, lays them out on the surface of the certificate's genus, and adds everything to the certificate
 * except the rotation system of the graph. `rank` comes from CanonicalMapOrder, for genus 0. */
void
AddPacking(const Graph &            graph,
           const PackedMap &        packed,
           PointAtInfinity          infinity,
           const std::vector<int> & rank,
           const Progress &         progress,
           EmbeddingCertificate &   certificate);

/** Adds the smallest node circle of the graph, and a warning if circles are too small to be visible. */
void
AddSmallestCircle(EmbeddingCertificate & certificate);
} // namespace shapeton

#endif
