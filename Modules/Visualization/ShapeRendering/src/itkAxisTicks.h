#ifndef itkAxisTicks_h
#define itkAxisTicks_h

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace itk
{
/** Where a value lies on an axis, in pixels. */
using PixelOf = std::function<double(double)>;

/** Round heats of the range, ascending, at least `leastDistance` pixels apart; the roundest win. */
std::vector<double>
HeatTicks(double lower, double upper, double leastDistance, const PixelOf & pixelOf);

/** Round time steps between the first and the last recorded one, and these two, ascending, at least `leastDistance`
 * pixels apart. */
std::vector<std::uint64_t>
TimeTicks(const std::vector<std::uint64_t> & timeSteps, double leastDistance, const PixelOf & pixelOf);

/** A heat as a short decimal number. */
std::string
HeatLabel(double heat);

/** 100000 as "100 000". */
std::string
GroupedDigits(std::uint64_t value);
} // namespace itk

#endif
