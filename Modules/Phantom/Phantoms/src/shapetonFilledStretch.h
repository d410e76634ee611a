#ifndef shapetonFilledStretch_h
#define shapetonFilledStretch_h

#include "shapetonFluidBasins.h"

#include <array>
#include <vector>

namespace shapeton
{
/** Raises the fluid of one dip until it fills consecutive slices completely: at least `lengths[1]`, or less if no dip
 * has that length, but at least `lengths[0]`. The dip is the one that requires least fluid, at most 15 % of the lumen,
 * among those with all filled slices in `allowed`, between slices with gas. Pools that the fluid reaches join that of
 * the dip and may become empty. Returns the first filled slice and the one after the last, which are equal if no dip
 * qualifies. */
std::array<int, 2>
FillStretch(const std::vector<std::vector<float>> & heights,
            const std::vector<FluidPassage> &       passages,
            const std::vector<bool> &               allowed,
            const std::array<int, 2> &              lengths,
            std::vector<FluidPool> &                pools);
} // namespace shapeton

#endif
