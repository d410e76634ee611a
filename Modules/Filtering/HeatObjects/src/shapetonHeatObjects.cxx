#include "shapetonHeatObjects.h"

#include "shapetonExceptions.h"
#include "shapetonImageGrid.h"
#include "shapetonMappedImage.h"
#include "shapetonParallelFor.h"
#include "shapetonPartitionTree.h"
#include "shapetonPi.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace shapeton
{
namespace
{
using HeatImage = itk::Image<float, 3>;
using Index = PartitionTree::Index;
using Region = PartitionTree::Region;
using Terms = std::array<double, HeatObjectTerms>;

/** Smallest growth of a candidate at its next merge. With 8 to 25 %, the first click is right for as many objects. */
constexpr double LeastGrowth = 0.15;

/** An object has at least this many times the voxels of an object in it; a larger part is the same object with another
 * border. */
constexpr std::uint64_t LeastRatio = 2;

/** Smallest probability of an offer: below, nothing is there. A volume has hundreds of offers, without this bound
 * thousands in its noise. */
constexpr double LeastOffer = 0.01;

/** A step of log heat that nobody sees: 0.1 %. */
constexpr double LeastStep = 1e-3;

/** Weights of HeatObject::terms in the score: those for which the probability of the right region among those around a
 * voxel is greatest (conditional logit), for 12 voxels of each visible part of 174 random scenes, 14 phantoms, and six
 * scans (foot, tooth, lobster, three CTs), which count three times. FitHeatObjects repeats the fit on fewer volumes;
 * its weights are worse for them and for others. */
constexpr std::array<double, 6> ScoreWeights = { { 1.769, 1.179, -2.006, 0.121, -1.236, 0.444 } };
/** Weights of the terms in the log odds of the probability, and the constant: logistic regression on the same volumes.
 */
constexpr Terms  ProbabilityWeights = { { 1.792, 3.118, 1.636, 0.211, -3.672, 1.554, 0.212, -3.571 } };
constexpr double ProbabilityConstant = -23.629;

template <std::size_t number>
double
Weighted(const std::array<double, number> & weights, const Terms & terms)
{
  return std::inner_product(weights.begin(), weights.end(), terms.begin(), 0.0);
}

/** Natural logarithm of heat, which has no negative value in the domain. */
std::vector<float>
LogarithmOf(const HeatImage * heat, const unsigned char * domain)
{
  constexpr float     least = 1e-6F;
  constexpr float     rounding = 1e-4F; // of expanded heat
  const float * const values = heat->GetBufferPointer();
  const std::size_t   voxels = heat->GetBufferedRegion().GetNumberOfPixels();
  const auto          isInside = [domain](std::size_t voxel) { return !domain || domain[voxel] != 0; };
  float               greatest = 0.0F;
  for (std::size_t voxel = 0; voxel < voxels; ++voxel)
  {
    greatest = isInside(voxel) && values[voxel] > greatest ? values[voxel] : greatest;
  }
  if (!(greatest > 0.0F) || std::isinf(greatest))
  {
    throw InputError("a heat volume needs finite values above 0, such as heat or visits");
  }
  for (std::size_t voxel = 0; voxel < voxels; ++voxel)
  {
    if (values[voxel] < -rounding * greatest && isInside(voxel))
    {
      throw InputError("a heat volume has no negative values, such as " + std::to_string(values[voxel]) +
                       "; use the heat or the visits of a volume, not its intensities");
    }
  }
  std::vector<float> logarithms(voxels);
  ParallelForBlocks(voxels, [&](std::size_t voxel) {
    const float value = values[voxel];
    logarithms[voxel] = std::isfinite(value) ? std::log(std::max(value, least * greatest)) : value;
  });
  return logarithms;
}

/** The terms of the regions of a tree. A path leads from a region to its parents, and down to the larger of its parts.
 */
class RegionTerms
{
public:
  explicit RegionTerms(const PartitionTree & tree) : m_Regions(tree.GetRegions()), m_LargerPart(m_Regions.size(), none)
  {
    for (Index region = 0; region < this->Root(); ++region)
    {
      Index & part = m_LargerPart[m_Regions[region].parent];
      if (part == none || m_Regions[region].NumberOfVoxels() > m_Regions[part].NumberOfVoxels())
      {
        part = region;
      }
    }
  }

  Index
  Root() const
  {
    return static_cast<Index>(m_Regions.size() - 1);
  }

  /** Factor by which a region grows when it is merged. */
  double
  Growth(Index region) const
  {
    const Region & here = m_Regions[region];
    return static_cast<double>(m_Regions[here.parent].NumberOfVoxels()) / here.NumberOfVoxels();
  }

  /** HeatObject::range. */
  double
  Range(Index region) const
  {
    constexpr double factor = 2.0;
    constexpr double most = 6.0; // of a region without weaker borders, such as a basin
    const double     voxels = m_Regions[region].NumberOfVoxels();
    Index            top = region;
    while (m_Regions[top].parent != this->Root() && top != this->Root() &&
           m_Regions[m_Regions[top].parent].NumberOfVoxels() <= factor * voxels)
    {
      top = m_Regions[top].parent;
    }
    Index bottom = region;
    while (m_LargerPart[bottom] != none && m_Regions[m_LargerPart[bottom]].NumberOfVoxels() * factor >= voxels)
    {
      bottom = m_LargerPart[bottom];
    }
    const double strongest = m_Regions[m_Regions[top].parent].strength;
    return std::min(most,
                    std::log(std::max(strongest, LeastStep) / std::max<double>(m_Regions[bottom].strength, LeastStep)));
  }

  /** HeatObject::terms of a region with these properties. */
  Terms
  Of(Index region, const HeatObject & object) const
  {
    constexpr double leastRange = 0.05; // below, objects and noise no longer differ
    constexpr double mostVoxels = 5000.0;
    constexpr double leastShare = 0.1;
    constexpr double mostGrowth = 51.0;
    constexpr double leastCompactness = 1e-4;
    constexpr double mostCompactness = 0.1;
    constexpr double mostIsolation = 4.0; // natural logarithms
    constexpr double leastContrast = -4.0;
    constexpr double mostContrast = 1.0;
    const Region &   here = m_Regions[region];
    const auto       voxels = static_cast<double>(object.voxels);
    const double     share = voxels / m_Regions[this->Root()].NumberOfVoxels();
    const double isolation = std::log((object.contrast + LeastStep) / (m_Regions[here.parent].strength + LeastStep));
    return { { std::log(std::max(object.range, leastRange)),
               std::log(std::min(voxels, mostVoxels)),
               std::log(std::max(share, leastShare)),
               std::log(std::min(this->Growth(region), mostGrowth)),
               std::clamp(isolation, 0.0, mostIsolation),
               std::clamp(std::log(object.contrast + LeastStep), leastContrast, mostContrast),
               std::log(std::clamp(object.compactness, leastCompactness, mostCompactness)),
               object.cut } };
  }

private:
  static constexpr Index none = std::numeric_limits<Index>::max();

  const std::vector<Region> & m_Regions;
  std::vector<Index>          m_LargerPart; ///< of each region; none for basins
};

using Candidate = HeatObjectCandidate;

/** What the tree tells about a region; no position and mean heat. */
HeatObject
Describe(const RegionTerms & terms, Index number, const Region & region, double voxelVolume)
{
  constexpr double perFaces = 2.0 / 3.0; // a ball has 1.5 times its surface as faces of voxels
  constexpr double ofBall = 36.0 * Pi;   // surface^3 / volume^2
  const double     faces = region.border + region.cut;
  const double     surface = perFaces * faces;
  HeatObject       object;
  object.voxels = region.NumberOfVoxels();
  object.volume = voxelVolume * static_cast<double>(object.voxels);
  object.contrast = region.Contrast();
  object.range = terms.Range(number);
  object.compactness = ofBall * object.volume * object.volume / (surface * surface * surface);
  object.cut = region.cut / faces;
  object.terms = terms.Of(number, object);
  object.score = Weighted(ScoreWeights, object.terms);
  object.probability = 1.0 / (1.0 + std::exp(-ProbabilityConstant - Weighted(ProbabilityWeights, object.terms)));
  return object;
}

/** Regions of a suitable size that a person could mean; each follows those that contain it. */
std::vector<Candidate>
FindCandidates(const PartitionTree & tree, double voxelVolume, const HeatObjectOptions & options)
{
  const RegionTerms      terms(tree);
  const auto &           regions = tree.GetRegions();
  const double           most = options.mostShare * static_cast<double>(tree.GetVoxels().size());
  std::vector<Candidate> candidates;
  for (Index region = terms.Root(); region-- > 0;)
  {
    const auto voxels = regions[region].NumberOfVoxels();
    if (voxels >= options.leastVoxels && voxels <= most && terms.Growth(region) >= 1.0 + LeastGrowth)
    {
      candidates.push_back({ region, {} });
    }
  }
  ParallelForBlocks(candidates.size(), [&](std::size_t i) {
    const Index region = candidates[i].region;
    candidates[i].object = Describe(terms, region, regions[region], voxelVolume);
  });
  return candidates;
}

/** What is around a region. */
struct Surroundings
{
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  double        bestScore{ -std::numeric_limits<double>::infinity() };   ///< of all candidates
  double        innerScore{ -std::numeric_limits<double>::infinity() };  ///< of those in the smallest listed object
  std::uint64_t mostVoxels{ std::numeric_limits<std::uint64_t>::max() }; ///< of a part of the smallest listed object
  double        offerScore{ -std::numeric_limits<double>::infinity() };  ///< of the best offer
  std::size_t   offer{ none };
  bool          isListed{ false }; ///< whether a candidate is listed
};

/** Numbers of candidates to list, and of those to offer for voxels in none of these. */
struct Choice
{
  std::vector<std::size_t> listed;
  std::vector<std::size_t> offers;
};

Choice
ChooseObjects(const std::vector<Candidate> & candidates, const PartitionTree & tree, double leastProbability)
{
  const auto &              regions = tree.GetRegions();
  std::vector<Surroundings> around(regions.size()); // of the parts of each region
  std::vector<bool>         isOffer(candidates.size(), false);
  Choice                    choice;
  std::size_t               next = 0;
  for (auto region = static_cast<Index>(regions.size()); region-- > 0;)
  {
    Surroundings & here = around[region];
    here = around[regions[region].parent];
    if (next < candidates.size() && candidates[next].region == region)
    {
      const HeatObject & object = candidates[next].object;
      const bool         isPart = object.voxels <= here.mostVoxels && object.score > here.innerScore;
      const bool         isBest = object.score > here.bestScore;
      const bool         isListed = (isPart || isBest) && object.probability >= leastProbability;
      if (object.probability >= LeastOffer && object.score > here.offerScore)
      {
        here.offerScore = object.score;
        here.offer = next;
      }
      here.bestScore = std::max(here.bestScore, object.score);
      here.innerScore = isPart || isBest ? std::max(here.innerScore, object.score) : here.innerScore;
      if (isListed)
      {
        here.innerScore = Surroundings{}.innerScore;
        here.mostVoxels = object.voxels / LeastRatio;
        here.isListed = true;
        choice.listed.push_back(next);
      }
      ++next;
    }
    if (tree.IsBasin(region) && !here.isListed && here.offer != Surroundings::none)
    {
      isOffer[here.offer] = true;
    }
  }
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    if (isOffer[i])
    {
      choice.offers.push_back(i);
    }
  }
  return choice;
}

/** These candidates by descending size, at most as many as labels allow. */
void
AddBySize(const std::vector<Candidate> & all, std::vector<std::size_t> numbers, std::vector<Candidate> & to)
{
  constexpr std::size_t most = std::numeric_limits<HeatObjectList::LabelImage::PixelType>::max();
  std::stable_sort(numbers.begin(), numbers.end(), [&](std::size_t a, std::size_t b) {
    return all[a].object.voxels > all[b].object.voxels;
  });
  numbers.resize(std::min(numbers.size(), most - to.size()));
  std::transform(numbers.begin(), numbers.end(), std::back_inserter(to), [&](std::size_t i) { return all[i]; });
}

std::vector<VoxelRange>
RangesOf(const PartitionTree & tree, const Region & region)
{
  std::vector<Index> voxels(tree.GetVoxels().begin() + region.first, tree.GetVoxels().begin() + region.end);
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

/** Sets the mean position and the mean heat. */
void
Measure(const std::vector<VoxelRange> & ranges, const HeatImage * heat, HeatObject & object)
{
  const VoxelGrid       grid = GridOf(heat);
  std::array<double, 3> sums{};
  double                sumOfHeat = 0.0;
  for (const VoxelRange & range : ranges)
  {
    for (Index voxel = range.begin; voxel < range.end; ++voxel)
    {
      const auto place = grid.Voxel(voxel);
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        sums[axis] += place[axis];
      }
      sumOfHeat += heat->GetBufferPointer()[voxel];
    }
  }
  const auto                      voxels = static_cast<double>(object.voxels);
  const auto                      first = heat->GetBufferedRegion().GetIndex();
  itk::ContinuousIndex<double, 3> mean;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    mean[axis] = static_cast<double>(first[axis]) + sums[axis] / voxels;
  }
  heat->TransformContinuousIndexToPhysicalPoint(mean, object.center);
  object.meanHeat = sumOfHeat / voxels;
}

