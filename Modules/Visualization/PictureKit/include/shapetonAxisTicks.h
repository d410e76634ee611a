#ifndef shapetonAxisTicks_h
#define shapetonAxisTicks_h

#include "PictureKitExport.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace shapeton
{
/** Where a value lies on an axis, in pixels. \ingroup PictureKit */
using PixelOf = std::function<double(double)>;

/** Round heats of the range, ascending, at least `leastDistance` pixels apart; the roundest win.
 * \ingroup PictureKit */
PictureKit_EXPORT std::vector<double>
                  HeatTicks(double lower, double upper, double leastDistance, const PixelOf & pixelOf);

/** Round time steps between the first and the last recorded one, and these two, ascending, at least `leastDistance`
 * pixels apart. \ingroup PictureKit */
PictureKit_EXPORT std::vector<std::uint64_t>
TimeTicks(const std::vector<std::uint64_t> & timeSteps, double leastDistance, const PixelOf & pixelOf);

/** Values from `lower` to `upper`, ascending, in equal steps of 1, 2 or 5 times a power of ten that go through 0: as
 * many as there are with at most `greatestNumber` steps. \ingroup PictureKit */
PictureKit_EXPORT std::vector<double>
                  RoundTicks(double lower, double upper, int greatestNumber);

/** A heat as a short decimal number. \ingroup PictureKit */
PictureKit_EXPORT std::string
                  HeatLabel(double heat, int digits = 3);

/** 100000 as "100 000". \ingroup PictureKit */
PictureKit_EXPORT std::string
                  GroupedDigits(std::uint64_t value);
} // namespace shapeton

#endif
