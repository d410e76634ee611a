#include "shapetonColonFluid.h"

#include "shapetonFluidBasins.h"
#include "shapetonPhantomRandom.h"
#include "shapetonExceptions.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace shapeton
{
namespace
{
constexpr double latticeStep = 2.0;       // mm
constexpr double sliceLength = 3.0;       // mm
constexpr double smallestBasin = 2.0;     // ml
constexpr double ridgeMargin = 1.2;       // mm; the lattice overestimates passage heights by about half a step
constexpr double textureDeviation = 43.0; // HU; as on CT colonographies
constexpr double latticeTurn = 0.61;      // radians
constexpr double wedgeShare = 0.4;        // of the pools
constexpr int    blockSide = 6;           // lattice steps; half the diagonal is below ColonAnatomy::Reach
constexpr double pointVolume = latticeStep * latticeStep * latticeStep / 1000.0; // ml

constexpr std::uint32_t filledStream = 0xf111;
constexpr DrawnRange    filledIntensity{ 600.0, 830.0 }; // HU, as in other pools

int
SliceAt(double arcLength)
{
  return std::max(0, static_cast<int>(std::floor(arcLength / sliceLength)));
}

// The points of a lattice in the lumen, with their slices. The lattice is oblique to distribute the heights of its
// points evenly.
class LumenLattice
{
public:
  LumenLattice(const ColonAnatomy & anatomy, const Eigen::Vector3d & down)
    : m_Anatomy(anatomy)
    , m_Axes(Eigen::AngleAxisd(latticeTurn, Eigen::Vector3d(1.0, 2.0, 3.0).normalized()).toRotationMatrix() *
             latticeStep)
    , m_Up(-down)
  {
    this->PlaceOverLumen();
    for (int z = 0; z < m_Size[2]; z += blockSide)
    {
      for (int y = 0; y < m_Size[1]; y += blockSide)
      {
        for (int x = 0; x < m_Size[0]; x += blockSide)
        {
          this->SampleBlock({ { x, y, z } });
        }
      }
    }
  }

  std::vector<std::vector<float>>
  Heights() const
  {
    std::vector<std::vector<float>> heights;
    this->Visit([&](const std::array<int, 3> & index, int slice) {
      if (static_cast<std::size_t>(slice) >= heights.size())
      {
        heights.resize(slice + 1);
      }
      heights[slice].push_back(this->HeightOf(index));
    });
    for (auto & list : heights)
    {
      std::sort(list.begin(), list.end());
    }
    return heights;
  }

  std::vector<FluidPassage>
  Passages() const
  {
    std::map<std::pair<int, int>, float> lowest;
    this->Visit([&](const std::array<int, 3> & index, int slice) {
      for (unsigned int axis = 0; axis < 3; ++axis)
      {
        auto next = index;
        ++next[axis];
        const int other = next[axis] < m_Size[axis] ? m_Slices[this->Offset(next)] : -1;
        if (other >= 0 && other != slice && this->IsPassage(index, next, slice, other))
        {
          const float height = std::max(this->HeightOf(index), this->HeightOf(next));
          const auto  found = lowest.emplace(std::minmax(slice, other), height).first;
          found->second = std::min(found->second, height);
        }
      }
    });
    std::vector<FluidPassage> passages;
    for (const auto & passage : lowest)
    {
      passages.push_back({ passage.first.first, passage.first.second, passage.second - ridgeMargin });
    }
    return passages;
  }

private:
  void
  PlaceOverLumen()
  {
    Eigen::Vector3d low;
    Eigen::Vector3d high;
    m_Anatomy.BoundingBox(latticeStep, low, high);
    const Eigen::Vector3d center = 0.5 * (low + high);
    const Eigen::Vector3d half = 0.5 * (high - low);
    Eigen::Vector3d       corner;
    for (unsigned int i = 0; i < 3; ++i)
    {
      const Eigen::Vector3d axis = m_Axes.col(i) / latticeStep;
      const double          reach = axis.cwiseAbs().dot(half) / latticeStep;
      m_Size[i] = 2 * static_cast<int>(std::ceil(reach)) + 1;
      corner[i] = -0.5 * (m_Size[i] - 1);
    }
    m_Origin = center + m_Axes * corner;
    m_Slices.assign(static_cast<std::size_t>(m_Size[0]) * m_Size[1] * m_Size[2], -1);
  }

  std::size_t
  Offset(const std::array<int, 3> & index) const
  {
    return (static_cast<std::size_t>(index[2]) * m_Size[1] + index[1]) * m_Size[0] + index[0];
  }

  Eigen::Vector3d
  PointAt(double x, double y, double z) const
  {
    return m_Origin + m_Axes * Eigen::Vector3d(x, y, z);
  }

  float
  HeightOf(const std::array<int, 3> & index) const
  {
    return static_cast<float>(m_Up.dot(this->PointAt(index[0], index[1], index[2])));
  }

  void
  SampleBlock(const std::array<int, 3> & first)
  {
    constexpr double middle = 0.5 * (blockSide - 1);
    const auto       center = this->PointAt(first[0] + middle, first[1] + middle, first[2] + middle);
    if (m_Anatomy.Evaluate(center).distance <= -ColonAnatomy::Reach)
    {
      return;
    }
    std::array<int, 3> index;
    for (index[2] = first[2]; index[2] < std::min(first[2] + blockSide, m_Size[2]); ++index[2])
    {
      for (index[1] = first[1]; index[1] < std::min(first[1] + blockSide, m_Size[1]); ++index[1])
      {
        for (index[0] = first[0]; index[0] < std::min(first[0] + blockSide, m_Size[0]); ++index[0])
        {
          const auto sample = m_Anatomy.Evaluate(this->PointAt(index[0], index[1], index[2]));
          m_Slices[this->Offset(index)] = static_cast<short>(sample.distance > 0.0 ? SliceAt(sample.arcLength) : -1);
        }
      }
    }
  }

  // A septum between touching stretches may separate lattice neighbors.
  bool
  IsPassage(const std::array<int, 3> & a, const std::array<int, 3> & b, int sliceA, int sliceB) const
  {
    if (std::abs(sliceA - sliceB) <= 2)
    {
      return true;
    }
    for (const double share : { 0.25, 0.5, 0.75 })
    {
      const auto point =
        this->PointAt(a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]), a[2] + share * (b[2] - a[2]));
      if (m_Anatomy.Evaluate(point).distance <= 0.0)
      {
        return false;
      }
    }
    return true;
  }

  template <typename TVisitor>
  void
  Visit(const TVisitor & visit) const
  {
    std::array<int, 3> index;
    for (index[2] = 0; index[2] < m_Size[2]; ++index[2])
    {
      for (index[1] = 0; index[1] < m_Size[1]; ++index[1])
      {
        for (index[0] = 0; index[0] < m_Size[0]; ++index[0])
        {
          const int slice = m_Slices[this->Offset(index)];
          if (slice >= 0)
          {
            visit(index, slice);
          }
        }
      }
    }
  }

  const ColonAnatomy & m_Anatomy;
  Eigen::Matrix3d      m_Axes;
  Eigen::Vector3d      m_Up;
  Eigen::Vector3d      m_Origin;
  std::array<int, 3>   m_Size;
  std::vector<short>   m_Slices;
};
} // namespace

