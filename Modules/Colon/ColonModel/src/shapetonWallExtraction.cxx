#include "shapetonCenterlineGeometry.h"
#include "shapetonColonWall.h"
#include "shapetonExceptions.h"
#include "shapetonLevelSurface.h"
#include "shapetonParallelFor.h"

#include <algorithm>
#include <stdexcept>

namespace shapeton
{
namespace
{
constexpr float LevelOfWall = 0.5F; // occupancy at the wall
/** Minimum difference of values from the level, to avoid degenerate faces at a voxel. */
constexpr float LeastStep = 0.001F;

/** Reflects a value about the level if it is on the wrong side. */
float
ClampedValue(float value, bool isLumen)
{
  const float mirrored = isLumen == (value >= LevelOfWall) ? value : 1.0F - value;
  return isLumen ? std::max(mirrored, LevelOfWall + LeastStep) : std::min(mirrored, LevelOfWall - LeastStep);
}

/** Size of the padded field. */
std::array<int, 3>
PaddedSize(const OccupancyImage * occupancy)
{
  const auto size = occupancy->GetBufferedRegion().GetSize();
  return { static_cast<int>(size[0]) + 2, static_cast<int>(size[1]) + 2, static_cast<int>(size[2]) + 2 };
}

/** The field padded with zeros, clamped to the mask. */
std::vector<float>
PaddedField(const OccupancyImage * occupancy, const LumenMaskImage * mask)
{
  const auto                  size = occupancy->GetBufferedRegion().GetSize();
  const float * const         from = occupancy->GetBufferPointer();
  const unsigned char * const isIn = mask == nullptr ? nullptr : mask->GetBufferPointer();
  std::vector<float>          values((size[0] + 2) * (size[1] + 2) * (size[2] + 2), 0.0F);
  ParallelFor(size[2], [&](std::size_t z) {
    for (std::size_t y = 0; y < size[1]; ++y)
    {
      float * const row = values.data() + ((z + 1) * (size[1] + 2) + y + 1) * (size[0] + 2) + 1;
      std::size_t   i = (z * size[1] + y) * size[0];
      for (std::size_t x = 0; x < size[0]; ++x, ++i)
      {
        row[x] = ClampedValue(from[i], isIn == nullptr ? from[i] >= LevelOfWall : isIn[i] != 0);
      }
    }
  });
  return values;
}

/** Extracts the contour in LPS mm. */
SurfaceMesh
ContourOf(const OccupancyImage * occupancy, const LumenMaskImage * mask)
{
  std::vector<float> values = PaddedField(occupancy, mask);
  SurfaceMesh        mesh = LevelSurface(values, PaddedSize(occupancy), LevelOfWall, -1.0);
  const GridGeometry grid(occupancy);
  for (Eigen::Index i = 0; i < mesh.V.rows(); ++i)
  {
    mesh.V.row(i) = grid.PointOf(mesh.V.row(i).transpose());
  }
  return mesh;
}
} // namespace

SurfaceMesh
ExtractWall(const OccupancyImage * occupancy, const LumenMaskImage * mask)
{
  if (mask != nullptr && mask->GetBufferedRegion().GetSize() != occupancy->GetBufferedRegion().GetSize())
  {
    throw std::invalid_argument("The occupancy and the mask have different sizes");
  }
  const SurfaceMesh mesh = ContourOf(occupancy, mask);
  if (mesh.NumberOfFaces() == 0)
  {
    throw InputError("the lumen has no wall: no voxel has an occupancy of at least 0.5");
  }
  return OuterShell(mesh);
}
} // namespace shapeton
