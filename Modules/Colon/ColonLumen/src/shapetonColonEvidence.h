#ifndef shapetonColonEvidence_h
#define shapetonColonEvidence_h

#include "shapetonAirFluidLevels.h"
#include "shapetonColonLumenSegmentation.h"
#include "shapetonGasPieces.h"
#include "shapetonLungEvidence.h"

namespace shapeton
{
constexpr double LargeLevel = 200.0; // mm^2
constexpr double PoolArea = 20.0;    // mm^2

/** All that is known of the volume before single voxels are decided. */
struct ColonEvidence
{
  ColonGrid                       grid;
  VoxelValues                     hu;
  ColonThresholds                 thresholds;
  double                          noise{ 0.0 };
  double                          remainingNoise{ 0.0 }; ///< after the prefilter
  double                          smoothing{ 0.0 };
  double                          bodyMl{ 0.0 }; ///< of everything denser than -400 HU
  GasOfVolume                     gas;
  std::vector<LungEvidence>       lung;        ///< of pieces of gas from 20 ml on; zero below
  std::vector<std::string>        kind;        ///< of pieces of gas: why not colon, empty for colon
  std::vector<char>               isCandidate; ///< pieces of gas that may lie in a bowel
  std::vector<char>               isColon;     ///< pieces of gas
  Eigen::Vector3d                 gravity{ 0.0, 1.0, 0.0 };
  std::vector<Level>              levels; ///< under the candidates
  VoxelRuns                       brightSet;
  RunLabels                       brightLabels;
  std::vector<char>               isColonBright; ///< bright pieces that are connected to colon gas or hold a seed
  std::vector<std::vector<int>>   brightOfLevel;
  std::vector<std::array<int, 3>> brightSeeds; ///< seed points in bright matter
  bool                            isTagged{ false };
};

/** The intensity of the fluid under the colon's levels and the thresholds that follow from it. */
void
MeasureFluid(ColonEvidence & evidence);

/** Bright matter, and which of it is connected to the colon's gas. */
void
FindBright(ColonEvidence & evidence);

/** The box around all that may be colon. */
VoxelBox
BoxOfColon(const ColonEvidence & evidence);

/** Voxels of the seed points. */
struct LumenSeeds
{
  std::vector<std::array<int, 3>> gas;
  std::vector<std::array<int, 3>> bright;
};

/** Of each point (LPS, mm) the most extreme voxel within 2 mm: gas, else bright. Throws ParameterError for a point that
 * lies outside the image, or in neither. */
LumenSeeds
FindSeedVoxels(const ColonEvidence & evidence, const std::vector<itk::Point<double, 3>> & points);

/** Fills in which way fluid falls and the levels under the candidates: along the direction that the position of the
 * patient says, else the one with by far the most flat levels, else supine. Warns where the position contradicts the
 * levels, and where nothing is known. */
void
FindGravity(const std::string & patientPosition, ColonEvidence & evidence, ColonLumen & lumen);
} // namespace shapeton

#endif
