#ifndef shapetonLumenChoice_h
#define shapetonLumenChoice_h

#include "shapetonColonCenterline.h"
#include "shapetonPieceLine.h"

namespace shapeton
{
/** The used components of a lumen, indexed from 1. */
struct LumenChoice
{
  std::vector<char> isUsed;
  /** Whether a seed or the start requires the component. */
  std::vector<char>        isWanted;
  std::vector<std::string> reasons;
};

/** Throws InputError if no component remains, or if the start or a seed is far from the lumen. */
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
