#ifndef itkFoldShape_h
#define itkFoldShape_h

#include "itkFoldLabels.h"

namespace itk
{
/** Measures one fold; all of HaustralFold but label, height and reliabilities. `floor`: see TraceCrest(). */
HaustralFold
MeasureFold(const FlatColonGrid & grid, const FoldPicture & picture, const FoldPixels & pixels, double floor);
} // namespace itk

#endif
