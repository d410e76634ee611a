#ifndef GraphPackingPeers_h
#define GraphPackingPeers_h

#include "shapetonCirclePacking.h"
#include "shapetonGraph.h"

#include <array>
#include <vector>

/** Peers of the circle packing: methods that the literature names, and a layout by forces. */
namespace peers
{
/** Triangulated grids, each diagonal one of the two: on the sphere with one node that closes the boundary. */
shapeton::CombinatorialMap
GridOnSphere(int side);
shapeton::CombinatorialMap
GridOnTorus(int side);

shapeton::CirclesAtInfinity
CirclesThroughFirstEdge(const shapeton::CombinatorialMap & map);

enum class Method
{
  ThurstonSweep, ///< each circle in turn takes the radius that uniform neighbours would give it (Collins and
                 ///< Stephenson)
  GradientFlow   ///< du = -h K with the largest h that is stable
};

struct PeerRun
{
  double seconds{ 0.0 };
  double steps{ 0.0 };
  double residual{ 0.0 };
  bool   isExtrapolated{ false };
};

/** Runs to a curvature of 1e-10 or for a minute, then time and steps are extrapolated. */
PeerRun
RunPeer(const shapeton::CombinatorialMap & map, const shapeton::CirclesAtInfinity & infinite, Method method);

struct SfdpRun
{
  double                             seconds{ -1.0 }; ///< negative: not installed
  long                               crossings{ 0 };
  std::vector<std::array<double, 2>> places;
};

/** Graphviz's layout of a large graph by forces. Crossings are counted by all pairs of edges. */
SfdpRun
RunSfdp(const shapeton::Graph & graph, bool countsCrossings = true);
} // namespace peers

#endif
