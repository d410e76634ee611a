#ifndef shapetonColonAbdomen_h
#define shapetonColonAbdomen_h

#include "shapetonColonAnatomy.h"
#include "shapetonColonFluid.h"
#include "shapetonColonStructures.h"
#include "shapetonPhantomBody.h"

namespace shapeton
{
/** All bodies of a CT volume of the phantom, in painting order: table, skin, fat, muscles, bones, organs, lung bases,
 * stomach, loops of small bowel, the colon with its contents and structures (ColonStructures). The background is air.
 *
 * All organs except the colon are at the same position for all patient positions; table, levels and bubbles follow
 * gravity. Anatomy and fluid must outlive the bodies. \ingroup ShapetonPhantoms */
ShapetonPhantoms_EXPORT PhantomBodies
MakeColonAbdomen(const ColonAnatomy & anatomy, const ColonFluid & fluid, const ColonStructures & structures);

/** Intensity of air, HU. \ingroup ShapetonPhantoms */
constexpr double airIntensity = -1000.0;
} // namespace shapeton

#endif
