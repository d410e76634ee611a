#include "shapetonVolumeGradientOperator.h"
#include "shapetonParallelFor.h"

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <string>

namespace shapeton
{
namespace
{
void
CheckParameters(const VolumeGradientOperator::Parameters & parameters)
{
  if (!(parameters.p >= 0.0) || !std::isfinite(parameters.p))
  {
    throw std::invalid_argument("p must be a nonnegative number");
  }
  if (!(parameters.leastWeight >= 0.0 && parameters.leastWeight <= 1.0))
  {
    throw std::invalid_argument("leastWeight must be between 0 and 1");
  }
  if (!std::isfinite(parameters.lower) || !std::isfinite(parameters.upper))
  {
    throw std::invalid_argument(
      "the volume or the intensity window contains values that are not finite (NaN or infinity)");
  }
  if (parameters.upper < parameters.lower)
  {
    throw std::invalid_argument("the upper end of the intensity window must not be below the lower end");
  }
  for (const double spacing : parameters.spacing)
  {
    if (!(spacing > 0.0) || !std::isfinite(spacing))
    {
      throw std::invalid_argument("the voxel spacing must be positive");
    }
  }
}

// One slice of intensities, scaled to [0, 1] and padded by repeating the border.
class ScaledSlice
{
public:
  ScaledSlice(const PaddedGrid & grid, const VolumeGradientOperator::Parameters & parameters)
    : m_Size(grid.GetSize())
    , m_Lower(parameters.lower)
    , m_Scale(parameters.upper > parameters.lower ? 1.0 / (parameters.upper - parameters.lower) : 0.0)
    , m_Values((m_Size[0] + 2) * (m_Size[1] + 2))
  {}

  /** Returns false if an intensity is not finite. */
  bool
  Load(const float * intensities, std::ptrdiff_t z)
  {
    const auto slice = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(z, 0, m_Size[2] - 1));
    bool       finite = true;
    for (std::ptrdiff_t y = -1; y <= static_cast<std::ptrdiff_t>(m_Size[1]); ++y)
    {
      const auto    row = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(y, 0, m_Size[1] - 1));
      const float * source = intensities + (slice * m_Size[1] + row) * m_Size[0];
      double *      target = this->Row(y);
      for (std::size_t x = 0; x < m_Size[0]; ++x)
      {
        finite &= std::isfinite(source[x]);
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
  std::array<std::size_t, 3> m_Size;
  double                     m_Lower;
  double                     m_Scale;
  std::vector<double>        m_Values;
};
} // namespace

VolumeGradientOperator::VolumeGradientOperator(const float *                      intensities,
                                               const std::array<std::size_t, 3> & size,
                                               const Parameters &                 parameters,
                                               const Progress &                   progress)
  : m_Grid(size), m_Parameters(parameters)
{
  CheckParameters(parameters);
  if (size[0] == 0 || size[1] == 0 || size[2] == 0)
  {
    throw std::invalid_argument("the volume is empty");
  }
  const double smallest = *std::min_element(parameters.spacing.begin(), parameters.spacing.end());
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    m_Resolution[axis] = parameters.spacing[axis] / smallest;
    m_Factors[axis] =
      parameters.conductance == Conductance::Physical ? 1.0 / (m_Resolution[axis] * m_Resolution[axis]) : 1.0;
    m_Conductances[axis] = PaddedField(m_Grid);
    progress(0.0); // slow for a large field
  }
  this->ComputeConductances(intensities, progress);
}

/** The product of the grid factor of each axis and the intensity factor. \equation{2.4} as a product; the source
 * writes a sum. */
void
VolumeGradientOperator::ComputeConductances(const float * intensities, const Progress & progress)
{
  constexpr std::size_t slicesAtOnce = 32; // between calls the caller may abort
  const auto &          size = m_Grid.GetSize();
  std::atomic<bool>     finite{ true };
  // Slices -1 .. nz - 1: the edges below the first slice belong to slice -1.
  const auto computeSlice = [&](std::ptrdiff_t z) {
    ScaledSlice slice(m_Grid, m_Parameters);
    ScaledSlice above(m_Grid, m_Parameters);
    if (!slice.Load(intensities, z) || !above.Load(intensities, z + 1))
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
          target[x] =
            static_cast<float>(m_Factors[axis] * EdgeWeight(halfGradient, m_Parameters.p, m_Parameters.leastWeight));
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
    throw std::invalid_argument("the volume contains values that are not finite (NaN or infinity); replace them");
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
      }
    }
  });
}

double
VolumeGradientOperator::GetEigenvalueBound() const
{
  return 4.0 * (m_Factors[0] + m_Factors[1] + m_Factors[2]);
}

std::array<double, 2>
WindowOf(const VolumeGradientOptions & options, const float * intensities, std::size_t number)
{
  if (options.intensityWindow || number == 0)
  {
    return options.intensityWindow.value_or(std::array<double, 2>{});
  }
  const auto ends = std::minmax_element(intensities, intensities + number);
  return { { *ends.first, *ends.second } };
}
} // namespace shapeton
