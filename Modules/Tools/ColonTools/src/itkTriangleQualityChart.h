#ifndef itkTriangleQualityChart_h
#define itkTriangleQualityChart_h

#include "itkColonFlattening.h"
#include "itkPicture.h"

namespace itk
{
/** The histogram of 2r/R over the faces, in space and in the metric of the map; its threshold of 0.6. */
Picture::Pointer
DrawTriangleQualities(const ColonFlattening & flattening);
} // namespace itk

#endif
