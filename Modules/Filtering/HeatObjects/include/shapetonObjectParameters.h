#ifndef shapetonObjectParameters_h
#define shapetonObjectParameters_h

#include "shapetonHeatParameterChoice.h"
#include "ShapetonHeatObjectsExport.h"

#include <array>
#include <vector>

namespace shapeton
{
/** Parameters of cumulative heat diffusion that give each object above or below an intensity threshold its own heat.
 *
 * The window is so narrow that nearly every edge that crosses `threshold` insulates, and nothing else does: objects are
 * connected regions on one side of the threshold. Smoothing by 0.8 of the smallest spacing closes gaps of single
 * voxels. After 100,000 steps, heat is uniform inside objects up to about 130 voxels wide, while little of it has
 * passed through the contacts between objects, which are narrow relative to their volume; smaller objects need fewer
 * steps. Chosen on the 12 bones of the data set foot: 4 were separate after 4,000 steps, 11 after 30,000, and all after
 * 100,000.
 *
 * \param contrast difference between the brightest and the darkest of three intensity classes
 * \param spacing mm
 * \ingroup ShapetonHeatObjects */
ShapetonHeatObjects_EXPORT HeatParameterChoice
ParametersAtThreshold(double threshold, double contrast, const std::array<double, 3> & spacing);

/** Windows at several intensity thresholds, as returned by ParametersAtThreshold(), each with the time, out of five
 * from 3,000 to 300,000 steps, at which it shows the most objects, counted by the sum of their probabilities.
 * Thresholds: the two between three intensity classes (Otsu 1979); the midpoint of the dark and the bright class; the
 * upper one between three classes of the voxels brighter than the dark class; and the lower one between three classes
 * of the voxels brighter than that. A threshold is used if neighbors on opposite sides of it differ by at least a
 * twentieth of the contrast on average, and it exceeds the mean of the dark class by as much. The first window shows
 * the most objects; among nearly equal ones, it has the strongest edges. The others follow by descending number of
 * objects; a window that adds no object to those of the preceding windows (see FindWindowObjects()) is omitted. Volumes
 * of more than 128^3 voxels are reduced for these trials. Given values are kept; a given window is the only one
 * returned. The reasons are in words. Throws as DiffuseCumulativeHeat().
 * \ingroup ShapetonHeatObjects */
ShapetonHeatObjects_EXPORT std::vector<HeatParameterChoice>
                           ChooseObjectWindows(const VolumeView &                     volume,
                                               const CumulativeHeatDiffusionOptions & options = {},
                                               const GivenHeatParameters &            given = {},
                                               const Progress &                       progress = {});

/** The first one of ChooseObjectWindows(). \ingroup ShapetonHeatObjects */
ShapetonHeatObjects_EXPORT HeatParameterChoice
ChooseObjectParameters(const VolumeView &                     volume,
                       const CumulativeHeatDiffusionOptions & options = {},
                       const GivenHeatParameters &            given = {},
                       const Progress &                       progress = {});
} // namespace shapeton

#endif
