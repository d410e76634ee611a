#ifndef shapetonLevelLayers_h
#define shapetonLevelLayers_h

#include "shapetonLumenField.h"

namespace shapeton
{
/** Fills the layer in which values pass from gas to fluid, near levels only: elsewhere a wall may lie between. */
void
FillLevelLayers(LumenField & field);
} // namespace shapeton

#endif
