#ifndef shapetonColonEvidence_h
#define shapetonColonEvidence_h

#include "shapetonAirFluidLevels.h"
#include "shapetonColonLumenSegmentation.h"
#include "shapetonGasPieces.h"
#include "shapetonLungEvidence.h"

namespace shapeton
{
constexpr double LargeLevel = 200.0; // mm^2; chosen
constexpr double PoolArea = 20.0;    // mm^2; chosen

/** Global evidence from the volume, computed before voxel classification. */
struct ColonEvidence
{
  ColonGrid                       grid;
  VoxelValues                     hu;
  ColonThresholds                 thresholds;
  double                          noise{ 0.0 };
  double                          remainingNoise{ 0.0 }; ///< after the prefilter
  double                          smoothing{ 0.0 };
  double                          bodyMl{ 0.0 }; ///< volume denser than -400 HU
  GasOfVolume                     gas;
  std::vector<LungEvidence>       lung;        ///< per piece of gas; zero below 20 ml
  std::vector<std::string>        kind;        ///< per piece of gas; empty for colon
  std::vector<char>               isCandidate; ///< pieces of gas that may be in a bowel
  std::vector<char>               isColon;     ///< pieces of gas
  Eigen::Vector3d                 gravity{ 0.0, 1.0, 0.0 };
  std::vector<Level>              levels; ///< under the candidates
  VoxelRuns                       brightSet;
  RunLabels                       brightLabels;
  std::vector<char>               isColonBright; ///< bright pieces connected to colon gas or with a seed
  std::vector<std::vector<int>>   brightOfLevel;
  std::vector<std::array<int, 3>> brightSeeds; ///< seed points in bright matter
  bool                            isTagged{ false };
};

/** Computes the intensity of the fluid under the levels of the colon, and the thresholds derived from it. */
void
MeasureFluid(ColonEvidence & evidence);

/** Adds tilted and small levels of the colon if the matter directly below is as bright as the fluid of the colon and
 * the voxels are small enough to show a wall in between. */
void
AddTiltedLevels(ColonEvidence & evidence);

/** Finds bright matter, and its pieces connected to the gas of the colon. */
void
FindBright(ColonEvidence & evidence);

/** The bounding box of all candidates for colon. */
VoxelBox
BoxOfColon(const ColonEvidence & evidence);

/** Voxels of the seed points. */
struct LumenSeeds
{
  std::vector<std::array<int, 3>> gas;
  std::vector<std::array<int, 3>> bright;
};

/** Finds the most extreme voxel within 2 mm of each point (LPS, mm): gas if any, otherwise bright matter. Throws
 * ParameterError for a point outside the image, or near neither gas nor bright matter. */
LumenSeeds
FindSeedVoxels(const ColonEvidence & evidence, const std::vector<itk::Point<double, 3>> & points);

/** Sets gravity and the levels under the candidates. Gravity is that of the patient position if given, otherwise the
 * direction with by far the largest area of flat levels, otherwise that of a supine patient. Warns if the position
 * contradicts the levels or gravity is unknown. */
void
FindGravity(const std::string & position, ColonEvidence & evidence, ColonLumen & lumen);
} // namespace shapeton

#endif