/** Sets the labels and parents: objects over offers, which are never parents of objects, and the smaller ones over
 * those that contain them. */
void
PutLabels(HeatObjectList & list)
{
  std::vector<std::size_t> order(list.objects.size());
  std::iota(order.begin(), order.end(), 0);
  std::rotate(order.begin(), order.end() - static_cast<std::ptrdiff_t>(list.numberOfOffers), order.end());
  auto * const labels = list.labels->GetBufferPointer();
  for (const std::size_t i : order)
  {
    const int around = labels[list.ranges[i].front().begin];
    list.objects[i].parent = list.IsOffer(around) && !list.IsOffer(static_cast<int>(i + 1)) ? 0 : around;
    for (const VoxelRange & range : list.ranges[i])
    {
      std::fill(labels + range.begin, labels + range.end, static_cast<unsigned short>(i + 1));
    }
  }
}

void
RequireObject(const HeatObjectList & list, int object)
{
  RequireParameter(object >= 1 && object <= static_cast<int>(list.objects.size()),
                   "object " + std::to_string(object) + " is not in the list of " +
                     std::to_string(list.objects.size()) + " objects");
}
} // namespace

HeatObjectTree::HeatObjectTree(const HeatImage *         heat,
                               const HeatObjectOptions & options,
                               const MaskImage *         domain,
                               const Progress &          progress)
  : m_Heat(heat), m_Options(options)
{
  CheckOptions(options);
  RequirePixels(heat, "the heat image");
  if (domain)
  {
    RequirePixels(domain, "the domain");
  }
  if (domain && !HaveSameGrid(heat, domain))
  {
    throw InputError("the domain of the objects has another grid than the heat; resample it to the grid of the heat");
  }
  const auto         spacing = heat->GetSpacing();
  const auto * const inside = domain ? domain->GetBufferPointer() : nullptr;
  constexpr double   shareOfTree = 0.8; // of the time
  m_Tree = BuildPartitionTree(LogarithmOf(heat, inside).data(),
                              GridOf(heat),
                              { { spacing[0], spacing[1], spacing[2] } },
                              inside,
                              progress.Part("Finding objects", 0.0, shareOfTree));
  progress("Finding objects", shareOfTree);
  m_Candidates = FindCandidates(m_Tree, spacing[0] * spacing[1] * spacing[2], options);
}

