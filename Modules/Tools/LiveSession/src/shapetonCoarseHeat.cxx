#include "shapetonCoarseHeat.h"

#include "shapetonParallelFor.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
/** Edge lengths of the blocks are powers of two up to this one. */
constexpr std::size_t largestFactor = 8;
/** Voxel updates of one picture: 0.5 to 1 s on two cores; a core performs 2e8 to 4e8 per second. */
constexpr double budget = 2.5e8;
/** t steps require about this times sqrt(t) applications of the operator: 1100 for t = 100,000; see
 * HeatDiffusionSolver. */
constexpr double applicationsPerRoot = 3.5;

/** Averages over blocks of 2^3 values; the last blocks along an axis may be smaller. `at` returns a value. */
template <typename TAt>
BlockValues
Halved(const std::array<std::size_t, 3> & size, std::size_t factor, const TAt & at)
{
  BlockValues blocks;
  blocks.factor = factor;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    blocks.size[axis] = (size[axis] + 1) / 2;
  }
  blocks.values.resize(blocks.size[0] * blocks.size[1] * blocks.size[2]);
  ParallelFor(blocks.size[2], [&](std::size_t z) {
    float * value = blocks.values.data() + z * blocks.size[0] * blocks.size[1];
    for (std::size_t y = 0; y < blocks.size[1]; ++y)
    {
      for (std::size_t x = 0; x < blocks.size[0]; ++x)
      {
        float       sum = 0.0F;
        std::size_t number = 0;
        for (std::size_t k = 2 * z; k < std::min(2 * z + 2, size[2]); ++k)
        {
          for (std::size_t j = 2 * y; j < std::min(2 * y + 2, size[1]); ++j)
          {
            for (std::size_t i = 2 * x; i < std::min(2 * x + 2, size[0]); ++i, ++number)
            {
              sum += at(i, j, k);
            }
          }
        }
        *value++ = sum / static_cast<float>(number);
      }
    }
  });
  return blocks;
}

BlockValues
Halved(const BlockValues & fine)
{
  return Halved(fine.size, 2 * fine.factor, [&fine](std::size_t i, std::size_t j, std::size_t k) {
    return fine.values[(k * fine.size[1] + j) * fine.size[0] + i];
  });
}
} // namespace

VolumeView
BlockValues::View(std::array<double, 3> spacing) const
{
  for (double & side : spacing)
  {
    side *= static_cast<double>(factor);
  }
  return { values.data(), size, spacing };
}

BlockValues
Halved(const VolumeView & volume)
{
  const auto & size = volume.size;
  return Halved(size, 2, [&](std::size_t i, std::size_t j, std::size_t k) {
    return volume.values[(k * size[1] + j) * size[0] + i];
  });
}

CoarseHeat::CoarseHeat(const VolumeView & volume, const CumulativeHeatDiffusionOptions & options)
  : m_Spacing(volume.spacing), m_Options(options)
{
  const EdgeVolume edges(volume, options);
  static_cast<VolumeGradientOptions &>(m_Options) = edges.options;
  Level level;
  {
    const VolumeGradientOperator volumeGradient(edges.volume, edges.options, options.conductance);
    const PaddedGrid &           grid = volumeGradient.GetGrid();
    PaddedField                  heat(grid);
    volumeGradient.ComputeInitialHeat(heat);
    level.heat = Halved(volume.size, 2, [&](std::size_t i, std::size_t j, std::size_t k) {
      return heat.GetData()[grid.GetRow(static_cast<std::ptrdiff_t>(j), static_cast<std::ptrdiff_t>(k)) + i];
    });
  }
  level.intensities = Halved(edges.volume);
  if (volume.domain)
  {
    level.domain = Halved(volume.size, 2, [&](std::size_t i, std::size_t j, std::size_t k) {
      return volume.IsInDomain((k * volume.size[1] + j) * volume.size[0] + i) ? 1.0F : 0.0F;
    });
  }
  m_Levels.push_back(std::move(level));
  while (m_Levels.back().heat.factor < largestFactor)
  {
    const Level & fine = m_Levels.back();
    const auto    domain = fine.domain.values.empty() ? BlockValues() : Halved(fine.domain);
    m_Levels.push_back({ Halved(fine.intensities), Halved(fine.heat), domain });
  }
}

const CoarseHeat::Level &
CoarseHeat::ChooseLevel(std::uint64_t timeSteps) const
{
  for (const Level & level : m_Levels)
  {
    const double steps = static_cast<double>(timeSteps) / static_cast<double>(level.heat.factor * level.heat.factor);
    const double applications = std::min(steps, applicationsPerRoot * std::sqrt(steps));
    if (applications * static_cast<double>(level.heat.values.size()) <= budget)
    {
      return level;
    }
  }
  return m_Levels.back();
}

BlockValues
CoarseHeat::After(std::uint64_t timeSteps, const Progress & progress) const
{
  const Level &     level = this->ChooseLevel(timeSteps);
  const std::size_t factor = level.heat.factor;
  const auto &      size = level.heat.size;
  VolumeView        volume = level.intensities.View(m_Spacing);
  if (!level.domain.values.empty())
  {
    constexpr float            least = 0.5F; // share of a block in the domain
    std::vector<unsigned char> domain(level.domain.values.size());
    std::transform(level.domain.values.begin(), level.domain.values.end(), domain.begin(), [](float share) {
      return share >= least ? 1 : 0;
    });
    volume.domain = std::make_shared<const std::vector<unsigned char>>(std::move(domain));
  }
  const VolumeGradientOperator volumeGradient(volume, m_Options, m_Options.conductance);
  const PaddedGrid &           grid = volumeGradient.GetGrid();
  PaddedField                  field(grid);
  const auto                   rowOf = [&](std::size_t y, std::size_t z) {
    return field.GetData() + grid.GetRow(static_cast<std::ptrdiff_t>(y), static_cast<std::ptrdiff_t>(z));
  };
  BlockValues blocks = level.heat;
  const auto  forRows = [&](const auto & body) {
    for (std::size_t z = 0; z < size[2]; ++z)
    {
      for (std::size_t y = 0; y < size[1]; ++y)
      {
        body(blocks.values.data() + (z * size[1] + y) * size[0], rowOf(y, z));
      }
    }
  };
  forRows([&](const float * values, float * row) { std::copy_n(values, size[0], row); });
  HeatDiffusionSolver solver(volumeGradient, m_Options.solver, m_Options.timeStepLength, m_Options.tolerance);
  solver.SetProgress(progress);
  solver.SetDevice(m_Options.device);
  solver.Run(field, std::max<std::uint64_t>(1, timeSteps / (factor * factor)));
  forRows([&](float * values, const float * row) { std::copy_n(row, size[0], values); });
  return blocks;
}
} // namespace shapeton
