#ifndef shapetonTubeSections_h
#define shapetonTubeSections_h

#include "shapetonLumenField.h"
#include "shapetonTubeBores.h"

#include <array>

namespace shapeton
{
/** Additional LumenClass: gas outside the colon surrounded by tissue, as in a balloon. */
constexpr unsigned char PocketGas = 6;

/** The part of the volume searched for a catheter. */
struct CatheterRegion
{
  ColonGrid               grid;
  VoxelValues             hu;
  ClassVolume             classes;
  const ColonThresholds & thresholds;

  /** Linear interpolation; border values are repeated. */
  double
  ValueAt(const Eigen::Vector3d & position) const;
  /** Class of the nearest voxel; Nothing outside the grid. */
  unsigned char
  ClassAt(const Eigen::Vector3d & position) const;
};

/** Matter behind a layer crossed by a ray. */
enum class BehindLayer
{
  Tissue, ///< no end within reach, or only a speck of gas
  Gas,    ///< of the colon or a pocket
  Fluid,  ///< of the colon
  Outside ///< other gas, such as around the body
};

constexpr double ThinnestTubeWall = 1.0; // mm, next to gas; chosen
/** mm, next to fluid; partial volume between gas and bright fluid resembles a wall of 1.2 mm. */
constexpr double ThinnestWallInFluid = 1.6;
constexpr double ThickestTubeWall = 4.5; // mm; chosen

/** The first layer along a ray from the center of a bore. Distances are from the center, mm. */
struct TubeRay
{
  double      inner{ 0.0 };  ///< end of the gas; 0 if not within reach
  double      outer{ 0.0 };  ///< end of the layer; 0 if not within reach
  double      wallHU{ 0.0 }; ///< maximum in the layer
  BehindLayer behind{ BehindLayer::Tissue };

  /** Whether the layer ends at lumen. */
  bool
  IsLeft() const;
  /** Whether the sequence is gas, wall, lumen. */
  bool
  IsEnclosed() const;
};

/** Sampling path outward from the center of a bore. */
struct OutwardRay
{
  Eigen::Vector3d from;
  Eigen::Vector3d direction; ///< unit vector
  double          boundary;  ///< upper threshold of gas, HU
};

/** A cross section of a bore. */
struct TubeSection
{
  static constexpr int NumberOfRays = 48; ///< chosen: 0.7 mm apart at a radius of 5 mm

  Eigen::Vector3d                   center;
  Eigen::Vector3d                   along; ///< unit vector
  std::array<Eigen::Vector3d, 2>    across;
  std::array<TubeRay, NumberOfRays> rays; ///< at equal angles from across[0] to across[1]

  Eigen::Vector3d
  DirectionOf(int ray) const;
  OutwardRay
  RayAlong(int ray, double boundary) const;
  /** The ray nearest to a point; `distance` is set to the distance from the point to the axis. */
  int
  RayTo(const Eigen::Vector3d & position, double & distance) const;
  double
  ClosedShare() const; ///< fraction of rays that end at the wall
  double
  ShareOf(BehindLayer behind) const;
  /** Fraction of enclosed rays. */
  double
  EnclosedShare() const;
  /** Median over the rays that end at the wall; 0 if there are none. */
  double
  BoreRadius() const;
  /** Deviation of the bore from a circle: root mean square of the second and third harmonics of the radius over the
   * angle, divided by the mean radius. The first harmonic is caused by an off-center axis, harmonics above the third by
   * voxel steps. */
  double
  Ovality() const;
};

/** The first layer behind the gas at `start` along a ray of length `reach`, mm. */
TubeRay
FirstLayer(const CatheterRegion & region, const OutwardRay & ray, double start, double reach);

/** The layer that begins at `inner` (mm) along a ray; its end is unset beyond `reach`. */
TubeRay
CrossLayer(const CatheterRegion & region, const OutwardRay & ray, double inner, double reach);

/** One section per point of an axis, centered in the bore. */
std::vector<TubeSection>
MeasureSections(const CatheterRegion & region, BoreAxis axis);
} // namespace shapeton

#endif
