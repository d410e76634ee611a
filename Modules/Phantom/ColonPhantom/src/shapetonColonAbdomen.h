#ifndef shapetonColonAbdomen_h
#define shapetonColonAbdomen_h

#include "shapetonColonAnatomy.h"
#include "shapetonColonFluid.h"
#include "shapetonColonStructures.h"
#include "shapetonPhantomBody.h"

namespace shapeton
{
/** All that a CT volume of the phantom shows, in the order of painting: table, skin, fat, muscles, bones, organs, lung
 * bases, stomach, loops of small bowel, the colon with its contents and what belongs to it (ColonStructures). The
 * background is air.
 *
 * Everything but the colon keeps its place in all positions; table, levels and bubbles follow gravity. Anatomy and
 * fluid have to outlive the bodies. \ingroup ColonPhantom */
ColonPhantom_EXPORT PhantomBodies
MakeColonAbdomen(const ColonAnatomy & anatomy, const ColonFluid & fluid, const ColonStructures & structures);

/** Intensity of air, HU. \ingroup ColonPhantom */
constexpr double airIntensity = -1000.0;
} // namespace shapeton

#endif
