#include "shapetonVolumeGradientOperator.h"
#include "shapetonExceptions.h"
#include "shapetonNumberText.h"
#include "shapetonParallelFor.h"
#include "shapetonSmoothVoxels.h"

#include <algorithm>
#include <atomic>
#include <limits>

namespace shapeton
{
namespace
{
void
Check(const VolumeView & volume, const VolumeGradientOptions & options)
{
  CheckOptions(options);
  if (volume.domain && volume.domain->size() != volume.NumberOfVoxels())
  {
    throw InputError("the domain has another size than the volume; use a mask on the grid of the volume");
  }
  if (volume.domain &&
      std::count(volume.domain->begin(), volume.domain->end(), 0) == static_cast<std::ptrdiff_t>(volume.domain->size()))
  {
    throw InputError("the domain of the volume has no voxel; use a mask with nonzero voxels");
  }
  const auto & [lower, upper] = *options.intensityWindow;
  if (!std::isfinite(lower) || !std::isfinite(upper))
  {
    throw InputError(
      "the volume or the intensity window contains values that are not finite (NaN or infinity) as float");
  }
  if (upper < lower)
  {
    throw ParameterError("the parameter \"intensityWindow\": its upper end must not be below its lower end");
  }
  for (const double spacing : volume.spacing)
  {
    if (!(spacing > 0.0) || !std::isfinite(spacing))
    {
      throw InputError("the voxel spacing must be positive");
    }
  }
  if (volume.NumberOfVoxels() == 0)
  {
    throw InputError("the volume is empty; update the filter that makes it");
  }
}

/** Smoothed by a Gaussian before edges are found (Catte et al. 1992). In a domain, its voxels only are averaged. */
VolumeView
Smoothed(const VolumeView & volume, double smoothing)
{
  std::array<double, 3> sigmas{};
  std::transform(
    volume.spacing.begin(), volume.spacing.end(), sigmas.begin(), [smoothing](double mm) { return smoothing / mm; });
  const auto         side = [&volume](unsigned int axis) { return static_cast<int>(volume.size[axis]); };
  const VoxelGrid    grid(side(0), side(1), side(2));
  std::vector<float> values(volume.begin(), volume.end());
  if (volume.domain)
  {
    std::vector<float> weights(volume.domain->size());
    std::transform(volume.domain->begin(), volume.domain->end(), weights.begin(), [](unsigned char isIn) {
      return isIn != 0 ? 1.0F : 0.0F;
    });
    for (std::size_t voxel = 0; voxel < values.size(); ++voxel)
    {
      values[voxel] = volume.IsInDomain(voxel) ? values[voxel] : 0.0F;
    }
    SmoothVoxels(grid, sigmas, weights.data());
    SmoothVoxels(grid, sigmas, values.data());
    std::transform(values.begin(), values.end(), weights.begin(), values.begin(), [](float sum, float weight) {
      return weight > 0.0F ? sum / weight : 0.0F;
    });
  }
  else
  {
    SmoothVoxels(grid, sigmas, values.data());
  }
  VolumeView smoothed(std::move(values), volume.size, volume.spacing);
  smoothed.domain = volume.domain;
  return smoothed;
}

// One slice of intensities, scaled to [0, 1] and padded by repeating the border.
class ScaledSlice
{
public:
  explicit ScaledSlice(const EdgeVolume & edges)
    : m_Volume(edges.volume), m_Size(edges.volume.size), m_Values((m_Size[0] + 2) * (m_Size[1] + 2))
  {
    const auto & [lower, upper] = *edges.options.intensityWindow;
    m_Lower = lower;
    m_Scale = upper > lower ? 1.0 / (upper - lower) : 0.0;
  }

  /** Returns false if an intensity in the domain is not finite. */
  bool
  Load(std::ptrdiff_t z)
  {
    const auto slice = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(z, 0, m_Size[2] - 1));
    bool       finite = true;
    for (std::ptrdiff_t y = -1; y <= static_cast<std::ptrdiff_t>(m_Size[1]); ++y)
    {
      const auto        row = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(y, 0, m_Size[1] - 1));
      const std::size_t first = (slice * m_Size[1] + row) * m_Size[0];
      const float *     source = m_Volume.values + first;
      double *          target = this->Row(y);
      for (std::size_t x = 0; x < m_Size[0]; ++x)
      {
        finite &= std::isfinite(source[x]) || !m_Volume.IsInDomain(first + x);
        target[x] = std::clamp((source[x] - m_Lower) * m_Scale, 0.0, 1.0);
      }
      target[-1] = target[0];
      target[m_Size[0]] = target[m_Size[0] - 1];
    }
    return finite;
  }

  double *
  Row(std::ptrdiff_t y)
  {
    return m_Values.data() + static_cast<std::size_t>(y + 1) * (m_Size[0] + 2) + 1;
  }

private:
  const VolumeView &         m_Volume;
  std::array<std::size_t, 3> m_Size;
  double                     m_Lower{ 0.0 };
  double                     m_Scale{ 0.0 };
  std::vector<double>        m_Values;
};
} // namespace

