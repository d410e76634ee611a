#include "itkPhantomGrid.h"

#include "itkCommandLine.h"
#include "itkOrthonormalDirection.h"
#include "itkToolError.h"

#include <algorithm>
#include <cmath>

#include <unistd.h>

namespace itk
{
namespace
{
template <typename TNumber>
void
CheckCount(const char * option, const std::vector<TNumber> & numbers, std::size_t count)
{
  if (numbers.size() != count)
  {
    throw UsageError(std::string("--") + option + " needs " + std::to_string(count) + " numbers, not " +
                     std::to_string(numbers.size()));
  }
}

ImageBase<3>::SizeType
ReadSize(const CommandLine & commandLine, double bytesPerVoxel)
{
  const auto numbers = commandLine.GetIntegers("size");
  CheckCount("size", numbers, 3);
  if (*std::min_element(numbers.begin(), numbers.end()) < 2)
  {
    throw UsageError("--size: a volume has at least 2 voxels along each axis");
  }
  const double bytes = bytesPerVoxel * numbers[0] * numbers[1] * numbers[2];
  const double memory = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  if (bytes > 0.9 * memory)
  {
    throw UsageError("--size: " + std::to_string(static_cast<long long>(std::ceil(bytes / 1e9))) +
                     " GB of voxels do not fit into the memory of this machine; ask for fewer");
  }
  ImageBase<3>::SizeType size;
  std::copy(numbers.begin(), numbers.end(), size.begin());
  return size;
}

ImageBase<3>::SpacingType
ReadSpacing(const CommandLine & commandLine)
{
  const auto numbers = commandLine.GetDoubles("spacing");
  CheckCount("spacing", numbers, 3);
  if (*std::min_element(numbers.begin(), numbers.end()) < 1e-3 ||
      *std::max_element(numbers.begin(), numbers.end()) > 1e3)
  {
    throw UsageError("--spacing: the distances of voxels lie between 0.001 and 1000 mm");
  }
  ImageBase<3>::SpacingType spacing;
  std::copy(numbers.begin(), numbers.end(), spacing.Begin());
  return spacing;
}

ImageBase<3>::DirectionType
ReadDirection(const CommandLine & commandLine)
{
  const auto numbers = commandLine.GetDoubles("direction");
  CheckCount("direction", numbers, 9);
  ImageBase<3>::DirectionType direction;
  for (unsigned int i = 0; i < 9; ++i)
  {
    direction(i / 3, i % 3) = numbers[i];
  }
  if (!MakeOrthonormal(direction, 1e-3))
  {
    throw UsageError("--direction: the columns of the matrix are not perpendicular unit vectors");
  }
  return direction;
}
} // namespace

PhantomGrid
ReadPhantomGrid(const CommandLine & commandLine, double bytesPerVoxel, const std::optional<Vector<double, 3>> & extent)
{
  const auto                size = ReadSize(commandLine, bytesPerVoxel);
  ImageBase<3>::SpacingType spacing;
  if (extent && commandLine.GetDoubles("spacing").empty())
  {
    for (unsigned int i = 0; i < 3; ++i)
    {
      spacing[i] = (*extent)[i] / static_cast<double>(size[i]);
    }
  }
  else
  {
    spacing = ReadSpacing(commandLine);
  }
  return { size, spacing, ReadDirection(commandLine) };
}

std::string
ProvenanceComment(const CommandLine & commandLine)
{
  std::string comment;
  for (const auto & fact : commandLine.GetProvenance())
  {
    comment += (comment.empty() ? "" : "; ") + fact.first + '=' + fact.second;
  }
  return comment;
}

std::string
WithoutTrailingSlashes(std::string path)
{
  while (path.size() > 1 && path.back() == '/')
  {
    path.pop_back();
  }
  return path;
}
} // namespace itk
