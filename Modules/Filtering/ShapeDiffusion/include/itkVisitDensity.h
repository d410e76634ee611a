#ifndef itkVisitDensity_h
#define itkVisitDensity_h

#include "ShapeDiffusionExport.h"
#include "itkHeatHistogram.h"

#include "itkImage.h"

#include <cstdint>

namespace itk
{
/** Visits divided by the greatest number of visits: a density in [0, 1], to which histogram, classification and
 * transfer function apply as they do to heat. 0 everywhere when there are no visits. \ingroup ShapeDiffusion */
ShapeDiffusion_EXPORT Image<float, 3>::Pointer
                      NormalizeVisits(const Image<std::uint32_t, 3> * visits);

/** Counts the voxels by their normalised visits in a row of a histogram. \ingroup ShapeDiffusion */
ShapeDiffusion_EXPORT void
AddVisitsToRow(const Image<std::uint32_t, 3> * visits, std::size_t row, HeatHistogram & histogram);
} // namespace itk

#endif
