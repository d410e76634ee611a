#ifndef itkColonQuality_h
#define itkColonQuality_h

#include "itkColonModel.h"
#include "itkJson.h"

namespace itk
{
/** What was measured of a model, for programs: lumen, centreline, distension, surfaces, warnings. Lengths in mm,
 * volumes in ml, intensities in HU, points in LPS. \ingroup ColonModel */
ColonModel_EXPORT Json
ColonQualityToJson(const ColonModel & model);
} // namespace itk

#endif
