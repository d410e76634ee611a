#include "shapetonColonFluid.h"

#include "shapetonFilledStretch.h"
#include "shapetonFluidBasins.h"
#include "shapetonForEachCell.h"
#include "shapetonColonNoise.h"
#include "shapetonColonPath.h"
#include "shapetonExceptions.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
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
constexpr int    puddleReach = 2;         // slices on each side of the lowest one
constexpr double latticeTurn = 0.61;      // radians
constexpr double wedgeShare = 0.4;        // of the pools
constexpr int    blockSide = 6;           // lattice steps; half the diagonal is below ColonAnatomy::Reach
constexpr double pointVolume = latticeStep * latticeStep * latticeStep / 1000.0; // ml

int
SliceAt(double arcLength)
{
  return std::max(0, static_cast<int>(std::floor(arcLength / sliceLength)));
}

// Position of the centerline in each slice.
std::vector<Eigen::Vector3d>
CentersOfSlices(const ColonAnatomy & anatomy, std::size_t count)
{
  const CurveSet               line = anatomy.Centerline();
  const Eigen::VectorXd        arcLength = PointValues(line, "arcLength", "centerline");
  std::vector<Eigen::Vector3d> centers(count, line.V.row(line.V.rows() - 1));
  for (Eigen::Index i = line.V.rows() - 1; i >= 0; --i)
  {
    centers[std::min<std::size_t>(SliceAt(arcLength[i]), count - 1)] = line.V.row(i);
  }
  return centers;
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
    ForEachCell({ 0, 0, 0 }, m_Size, blockSide, [this](const std::array<int, 3> & first) { this->SampleBlock(first); });
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
    std::array<int, 3> end;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      end[axis] = std::min(first[axis] + blockSide, m_Size[axis]);
    }
    ForEachCell(first, end, 1, [this](const std::array<int, 3> & index) {
      const auto sample = m_Anatomy.Evaluate(this->PointAt(index[0], index[1], index[2]));
      m_Slices[this->Offset(index)] = static_cast<short>(sample.distance > 0.0 ? SliceAt(sample.arcLength) : -1);
    });
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
    ForEachCell({ 0, 0, 0 }, m_Size, 1, [&](const std::array<int, 3> & index) {
      const int slice = m_Slices[this->Offset(index)];
      if (slice >= 0)
      {
        visit(index, slice);
      }
    });
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

double
TiltedLevel::FallTo(double arcLength) const
{
  const double along = end < begin ? begin - arcLength : arcLength - begin;
  return slope * std::clamp(along, 0.0, std::abs(end - begin));
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
  const auto    passages = lattice.Passages();
  auto          pools = FillBasins(heights, passages, share, smallest, random);
  this->FillStretch(heights, passages, pools);
  for (const auto & pool : pools)
  {
    const double intensity = random.Uniform(600.0, 830.0);
    const double wedge = random.Uniform(0.0, 1.0) < wedgeShare ? random.Uniform(250.0, 450.0) : 0.0;
    if (pool.slices.empty())
    {
      continue; // joined another pool
    }
    for (const int slice : pool.slices)
    {
      m_PoolOfBin[slice] = static_cast<int>(m_Pools.size());
    }
    m_Pools.push_back({ pool.level, pool.bottom, static_cast<double>(pool.points) * pointVolume, intensity, wedge });
  }
  this->TiltLevel(heights);
  this->AddSmallLevels(heights);
}

void
ColonFluid::FillStretch(const std::vector<std::vector<float>> & heights,
                        const std::vector<FluidPassage> &       passages,
                        std::vector<FluidPool> &                pools)
{
  constexpr int shortest = 10; // slices
  const int     slices = static_cast<int>(std::lround(m_Anatomy.GetParameters().filledStretch / sliceLength));
  if (slices == 0)
  {
    return;
  }
  std::vector<bool> isNarrow(heights.size()); // sigmoid and descending colon
  for (std::size_t slice = 0; slice < heights.size(); ++slice)
  {
    const int segment = m_Anatomy.SegmentAt((static_cast<double>(slice) + 0.5) * sliceLength);
    isNarrow[slice] = segment == 2 || segment == 3;
  }
  const auto filled =
    shapeton::FillStretch(heights, passages, isNarrow, { { std::min(shortest, slices), slices } }, pools);
  m_FilledStretch = { { filled[0] * sliceLength, filled[1] * sliceLength } };
}

