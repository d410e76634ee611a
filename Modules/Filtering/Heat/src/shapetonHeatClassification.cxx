#include "shapetonHeatClassification.h"
#include "shapetonExceptions.h"
#include "shapetonImageGrid.h"
#include "shapetonDisjointSets.h"
#include "shapetonMappedImage.h"
#include "shapetonParallelFor.h"

#include "itkImageRegionConstIterator.h"
#include "itkImageRegionConstIteratorWithIndex.h"
#include "itkImageRegionIterator.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace shapeton
{
namespace
{
/** Bins [first, end) around one peak of the smoothed row. */
struct Hill
{
  unsigned int first;
  unsigned int end;
  double       peak;
  unsigned int peakBin;
  double       mass; // voxels, unsmoothed
};

/** Voxels per unit of log(heat): bins are wider at the start of each octave. */
std::vector<double>
SmoothedDensity(const std::uint32_t * counts)
{
  constexpr int                   radius = 2;
  constexpr std::array<double, 3> kernel = { 0.36, 0.24, 0.08 }; // approximately a Gaussian of 1.1 bins: 0.4 % of the
                                                                 // heat
  constexpr auto      last = static_cast<int>(HeatHistogram::NumberOfBins) - 1;
  std::vector<double> density(HeatHistogram::NumberOfBins, 0.0);
  for (int bin = 1; bin <= last; ++bin)
  {
    density[bin] = counts[bin] / std::log(HeatHistogram::LowerEdge(bin + 1) / HeatHistogram::LowerEdge(bin));
  }
  std::vector<double> smooth(HeatHistogram::NumberOfBins, 0.0);
  for (int bin = 1; bin <= last; ++bin)
  {
    for (int offset = -radius; offset <= radius; ++offset)
    {
      const int neighbor = bin + offset;
      if (neighbor >= 1 && neighbor <= last)
      {
        smooth[bin] += kernel[std::abs(offset)] * density[neighbor];
      }
    }
  }
  return smooth;
}

std::vector<Hill>
FindHills(const std::vector<double> & smooth, const std::uint32_t * counts)
{
  std::vector<Hill> hills;
  const auto        bins = static_cast<unsigned int>(smooth.size());
  for (unsigned int bin = 1; bin < bins;)
  {
    Hill hill{ bin, bin, 0.0, bin, 0.0 };
    while (bin < bins && (hill.end == hill.first || smooth[bin] >= smooth[bin - 1])) // up
    {
      hill.end = ++bin;
    }
    while (bin < bins && smooth[bin] <= smooth[bin - 1] && !(smooth[bin] == 0.0 && smooth[bin - 1] == 0.0)) // down
    {
      hill.end = ++bin;
    }
    while (bin < bins && smooth[bin] == 0.0) // the exact position of the cut within the empty range is irrelevant
    {
      hill.end = ++bin;
    }
    for (unsigned int k = hill.first; k < hill.end; ++k)
    {
      hill.peakBin = smooth[k] > hill.peak ? k : hill.peakBin;
      hill.peak = std::max(hill.peak, smooth[k]);
      hill.mass += counts[k];
    }
    if (hill.mass > 0.0)
    {
      hills.push_back(hill);
    }
  }
  return hills;
}

/** Merges the least significant hill with a neighbor until all hills satisfy the rule. */
void
JoinHills(std::vector<Hill> & hills, const std::vector<double> & smooth, const HeatClassificationRule & rule)
{
  double total = 0.0;
  for (const Hill & hill : hills)
  {
    total += hill.mass;
  }
  const auto valley = [&](std::size_t left) { // valley between hill `left` and the next one
    double least = std::numeric_limits<double>::max();
    for (unsigned int bin = hills[left].end - 1; bin <= hills[left + 1].first && bin < smooth.size(); ++bin)
    {
      least = std::min(least, smooth[bin]);
    }
    return least;
  };
  while (hills.size() > 1)
  {
    // Hills that violate the rule come first, then the hills with the smallest prominence, weighted by mass.
    std::size_t             weakest = 0;
    std::pair<bool, double> least{ true, std::numeric_limits<double>::max() };
    bool                    allowed = hills.size() <= rule.maximumNumberOfClasses;
    for (std::size_t i = 0; i + 1 < hills.size(); ++i)
    {
      const double low = std::min(hills[i].peak, hills[i + 1].peak);
      const double ratio = low / std::max(valley(i), 1e-3 * low);
      const double mass = std::min(hills[i].mass, hills[i + 1].mass);
      const bool   keep = ratio >= rule.minimumPeakToValley && mass >= rule.minimumShare * total;
      const auto   worth = std::make_pair(keep, std::log(ratio) * mass);
      allowed &= keep;
      if (worth < least)
      {
        least = worth;
        weakest = i;
      }
    }
    if (allowed)
    {
      return;
    }
    Hill &       joined = hills[weakest];
    Hill &       next = hills[weakest + 1];
    const Hill & higher = joined.peak >= next.peak ? joined : next;
    joined = { joined.first, next.end, higher.peak, higher.peakBin, joined.mass + next.mass };
    hills.erase(hills.begin() + static_cast<std::ptrdiff_t>(weakest) + 1);
  }
}

HeatClass
MakeClass(const Hill & hill, const std::uint32_t * counts)
{
  HeatClass heatClass;
  heatClass.lowerHeat = HeatHistogram::LowerEdge(hill.first);
  heatClass.upperHeat = HeatHistogram::LowerEdge(hill.end);
  for (unsigned int bin = hill.first; bin < hill.end; ++bin)
  {
    heatClass.voxels += counts[bin];
    heatClass.meanHeat += counts[bin] * 0.5 * (HeatHistogram::LowerEdge(bin) + HeatHistogram::LowerEdge(bin + 1));
  }
  heatClass.meanHeat /= static_cast<double>(std::max<std::uint64_t>(1, heatClass.voxels));
  return heatClass;
}

unsigned int
LabelOf(float heat, const std::vector<HeatClass> & classes)
{
  const auto above =
    std::upper_bound(classes.begin(), classes.end(), static_cast<double>(heat), [](double h, const HeatClass & c) {
      return h < c.lowerHeat;
    });
  return above == classes.begin() ? 0 : (above - 1)->label;
}

void
MeasureBorder(const itk::Image<unsigned char, 3> * labels, std::vector<HeatClass> & classes)
{
  const auto region = labels->GetBufferedRegion();
  const auto size = region.GetSize();
  double     total = 0.0;
  for (itk::ImageRegionConstIteratorWithIndex<itk::Image<unsigned char, 3>> it(labels, region); !it.IsAtEnd(); ++it)
  {
    bool atBorder = false;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      const auto place = it.GetIndex()[axis] - region.GetIndex(axis);
      atBorder |= place == 0 || place + 1 == static_cast<itk::IndexValueType>(size[axis]);
    }
    if (atBorder)
    {
      classes[it.Get()].borderShare += 1.0;
      total += 1.0;
    }
  }
  for (auto & heatClass : classes)
  {
    heatClass.borderShare /= std::max(1.0, total);
    heatClass.isSurroundings = heatClass.borderShare > 0.5;
  }
}
/** Sums over the faces between classes i and j, stored at i * classes + j and j * classes + i; stored once if i = j. */
struct ClassContacts
{
  std::vector<double> conductance;
  std::vector<double> unhindered; ///< conductance without edges
};

/** Each slice has its own sums, which are added in order. */
ClassContacts
MeasureContacts(const VolumeGradientOperator & volumeGradient,
                const float *                  heat,
                const std::vector<HeatClass> & classes)
{
  const PaddedGrid &               grid = volumeGradient.GetGrid();
  const auto &                     size = grid.GetSize();
  const std::size_t                number = classes.size();
  const std::array<std::size_t, 3> strides = { 1, size[0], size[0] * size[1] };
  std::vector<unsigned char>       labels(grid.GetNumberOfVoxels());
  ParallelFor(size[2], [&](std::size_t z) {
    std::transform(heat + z * strides[2],
                   heat + (z + 1) * strides[2],
                   labels.begin() + static_cast<std::ptrdiff_t>(z * strides[2]),
                   [&](float h) { return static_cast<unsigned char>(LabelOf(h, classes)); });
  });
  const ClassContacts none{ std::vector<double>(number * number, 0.0), std::vector<double>(number * number, 0.0) };
  std::vector<ClassContacts> slices(size[2], none);
  ParallelFor(size[2], [&](std::size_t z) {
    for (std::size_t y = 0; y < size[1]; ++y)
    {
      for (std::size_t x = 0; x < size[0]; ++x)
      {
        const std::array<std::size_t, 3> index = { x, y, z };
        const std::size_t                voxel = x + y * strides[1] + z * strides[2];
        for (unsigned int axis = 0; axis < 3; ++axis)
        {
          if (index[axis] + 1 < size[axis])
          {
            const auto        ends = std::minmax(labels[voxel], labels[voxel + strides[axis]]);
            const std::size_t pair = ends.first * number + ends.second;
            slices[z].conductance[pair] += volumeGradient.GetConductances(axis)[grid.GetRow(y, z) + x];
            slices[z].unhindered[pair] += volumeGradient.GetFactor(axis);
          }
        }
      }
    }
  });
  ClassContacts sums = none;
  for (const ClassContacts & slice : slices)
  {
    for (std::size_t pair = 0; pair < number * number; ++pair)
    {
      const std::size_t mirrored = pair % number * number + pair / number;
      sums.conductance[pair] += slice.conductance[std::min(pair, mirrored)];
      sums.unhindered[pair] += slice.unhindered[std::min(pair, mirrored)];
    }
  }
  return sums;
}
} // namespace

