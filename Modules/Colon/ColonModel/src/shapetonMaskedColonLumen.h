#ifndef shapetonMaskedColonLumen_h
#define shapetonMaskedColonLumen_h

#include "shapetonColonLumenSegmentation.h"
#include "shapetonLumenDistance.h"

namespace shapeton
{
/** Splits a lumen mask on the grid of the CT into gas and fluid, with the intensities needed for cleansing. Gas is
 * below the mean of gas and tissue. Without a patient position gravity points from the gas of the pieces to their
 * fluid. Throws InputError when the mask is empty or contains no gas, ParameterError for the patient position as
 * SegmentColonLumen(). */
ColonLumen
ColonLumenOfMask(const itk::Image<float, 3> * ct, const LumenMask * mask, const ColonLumenOptions & options);

/** Lumen from a mask only: all of it counts as gas. Throws InputError when the mask is empty. */
ColonLumen
ColonLumenOfMask(const LumenMask * mask);
} // namespace shapeton

#endif
