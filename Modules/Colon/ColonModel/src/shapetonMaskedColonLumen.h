#ifndef shapetonMaskedColonLumen_h
#define shapetonMaskedColonLumen_h

#include "shapetonColonLumenSegmentation.h"
#include "shapetonLumenDistance.h"

namespace shapeton
{
/** A lumen that is given as a mask on the grid of the CT: what in it is gas and what fluid, with the intensities that
 * cleansing needs. Gas lies below the mean of gas and tissue. Without a patient position gravity points from the gas of
 * the pieces to their fluid. Throws InputError when the mask is empty or holds no gas, ParameterError as
 * SegmentColonLumen() for the patient position. */
ColonLumen
ColonLumenOfMask(const itk::Image<float, 3> * ct, const LumenMask * mask, const ColonLumenOptions & options);

/** A lumen that is given as a mask alone: all of it counts as gas. Throws InputError when the mask is empty. */
ColonLumen
ColonLumenOfMask(const LumenMask * mask);
} // namespace shapeton

#endif