// Tilts the level at the narrowest stretch that allows it, so that the smaller part of the pool is the lower one.
void
ColonFluid::TiltLevel(const std::vector<std::vector<float>> & heights)
{
  constexpr DrawnRange length{ 20.0, 35.0 }; // mm
  const auto &         parameters = m_Anatomy.GetParameters();
  if (parameters.levelSlope == 0.0)
  {
    return;
  }
  ColonRandom random(parameters.seed, ColonStream::TiltedLevel, PositionNumber(parameters.position));
  const int   slices = static_cast<int>(std::lround(random.Uniform(length) / sliceLength));
  const auto  mayTilt = this->PlacesForTilt(heights, slices);
  int         best = -1;
  std::size_t narrowest = std::numeric_limits<std::size_t>::max();
  for (int first = 0; first + slices <= static_cast<int>(heights.size()); ++first)
  {
    std::size_t points = 0;
    for (int slice = first; slice < first + slices; ++slice)
    {
      points += heights[slice].size();
    }
    if (mayTilt[first] && points < narrowest)
    {
      best = first;
      narrowest = points;
    }
  }
  if (best < 0)
  {
    return;
  }
  m_TiltedPool = m_PoolOfBin[best];
  const auto   begin = m_PoolOfBin.begin();
  const auto   before = std::count(begin, begin + best, m_TiltedPool);
  const auto   beyond = std::count(begin + best + slices, m_PoolOfBin.end(), m_TiltedPool);
  const double first = best * sliceLength;
  const double last = (best + slices) * sliceLength;
  m_TiltedLevel = { before < beyond ? last : first, before < beyond ? first : last, parameters.levelSlope };
  std::size_t points = 0;
  for (std::size_t slice = 0; slice < heights.size(); ++slice)
  {
    const double level =
      m_Pools[m_TiltedPool].level - m_TiltedLevel.FallTo((static_cast<double>(slice) + 0.5) * sliceLength);
    points += m_PoolOfBin[slice] == m_TiltedPool ? PointsBelow(heights, { static_cast<int>(slice) }, level) : 0;
  }
  m_Pools[m_TiltedPool].volume = static_cast<double>(points) * pointVolume;
}

// For each slice, whether a straight and horizontal stretch of one pool begins there, with gas above fluid that is
// deeper than the fall.
std::vector<bool>
ColonFluid::PlacesForTilt(const std::vector<std::vector<float>> & heights, int slices) const
{
  constexpr double margin = 2.0;            // mm of fluid and of gas
  constexpr double mostlyHorizontal = 0.85; // of the length
  const double     length = slices * sliceLength;
  const double     fall = m_Anatomy.GetParameters().levelSlope * length;
  const int  filledPool = m_FilledStretch[1] > m_FilledStretch[0] ? m_PoolOfBin[this->BinOf(m_FilledStretch[0])] : -1;
  const auto centers = CentersOfSlices(m_Anatomy, heights.size());
  std::vector<bool> may(heights.size(), false);
  int               run = 0;
  for (int slice = 0; slice < static_cast<int>(heights.size()); ++slice)
  {
    const int  pool = m_PoolOfBin[slice];
    const bool isDeep = pool >= 0 && pool != filledPool && !heights[slice].empty() &&
                        heights[slice].front() < m_Pools[pool].level - fall - margin &&
                        heights[slice].back() > m_Pools[pool].level + margin;
    const bool isSame = slice > 0 && m_PoolOfBin[slice - 1] == pool;
    run = isDeep ? (isSame ? run + 1 : 1) : 0;
    if (run > slices)
    {
      const Eigen::Vector3d chord = centers[slice] - centers[slice - slices];
      may[slice - slices] = (chord - chord.dot(m_Down) * m_Down).norm() > mostlyHorizontal * length;
    }
  }
  return may;
}