void
RequireWindow(const std::optional<std::array<double, 2>> & window)
{
  RequireParameter(!window ||
                     (std::isfinite((*window)[0]) && std::isfinite((*window)[1]) && (*window)[0] < (*window)[1]),
                   "the parameter \"intensityWindow\" requires two numbers, the lower one first");
}

std::array<double, 2>
WindowOf(const VolumeGradientOptions & options, const VolumeView & volume)
{
  if (options.intensityWindow || volume.NumberOfVoxels() == 0)
  {
    return options.intensityWindow.value_or(std::array<double, 2>{});
  }
  std::array<double, 2> window{ { std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() } };
  for (std::size_t voxel = 0; voxel < volume.NumberOfVoxels(); ++voxel)
  {
    if (volume.IsInDomain(voxel))
    {
      window = { { std::min<double>(window[0], volume.values[voxel]),
                   std::max<double>(window[1], volume.values[voxel]) } };
    }
  }
  return window;
}

Remarks
RemarksOnWindow(const VolumeView & volume, const std::array<double, 2> & window)
{
  constexpr double leastShare = 0.01; // of the window; chosen: the default p of presets finds no such edge
  const auto       ofVolume = WindowOf({}, volume);
  const double     lowest = std::clamp(ofVolume[0], window[0], window[1]);
  const double     highest = std::clamp(ofVolume[1], window[0], window[1]);
  if (highest == lowest)
  {
    return { "all voxels have the same intensity in the window, which leaves no edges; choose another window" };
  }
  if (highest - lowest < leastShare * (window[1] - window[0]))
  {
    return { "the intensities fill less than 1 % of the window, which leaves hardly any edges; choose a window "
             "in the unit of the volume, which is from " +
             NumberText(ofVolume[0], 4) + " to " + NumberText(ofVolume[1], 4) };
  }
  return {};
}

EdgeVolume::EdgeVolume(const VolumeView & given, const VolumeGradientOptions & givenOptions)
  : volume(given), options(givenOptions)
{
  options.intensityWindow = WindowOf(options, volume);
  Check(volume, options);
  if (options.smoothing > 0.0)
  {
    volume = Smoothed(volume, options.smoothing);
    options.smoothing = 0.0;
  }
}

VolumeGradientOperator::VolumeGradientOperator(const VolumeView &            volume,
                                               const VolumeGradientOptions & options,
                                               Conductance                   conductance,
                                               double                        leastWeight,
                                               const Progress &              progress)
  : m_Grid(volume.size), m_Domain(volume.domain), m_LeastWeight(leastWeight)
{
  const EdgeVolume edges(volume, options);
  RequireParameter(leastWeight >= 0.0 && leastWeight <= 1.0, "the parameter \"leastWeight\" must be between 0 and 1");
  const double smallest = *std::min_element(volume.spacing.begin(), volume.spacing.end());
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    m_Resolution[axis] = volume.spacing[axis] / smallest;
    const double ofGrid = 1.0 / (m_Resolution[axis] * m_Resolution[axis]);
    m_Factors[axis] = conductance == Conductance::Physical ? ofGrid : 1.0;
    m_Summands[axis] = conductance == Conductance::Sum ? ofGrid - 1.0 : 0.0;
    m_Conductances[axis] = PaddedField(m_Grid);
    progress(0.0); // slow for a large field
  }
  this->ComputeConductances(edges, progress);
  if (m_Domain)
  {
    this->InsulateDomain();
  }
}

bool
VolumeGradientOperator::IsInDomain(std::ptrdiff_t x, std::ptrdiff_t y, std::ptrdiff_t z) const
{
  const auto & size = m_Grid.GetSize();
  const auto   inside = [&](std::ptrdiff_t place, unsigned int axis) {
    return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(place, 0, size[axis] - 1));
  };
  return (*m_Domain)[(inside(z, 2) * size[1] + inside(y, 1)) * size[0] + inside(x, 0)] != 0;
}

/** Removes the edges to and between voxels outside the domain. The layer around the volume repeats its border. */
void
VolumeGradientOperator::InsulateDomain()
{
  const auto & size = m_Grid.GetSize();
  const auto   end = [&](unsigned int axis) { return static_cast<std::ptrdiff_t>(size[axis]); };
  ParallelFor(size[2] + 1, [&](std::size_t slice) {
    const auto z = static_cast<std::ptrdiff_t>(slice) - 1;
    for (std::ptrdiff_t y = -1; y < end(1); ++y)
    {
      for (std::ptrdiff_t x = -1; x < end(0); ++x)
      {
        const bool                isIn = this->IsInDomain(x, y, z);
        const std::array<bool, 3> isNextIn = {
          { this->IsInDomain(x + 1, y, z), this->IsInDomain(x, y + 1, z), this->IsInDomain(x, y, z + 1) }
        };
        for (unsigned int axis = 0; axis < 3; ++axis)
        {
          if (!isIn || !isNextIn[axis])
          {
            m_Conductances[axis].GetData()[m_Grid.GetRow(y, z) + x] = 0.0F;
          }
        }
      }
    }
  });
}

