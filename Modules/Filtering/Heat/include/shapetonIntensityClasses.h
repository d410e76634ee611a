#ifndef shapetonIntensityClasses_h
#define shapetonIntensityClasses_h

#include "ShapetonHeatExport.h"
#include "shapetonVolumeView.h"

#include <array>
#include <vector>

namespace shapeton
{
/** Sorted sample of about 500,000 values. \ingroup ShapetonHeat */
ShapetonHeat_EXPORT std::vector<float>
                    SampleIntensities(const VolumeView & volume);

/** Mean of the darkest class, the two thresholds, and mean of the brightest class, for the three classes with the
 * greatest between-class variance (Otsu 1979) in a sorted sample, excluding its extremes. \ingroup ShapetonHeat */
ShapetonHeat_EXPORT std::array<double, 4>
                    FindIntensityClasses(const std::vector<float> & sample);
} // namespace shapeton

#endif
