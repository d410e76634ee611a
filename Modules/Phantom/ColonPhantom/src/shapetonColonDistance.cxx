#include "shapetonColonDistance.h"

#include <cmath>

namespace shapeton
{
ColonDistance
JoinTissue(const ColonDistance & a, const ColonDistance & b, double fillet)
{
  if (a.value >= fillet || b.value >= fillet)
  {
    return a.value < b.value ? a : b;
  }
  const double  x = fillet - a.value;
  const double  y = fillet - b.value;
  const double  r = std::sqrt(x * x + y * y);
  ColonDistance result{ fillet - r, (x * a.gradient + y * b.gradient) / r };
  // Bodies that lie alongside add up; that is undone.
  const double length = result.gradient.norm();
  if (length > 1.0)
  {
    result.gradient /= length;
  }
  return result;
}
} // namespace shapeton
