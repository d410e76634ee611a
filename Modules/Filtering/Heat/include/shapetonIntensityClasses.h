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

/** Mean of the darkest, two thresholds, and mean of the brightest of the three classes of greatest variance between
 * them (Otsu 1979), of a sorted sample without its extremes. \ingroup ShapetonHeat */
ShapetonHeat_EXPORT std::array<double, 4>
                    FindIntensityClasses(const std::vector<float> & sample);
} // namespace shapeton

#endif
