#ifndef shapetonColonExtent_h
#define shapetonColonExtent_h

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace shapeton
{
/** \brief Bounding box of the known lumen of a colon, LPS in mm. The position of a point in the box indicates to which
 * end of the colon it may belong. Points are of any type with coordinates [0] to [2]. \ingroup ShapetonColonLumen */
struct ColonExtent
{
  template <typename TPoint>
  void
  Include(const TPoint & point)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      lowest[axis] = std::min<double>(lowest[axis], point[axis]);
      highest[axis] = std::max<double>(highest[axis], point[axis]);
    }
  }

  /** Weighted distance (mm) of a point from the expected end of the rectum: caudal, medial, posterior. */
  template <typename TPoint>
  double
  DistanceFromAnus(const TPoint & place) const
  {
    // Weights relative to that of the distance along the body. Chosen: the height counts most.
    constexpr double sideways = 0.7;
    constexpr double forwards = 0.5;
    const double     middle = 0.5 * (lowest[0] + highest[0]);
    return (place[2] - lowest[2]) + sideways * std::abs(place[0] - middle) + forwards * (highest[1] - place[1]);
  }

  /** Relative position of a point between the lower and the upper side of the box along an axis, 0 to 1. */
  template <typename TPoint>
  double
  ShareAlong(int axis, const TPoint & place) const
  {
    return (place[axis] - lowest[axis]) / std::max(highest[axis] - lowest[axis], 1.0);
  }

  std::array<double, 3> lowest{ { nowhere, nowhere, nowhere } };
  std::array<double, 3> highest{ { -nowhere, -nowhere, -nowhere } };

private:
  static constexpr double nowhere = std::numeric_limits<double>::max(); ///< start of a minimum (mm)
};
} // namespace shapeton

#endif
