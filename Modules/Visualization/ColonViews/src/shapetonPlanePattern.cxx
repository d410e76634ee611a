#include "shapetonConformalMapPicture.h"
#include "shapetonPi.h"

#include <cmath>
#include <stdexcept>

namespace shapeton
{
namespace
{

void
Require(bool condition, const char * message)
{
  if (!condition)
  {
    throw std::invalid_argument(message);
  }
}

RGBColor
CheckColor(double column, double row)
{
  static const RGBColor odd = MakeColor(58, 86, 138);
  static const RGBColor even = MakeColor(244, 236, 220);
  const bool            isOdd = std::fmod(std::abs(std::floor(column) + std::floor(row)), 2.0) == 1.0;
  return isOdd ? odd : even;
}
} // namespace

PlanePattern
Checkerboard(double side)
{
  Require(side > 0.0, "the side of a check must be greater than 0");
  return [side](double u, double v) { return CheckColor(u / side, v / side); };
}

PlanePattern
PolarCheckerboard(int around)
{
  Require(around > 0 && around % 2 == 0, "the number of checks around an annulus must be even and positive");
  const double perRadian = around / (2.0 * Pi);
  return [perRadian](double u, double v) {
    return CheckColor(perRadian * std::log(std::hypot(u, v)), perRadian * std::atan2(v, u));
  };
}

PlanePattern
LevelSets(double lower, double upper, double width)
{
  Require(lower < upper && width > 0.0, "level sets require an ascending range and a positive width");
  return [=](double u, double) {
    static const RGBColor colorOfLine = MakeColor(20, 22, 28);
    const double          band = std::floor((u - lower) / width);
    const double          within = (u - lower) / width - band;
    const RGBColor        color = HeatColor((band + 0.5) * width / (upper - lower));
    constexpr double      line = 0.06; // fraction of the band width, on each side of a level
    constexpr double      opacity = 0.8;
    return std::min(within, 1.0 - within) < line ? MixColors(color, colorOfLine, opacity) : color;
  };
}
} // namespace shapeton
