#include "shapetonPhantomGrid.h"

#include "shapetonOrthonormalDirection.h"
#include "shapetonOperatingSystem.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace shapeton
{
namespace
{
constexpr double memoryShare = 0.9; // of the memory of the machine, available for voxels
constexpr double bytesOfGB = 1e9;

std::string
Named(const char * parameter)
{
  return std::string("the parameter \"") + parameter + '"';
}

template <typename TNumber>
void
CheckCount(const char * parameter, const std::vector<TNumber> & numbers, std::size_t count)
{
  if (numbers.size() != count)
  {
    throw ParameterError(Named(parameter) + " needs " + std::to_string(count) + " numbers, not " +
                         std::to_string(numbers.size()));
  }
}

itk::ImageBase<3>::SizeType
SizeOf(const std::vector<int> & numbers, double bytesPerVoxel)
{
  CheckCount("size", numbers, 3);
  if (*std::min_element(numbers.begin(), numbers.end()) < 2)
  {
    throw ParameterError(Named("size") + ": a volume requires at least 2 voxels along each axis");
  }
  const double bytes = bytesPerVoxel * numbers[0] * numbers[1] * numbers[2];
  if (bytes > memoryShare * PhysicalMemory())
  {
    throw ParameterError(Named("size") + ": " + std::to_string(static_cast<long long>(std::ceil(bytes / bytesOfGB))) +
                         " GB of voxels do not fit into the memory of this machine; reduce the size");
  }
  itk::ImageBase<3>::SizeType size;
  std::copy(numbers.begin(), numbers.end(), size.begin());
  return size;
}

itk::ImageBase<3>::SpacingType
SpacingOf(const std::vector<double> & numbers)
{
  CheckCount("spacing", numbers, 3);
  if (*std::min_element(numbers.begin(), numbers.end()) < 1e-3 ||
      *std::max_element(numbers.begin(), numbers.end()) > 1e3)
  {
    throw ParameterError(Named("spacing") + ": the spacing must be between 0.001 and 1000 mm");
  }
  itk::ImageBase<3>::SpacingType spacing;
  std::copy(numbers.begin(), numbers.end(), spacing.Begin());
  return spacing;
}

itk::ImageBase<3>::DirectionType
DirectionOf(const std::vector<double> & numbers)
{
  CheckCount("direction", numbers, 9);
  itk::ImageBase<3>::DirectionType direction;
  for (unsigned int i = 0; i < 9; ++i)
  {
    direction(i / 3, i % 3) = numbers[i];
  }
  if (!MakeOrthonormal(direction, 1e-3))
  {
    throw ParameterError(Named("direction") + ": the columns of the matrix are not perpendicular unit vectors");
  }
  return direction;
}
} // namespace

PhantomGrid
MakePhantomGrid(const PhantomGridOptions &                    options,
                double                                        bytesPerVoxel,
                const std::optional<itk::Vector<double, 3>> & extent)
{
  PhantomGrid grid;
  grid.size = SizeOf(options.size, bytesPerVoxel);
  if (extent && options.spacing.empty())
  {
    for (unsigned int i = 0; i < 3; ++i)
    {
      grid.spacing[i] = (*extent)[i] / static_cast<double>(grid.size[i]);
    }
  }
  else
  {
    grid.spacing = SpacingOf(options.spacing);
  }
  grid.direction = DirectionOf(options.direction);
  return grid;
}
} // namespace shapeton