// Adds small levels in dips without other fluid, in random order.
void
ColonFluid::AddSmallLevels(const std::vector<std::vector<float>> & heights)
{
  constexpr DrawnRange area{ 20.0, 60.0 };      // mm^2
  constexpr DrawnRange content{ 600.0, 830.0 }; // HU
  constexpr double     shallowest = 0.75;       // mm
  constexpr double     deepest = 3.0;           // mm above the lowest point of the lattice
  constexpr double     step = 0.25;             // mm
  const auto &         parameters = m_Anatomy.GetParameters();
  if (parameters.smallLevels == 0)
  {
    return;
  }
  ColonRandom random(parameters.seed, ColonStream::SmallLevels, PositionNumber(parameters.position));
  const auto  centers = CentersOfSlices(m_Anatomy, heights.size());
  const int   count = static_cast<int>(heights.size());
  const int   start = static_cast<int>(random.Uniform() * count);
  const auto  wanted = static_cast<std::size_t>(parameters.smallLevels);
  for (int i = 0; i < count && m_SmallLevels.size() < wanted; ++i)
  {
    const int  slice = (start + i) % count;
    SmallLevel puddle{};
    double     level = 0.0;
    for (double height = deepest; puddle.area == 0.0 && height > 0.0 && this->MayHoldPuddle(heights, slice);
         height -= step)
    {
      level = heights[slice].front() + height;
      puddle = this->PuddleIn(slice, centers[slice], level);
      puddle.area =
        puddle.depth >= shallowest && puddle.area >= area.low && puddle.area <= area.high ? puddle.area : 0.0;
    }
    if (puddle.area == 0.0)
    {
      continue;
    }
    std::fill_n(m_PoolOfBin.begin() + slice - puddleReach, 2 * puddleReach + 1, static_cast<int>(m_Pools.size()));
    const double volume = 0.5 * puddle.area * puddle.depth / 1000.0;
    m_Pools.push_back({ level, level - puddle.depth, volume, random.Uniform(content), 0.0 });
    m_SmallLevels.push_back(puddle);
  }
}

// Whether the slice is beyond the anal canal, lower than its neighbors, and contains only gas.
bool
ColonFluid::MayHoldPuddle(const std::vector<std::vector<float>> & heights, int slice) const
{
  constexpr int canal = 20; // slices
  constexpr int around = 3; // slices
  if (slice < canal || slice + around >= static_cast<int>(heights.size()))
  {
    return false;
  }
  for (int other = slice - around; other <= slice + around; ++other)
  {
    if (m_PoolOfBin[other] >= 0 || heights[other].empty() || heights[other].front() < heights[slice].front())
    {
      return false;
    }
  }
  return true;
}

// The puddle below a level around a slice; its area is 0 if it is not compact or extends beyond these slices.
SmallLevel
ColonFluid::PuddleIn(int slice, const Eigen::Vector3d & center, double level) const
{
  constexpr double             step = 1.0;      // mm
  constexpr double             reach = 25.0;    // mm from the center
  constexpr double             compact = 10.0;  // mm, radius
  constexpr double             downStep = 0.25; // mm
  const Eigen::Vector3d        up = -m_Down;
  const Eigen::Vector3d        across = up.unitOrthogonal();
  const Eigen::Vector3d        along = up.cross(across);
  const Eigen::Vector3d        middle = center + (level - up.dot(center)) * up;
  std::vector<Eigen::Vector3d> points;
  for (double u = -reach; u <= reach; u += step)
  {
    for (double v = -reach; v <= reach; v += step)
    {
      const Eigen::Vector3d point = middle + u * across + v * along;
      const auto            sample = m_Anatomy.Evaluate(point);
      const int             off = std::abs(SliceAt(sample.arcLength) - slice);
      if (sample.distance <= 0.0 || off > puddleReach + 1)
      {
        continue;
      }
      if (off > puddleReach)
      {
        return {};
      }
      points.push_back(point);
    }
  }
  SmallLevel puddle{ Eigen::Vector3d::Zero(), step * step * static_cast<double>(points.size()), 0.0, 0.0 };
  for (const Eigen::Vector3d & point : points)
  {
    puddle.position += point / static_cast<double>(points.size());
  }
  for (const Eigen::Vector3d & point : points)
  {
    if ((point - puddle.position).norm() > compact)
    {
      return {};
    }
    double depth = 0.0;
    while (m_Anatomy.Evaluate(point + (depth + downStep) * m_Down).distance > 0.0)
    {
      depth += downStep;
    }
    puddle.depth = std::max(puddle.depth, depth);
  }
  puddle.arcLength = (slice + 0.5) * sliceLength;
  return puddle;
}

void
ColonFluid::MakeTexture()
{
  PhantomRandom random(m_Anatomy.GetParameters().seed, 0x7e87);
  for (auto & wave : m_Waves)
  {
    const Eigen::Vector3d direction(random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1));
    constexpr double      pi = 3.14159265358979;               // not Pi: its digits enter the voxels
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
  if (pool < 0)
  {
    return -1000.0;
  }
  const double fall = pool == m_TiltedPool ? m_TiltedLevel.FallTo(arcLength) : 0.0;
  return m_Pools[pool].level - fall + m_Down.dot(point);
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
