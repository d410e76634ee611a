#ifndef shapetonTubeSections_h
#define shapetonTubeSections_h

#include "shapetonLumenVoxels.h"
#include "shapetonTubeBores.h"

#include <array>

namespace shapeton
{
/** A class of voxels beside those of LumenClass: other gas, not the colon's, with tissue all round, as in a balloon. */
constexpr unsigned char PocketGas = 6;

/** The part of the volume in which a catheter is looked for. */
struct CatheterRegion
{
  ColonGrid               grid;
  VoxelValues             hu;
  ClassVolume             classes;
  const ColonThresholds & thresholds;

  /** Linear between voxels; beyond the grid the value at its border. */
  double
  ValueAt(const Eigen::Vector3d & position) const;
  /** Of the nearest voxel; Nothing beyond the grid. */
  unsigned char
  ClassAt(const Eigen::Vector3d & position) const;
};

/** What lies behind a layer that a ray crosses. */
enum class BehindLayer
{
  Tissue, ///< the layer does not end within reach, or at a speck of gas
  Gas,    ///< of the colon or a pocket
  Fluid,  ///< of the colon
  Outside ///< other gas, as around the body
};

constexpr double ThinnestTubeWall = 1.0; // mm, if gas lies behind the wall
/** mm, if fluid lies behind the wall. Partial volume between gas and bright fluid alone looks like a wall of 1.2 mm. */
constexpr double ThinnestWallInFluid = 1.6;
constexpr double ThickestTubeWall = 4.5; // mm

/** A ray from the middle of a bore and the first layer on its way. Distances from the middle in mm. */
struct TubeRay
{
  double      inner{ 0.0 };  ///< where the gas ends; 0 where it does not within the ray's reach
  double      outer{ 0.0 };  ///< where the layer ends; 0 where it does not within reach
  double      wallHU{ 0.0 }; ///< the greatest in the layer
  BehindLayer behind{ BehindLayer::Tissue };

  /** The layer ends at lumen. */
  bool
  IsLeft() const;
  /** Gas, a wall, lumen. */
  bool
  IsEnclosed() const;
};

/** A way from the middle of a bore outwards. */
struct OutwardRay
{
  Eigen::Vector3d from;
  Eigen::Vector3d direction; ///< unit vector
  double          boundary;  ///< HU from which on there is no gas
};

/** A cut across a bore. */
struct TubeSection
{
  static constexpr int NumberOfRays = 48;

  Eigen::Vector3d                   centre;
  Eigen::Vector3d                   along; ///< unit vector
  std::array<Eigen::Vector3d, 2>    across;
  std::array<TubeRay, NumberOfRays> rays; ///< at even angles from across[0] towards across[1]

  Eigen::Vector3d
  DirectionOf(int ray) const;
  OutwardRay
  RayAlong(int ray, double boundary) const;
  /** The ray next to a place; `distance`: of the place from the axis. */
  int
  RayTo(const Eigen::Vector3d & position, double & distance) const;
  /** Of all rays, as those below. */
  double
  ClosedShare() const; ///< that leave the bore
  double
  ShareOf(BehindLayer behind) const;
  double
  EnclosedShare() const;
  /** The median of the rays that leave the bore; 0 where none does. */
  double
  BoreRadius() const;
  /** How far the bore is from round: the root mean square, by its mean radius, of the second and third harmonics of the
   * radius over the angle. The first one is that of an axis off the middle, higher ones are those of voxels. */
  double
  Ovality() const;
};

/** The first layer behind the gas at `start` on a ray that reaches to `reach`, mm. */
TubeRay
FirstLayer(const CatheterRegion & region, const OutwardRay & ray, double start, double reach);

/** The layer that a ray enters at `inner`, mm; one that goes on beyond `reach` has no end. */
TubeRay
CrossLayer(const CatheterRegion & region, const OutwardRay & ray, double inner, double reach);

/** One section for each point of an axis, moved into the middle of the bore. */
std::vector<TubeSection>
MeasureSections(const CatheterRegion & region, BoreAxis axis);

/** The value in the middle, for an odd number of values; 0 for none. */
double
MedianOf(std::vector<double> values);
} // namespace shapeton

#endif
