#ifndef shapetonLocalFluid_h
#define shapetonLocalFluid_h

#include "shapetonColonVolume.h"

namespace shapeton
{
/** The intensity of tagged fluid around a place: means over cells of about 2 mm of what is deep in the fluid, smoothed
 * with a standard deviation of about 3 mm and carried on to the surroundings. */
class LocalFluid
{
public:
  /** `fluid`: voxels with a non-zero value that are at least 2 mm from anything else are averaged. `fallback` holds
   * where there are none near. */
  LocalFluid(const ColonGrid &                  grid,
             const std::vector<float> &         hu,
             const std::vector<unsigned char> & fluid,
             double                             fallback);

  /** Linear between the cells. */
  double
  At(int i, int j, int k) const;

private:
  void
  Accumulate(const ColonGrid & grid, const std::vector<float> & hu, const std::vector<unsigned char> & fluid);
  void
  Spread();
  std::size_t
  Cell(int x, int y, int z) const
  {
    return x + m_Size[0] * (y + static_cast<std::size_t>(m_Size[1]) * z);
  }

  std::array<int, 3> m_Edge; ///< voxels in a cell along each axis
  std::array<int, 3> m_Size;
  double             m_Fallback;
  std::vector<float> m_Sum;
  std::vector<float> m_Weight;
};
} // namespace shapeton

#endif
