#include "shapetonHeatObjects.h"

#include "shapetonExceptions.h"
#include "shapetonParallelFor.h"
#include "shapetonPi.h"
#include "shapetonQuantiles.h"
#include "shapetonImageGrid.h"
#include "shapetonMappedImage.h"
#include "shapetonStableRegions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace shapeton
{
namespace
{
using HeatImage = itk::Image<float, 3>;
using Index = ComponentTree::Index;

/** An object and its voxels. */
struct Candidate
{
  HeatObject         object;
  std::vector<Index> voxels;
};

/** Weights of ProbabilityTerms(), fitted by FitHeatObjects (Testing/Validation) to 1,460 regions of 40 random scenes.
 */
double
ProbabilityOf(const HeatObject & object)
{
  constexpr double                constant = -14.3302;
  constexpr std::array<double, 4> weights = { { 0.676454, -1.2026, 1.37828, 1.62809 } };
  const auto                      terms = ProbabilityTerms(object);
  return 1.0 / (1.0 + std::exp(-std::inner_product(terms.begin(), terms.end(), weights.begin(), constant)));
}

/** The volumes in which to search for objects, on one grid. */
struct Volumes
{
  const HeatImage *          image{ nullptr }; ///< the first one, for its geometry
  std::vector<const float *> values;
  VoxelGrid                  grid;
  double                     voxelVolume{ 0.0 };            ///< mm^3
  std::array<double, 3>      faceArea{ { 0.0, 0.0, 0.0 } }; ///< mm^2, of the faces across each axis
};

Volumes
RequireOneGrid(const std::vector<const HeatImage *> & images)
{
  if (images.empty())
  {
    throw ParameterError("objects need at least one heat volume");
  }
  const auto & spacing = images[0]->GetSpacing();
  const auto   size = images[0]->GetBufferedRegion().GetSize();
  Volumes      volumes;
  volumes.image = images[0];
  volumes.grid.SetSize({ { static_cast<int>(size[0]), static_cast<int>(size[1]), static_cast<int>(size[2]) } });
  volumes.voxelVolume = spacing[0] * spacing[1] * spacing[2];
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    volumes.faceArea[axis] = volumes.voxelVolume / spacing[axis];
  }
  for (std::size_t i = 0; i < images.size(); ++i)
  {
    if (!HaveSameGrid(images[i], images[0]))
    {
      throw InputError("the grid of heat volume " + std::to_string(i + 1) + " differs from that of the first one");
    }
    volumes.values.push_back(images[i]->GetBufferPointer());
  }
  return volumes;
}

/** Measures the regions of one tree. */
class RegionMeasures
{
public:
  RegionMeasures(const ComponentTree & tree, const Volumes & volumes, int time, bool isWarm, float greatest)
    : m_Voxels(tree.GetVoxels())
    , m_Volumes(volumes)
    , m_Time(time)
    , m_IsWarm(isWarm)
    , m_Greatest(greatest)
    , m_Position(m_Voxels.size())
  {
    ParallelForBlocks(m_Voxels.size(), [this](std::size_t i) { m_Position[m_Voxels[i]] = static_cast<Index>(i); });
  }

  HeatObject
  Measure(const StableRegion & region) const
  {
    const float * const heat = m_Volumes.values[m_Time];
    const auto          begin = m_Voxels.begin() + region.first;
    const auto          end = m_Voxels.begin() + region.end;
    HeatObject          object;
    object.isWarm = m_IsWarm;
    object.time = m_Time;
    object.heat = heat[*(end - 1)];
    object.seed = *std::min_element(
      begin, end, [&](Index a, Index b) { return heat[a] != heat[b] ? (heat[a] > heat[b]) == m_IsWarm : a < b; });
    object.voxels = region.end - region.first;
    object.volume = m_Volumes.voxelVolume * static_cast<double>(object.voxels);
    object.growth = region.growth;
    object.range = region.range;
    for (const float * const values : m_Volumes.values)
    {
      const auto add = [values](double sum, Index voxel) { return sum + values[voxel]; };
      const auto sum = std::accumulate(begin, end, 0.0, add);
      object.heatCurve.push_back(sum / static_cast<double>(object.voxels));
    }
    object.center = this->CenterOf(region);
    this->MeasureBorder(region, object);
    object.probability = ProbabilityOf(object);
    return object;
  }

private:
  itk::Point<double, 3>
  CenterOf(const StableRegion & region) const
  {
    std::array<double, 3> sums{};
    for (Index i = region.first; i < region.end; ++i)
    {
      const auto place = m_Volumes.grid.Voxel(m_Voxels[i]);
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        sums[axis] += place[axis];
      }
    }
    itk::ContinuousIndex<double, 3> mean;
    const auto                      first = m_Volumes.image->GetBufferedRegion().GetIndex();
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      mean[axis] = static_cast<double>(first[axis]) + sums[axis] / (region.end - region.first);
    }
    itk::Point<double, 3> center;
    m_Volumes.image->TransformContinuousIndexToPhysicalPoint(mean, center);
    return center;
  }

  void
  MeasureBorder(const StableRegion & region, HeatObject & object) const
  {
    const float * const heat = m_Volumes.values[m_Time];
    std::vector<double> ratios;
    double              surface = 0.0;
    double              cut = 0.0;
    for (Index i = region.first; i < region.end; ++i)
    {
      const Index voxel = m_Voxels[i];
      const auto  place = m_Volumes.grid.Voxel(voxel);
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        for (const int step : { -1, 1 })
        {
          const int to = place[axis] + step;
          if (to < 0 || to >= m_Volumes.grid.size[axis])
          {
            cut += m_Volumes.faceArea[axis];
            continue;
          }
          const std::size_t neighbor = voxel + step * static_cast<std::ptrdiff_t>(m_Volumes.grid.stride[axis]);
          if (m_Position[neighbor] < region.first || m_Position[neighbor] >= region.end)
          {
            surface += m_Volumes.faceArea[axis];
            ratios.push_back(std::abs(LogHeat(heat[voxel], m_Greatest) - LogHeat(heat[neighbor], m_Greatest)));
          }
        }
      }
    }
    if (!ratios.empty())
    {
      object.contrast = UpperMedian(std::move(ratios));
    }
    constexpr double perFaces = 2.0 / 3.0; // a ball has 1.5 times its surface as faces of voxels
    constexpr double ofBall = 36.0 * Pi;   // surface^3 / volume^2
    const double     whole = perFaces * (surface + cut);
    object.compactness = ofBall * object.volume * object.volume / (whole * whole * whole);
    object.cut = cut / (surface + cut);
  }

  const std::vector<Index> & m_Voxels;
  const Volumes &            m_Volumes;
  int                        m_Time;
  bool                       m_IsWarm;
  float                      m_Greatest;
  std::vector<Index>         m_Position;
};

