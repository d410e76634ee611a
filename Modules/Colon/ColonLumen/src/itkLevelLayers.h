#ifndef itkLevelLayers_h
#define itkLevelLayers_h

#include "itkLumenField.h"

namespace itk
{
/** Fills the layer in which values pass from gas to fluid, near levels only: elsewhere a wall may lie between. */
void
FillLevelLayers(LumenField & field);
} // namespace itk

#endif
