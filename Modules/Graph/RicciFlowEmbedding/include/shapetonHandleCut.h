#ifndef shapetonHandleCut_h
#define shapetonHandleCut_h

#include "ShapetonRicciFlowEmbeddingExport.h"
#include "shapetonCombinatorialMap.h"

#include <array>
#include <vector>

namespace shapeton
{
/** \brief Cuts a map of genus g along g closed curves into a map of genus 0 with a hub on each side of each cut.
 *
 * Each curve passes through faces and crosses edges. The curves are simple and disjoint, and do not disconnect the
 * surface. Each of the two holes of a cut is filled by a node, the hub, where the halves of the crossed edges end. All
 * faces remain disks, and gluing each pair of hubs together, reversed, restores the map.
 *
 * Each curve is the shortest, in crossed edges, of the loops found by dual trees from some root faces (from every face
 * on small maps). (Tree and cotree: Eppstein 2003; the loop through an edge outside both trees crosses a loop of the
 * map once, so it does not separate the surface.) Components of genus 0 are unchanged.
 * \ingroup ShapetonRicciFlowEmbedding */
struct ShapetonRicciFlowEmbedding_EXPORT HandleCut
{
  explicit HandleCut(const CombinatorialMap & map);

  /** The cut map of genus 0. Nodes and half-edges 2e of the map keep their numbers and positions. The halves of crossed
   * edges end at hubs, which are numbered after the nodes. */
  CombinatorialMap sphere;
  /** The two hubs of each handle. Half-edges joined by `across` are counter-clockwise around the first hub, clockwise
   * around the second. */
  std::vector<std::array<int, 2>> hubs;
  /** For each half-edge of `sphere` that starts at a hub, its continuation at the other hub; -1 for others. */
  std::vector<int> across;
};
} // namespace shapeton

#endif
