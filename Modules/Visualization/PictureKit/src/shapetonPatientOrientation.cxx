#include "shapetonPatientOrientation.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace shapeton
{
std::string
OrientationLetters(const itk::Vector<double, 3> & direction)
{
  constexpr char              positive[] = "LPH";
  constexpr char              negative[] = "RAF";
  constexpr double            leastShare = 0.25;
  std::array<unsigned int, 3> axes{ { 0, 1, 2 } };
  std::stable_sort(axes.begin(), axes.end(), [&](unsigned int a, unsigned int b) {
    return std::fabs(direction[a]) > std::fabs(direction[b]);
  });
  std::string letters;
  for (const unsigned int axis : axes)
  {
    if (std::fabs(direction[axis]) > leastShare * direction.GetNorm())
    {
      letters += direction[axis] > 0.0 ? positive[axis] : negative[axis];
    }
  }
  return letters;
}
} // namespace shapeton
