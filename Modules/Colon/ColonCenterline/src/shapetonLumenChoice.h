#ifndef shapetonLumenChoice_h
#define shapetonLumenChoice_h

#include "shapetonColonCenterline.h"
#include "shapetonPieceLine.h"

namespace shapeton
{
/** The used components of a lumen; entries from 1. */
struct LumenChoice
{
  std::vector<char> isUsed;
  /** Requested by a seed or as the start. */
  std::vector<char>        isWanted;
  std::vector<std::string> reasons;
};

/** Throws InputError when no component remains, or when a start or seed is far from the lumen. */
LumenChoice
ChooseLumen(const LumenMask * lumen, const LumenComponents & components, const ColonCenterlineOptions & options);

/** Whether each used component has nodes. */
bool
IsComplete(const LumenGrid & grid, const std::vector<char> & isUsed);

/** Center of the bounding box of the component, LPS in mm. */
itk::Point<double, 3>
PlaceOf(const LumenMask * lumen, const LumenComponent & component);
} // namespace shapeton

#endif