std::size_t
VolumeGradientOperator::GetNumberOfVoxels() const
{
  const std::size_t all = m_Grid.GetNumberOfVoxels();
  return m_Domain ? all - static_cast<std::size_t>(std::count(m_Domain->begin(), m_Domain->end(), 0)) : all;
}

/** The intensity factor of each edge, with the factor and the summand of the grid. \equation{2.4} */
void
VolumeGradientOperator::ComputeConductances(const EdgeVolume & edges, const Progress & progress)
{
  constexpr std::size_t slicesAtOnce = 32; // between calls the caller may abort
  const auto &          size = m_Grid.GetSize();
  std::atomic<bool>     finite{ true };
  // Slices -1 .. nz - 1: the edges below the first slice belong to slice -1.
  const auto computeSlice = [&](std::ptrdiff_t z) {
    ScaledSlice slice(edges);
    ScaledSlice above(edges);
    if (!slice.Load(z) || !above.Load(z + 1))
    {
      finite = false;
    }
    for (std::ptrdiff_t y = -1; y < static_cast<std::ptrdiff_t>(size[1]); ++y)
    {
      const double * const                row = slice.Row(y);
      const std::array<const double *, 3> successors = { row + 1, slice.Row(y + 1), above.Row(y) };
      for (unsigned int axis = 0; axis < 3; ++axis)
      {
        float * const target = m_Conductances[axis].GetData() + m_Grid.GetRow(y, z);
        for (std::ptrdiff_t x = -1; x < static_cast<std::ptrdiff_t>(size[0]); ++x)
        {
          const double halfGradient = HalfGradient(row[x], successors[axis][x], m_Resolution[axis]);
          const double weight = EdgeWeight(halfGradient, edges.options.p, m_LeastWeight);
          target[x] = static_cast<float>(std::max(0.0, m_Factors[axis] * weight + m_Summands[axis]));
        }
      }
    }
  };
  const std::size_t slices = size[2] + 1;
  for (std::size_t first = 0; first < slices; first += slicesAtOnce)
  {
    ParallelFor(std::min(slicesAtOnce, slices - first),
                [&](std::size_t i) { computeSlice(static_cast<std::ptrdiff_t>(first + i) - 1); });
    progress(static_cast<double>(first) / static_cast<double>(slices));
  }
  if (!finite)
  {
    throw InputError("the volume contains values that are not finite (NaN or infinity); replace them");
  }
}

/** \equation{2.3} */
void
VolumeGradientOperator::ComputeInitialHeat(PaddedField & heat) const
{
  const auto &         size = m_Grid.GetSize();
  std::vector<float>   largest(size[2], 0.0F);
  std::array<float, 3> inverse{};
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    inverse[axis] = static_cast<float>(1.0 / m_Factors[axis]);
  }
  ParallelFor(size[2], [&](std::size_t z) {
    for (std::size_t y = 0; y < size[1]; ++y)
    {
      const std::size_t row = m_Grid.GetRow(y, z);
      for (std::size_t i = row; i < row + size[0]; ++i)
      {
        float sum = 0.0F;
        for (unsigned int axis = 0; axis < 3; ++axis)
        {
          const float * const c = m_Conductances[axis].GetData();
          sum += (c[i] + c[i - m_Grid.GetStride(axis)]) * inverse[axis];
        }
        sum += m_Domain ? this->FacesOfDomain(i - row, y, z) : 0.0F;
        heat.GetData()[i] = sum;
        largest[z] = std::max(largest[z], sum);
      }
    }
  });
  const float maximum = *std::max_element(largest.begin(), largest.end());
  ParallelFor(size[2], [&](std::size_t z) {
    for (std::size_t y = 0; y < size[1]; ++y)
    {
      float * const row = heat.GetData() + m_Grid.GetRow(y, z);
      for (std::size_t x = 0; x < size[0]; ++x)
      {
        row[x] = 1.0F - row[x] / maximum; // border edges have weight 1: maximum > 0
        if (m_Domain && !this->IsInDomain(x, y, z))
        {
          row[x] = 0.0F;
        }
      }
    }
  });
}

float
VolumeGradientOperator::FacesOfDomain(std::ptrdiff_t x, std::ptrdiff_t y, std::ptrdiff_t z) const
{
  float faces = 0.0F;
  for (const std::ptrdiff_t step : { -1, 1 })
  {
    faces += static_cast<float>(!this->IsInDomain(x + step, y, z)) +
             static_cast<float>(!this->IsInDomain(x, y + step, z)) +
             static_cast<float>(!this->IsInDomain(x, y, z + step));
  }
  return this->IsInDomain(x, y, z) ? faces : 0.0F;
}

double
VolumeGradientOperator::GetEigenvalueBound() const
{
  return 4.0 * (m_Factors[0] + m_Factors[1] + m_Factors[2]);
}
} // namespace shapeton
