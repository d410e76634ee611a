#ifndef shapetonFluidBasins_h
#define shapetonFluidBasins_h

#include "shapetonPhantomRandom.h"

#include <vector>

namespace shapeton
{
/** A connection for fluid between two slices of the lumen. */
struct FluidPassage
{
  int    a;
  int    b;
  double height; // mm
};

/** The slices with fluid below one level. */
struct FluidPool
{
  std::vector<int> slices;
  double           level;
  double           bottom;
  std::size_t      points;
};

/** Number of lattice points of slices below a level; `heights` are sorted in each slice. */
std::size_t
PointsBelow(const std::vector<std::vector<float>> & heights, const std::vector<int> & slices, double level);

/** Distributes fluid, measured in lattice points, over the slices of a lumen; `heights` are the sorted heights of the
 * points of each slice. See ColonFluid. */
std::vector<FluidPool>
FillBasins(const std::vector<std::vector<float>> & heights,
           std::vector<FluidPassage>               passages,
           std::size_t                             points,
           std::size_t                             smallestBasin,
           PhantomRandom &                         random);
} // namespace shapeton

#endif