void
RequireHeat(const itk::Image<float, 3> * heat, const std::string & what)
{
  RequirePixels(heat, what.c_str());
  constexpr float     tolerance = 1e-4F; // of expanded heat
  const float * const values = heat->GetBufferPointer();
  const bool isHeat = std::all_of(values, values + heat->GetBufferedRegion().GetNumberOfPixels(), [](float value) {
    return value >= -tolerance && value <= 1.0F + tolerance;
  });
  if (!isHeat)
  {
    throw InputError(
      what + " is not a heat volume, its values are not in [0, 1]: use one written by CumulativeHeatDiffusion, or a "
             ".nrrd or .mha with the visits of ShapetonDiffusion");
  }
}

std::vector<HeatClass>
FindHeatClasses(const HeatHistogram & histogram, std::size_t row, const HeatClassificationRule & rule)
{
  constexpr unsigned int mostClasses = 254;
  RequireParameter(rule.maximumNumberOfClasses >= 1 && rule.maximumNumberOfClasses <= mostClasses,
                   "the maximum number of classes must be between 1 and 254");
  RequireParameter(rule.backgroundHeat >= 0.0 && rule.minimumShare >= 0.0 && rule.minimumShare <= 1.0 &&
                     rule.minimumPeakToValley >= 0.0,
                   "the rule of classes has a number that is negative, not finite, or a share above 1");
  const std::uint32_t * const counts = histogram.GetRow(row);
  const auto                  smooth = SmoothedDensity(counts);
  std::vector<Hill>           hills = FindHills(smooth, counts);
  JoinHills(hills, smooth, rule);
  Hill background{ 0, 1, 0.0, 0, 0.0 };
  while (!hills.empty() && HeatHistogram::LowerEdge(hills.front().peakBin) < rule.backgroundHeat)
  {
    background.end = hills.front().end;
    hills.erase(hills.begin());
  }
  hills.insert(hills.begin(), background);

  std::vector<HeatClass> classes;
  for (const Hill & hill : hills)
  {
    classes.push_back(MakeClass(hill, counts));
    classes.back().label = static_cast<unsigned int>(classes.size() - 1);
    if (classes.size() > 1)
    {
      classes.back().lowerHeat = classes[classes.size() - 2].upperHeat; // no gap between classes
    }
  }
  if (classes.size() > 1)
  {
    classes.back().upperHeat = 1.0;
  }
  return classes;
}

