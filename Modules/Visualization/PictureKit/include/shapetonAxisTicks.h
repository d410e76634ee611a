#ifndef shapetonAxisTicks_h
#define shapetonAxisTicks_h

#include "ShapetonPictureKitExport.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace shapeton
{
/** Maps a value to its position on an axis, in pixels. \ingroup ShapetonPictureKit */
using PixelOf = std::function<double(double)>;

/** Round heat values in the range, ascending, at least `leastDistance` pixels apart; values with fewer digits take
 * precedence.
 * \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT std::vector<double>
                          HeatTicks(double lower, double upper, double leastDistance, const PixelOf & pixelOf);

/** The first and the last recorded time step and round ones between them, ascending, at least `leastDistance` pixels
 * apart. \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT std::vector<std::uint64_t>
TimeTicks(const std::vector<std::uint64_t> & timeSteps, double leastDistance, const PixelOf & pixelOf);

/** Multiples of a step from `lower` to `upper`, ascending. The step is 1, 2 or 5 times a power of ten, the smallest one
 * with at most `greatestNumber` steps. \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT std::vector<double>
                          RoundTicks(double lower, double upper, int greatestNumber);

/** Formats a heat value as a short decimal number. \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT std::string
                          HeatLabel(double heat, int digits = 3);

/** Formats 100000 as "100 000". \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT std::string
                          GroupedDigits(std::uint64_t value);
} // namespace shapeton

#endif
