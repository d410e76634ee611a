#ifndef shapetonMaskedColonLumen_h
#define shapetonMaskedColonLumen_h

#include "shapetonColonLumenSegmentation.h"
#include "shapetonLumenDistance.h"

namespace shapeton
{
/** Splits a lumen mask on the grid of the CT into gas and fluid, and estimates the intensities required for cleansing.
 * Gas is below the mean of gas and tissue. Without a patient position, gravity points from gas to fluid. Throws
 * InputError if the mask is empty or contains no gas, and ParameterError for an unknown patient position. */
ColonLumen
ColonLumenOfMask(const itk::Image<float, 3> * ct, const LumenMask * mask, const ColonLumenOptions & options);

/** Creates a lumen from a mask only, labeled as gas. Throws InputError if the mask is empty. */
ColonLumen
ColonLumenOfMask(const LumenMask * mask);
} // namespace shapeton

#endif
