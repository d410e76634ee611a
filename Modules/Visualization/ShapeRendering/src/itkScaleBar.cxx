#include "itkScaleBar.h"

#include "itkCsvTable.h"

#include <cmath>

namespace itk
{
namespace
{
/** The largest 1, 2 or 5 times a power of ten that is at most `value`. */
double
RoundLengthUpTo(double value)
{
  double length = 1.0;
  while (length > value)
  {
    length /= 10.0;
  }
  while (length * 10.0 <= value)
  {
    length *= 10.0;
  }
  for (const double factor : { 5.0, 2.0 })
  {
    if (factor * length <= value)
    {
      return factor * length;
    }
  }
  return length;
}
} // namespace

void
DrawScaleBar(Picture *        picture,
             int              left,
             int              bottom,
             int              greatestLength,
             double           millimetresPerPixel,
             const RGBColor & color)
{
  constexpr int thickness = 3;
  const double  length = RoundLengthUpTo(greatestLength * millimetresPerPixel);
  const int     pixels = static_cast<int>(std::lround(length / millimetresPerPixel));
  TextStyle     style;
  style.size = 15;
  style.color = color;
  style.vertical = VerticalAnchor::Bottom;
  FillRectangle(picture, left, bottom - thickness, pixels, thickness, color);
  DrawText(picture, CsvTable::Rounded(length, 6) + " mm", left, bottom - thickness - 2, style);
}
} // namespace itk
