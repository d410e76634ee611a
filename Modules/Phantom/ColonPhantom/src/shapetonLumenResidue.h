#ifndef shapetonLumenResidue_h
#define shapetonLumenResidue_h

#include "shapetonColonStructurePart.h"

#include <vector>

namespace shapeton
{
/** What lies in the lumen besides gas and fluid: stool, bubbles and foam, as parts in the order of painting. */
struct LumenResidue
{
  std::vector<ColonResidue>          truth;
  std::vector<ColonStructures::Part> parts;
};

/** Anatomy and fluid have to outlive the parts. */
LumenResidue
MakeLumenResidue(const ColonAnatomy & anatomy, const ColonFluid & fluid);
} // namespace shapeton

#endif
