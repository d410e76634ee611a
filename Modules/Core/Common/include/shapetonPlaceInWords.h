#ifndef shapetonPlaceInWords_h
#define shapetonPlaceInWords_h

#include <cmath>
#include <string>

namespace shapeton
{
/** "12.3": one decimal place, independent of the locale. \ingroup ShapetonCommon */
inline std::string
InTenths(double value)
{
  const long long   tenths = std::llround(10.0 * std::abs(value));
  const std::string sign = value < 0.0 && tenths != 0 ? "-" : "";
  return sign + std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
}

/** Formats a point as "(1, -2, 3) mm". \ingroup ShapetonCommon */
template <typename TPoint>
std::string
PlaceInWords(const TPoint & point)
{
  return "(" + std::to_string(std::llround(point[0])) + ", " + std::to_string(std::llround(point[1])) + ", " +
         std::to_string(std::llround(point[2])) + ") mm";
}
} // namespace shapeton

#endif
