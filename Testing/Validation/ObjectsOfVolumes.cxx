#include "Overlaps.h"
#include "RandomScenes.h"
#include "Reliability.h"
#include "SampledScenes.h"
#include "Tables.h"
#include "ValidationReport.h"
#include "ValidationVolumes.h"

#include "shapetonCumulativeHeatDiffusionImageFilter.h"
#include "shapetonImageGrid.h"
#include "shapetonHeatObjects.h"
#include "shapetonHeatParameterChoice.h"
#include "shapetonMappedImage.h"
#include "shapetonPartitionTree.h"
#include "shapetonTestImages.h"
#include "shapetonVolumeReader.h"
#include "shapetonVoxelRuns.h"

#include "itkBinaryThresholdImageFilter.h"
#include "itkConnectedComponentImageFilter.h"
#include "itkGradientMagnitudeRecursiveGaussianImageFilter.h"
#include "itkMorphologicalWatershedImageFilter.h"
#include "itkSmoothingRecursiveGaussianImageFilter.h"

#include <algorithm>
#include <map>
#include <numeric>

using namespace shapeton;

namespace
{
using Image = itk::Image<float, 3>;
using Labels = itk::Image<unsigned char, 3>;

struct Found
{
  HeatParameterChoice choice;
  Image::Pointer      heat;
  HeatObjectList      list;
};

/** As CumulativeHeatDiffusion, followed by HeatObjects. */
Found
FindObjects(const Image * image, double leastProbability, const std::string & modality = {})
{
  const auto filter = CumulativeHeatDiffusionImageFilter<Image>::New();
  filter->SetInput(image);
  Found found;
  found.choice = ChooseHeatParameters(VolumeView(image), filter->GetOptions(), {}, modality);
  filter->UseParameters(found.choice);
  filter->Update();
  found.heat = filter->GetOutput();
  HeatObjectOptions options;
  options.leastProbability = leastProbability;
  found.list = FindHeatObjects(found.heat, options);
  return found;
}

/** Adjusted Rand index of labels and smallest objects over the voxels of labels. */
double
RandIndex(const HeatObjectList & list, const Labels * labels)
{
  Overlaps overlaps = OverlapsOf(
    labels->GetBufferPointer(), list.labels->GetBufferPointer(), labels->GetBufferedRegion().GetNumberOfPixels());
  overlaps.erase(0);
  return AdjustedRandIndex(overlaps);
}

std::size_t
CountWhole(const std::vector<double> & dice)
{
  return std::count_if(dice.begin(), dice.end(), [](double d) { return d >= wholeObject; });
}

void
ValidatePhantoms(const ValidationSettings & settings, ValidationReport & report)
{
  CsvTable   table({ "phantom", "noise SD, HU", "objects", "listed", "found", "adjusted Rand index", ">= 0.95" });
  const auto names = settings.quick ? std::vector<std::string>{ "figure2.7a" } : ShapeScene::GetPresetNames();
  for (const std::string & name : names)
  {
    for (const double noise : { 0.0, 60.0 })
    {
      ShapePhantomOptions options;
      options.noise = noise;
      options.blur = noise > 0.0 ? 0.6 : 0.0;
      options.seed = 11;
      const auto   source = SampledScene(ShapeScene::Load(name), itk::Size<3>::Filled(96), options);
      const Found  found = FindObjects(ToFloat(source->GetOutput()), HeatObjectOptions{}.leastProbability);
      const auto   agreement = CompareObjects(found.list, source->GetLabelOutput());
      const double rand = RandIndex(found.list, source->GetLabelOutput());
      const bool   isOne = agreement.diceOfLabel.size() == 1; // no partition
      table.AddRow(Cells() << name << noise << agreement.diceOfLabel.size() << found.list.objects.size()
                           << CountWhole(agreement.diceOfLabel) << (isOne ? "" : Rounded(rand))
                           << (isOne ? "" : report.Check(rand >= 0.95)));
    }
  }
  report.AddTable(table);
}

void
ValidateScenes(const ValidationSettings & settings, ValidationReport & report)
{
  constexpr unsigned int firstSeed = 201;
  constexpr unsigned int side = 88;
  const unsigned int     seeds = settings.quick ? 3 : 12;
  Reliability            reliability;
  double                 labels = 0.0, found = 0.0, listed = 0.0, whole = 0.0;
  std::vector<double>    rand;
  for (unsigned int seed = firstSeed; seed < firstSeed + seeds; ++seed)
  {
    const SceneVolume volume = SampleScene(seed, side);
    const Found       all = FindObjects(volume.image, 0.0);
    const auto        agreement = CompareObjects(all.list, volume.labels);
    for (std::size_t i = 0; i < all.list.objects.size(); ++i)
    {
      const double probability = all.list.objects[i].probability;
      const bool   isWhole = agreement.dice[i] >= wholeObject;
      reliability.Add(probability, isWhole);
      listed += probability >= HeatObjectOptions{}.leastProbability ? 1.0 : 0.0;
      whole += probability >= HeatObjectOptions{}.leastProbability && isWhole ? 1.0 : 0.0;
    }
    const auto list = FindHeatObjects(all.heat);
    const auto ofList = CompareObjects(list, volume.labels);
    labels += static_cast<double>(ofList.diceOfLabel.size());
    found += static_cast<double>(CountWhole(ofList.diceOfLabel));
    rand.push_back(RandIndex(list, volume.labels));
  }
  report.AddText("Random scenes of " + std::to_string(side) + "^3 voxels with blur, noise, contacts and cores, seeds " +
                 std::to_string(firstSeed) + " to " + std::to_string(firstSeed + seeds - 1) +
                 " (not used for the fit): " + CsvTable::Number(found) + " of " + CsvTable::Number(labels) +
                 " objects, or objects with their core, are found; " + CsvTable::Number(whole) + " of " +
                 CsvTable::Number(listed) + " listed objects are whole. Adjusted Rand index " + MeanWithInterval(rand) +
                 '.');
  reliability.Write("regions", report);
  report.AddText("Brier score " + Rounded(reliability.BrierScore()) + ", calibration error " +
                 Rounded(reliability.CalibrationError()) +
                 " (bound 0.1): " + report.Check(reliability.CalibrationError() <= 0.1));
}

// ---- the foot ----

Image::Pointer
Smooth(const Image * image, double sigma)
{
  const auto filter = itk::SmoothingRecursiveGaussianImageFilter<Image>::New();
  filter->SetInput(image);
  filter->SetSigma(sigma);
  filter->Update();
  return filter->GetOutput();
}

/** Voxels that meet a condition on themselves and all face neighbors, or (any) on one of them. */
std::vector<char>
Morph(const std::vector<char> & set, const VoxelGrid & grid, bool any)
{
  std::vector<char> result(set.size());
  for (std::size_t voxel = 0; voxel < set.size(); ++voxel)
  {
    bool value = set[voxel] != 0;
    ForEachNeighbor(grid, voxel, [&](std::size_t neighbor) {
      value = any ? value || set[neighbor] != 0 : value && set[neighbor] != 0;
    });
    result[voxel] = value ? 1 : 0;
  }
  return result;
}

/** Reference bones: intensity smoothed by 0.8 voxel above 95, opened by the face neighbors, components of more than
 * 1,500 voxels, dilated once within the threshold; labels by descending size. */
Labels::Pointer
ReferenceBones(const Image * foot)
{
  constexpr float       bone = 95.0F;
  constexpr std::size_t leastVoxels = 1500;
  const auto            smooth = Smooth(foot, 0.8);
  const VoxelGrid       grid = GridOf(foot);
  std::vector<char>     isBone(grid.NumberOfVoxels());
  std::transform(smooth->GetBufferPointer(),
                 smooth->GetBufferPointer() + isBone.size(),
                 isBone.begin(),
                 [](float value) { return value > bone ? 1 : 0; });
  const auto               core = Morph(isBone, grid, false);
  const VoxelRuns          runs = CollectRuns(grid, [&](std::size_t i) { return core[i] != 0; });
  const RunLabels          components = LabelRuns(runs);
  std::vector<std::size_t> sizes(components.number + 1, 0);
  ForEachRun(runs, [&](std::size_t run, int, int) {
    sizes[components.ofRun[run]] += runs.runs[run].end - runs.runs[run].begin;
  });
  std::vector<int> kept;
  for (int component = 1; component <= components.number; ++component)
  {
    if (sizes[component] > leastVoxels)
    {
      kept.push_back(component);
    }
  }
  std::sort(kept.begin(), kept.end(), [&](int a, int b) { return sizes[a] > sizes[b]; });
  const auto labels = NewImageOn<Labels>(foot, true);
  for (std::size_t i = 0; i < kept.size(); ++i)
  {
    std::vector<char> part(isBone.size(), 0);
    ForEachRun(runs, [&](std::size_t run, int j, int k) {
      if (components.ofRun[run] == kept[i])
      {
        std::fill(part.begin() + grid.Index(runs.runs[run].begin, j, k),
                  part.begin() + grid.Index(runs.runs[run].end - 1, j, k) + 1,
                  1);
      }
    });
    const auto dilated = Morph(part, grid, true);
    for (std::size_t voxel = 0; voxel < dilated.size(); ++voxel)
    {
      if (dilated[voxel] != 0 && isBone[voxel] != 0)
      {
        labels->GetBufferPointer()[voxel] = static_cast<unsigned char>(i + 1);
      }
    }
  }
  return labels;
}

/** The voxel of each label that remains longest when the label is eroded: where one would click. */
std::map<int, std::size_t>
Clicks(const Labels * labels, const VoxelGrid & grid)
{
  std::map<int, std::size_t> clicks;
  const int last = *std::max_element(labels->GetBufferPointer(), labels->GetBufferPointer() + grid.NumberOfVoxels());
  for (int label = 1; label <= last; ++label)
  {
    std::vector<char> part(grid.NumberOfVoxels());
    std::transform(labels->GetBufferPointer(), labels->GetBufferPointer() + part.size(), part.begin(), [&](int l) {
      return l == label ? 1 : 0;
    });
    while (std::find(part.begin(), part.end(), 1) != part.end())
    {
      clicks[label] = std::find(part.begin(), part.end(), 1) - part.begin();
      part = Morph(part, grid, false);
    }
  }
  return clicks;
}

/** Dice of each label with the region of the partition tree that fits it best. */
std::map<int, double>
BestRegionsOfTree(const Image * values, const std::vector<int> & labels)
{
  const auto spacing = values->GetSpacing();
  const auto tree =
    BuildPartitionTree(values->GetBufferPointer(), GridOf(values), { { spacing[0], spacing[1], spacing[2] } });
  std::map<int, double> total;
  for (const int label : labels)
  {
    total[label] += 1.0;
  }
  total.erase(0);
  std::map<int, double> best;
  for (const auto & [label, voxels] : total)
  {
    std::vector<double> before{ 0.0 }; // voxels of the label among the first ones of the tree
    for (const auto voxel : tree.GetVoxels())
    {
      before.push_back(before.back() + (labels[voxel] == label ? 1.0 : 0.0));
    }
    for (const auto & region : tree.GetRegions())
    {
      const double dice = 2.0 * (before[region.end] - before[region.first]) / (region.NumberOfVoxels() + voxels);
      best[label] = std::max(best[label], dice);
    }
  }
  return best;
}

/** The same for heat, of which the tree is that of FindHeatObjects(). */
std::map<int, double>
BestRegionsOfHeat(const Image * heat, const std::vector<int> & labels)
{
  const float least = 1e-6F;
  const auto  logarithm = MapVoxels<float>(heat, [=](float value) { return std::log(std::max(value, least)); });
  return BestRegionsOfTree(logarithm, labels);
}

/** Dice of each label with the region of a partition that fits it best. */
std::map<int, double>
BestRegions(const itk::Image<unsigned int, 3> * regions, const std::vector<int> & labels, std::map<int, double> best)
{
  for (const auto & [label, fit] : BestFits(OverlapsOf(labels.data(), regions->GetBufferPointer(), labels.size())))
  {
    best[label] = std::max(best[label], fit.dice);
  }
  best.erase(0);
  return best;
}

std::map<int, double>
BestWatersheds(const Image * image, const std::vector<int> & labels)
{
  const auto gradient = itk::GradientMagnitudeRecursiveGaussianImageFilter<Image>::New();
  gradient->SetInput(image);
  gradient->SetSigma(0.8);
  std::map<int, double> best;
  for (const double level : { 2.0, 5.0, 10.0, 20.0 })
  {
    const auto watershed = itk::MorphologicalWatershedImageFilter<Image, itk::Image<unsigned int, 3>>::New();
    watershed->SetInput(gradient->GetOutput());
    watershed->SetLevel(level);
    watershed->MarkWatershedLineOff();
    watershed->Update();
    best = BestRegions(watershed->GetOutput(), labels, best);
  }
  return best;
}

/** Components above each of several thresholds of the smoothed image, chosen per label with knowledge of the labels. */
std::map<int, double>
BestConnectedThresholds(const Image * image, const std::vector<int> & labels)
{
  const auto            smooth = Smooth(image, 0.8);
  std::map<int, double> best;
  for (float threshold = 60.0F; threshold <= 160.0F; threshold += 5.0F)
  {
    const auto above = itk::BinaryThresholdImageFilter<Image, Labels>::New();
    above->SetInput(smooth);
    above->SetLowerThreshold(threshold);
    above->SetInsideValue(1);
    above->SetOutsideValue(0);
    const auto components = itk::ConnectedComponentImageFilter<Labels, itk::Image<unsigned int, 3>>::New();
    components->SetInput(above->GetOutput());
    components->Update();
    best = BestRegions(components->GetOutput(), labels, best);
  }
  return best;
}

double
Mean(const std::map<int, double> & dice)
{
  return std::accumulate(dice.begin(), dice.end(), 0.0, [](double sum, const auto & d) { return sum + d.second; }) /
         static_cast<double>(dice.size());
}

/** Dice of each bone with the object that its click selects. */
std::map<int, double>
DiceOfClicks(const HeatObjectList & list, const std::map<int, std::size_t> & clicks, const std::vector<int> & labels)
{
  std::map<int, double> dice;
  for (const auto & [bone, voxel] : clicks)
  {
    dice[bone] = 0.0;
    if (const int object = list.labels->GetBufferPointer()[voxel])
    {
      const auto mask = MaskOfObject(list, ObjectOfClick(list, object));
      double     both = 0.0, sum = 0.0;
      for (std::size_t i = 0; i < labels.size(); ++i)
      {
        both += mask->GetBufferPointer()[i] != 0 && labels[i] == bone ? 1.0 : 0.0;
        sum += (mask->GetBufferPointer()[i] != 0 ? 1.0 : 0.0) + (labels[i] == bone ? 1.0 : 0.0);
      }
      dice[bone] = 2.0 * both / sum;
    }
  }
  return dice;
}

void
ValidateFoot(const ValidationSettings & settings, ValidationReport & report)
{
  const Volume     volume = ReadVolume(settings.dataFolder + "/scivis/foot.nii.gz");
  const Image *    foot = volume.image;
  const auto       bones = ReferenceBones(foot);
  const VoxelGrid  grid = GridOf(foot);
  const Found      found = FindObjects(foot, HeatObjectOptions{}.leastProbability);
  std::vector<int> labels(bones->GetBufferPointer(), bones->GetBufferPointer() + grid.NumberOfVoxels());
  const auto       clicks = Clicks(bones, grid);
  const auto       byClick = DiceOfClicks(found.list, clicks, labels);
  const std::vector<std::pair<std::string, std::map<int, double>>> columns = {
    { "one click", byClick },
    { "best region of the heat", BestRegionsOfHeat(found.heat, labels) },
    { "best region of the intensity", BestRegionsOfTree(Smooth(foot, 0.8), labels) },
    { "best watershed region", BestWatersheds(foot, labels) },
    { "best component above a threshold", BestConnectedThresholds(foot, labels) }
  };
  report.AddText("Foot (scivis), bones by threshold and opening; the automatic window is " +
                 CsvTable::Number(found.choice.intensityWindow[0]) + " to " +
                 CsvTable::Number(found.choice.intensityWindow[1]) + " and " + std::to_string(found.choice.timeSteps) +
                 " steps; listed are " + std::to_string(found.list.objects.size()) +
                 " objects. Dice; one click at the deepest voxel of a bone selects an object without "
                 "knowledge of the bones. The others use the best node or region for each bone, chosen with that "
                 "knowledge; the last is a ceiling, because thresholds define the bones.");
  std::vector<std::string> names{ "bone" };
  for (const auto & column : columns)
  {
    names.push_back(column.first);
  }
  CsvTable table(names);
  for (const auto & bone : byClick)
  {
    std::vector<std::string> row{ std::to_string(bone.first) };
    for (const auto & column : columns)
    {
      row.push_back(Rounded(column.second.at(bone.first)));
    }
    table.AddRow(row);
  }
  std::vector<std::string> row{ "mean" };
  for (const auto & column : columns)
  {
    row.push_back(Rounded(Mean(column.second)));
  }
  table.AddRow(row);
  report.AddTable(table);
  const auto right =
    std::count_if(byClick.begin(), byClick.end(), [](const auto & d) { return d.second >= wholeObject; });
  report.AddText(std::to_string(right) + " of " + std::to_string(byClick.size()) +
                 " bones by one click (bound 10 of 12): " + report.Check(right >= 10));
}

/** Best region per organ. */
void
ValidateOrgans(const ValidationSettings & settings, ValidationReport & report)
{
  const auto [ct, organs] = ReadAbdomen(settings.dataFolder);
  const float * const    first = organs.image->GetBufferPointer();
  const std::vector<int> labels(first, first + GridOf(ct.image).NumberOfVoxels());
  const Found            found = FindObjects(ct.image, HeatObjectOptions{}.leastProbability, "CT");
  const auto             best = BestRegionsOfHeat(found.heat, labels);
  CsvTable               table({ "organ label", "Dice of the best region" });
  for (const auto & [organ, dice] : best)
  {
    table.AddRow({ std::to_string(organ), Rounded(dice) });
  }
  report.AddText("Abdomen CT of TotalSegmentator's tests: the best region of the automatic heat per organ, chosen with "
                 "knowledge of the organs. Mean Dice " +
                 Rounded(Mean(best)) + '.');
  report.AddRows("organs", table);
}
} // namespace

void
ValidateObjectsOfVolumes(const ValidationSettings & settings, ValidationReport & report)
{
  report.AddText("`CumulativeHeatDiffusion`, then `HeatObjects`. Found: an object with a Dice of at "
                 "least 0.85. Phantoms of `ShapePhantom`:");
  ValidatePhantoms(settings, report);
  ValidateScenes(settings, report);
  if (!settings.dataFolder.empty() && !settings.quick)
  {
    ValidateFoot(settings, report);
    ValidateOrgans(settings, report);
  }
}
