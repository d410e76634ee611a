#ifndef shapetonObjectParameters_h
#define shapetonObjectParameters_h

#include "shapetonHeatParameterChoice.h"
#include "ShapetonHeatObjectsExport.h"

#include <array>
#include <vector>

namespace shapeton
{
/** Parameters of cumulative heat diffusion by which the objects on both sides of an intensity get a heat of their own.
 *
 * The window is so narrow that nearly every edge that crosses `threshold` insulates, and nothing else does: objects are
 * connected regions on one side of the threshold. Smoothing by 0.8 of the smallest spacing closes gaps of single
 * voxels. After 100,000 steps heat is even inside of objects up to about 130 voxels wide, while contacts between them,
 * narrow compared with their volume, have let little of it pass; smaller objects need less. Chosen on the bones of the
 * data set foot: with 4,000 steps 4 of 12 bones were separate, with 30,000 11, with 100,000 all.
 *
 * \param contrast difference between the brightest and the darkest of three intensity classes
 * \param spacing mm
 * \ingroup ShapetonHeatObjects */
ShapetonHeatObjects_EXPORT HeatParameterChoice
ParametersAtThreshold(double threshold, double contrast, const std::array<double, 3> & spacing);

/** Windows at several thresholds of intensity, as ParametersAtThreshold(), and for each the time, of five from 3,000 to
 * 300,000 steps, at which most objects are found: the sum of their probabilities. Thresholds: the two between three
 * intensity classes (Otsu 1979), the middle between the dark and the bright class, the upper one of what is brighter
 * than the dark class, and the lower one of what is brighter than that, if neighbors on both sides of it differ by a
 * twentieth of the contrast and it is as far from the dark class. The first one shows most objects; of nearly equal
 * ones, that with the strongest edges. The others follow by descending number of objects; those that do not add one to
 * the objects of the windows before, see FindWindowObjects(), are left out. Volumes of more than 128^3 voxels are
 * reduced for these trials. Values that are given are kept; with a given window there is one threshold. The reasons are
 * in words. Throws as DiffuseCumulativeHeat().
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