double
MeasureCoherence(const VolumeGradientOperator & volumeGradient, const float * heat, std::vector<HeatClass> & classes)
{
  const ClassContacts contacts = MeasureContacts(volumeGradient, heat, classes);
  const std::size_t   number = classes.size();
  const double        conductance =
    2.0 * (volumeGradient.GetFactor(0) + volumeGradient.GetFactor(1) + volumeGradient.GetFactor(2));
  DisjointSets        regions(number);
  std::vector<double> worth(number, 0.0);
  for (std::size_t i = 0; i < number; ++i)
  {
    constexpr double leak = 3.0; // an open face to another class outweighs three inner ones; 1 to 5 rank alike
    constexpr double open = 0.5;
    constexpr double fullShare = 0.05;
    double           excess = 2.0 * contacts.conductance[i * number + i];
    for (std::size_t j = 0; j < number; ++j)
    {
      const double across = contacts.conductance[i * number + j];
      if (j != i)
      {
        excess -= leak * across;
        if (across > open * contacts.unhindered[i * number + j])
        {
          regions.Join(i, j);
        }
      }
    }
    const auto voxels = static_cast<double>(std::max<std::uint64_t>(1, classes[i].voxels));
    const auto all = static_cast<double>(volumeGradient.GetNumberOfVoxels());
    classes[i].coherence = std::clamp(excess / (conductance * voxels), 0.0, 1.0);
    worth[i] = *classes[i].coherence * std::sqrt(std::min(1.0, voxels / (fullShare * all)));
  }
  std::vector<double> best(number, 0.0);
  for (std::size_t i = 0; i < number; ++i)
  {
    const std::size_t region = regions.Find(i);
    best[region] = std::max(best[region], worth[i]);
  }
  return std::accumulate(best.begin(), best.end(), 0.0);
}