HeatObjectList
HeatObjectTree::List(bool withOffers) const
{
  const Choice           choice = ChooseObjects(m_Candidates, m_Tree, m_Options.leastProbability);
  std::vector<Candidate> chosen;
  AddBySize(m_Candidates, choice.listed, chosen);
  HeatObjectList    list;
  const std::size_t listed = chosen.size();
  if (listed == 0)
  {
    list.warnings.emplace_back("no object was found: diffuse heat with the preset automatic, or reduce the parameter "
                               "\"leastProbability\"");
  }
  if (withOffers)
  {
    AddBySize(m_Candidates, choice.offers, chosen);
  }
  list.numberOfOffers = chosen.size() - listed;
  list.objects.resize(chosen.size());
  list.ranges.resize(chosen.size());
  list.labels = NewImageOn<HeatObjectList::LabelImage>(m_Heat.GetPointer(), true);
  ParallelFor(chosen.size(), [&](std::size_t i) {
    list.objects[i] = chosen[i].object;
    list.ranges[i] = RangesOf(m_Tree, m_Tree.GetRegions()[chosen[i].region]);
    Measure(list.ranges[i], m_Heat, list.objects[i]);
  });
  PutLabels(list);
  return list;
}

HeatObjectList
FindHeatObjects(const HeatImage * heat, const HeatObjectOptions & options, const Progress & progress)
{
  auto list = HeatObjectTree(heat, options, nullptr, progress).List();
  progress("Finding objects", 1.0);
  return list;
}

int
ObjectOfClick(const HeatObjectList & list, int smallest)
{
  RequireObject(list, smallest);
  int best = smallest;
  for (int object = smallest; object > 0; object = list.objects[object - 1].parent)
  {
    best = list.objects[object - 1].score > list.objects[best - 1].score ? object : best;
  }
  return best;
}

itk::Image<unsigned char, 3>::Pointer
MaskOfObject(const HeatObjectList & list, int object)
{
  RequireObject(list, object);
  const auto mask = NewImageOn<itk::Image<unsigned char, 3>>(list.labels, true);
  for (const VoxelRange & range : list.ranges[object - 1])
  {
    std::fill(mask->GetBufferPointer() + range.begin, mask->GetBufferPointer() + range.end, 1);
  }
  return mask;
}
} // namespace shapeton
