#ifndef shapetonLumenChoice_h
#define shapetonLumenChoice_h

#include "shapetonColonCentreline.h"
#include "shapetonPieceLine.h"

namespace shapeton
{
/** Which components of a lumen are used; entries from 1. */
struct LumenChoice
{
  std::vector<char> isUsed;
  /** Asked for by a seed or as the start. */
  std::vector<char>        isWanted;
  std::vector<std::string> reasons;
};

/** Throws InputError where nothing is left, or where a start or seed lies far from the lumen. */
LumenChoice
ChooseLumen(const LumenMask * lumen, const LumenComponents & components, const ColonCentrelineOptions & options);

/** Whether each component that is used has nodes. */
bool
IsComplete(const LumenGrid & grid, const std::vector<char> & isUsed);

/** The middle of the component's box, LPS in mm. */
itk::Point<double, 3>
PlaceOf(const LumenMask * lumen, const LumenComponent & component);
} // namespace shapeton

#endif
