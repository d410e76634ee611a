#ifndef shapetonLumenSeeds_h
#define shapetonLumenSeeds_h

#include "shapetonColonSearch.h"

namespace shapeton
{
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
} // namespace shapeton

#endif
