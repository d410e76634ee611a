#ifndef shapetonHandleCut_h
#define shapetonHandleCut_h

#include "RicciFlowEmbeddingExport.h"
#include "shapetonCombinatorialMap.h"

#include <array>
#include <vector>

namespace shapeton
{
/** \brief A map of genus g, cut along g closed curves into a map of genus 0 with a hub on either side of each cut.
 *
 * Each curve runs through faces and crosses edges, meets neither itself nor another curve, and leaves the surface in
 * one piece. Both holes that it makes are filled by a node, the hub, where the halves of the crossed edges end. So all
 * faces stay disks, and putting the hubs of each pair together again, reversed, gives the map back.
 *
 * A curve is the shortest, in crossed edges, of the loops that trees of the dual from some faces make: from each face
 * where the map is small. (Tree and cotree: Eppstein 2003; the loop through an edge in neither tree crosses a loop of
 * the map once, so it does not divide the surface.) Components of genus 0 stay as they are.
 * \ingroup RicciFlowEmbedding */
struct RicciFlowEmbedding_EXPORT HandleCut
{
  explicit HandleCut(const CombinatorialMap & map);

  /** Genus 0. Nodes and half-edges 2e of the map keep their numbers and places; the halves of crossed edges end at
   * hubs, whose numbers are above those of the nodes. */
  CombinatorialMap sphere;
  /** The two hubs of each handle. Half-edges that `across` joins stand counter-clockwise around the first, clockwise
   * around the second. */
  std::vector<std::array<int, 2>> hubs;
  /** Of each half-edge of `sphere` that leaves a hub, the one at the other hub that goes on with its edge; -1 for
   * others. */
  std::vector<int> across;
};
} // namespace shapeton

#endif
