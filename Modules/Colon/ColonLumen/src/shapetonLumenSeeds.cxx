#include "shapetonLumenSeeds.h"

#include "shapetonVoxelSet.h"
#include "shapetonExceptions.h"

#include <cmath>
#include <optional>
#include <sstream>

namespace shapeton
{
namespace
{
constexpr double SeedReach = 2.0;       // mm
constexpr double LeastContrast = 150.0; // HU, of bright matter above tissue

std::string
NameOf(const itk::Point<double, 3> & point)
{
  std::ostringstream name;
  name << "the seed point " << point[0] << ',' << point[1] << ',' << point[2];
  return name.str();
}

std::size_t
VoxelOf(const ColonGrid & grid, const itk::Point<double, 3> & point)
{
  const Eigen::Vector3d    x = grid.VoxelOf(Eigen::Vector3d(point[0], point[1], point[2]));
  const std::array<int, 3> v{
    { static_cast<int>(std::lround(x[0])), static_cast<int>(std::lround(x[1])), static_cast<int>(std::lround(x[2])) }
  };
  RequireParameter(x.allFinite() && grid.Holds(v[0], v[1], v[2]), NameOf(point) + " lies outside the image");
  return grid.Index(v[0], v[1], v[2]);
}

/** The voxel near this one whose value, times `sign`, is greatest, and greater than a threshold. */
std::optional<std::size_t>
MostExtreme(const ColonEvidence & evidence, std::size_t voxel, double sign, double threshold)
{
  std::optional<std::size_t> best;
  double                     most = sign * threshold;
  ForAllWithin(evidence.grid, voxel, SeedReach, [&](std::size_t p, double) {
    if (sign * evidence.hu[p] > most)
    {
      most = sign * evidence.hu[p];
      best = p;
    }
    return true;
  });
  return best;
}
} // namespace

LumenSeeds
FindSeedVoxels(const ColonEvidence & evidence, const std::vector<itk::Point<double, 3>> & points)
{
  LumenSeeds seeds;
  for (const auto & point : points)
  {
    const std::size_t voxel = VoxelOf(evidence.grid, point);
    if (const auto gas = MostExtreme(evidence, voxel, -1.0, evidence.thresholds.gasSeed))
    {
      seeds.gas.push_back(evidence.grid.Voxel(*gas));
      continue;
    }
    const auto bright = MostExtreme(evidence, voxel, 1.0, evidence.thresholds.tissue + LeastContrast);
    RequireParameter(bright.has_value(),
                     NameOf(point) +
                       " lies in neither gas nor bright fluid; give a point inside the colon's lumen in LPS, mm");
    seeds.bright.push_back(evidence.grid.Voxel(*bright));
  }
  return seeds;
}
} // namespace shapeton
