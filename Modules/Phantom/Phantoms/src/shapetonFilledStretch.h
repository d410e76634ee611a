#ifndef shapetonFilledStretch_h
#define shapetonFilledStretch_h

#include "shapetonFluidBasins.h"

#include <array>
#include <vector>

namespace shapeton
{
/** Raises the fluid of one dip until it completely fills at least `lengths[1]` consecutive slices, or fewer if no dip
 * is long enough, but at least `lengths[0]`. The filled slices must all be in `allowed` and between slices with gas. Of
 * the dips that qualify, the one that requires the least fluid is used, at most 15 % of the lumen. Pools reached by the
 * fluid are merged into that of the dip and may become empty. Returns the first filled slice and the one after the
 * last, which are equal if no dip qualifies. */
std::array<int, 2>
FillStretch(const std::vector<std::vector<float>> & heights,
            const std::vector<FluidPassage> &       passages,
            const std::vector<bool> &               allowed,
            const std::array<int, 2> &              lengths,
            std::vector<FluidPool> &                pools);
} // namespace shapeton

#endif
