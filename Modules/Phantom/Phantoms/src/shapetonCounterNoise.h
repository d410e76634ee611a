#ifndef shapetonCounterNoise_h
#define shapetonCounterNoise_h

#include <cstdint>

namespace shapeton
{
/** A standard normal number that depends only on `seed` and `counter`, so threads may request numbers in any order.
 * Philox4x32-10 (Salmon et al. 2011) and the inverse normal distribution function AS 241 (Wichura 1988). Identical on
 * all machines, since all operations are correctly rounded (IEEE 754). */
double
NormalNoise(std::uint64_t seed, std::uint64_t counter);

/** The standard normal distribution function, accurate to about 1e-14 and equally portable; 0 below -8 and 1 above
 * 8. */
double
NormalDistribution(double x);
} // namespace shapeton

#endif