itk::Image<unsigned char, 3>::Pointer
LabelHeat(const itk::Image<float, 3> * heat, std::vector<HeatClass> & classes)
{
  RequireParameter(!classes.empty(),
                   "the list of classes is empty; turn WantComponents on for the run, or classify its heat alone");
  RequireHeat(heat, "the image");
  auto                labels = NewImageOn<itk::Image<unsigned char, 3>>(heat);
  std::vector<double> sums(classes.size(), 0.0);
  for (auto & heatClass : classes)
  {
    heatClass.voxels = 0;
  }
  itk::ImageRegionConstIterator<itk::Image<float, 3>>    in(heat, heat->GetBufferedRegion());
  itk::ImageRegionIterator<itk::Image<unsigned char, 3>> out(labels, heat->GetBufferedRegion());
  for (; !in.IsAtEnd(); ++in, ++out)
  {
    const unsigned int label = LabelOf(in.Get(), classes);
    out.Set(static_cast<unsigned char>(label));
    ++classes[label].voxels;
    sums[label] += in.Get();
  }
  const auto & spacing = heat->GetSpacing();
  for (auto & heatClass : classes)
  {
    heatClass.meanHeat = heatClass.voxels > 0 ? sums[heatClass.label] / heatClass.voxels : heatClass.meanHeat;
    heatClass.volume = heatClass.voxels * spacing[0] * spacing[1] * spacing[2];
    heatClass.borderShare = 0.0;
  }
  MeasureBorder(labels, classes);
  return labels;
}

void
MeasureContiguity(const itk::Image<unsigned char, 3> * labels, std::vector<HeatClass> & classes)
{
  const auto                       size = labels->GetBufferedRegion().GetSize();
  const std::array<std::size_t, 3> strides = { 1, size[0], size[0] * size[1] };
  const unsigned char * const      label = labels->GetBufferPointer();
  std::vector<double>              excess(classes.size(), 0.0); // faces inside minus faces to other classes
  std::vector<double>              faces(classes.size(), 0.0);
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    for (std::size_t voxel = 0; voxel + strides[axis] < strides[2] * size[2]; ++voxel)
    {
      if (voxel / strides[axis] % size[axis] + 1 == size[axis])
      {
        continue;
      }
      for (const unsigned char end : { label[voxel], label[voxel + strides[axis]] })
      {
        excess[end] += label[voxel] == label[voxel + strides[axis]] ? 1.0 : -1.0;
        faces[end] += 1.0;
      }
    }
  }
  for (HeatClass & heatClass : classes)
  {
    heatClass.coherence = std::max(0.0, excess[heatClass.label] / std::max(1.0, faces[heatClass.label]));
  }
}

void
AssignComponents(const std::vector<ShapeComponent> & components,
                 const itk::Image<float, 3> *        heat,
                 std::vector<HeatClass> &            classes)
{
  const auto          first = heat->GetBufferedRegion().GetIndex();
  std::vector<double> voxels(classes.size(), 0.0);
  for (const auto & component : components)
  {
    itk::Index<3> index = first;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      index[axis] += static_cast<itk::IndexValueType>(component.index[axis]);
    }
    const float      now = heat->GetPixel(index);
    constexpr double converged = 0.05; // relative deviation
    if (!component.closed || std::abs(now - component.convergedHeat) > converged * component.convergedHeat)
    {
      continue;
    }
    const unsigned int label = LabelOf(now, classes);
    ++classes[label].components;
    classes[label].normalizedHeat += component.voxels * component.normalizedHeat;
    voxels[label] += component.voxels;
  }
  for (auto & heatClass : classes)
  {
    heatClass.normalizedHeat /= std::max(1.0, voxels[heatClass.label]);
  }
}

HeatClassification
ClassifyHeat(const itk::Image<float, 3> *        heat,
             const std::vector<ShapeComponent> & components,
             const HeatClassificationRule &      rule)
{
  RequireHeat(heat, "the image");
  HeatHistogram histogram({ 0 });
  histogram.AddToRow(0, heat->GetBufferPointer(), heat->GetBufferedRegion().GetNumberOfPixels());
  HeatClassification classification;
  classification.classes = FindHeatClasses(histogram, 0, rule);
  classification.labels = LabelHeat(heat, classification.classes);
  AssignComponents(components, heat, classification.classes);
  return classification;
}

HeatClassification
ClassifyHeat(const itk::Image<float, 3> * heat, const CumulativeHeatDiffusionResult & result)
{
  HeatClassification classification;
  classification.classes = result.classes;
  classification.labels = LabelHeat(heat, classification.classes);
  AssignComponents(result.components, heat, classification.classes);
  return classification;
}
} // namespace shapeton