Eigen::Vector3d
GravityOf(const ColonPhantomParameters & parameters)
{
  const std::map<std::string, Eigen::Vector3d> directions{ { "supine", { 0, 1, 0 } },
                                                           { "prone", { 0, -1, 0 } },
                                                           { "leftDecubitus", { 1, 0, 0 } },
                                                           { "rightDecubitus", { -1, 0, 0 } } };
  const auto                                   found = directions.find(parameters.position);
  if (found == directions.end())
  {
    throw ParameterError("the position must be supine, prone, leftDecubitus or rightDecubitus, not \"" +
                         parameters.position + '"');
  }
  PhantomRandom random(parameters.seed, 0x7117);
  const double  across = random.Uniform(-0.7, 0.7) * 3.14159265358979 / 180.0;
  const double  along = random.Uniform(-0.7, 0.7) * 3.14159265358979 / 180.0;
  const auto &  down = found->second;
  return (down + across * Eigen::Vector3d(down[1], down[0], 0.0) + along * Eigen::Vector3d(0.0, 0.0, 1.0)).normalized();
}

ColonFluid::ColonFluid(const ColonAnatomy & anatomy) : m_Anatomy(anatomy), m_Down(GravityOf(anatomy.GetParameters()))
{
  const auto &       parameters = anatomy.GetParameters();
  const LumenLattice lattice(anatomy, m_Down);
  const auto         heights = lattice.Heights();
  std::size_t        points = 0;
  for (const auto & list : heights)
  {
    points += list.size();
  }
  m_LumenVolume = static_cast<double>(points) * pointVolume;
  m_PoolOfBin.assign(heights.size(), -1);
  this->MakeTexture();

  PhantomRandom random(parameters.seed, 0xf1d0 + static_cast<std::uint32_t>(parameters.position[0]));
  const auto    share = static_cast<std::size_t>(std::lround(parameters.fluid * static_cast<double>(points)));
  const auto    smallest = static_cast<std::size_t>(smallestBasin / pointVolume);
  for (const auto & pool : FillBasins(heights, lattice.Passages(), share, smallest, random))
  {
    for (const int slice : pool.slices)
    {
      m_PoolOfBin[slice] = static_cast<int>(m_Pools.size());
    }
    const double intensity = random.Uniform(600.0, 830.0);
    const double wedge = random.Uniform(0.0, 1.0) < wedgeShare ? random.Uniform(250.0, 450.0) : 0.0;
    m_Pools.push_back({ pool.level, pool.bottom, static_cast<double>(pool.points) * pointVolume, intensity, wedge });
  }
  this->FillStretch(heights);
}

