#ifndef GraphPackingPeers_h
#define GraphPackingPeers_h

#include "shapetonCirclePacking.h"
#include "shapetonGraph.h"

#include <array>
#include <vector>

/** Peers for circle packing: methods from the literature and a force layout. */
namespace peers
{
/** Triangulated grids with random diagonals; on the sphere, one node closes the boundary. */
shapeton::CombinatorialMap
GridOnSphere(int side);
shapeton::CombinatorialMap
GridOnTorus(int side);

shapeton::CirclesAtInfinity
CirclesThroughFirstEdge(const shapeton::CombinatorialMap & map);

enum class Method
{
  ThurstonSweep, ///< updates one radius at a time by the uniform neighbor model (Collins and Stephenson)
  GradientFlow   ///< du = -h K with the largest stable h
};

struct PeerRun
{
  double seconds{ 0.0 };
  double steps{ 0.0 };
  double residual{ 0.0 };
  bool   isExtrapolated{ false };
};

/** Runs until the curvature is 1e-10; after one minute, time and steps are extrapolated. */
PeerRun
RunPeer(const shapeton::CombinatorialMap & map, const shapeton::CirclesAtInfinity & infinite, Method method);

struct SfdpRun
{
  double                             seconds{ -1.0 }; ///< negative if sfdp is not installed
  long                               crossings{ 0 };
  std::vector<std::array<double, 2>> places;
};

/** Graphviz's force layout of a large graph. Crossings are counted over all pairs of edges. */
SfdpRun
RunSfdp(const shapeton::Graph & graph, bool countsCrossings = true);
} // namespace peers

#endif