float
Greatest(const HeatImage & image)
{
  const float * const first = image.GetBufferPointer();
  const float         greatest = *std::max_element(first, first + image.GetBufferedRegion().GetNumberOfPixels());
  if (!(greatest > 0.0F) || std::isinf(greatest))
  {
    throw InputError("a heat volume needs finite values above 0, not at most " + std::to_string(greatest));
  }
  return greatest;
}

void
AddCandidates(const ComponentTree &     tree,
              const Volumes &           volumes,
              int                       time,
              bool                      isWarm,
              float                     greatest,
              const HeatObjectOptions & options,
              std::vector<Candidate> &  candidates)
{
  const auto              regions = FindStableRegions(tree, volumes.values[time], greatest, options);
  const RegionMeasures    measures(tree, volumes, time, isWarm, greatest);
  std::vector<HeatObject> found(regions.size());
  ParallelFor(regions.size(), [&](std::size_t i) { found[i] = measures.Measure(regions[i]); });
  const auto voxels = tree.GetVoxels().begin();
  for (std::size_t i = 0; i < regions.size(); ++i)
  {
    if (found[i].probability >= options.leastProbability)
    {
      candidates.push_back({ found[i], { voxels + regions[i].first, voxels + regions[i].end } });
    }
  }
}

/** The objects drawn so far, each over those that contain it. */
class Nesting
{
public:
  explicit Nesting(const HeatImage & image) : m_Labels(NewImageOn<HeatObjectList::LabelImage>(&image, true)) {}

  /** The object that contains nearly all voxels of a candidate, or 0. */
  int
  Around(const Candidate & candidate) const
  {
    std::vector<std::size_t> counts(m_Last + 1, 0);
    for (const Index voxel : candidate.voxels)
    {
      ++counts[m_Labels->GetBufferPointer()[voxel]];
    }
    const auto       most = std::max_element(counts.begin(), counts.end());
    constexpr double nearlyAll = 0.9; // objects of different times or trees differ by voxels of their borders
    const bool       isAround = static_cast<double>(*most) >= nearlyAll * static_cast<double>(candidate.voxels.size());
    return isAround ? static_cast<int>(most - counts.begin()) : 0;
  }

  void
  Draw(const Candidate & candidate, std::size_t number)
  {
    m_Last = std::max(m_Last, number);
    for (const Index voxel : candidate.voxels)
    {
      m_Labels->GetBufferPointer()[voxel] = static_cast<unsigned short>(number);
    }
  }

