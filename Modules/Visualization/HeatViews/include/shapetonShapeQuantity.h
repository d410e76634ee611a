#ifndef shapetonShapeQuantity_h
#define shapetonShapeQuantity_h

#include <cstdint>
#include <string>

namespace shapeton
{
/** What the values in [0, 1] of the voxels are, for titles, axes and tables: heat by default.
 * \ingroup HeatViews */
struct ShapeQuantity
{
  /** One word in small letters, for one and for several. */
  std::string name{ "heat" };
  std::string plural{ "heats" };
  /** The number of visits that a value of 1 stands for; 0 where the values are no visits. */
  std::uint32_t greatestVisits{ 0 };

  /** The name with a capital. */
  std::string
  GetTitle() const
  {
    std::string title = name;
    title[0] = static_cast<char>(title[0] - 'a' + 'A');
    return title;
  }

  /** Shapeton density: visits in units of the greatest number of visits. */
  static ShapeQuantity
  Density(std::uint32_t greatestVisits)
  {
    return { "density", "densities", greatestVisits };
  }
};
} // namespace shapeton

#endif
