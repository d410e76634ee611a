#ifndef shapetonPackedEmbedding_h
#define shapetonPackedEmbedding_h

#include "shapetonGraphEmbedding.h"

namespace shapeton
{
/** Packs circles, lays them out on the surface of the certificate's genus, and adds all of it to the certificate but
 * the rotation system of the graph. `rank` is that of CanonicalMapOrder, for genus 0. */
void
AddPacking(const Graph &            graph,
           const PackedMap &        packed,
           PointAtInfinity          infinity,
           const std::vector<int> & rank,
           const Progress &         progress,
           EmbeddingCertificate &   certificate);

/** Adds the smallest circle of a node of the graph, and a warning where there are circles too small to be seen. */
void
AddSmallestCircle(EmbeddingCertificate & certificate);
} // namespace shapeton

#endif
