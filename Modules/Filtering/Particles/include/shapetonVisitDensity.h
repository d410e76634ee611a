#ifndef shapetonVisitDensity_h
#define shapetonVisitDensity_h

#include "ShapetonParticlesExport.h"
#include "shapetonHeatClassification.h"

#include "itkImage.h"

#include <cstdint>

namespace shapeton
{
/** Visits divided by the maximum number of visits: a density in [0, 1], which can be used like heat for histogram,
 * classification and transfer function. 0 everywhere if there are no visits. \ingroup ShapetonParticles */
ShapetonParticles_EXPORT itk::Image<float, 3>::Pointer
                         NormalizeVisits(const itk::Image<std::uint32_t, 3> * visits);

/** Maximum number of visits of a voxel. \ingroup ShapetonParticles */
ShapetonParticles_EXPORT std::uint32_t
                         GreatestVisits(const itk::Image<std::uint32_t, 3> * visits);

/** Adds the normalized visits of all voxels to a row of a histogram. A number of visits n is spread over n - 1/2 to n +
 * 1/2, to avoid a comb of lines for small numbers; voxels without visits are in bin 0.
 * \ingroup ShapetonParticles */
ShapetonParticles_EXPORT void
AddVisitsToRow(const itk::Image<std::uint32_t, 3> * visits, std::size_t row, HeatHistogram & histogram);

/** The classes of a row filled by AddVisitsToRow(), as FindHeatClasses() finds them for heat. Voxels without visits are
 * background. `greatest` is the result of GreatestVisits(). \ingroup ShapetonParticles */
ShapetonParticles_EXPORT std::vector<HeatClass>
                         FindVisitClasses(const HeatHistogram & histogram, std::size_t row, std::uint32_t greatest);

/** The classes of a volume of visits and the label of each voxel, as ClassifyHeat() finds them for heat. `density` is
 * the result of NormalizeVisits(). \ingroup ShapetonParticles */
ShapetonParticles_EXPORT HeatClassification
ClassifyVisits(const itk::Image<std::uint32_t, 3> * visits, const itk::Image<float, 3> * density);
} // namespace shapeton

#endif
