#ifndef shapetonShapeQuantity_h
#define shapetonShapeQuantity_h

#include <cstdint>
#include <string>

namespace shapeton
{
/** Quantity that the voxel values in [0, 1] represent, for titles, axes and tables; heat by default.
 * \ingroup ShapetonHeatViews */
struct ShapeQuantity
{
  enum class Kind
  {
    Heat,
    Visits
  };
  Kind kind{ Kind::Heat };
  /** Lowercase name, singular and plural. */
  std::string name{ "heat" };
  std::string plural{ "heats" };
  /** Number of visits that a value of 1 represents; 0 for heat. */
  std::uint32_t greatestVisits{ 0 };

  /** The capitalized name. */
  std::string
  GetTitle() const
  {
    std::string title = name;
    title[0] = static_cast<char>(title[0] - 'a' + 'A');
    return title;
  }

  /** Shapeton density: visits divided by the maximum number of visits. */
  static ShapeQuantity
  Density(std::uint32_t greatestVisits)
  {
    return { Kind::Visits, "density", "densities", greatestVisits };
  }
};
} // namespace shapeton

#endif
