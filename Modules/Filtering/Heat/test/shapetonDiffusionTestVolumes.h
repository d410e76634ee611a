#ifndef shapetonDiffusionTestVolumes_h
#define shapetonDiffusionTestVolumes_h

#include "shapetonVolumeGradientOperator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace shapeton
{
namespace test
{
using Size = std::array<std::size_t, 3>;

/** Calls `body` with the number, x first, and the index of each voxel. */
template <typename TBody>
void
ForVoxels(const Size & size, const TBody & body)
{
  std::size_t i = 0;
  for (std::size_t z = 0; z < size[2]; ++z)
  {
    for (std::size_t y = 0; y < size[1]; ++y)
    {
      for (std::size_t x = 0; x < size[0]; ++x, ++i)
      {
        body(i, x, y, z);
      }
    }
  }
}

/** A volume as an array, x fastest. */
struct Volume
{
  Size                  size;
  std::vector<float>    values;
  std::array<double, 3> spacing{ { 1.0, 1.0, 1.0 } };

  explicit Volume(const Size & s, float value = 0.0F) : size(s), values(s[0] * s[1] * s[2], value) {}

  float &
  At(std::size_t x, std::size_t y, std::size_t z)
  {
    return values[(z * size[1] + y) * size[0] + x];
  }

  template <typename TFunction>
  void
  Fill(const TFunction & function)
  {
    ForVoxels(size, [&](std::size_t i, std::size_t x, std::size_t y, std::size_t z) {
      values[i] = static_cast<float>(function(x, y, z));
    });
  }

  operator VolumeView() const { return { values.data(), size, spacing }; }

  /** From the minimum to the maximum. */
  std::array<double, 2>
  Window() const
  {
    const auto ends = std::minmax_element(values.begin(), values.end());
    return { { *ends.first, *ends.second } };
  }
};

inline VolumeGradientOptions
OptionsWith(double p)
{
  VolumeGradientOptions options;
  options.p = p;
  return options;
}

/** Uniform noise in [-0.5, 0.5) from a hash of the position: platform-independent. */
inline double
Noise(std::size_t x, std::size_t y, std::size_t z)
{
  auto h = static_cast<std::uint32_t>((z * 1031 + y) * 1033 + x + 1) * 2654435761U;
  h ^= h >> 16;
  h *= 0x7feb352dU;
  h ^= h >> 15;
  h *= 0x846ca68bU;
  h ^= h >> 16;
  return h / 4294967296.0 - 0.5;
}

/** Objects with soft and hard edges of several contrasts, in noise. */
inline Volume
MakeScene(const Size & size, double noise, const std::array<double, 3> & spacing = { { 1.0, 1.0, 1.0 } })
{
  Volume volume(size);
  volume.spacing = spacing;
  const auto soft = [](double distance) { return std::clamp(0.5 - distance / 2.0, 0.0, 1.0); };
  volume.Fill([&](double x, double y, double z) {
    const double u = x / size[0], v = y / size[1], w = z / size[2];
    double       value = 0.1;
    const double ball = soft((std::hypot(u - 0.3, v - 0.35, w - 0.3) - 0.16) * size[0]);
    value = value * (1.0 - ball) + 0.9 * ball;
    const bool box = std::abs(u - 0.7) < 0.15 && std::abs(v - 0.6) < 0.2 && std::abs(w - 0.6) < 0.12;
    value = box ? 0.6 : value;
    return value + noise * Noise(x, y, z);
  });
  return volume;
}

/** Reference diffusion of the dissertation in double precision, independent of the code under test. */
class BruteForce
{
public:
  BruteForce(const Volume & volume, double p, double dt, bool isPhysical = true)
    : m_Size(volume.size)
    , m_Dt(dt)
    , heat(volume.values.size())
    , m_Next(volume.values.size())
    , m_Conductances(volume.values.size())
  {
    const auto   window = volume.Window();
    const double smallest = *std::min_element(volume.spacing.begin(), volume.spacing.end());
    const auto   scaled = [&](std::ptrdiff_t x, std::ptrdiff_t y, std::ptrdiff_t z) {
      const auto inside = [](std::ptrdiff_t i, std::size_t n) { return std::clamp<std::ptrdiff_t>(i, 0, n - 1); };
      const auto value =
        volume.values[(inside(z, m_Size[2]) * m_Size[1] + inside(y, m_Size[1])) * m_Size[0] + inside(x, m_Size[0])];
      return std::clamp((value - window[0]) / (window[1] - window[0]), 0.0, 1.0);
    };
    double largest = 0.0;
    ForVoxels(m_Size, [&](std::size_t i, std::ptrdiff_t x, std::ptrdiff_t y, std::ptrdiff_t z) {
      for (int k = 0; k < 6; ++k)
      {
        const auto & o = Offset(k);
        const double resolution = volume.spacing[k / 2] / smallest;
        const double weight =
          std::clamp(1.0 - p * std::abs(scaled(x, y, z) - scaled(x + o[0], y + o[1], z + o[2])) / resolution, 0.0, 1.0);
        heat[i] += weight;
        m_Conductances[i][k] = isPhysical ? weight / (resolution * resolution) : weight;
      }
      largest = std::max(largest, heat[i]);
    });
    for (double & h : heat)
    {
      h = 1.0 - h / largest;
    }
  }

  void
  Step()
  {
    const std::array<std::ptrdiff_t, 3> strides = { 1,
                                                    static_cast<std::ptrdiff_t>(m_Size[0]),
                                                    static_cast<std::ptrdiff_t>(m_Size[0] * m_Size[1]) };
    ForVoxels(m_Size, [&](std::size_t i, std::ptrdiff_t x, std::ptrdiff_t y, std::ptrdiff_t z) {
      const std::array<std::ptrdiff_t, 3> index = { x, y, z };
      double                              flow = 0.0;
      for (int k = 0; k < 6; ++k)
      {
        const int  axis = k / 2;
        const bool inside = k % 2 == 0 ? index[axis] + 1 < static_cast<std::ptrdiff_t>(m_Size[axis]) : index[axis] > 0;
        const double neighbor = inside ? heat[i + (k % 2 == 0 ? strides[axis] : -strides[axis])] : 0.0;
        flow += m_Conductances[i][k] * (neighbor - heat[i]);
      }
      m_Next[i] = heat[i] + m_Dt * flow;
    });
    std::swap(heat, m_Next);
  }

private:
  static const std::array<std::ptrdiff_t, 3> &
  Offset(int k)
  {
    static const std::array<std::ptrdiff_t, 3> offsets[6] = { { 1, 0, 0 },  { -1, 0, 0 }, { 0, 1, 0 },
                                                              { 0, -1, 0 }, { 0, 0, 1 },  { 0, 0, -1 } };
    return offsets[k];
  }

  Size   m_Size;
  double m_Dt;

public:
  std::vector<double> heat;

private:
  std::vector<double>                m_Next;
  std::vector<std::array<double, 6>> m_Conductances;
};

/** The values of a padded field, x fastest. */
inline std::vector<float>
Values(const PaddedGrid & grid, const PaddedField & field)
{
  std::vector<float> values;
  for (std::size_t z = 0; z < grid.GetSize()[2]; ++z)
  {
    for (std::size_t y = 0; y < grid.GetSize()[1]; ++y)
    {
      const float * const row = field.GetData() + grid.GetRow(y, z);
      values.insert(values.end(), row, row + grid.GetSize()[0]);
    }
  }
  return values;
}

template <typename TA, typename TB>
double
LargestDifference(const std::vector<TA> & a, const std::vector<TB> & b)
{
  double largest = a.size() == b.size() ? 0.0 : HUGE_VAL;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
  {
    largest = std::max(largest, std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i])));
  }
  return largest;
}
} // namespace test
} // namespace shapeton

#endif
