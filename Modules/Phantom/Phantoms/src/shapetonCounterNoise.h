#ifndef shapetonCounterNoise_h
#define shapetonCounterNoise_h

#include <cstdint>

namespace shapeton
{
/** A standard normal number that depends only on `seed` and `counter`, so that threads may request numbers in any
 * order. Philox4x32-10 (Salmon et al. 2011) and the inverse normal distribution function AS 241 (Wichura 1988).
 * Uses only operations that IEEE 754 rounds correctly: every machine gets the same number. */
double
NormalNoise(std::uint64_t seed, std::uint64_t counter);

/** The standard normal distribution function, to about 1e-14, with the same arithmetic. 0 below -8 and 1 above 8. */
double
NormalDistribution(double x);
} // namespace shapeton

#endif