  HeatObjectList::LabelImage *
  GetLabels() const
  {
    return m_Labels;
  }

private:
  HeatObjectList::LabelImage::Pointer m_Labels;
  std::size_t                         m_Last{ 0 }; ///< greatest number drawn
};

/** Keeps the more probable of two candidates with nearly the same voxels; the result is sorted by descending size. */
std::vector<Candidate>
WithoutTwins(std::vector<Candidate> candidates, const HeatImage & image)
{
  const auto isLarger = [](const Candidate & a, const Candidate & b) { return a.voxels.size() > b.voxels.size(); };
  constexpr double       sameSize = 0.75; // as stable regions of one path, which differ by OtherVolume
  constexpr std::size_t  most = std::numeric_limits<unsigned short>::max();
  Nesting                nesting(image);
  std::vector<Candidate> kept;
  std::stable_sort(candidates.begin(), candidates.end(), isLarger);
  for (Candidate & candidate : candidates)
  {
    const int  around = nesting.Around(candidate);
    const bool isTwin = around > 0 && static_cast<double>(candidate.voxels.size()) >=
                                        sameSize * static_cast<double>(kept[around - 1].voxels.size());
    if (!isTwin && kept.size() < most)
    {
      nesting.Draw(candidate, kept.size() + 1);
      kept.push_back(std::move(candidate));
    }
    else if (isTwin && candidate.object.probability > kept[around - 1].object.probability)
    {
      nesting.Draw(candidate, around);
      kept[around - 1] = std::move(candidate);
    }
  }
  std::stable_sort(kept.begin(), kept.end(), isLarger);
  return kept;
}

std::vector<VoxelRange>
RangesOf(std::vector<Index> voxels)
{
  std::sort(voxels.begin(), voxels.end());
  std::vector<VoxelRange> ranges;
  for (const Index voxel : voxels)
  {
    if (ranges.empty() || ranges.back().end != voxel)
    {
      ranges.push_back({ voxel, voxel });
    }
    ++ranges.back().end;
  }
  ranges.shrink_to_fit();
  return ranges;
}

HeatObjectList
Nest(std::vector<Candidate> candidates, const HeatImage & image)
{
  HeatObjectList list;
  Nesting        nesting(image);
  for (const Candidate & candidate : candidates)
  {
    list.objects.push_back(candidate.object);
    list.objects.back().parent = nesting.Around(candidate);
    nesting.Draw(candidate, list.objects.size());
  }
  list.labels = nesting.GetLabels();
  list.ranges.resize(candidates.size());
  ParallelFor(candidates.size(), [&](std::size_t i) { list.ranges[i] = RangesOf(std::move(candidates[i].voxels)); });
  return list;
}
} // namespace

std::array<double, 4>
ProbabilityTerms(const HeatObject & object)
{
  constexpr double mostRange = 6.0;
  constexpr double leastGrowth = 0.002;
  constexpr double mostCompactness = 0.02;
  constexpr double mostVoxels = 2000.0;
  return { { std::log(std::min(object.range, mostRange)),
             std::log(object.growth + leastGrowth),
             std::log(std::min(object.compactness, mostCompactness)),
             std::log(std::min(static_cast<double>(object.voxels), mostVoxels)) } };
}

HeatObjectList
FindHeatObjects(const std::vector<const HeatImage *> & heats,
                const HeatObjectOptions &              options,
                const Progress &                       progress)
{
  CheckOptions(options);
  const Volumes          volumes = RequireOneGrid(heats);
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < heats.size(); ++i)
  {
    const auto           time = static_cast<int>(i);
    const float          greatest = Greatest(*heats[i]);
    const ComponentTrees trees = BuildComponentTrees(volumes.values[i], volumes.grid);
    AddCandidates(trees.maxTree, volumes, time, true, greatest, options, candidates);
    AddCandidates(trees.minTree, volumes, time, false, greatest, options, candidates);
    progress("Finding objects", static_cast<double>(i + 1) / static_cast<double>(heats.size()));
  }
  return Nest(WithoutTwins(std::move(candidates), *heats[0]), *heats[0]);
}

itk::Image<unsigned char, 3>::Pointer
MaskOfObject(const HeatObjectList & list, int object)
{
  if (object < 1 || object > static_cast<int>(list.objects.size()))
  {
    throw ParameterError("object " + std::to_string(object) + " is not in the list of " +
                         std::to_string(list.objects.size()) + " objects");
  }
  const auto mask = NewImageOn<itk::Image<unsigned char, 3>>(list.labels, true);
  for (const VoxelRange & range : list.ranges[object - 1])
  {
    std::fill(mask->GetBufferPointer() + range.begin, mask->GetBufferPointer() + range.end, 1);
  }
  return mask;
}
} // namespace shapeton