// The lowest stretch without other fluid.
void
ColonFluid::FillStretch(const std::vector<std::vector<float>> & heights)
{
  constexpr int    gasSlices = 5;     // between the stretch and other fluid
  constexpr double aboveAll = 1000.0; // mm, a level
  const auto &     parameters = m_Anatomy.GetParameters();
  const int        slices = static_cast<int>(std::lround(parameters.filledStretch / sliceLength));
  const auto       isFree = [&](int slice) {
    const int segment = m_Anatomy.SegmentAt((slice + 0.5) * sliceLength);
    return (segment == 2 || segment == 3) && m_PoolOfBin[slice] < 0 && !heights[slice].empty();
  };
  int    best = -1;
  int    free = 0;
  double lowest = aboveAll;
  for (int end = 0; slices > 0 && end < static_cast<int>(heights.size()); ++end)
  {
    free = isFree(end) ? free + 1 : 0;
    const int first = end + 1 - gasSlices - slices;
    if (free < slices + 2 * gasSlices)
    {
      continue;
    }
    double bottom = aboveAll;
    for (int slice = first; slice < first + slices; ++slice)
    {
      bottom = std::min(bottom, static_cast<double>(heights[slice].front()));
    }
    best = bottom < lowest ? first : best;
    lowest = std::min(lowest, bottom);
  }
  if (best < 0)
  {
    return;
  }
  std::size_t points = 0;
  for (int slice = best; slice < best + slices; ++slice)
  {
    m_PoolOfBin[slice] = static_cast<int>(m_Pools.size());
    points += heights[slice].size();
  }
  PhantomRandom random(parameters.seed, filledStream + static_cast<std::uint32_t>(parameters.position[0]));
  const double  volume = static_cast<double>(points) * pointVolume;
  m_Pools.push_back({ lowest + aboveAll, lowest, volume, random.Uniform(filledIntensity), 0.0 });
  m_FilledStretch = { { best * sliceLength, (best + slices) * sliceLength } };
}

void
ColonFluid::MakeTexture()
{
  PhantomRandom random(m_Anatomy.GetParameters().seed, 0x7e87);
  for (auto & wave : m_Waves)
  {
    const Eigen::Vector3d direction(random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1));
    constexpr double      pi = 3.14159265358979;               // not M_PI: its digits enter the voxels
    const double          length = random.Uniform(15.0, 40.0); // mm
    wave.number = direction.normalized() * (2.0 * pi / length);
    wave.phase = random.Uniform(0.0, 2.0 * pi);
  }
}

int
ColonFluid::BinOf(double arcLength) const
{
  return std::min(SliceAt(arcLength), static_cast<int>(m_PoolOfBin.size()) - 1);
}

double
ColonFluid::DepthBelowLevel(const Eigen::Vector3d & point, double arcLength) const
{
  const int bin = this->BinOf(arcLength);
  const int pool = bin < 0 ? -1 : m_PoolOfBin[bin];
  return pool < 0 ? -1000.0 : m_Pools[pool].level + m_Down.dot(point);
}

// The wedge fills the lower half of the pool, with a slope of about 10 degrees.
double
ColonFluid::Intensity(const Eigen::Vector3d & point, double arcLength) const
{
  const int bin = this->BinOf(arcLength);
  const int index = bin < 0 ? -1 : m_PoolOfBin[bin];
  if (index < 0)
  {
    return 0.0;
  }
  const ColonPool & pool = m_Pools[index];
  double            waves = 0.0;
  for (const auto & wave : m_Waves)
  {
    waves += std::cos(wave.number.dot(point) + wave.phase);
  }
  const double texture = textureDeviation * waves * std::sqrt(2.0 / static_cast<double>(m_Waves.size()));
  if (pool.wedge == 0.0)
  {
    return pool.intensity + texture;
  }
  const double height = -m_Down.dot(point) - pool.bottom;
  const double top =
    std::min(0.5 * (pool.level - pool.bottom), 12.0) + 0.18 * (arcLength - std::floor(arcLength / 60.0) * 60.0 - 30.0);
  const double share = 1.0 / (1.0 + std::exp(std::clamp(1.5 * (height - top), -50.0, 50.0)));
  return (1.0 - share) * (pool.intensity + texture) + share * (pool.wedge + 0.5 * texture);
}
} // namespace shapeton
