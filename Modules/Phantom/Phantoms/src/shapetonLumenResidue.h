#ifndef shapetonLumenResidue_h
#define shapetonLumenResidue_h

#include "shapetonColonStructurePart.h"

#include <vector>

namespace shapeton
{
/** Residue in the lumen: stool, bubbles and foam, as parts in painting order. */
struct LumenResidue
{
  std::vector<ColonResidue>          truth;
  std::vector<ColonStructures::Part> parts;
};

/** Anatomy and fluid must outlive the parts. */
LumenResidue
MakeLumenResidue(const ColonAnatomy & anatomy, const ColonFluid & fluid);
} // namespace shapeton

#endif
