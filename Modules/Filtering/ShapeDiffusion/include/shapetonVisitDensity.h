#ifndef shapetonVisitDensity_h
#define shapetonVisitDensity_h

#include "ShapeDiffusionExport.h"
#include "shapetonHeatClassification.h"

#include "itkImage.h"

#include <cstdint>

namespace shapeton
{
/** Visits divided by the greatest number of visits: a density in [0, 1], to which histogram, classification and
 * transfer function apply as they do to heat. 0 everywhere when there are no visits. \ingroup ShapeDiffusion */
ShapeDiffusion_EXPORT itk::Image<float, 3>::Pointer
                      NormalizeVisits(const itk::Image<std::uint32_t, 3> * visits);

/** The greatest number of visits of a voxel. \ingroup ShapeDiffusion */
ShapeDiffusion_EXPORT std::uint32_t
                      GreatestVisits(const itk::Image<std::uint32_t, 3> * visits);

/** Counts the voxels by their normalised visits in a row of a histogram. A number of visits n stands for all from n -
 * 1/2 to n + 1/2, so that small numbers make no comb of lines; voxels without visits lie in bin 0.
 * \ingroup ShapeDiffusion */
ShapeDiffusion_EXPORT void
AddVisitsToRow(const itk::Image<std::uint32_t, 3> * visits, std::size_t row, HeatHistogram & histogram);

/** The classes of a row that AddVisitsToRow() filled, as FindHeatClasses() finds those of heat. The background are
 * voxels without visits. `greatest` is that of GreatestVisits(). \ingroup ShapeDiffusion */
ShapeDiffusion_EXPORT std::vector<HeatClass>
                      FindVisitClasses(const HeatHistogram & histogram, std::size_t row, std::uint32_t greatest);

/** The classes of a volume of visits and the label of each voxel, as ClassifyHeat() finds those of heat.
 * `density` is that of NormalizeVisits(). \ingroup ShapeDiffusion */
ShapeDiffusion_EXPORT HeatClassification
ClassifyVisits(const itk::Image<std::uint32_t, 3> * visits, const itk::Image<float, 3> * density);
} // namespace shapeton

#endif
