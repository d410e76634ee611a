#ifndef shapetonLumenLabels_h
#define shapetonLumenLabels_h

#include "shapetonColonAnatomy.h"
#include "shapetonColonFluid.h"

#include "itkImage.h"

namespace shapeton
{
/** Labels the voxels of a region with centers in the lumen: gas (1) or fluid (2), and the segment. Other voxels keep
 * their labels. */
void
FillLumenLabels(const ColonAnatomy &           anatomy,
                const ColonFluid &             fluid,
                const itk::ImageRegion<3> &    region,
                itk::Image<unsigned char, 3> * lumen,
                itk::Image<unsigned char, 3> * segments);
} // namespace shapeton

#endif
