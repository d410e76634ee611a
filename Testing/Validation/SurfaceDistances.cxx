#include "SurfaceDistances.h"
#include "Tables.h"

#include "shapetonExceptions.h"
#include "shapetonImageGrid.h"
#include "shapetonSquaredDistances.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace shapeton;

namespace
{
/** 0 for voxels of the surface, 1 for all others. */
std::vector<unsigned char>
OutsideSurface(const LumenMask * mask)
{
  const VoxelGrid             grid = GridOf(mask);
  const unsigned char * const voxels = mask->GetBufferPointer();
  std::vector<unsigned char>  outside(grid.NumberOfVoxels(), 1);
  for (std::size_t i = 0; i < outside.size(); ++i)
  {
    if (voxels[i] != 0)
    {
      ForEachNeighbor(grid, i, [&](std::size_t neighbor) { outside[i] = voxels[neighbor] == 0 ? 0 : outside[i]; });
    }
  }
  return outside;
}

/** Distances (mm) of the points of one surface from another one. */
std::vector<double>
DistancesOf(const std::vector<unsigned char> & from, const std::vector<unsigned char> & to, const LumenMask * mask)
{
  const auto          spacing = mask->GetSpacing();
  const VoxelValues   squares = SquaredDistances(GridOf(mask), { { spacing[0], spacing[1], spacing[2] } }, to);
  std::vector<double> distances;
  for (std::size_t i = 0; i < from.size(); ++i)
  {
    if (from[i] == 0)
    {
      distances.push_back(std::sqrt(squares[i]));
    }
  }
  return distances;
}
} // namespace

SurfaceDistances
MeasureSurfaceDistances(const LumenMask * first, const LumenMask * second)
{
  if (!HaveSameGrid(first, second))
  {
    throw InputError("the surfaces of two masks are compared on one grid only");
  }
  const std::vector<unsigned char> a = OutsideSurface(first);
  const std::vector<unsigned char> b = OutsideSurface(second);
  std::vector<double>              ofA = DistancesOf(a, b, first);
  const std::vector<double>        ofB = DistancesOf(b, a, first);
  SurfaceDistances                 distances;
  if (ofA.empty() != ofB.empty())
  {
    distances.average = distances.hausdorff95 = std::numeric_limits<double>::infinity();
    return distances;
  }
  distances.hausdorff95 = std::max(LowerQuantile(ofA, 0.95), LowerQuantile(ofB, 0.95));
  ofA.insert(ofA.end(), ofB.begin(), ofB.end());
  distances.average = MeanOf(ofA);
  return distances;
}
