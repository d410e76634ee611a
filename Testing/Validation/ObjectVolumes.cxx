#include "ObjectVolumes.h"

#include "RandomScenes.h"
#include "SampledScenes.h"
#include "ValidationVolumes.h"
#include "VoxelMorphology.h"

#include "shapetonMappedImage.h"
#include "shapetonSmoothVoxels.h"
#include "shapetonVoxelRuns.h"

#include "itkBinShrinkImageFilter.h"

#include <algorithm>
#include <limits>

using namespace shapeton;

namespace
{
using Image = itk::Image<float, 3>;
using Labels = itk::Image<unsigned char, 3>;

/** Parts of a scan: components of the voxels with a smoothed intensity in (above, most], after opening by the face
 * neighbors. */
struct PartRule
{
  double      above;
  double      most;
  std::size_t leastVoxels;
  std::size_t mostParts;         ///< the largest ones
  bool        isInside{ false }; ///< it does not touch the borders of the first two axes
};

struct Scan
{
  std::string           name;
  std::string           file;
  bool                  isHeldBack;
  double                smoothing; ///< standard deviation for the reference, voxels
  unsigned int          shrink;    ///< factor of the first two axes
  std::vector<PartRule> rules;
};

constexpr double      infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t many = 60;
const PartRule        boneOfCt{ 220.0, infinity, 1500, many };
const PartRule        gasOfCt{ -infinity, -400.0, 2000, 12, true };

const std::vector<Scan> scans = {
  { "foot", "/scivis/foot.nii.gz", false, 0.8, 1, { { 95.0, infinity, 1500, many } } },
  { "lobster", "/scivis/second/lobster.nii.gz", false, 0.8, 1, { { 60.0, infinity, 3000, many } } },
  { "chest", "/ct/no-colon/chest.nii.gz", false, 0.6, 1, { boneOfCt, gasOfCt } },
  { "ankles", "/ct/visible-female-ankle", false, 0.6, 2, { { 180.0, infinity, 1500, many } } },
  { "tooth",
    "/scivis/second/tooth.nii.gz",
    true,
    0.8,
    1,
    { { 193.0, infinity, 2000, 1 }, { 118.0, 193.0, 2000, 1 }, { -infinity, 115.0, 300, 1, true } } },
  { "engine", "/volumes/engine.nii.gz", true, 0.8, 1, { { 185.0, infinity, 800, many }, { 70.0, 175.0, 5000, 1 } } },
  { "upper abdomen", "/ct/no-colon/upper-abdomen.nii.gz", true, 0.6, 1, { boneOfCt, gasOfCt } },
};

struct Component
{
  int         number;
  std::size_t voxels;
  bool        isInside;
};

/** The components that a rule selects, by descending size. */
std::vector<Component>
Select(const VoxelRuns & runs, const RunLabels & labels, const PartRule & rule)
{
  std::vector<Component> components(labels.number + 1, { 0, 0, true });
  ForEachRun(runs, [&](std::size_t run, int j, int) {
    Component & component = components[labels.ofRun[run]];
    const auto  columns = runs.runs[run];
    component.number = labels.ofRun[run];
    component.voxels += columns.end - columns.begin;
    component.isInside &= j > 0 && j + 1 < runs.size[1] && columns.begin > 0 && columns.end < runs.size[0];
  });
  const auto isLeft = [&](const Component & c) {
    return c.voxels < rule.leastVoxels || (rule.isInside && !c.isInside);
  };
  components.erase(std::remove_if(components.begin(), components.end(), isLeft), components.end());
  std::stable_sort(
    components.begin(), components.end(), [](const Component & a, const Component & b) { return a.voxels > b.voxels; });
  components.resize(std::min(components.size(), rule.mostParts));
  return components;
}

/** Adds the parts of a rule to the labels, where these are 0. */
void
AddParts(const std::vector<float> & smooth, const PartRule & rule, const VoxelGrid & grid, VoxelMask & labels)
{
  VoxelMask mask(smooth.size());
  std::transform(smooth.begin(), smooth.end(), mask.begin(), [&](float value) {
    return value > rule.above && value <= rule.most ? 1 : 0;
  });
  const VoxelMask  core = Eroded(mask, grid);
  const VoxelRuns  runs = CollectRuns(grid, [&](std::size_t voxel) { return core[voxel] != 0; });
  const RunLabels  components = LabelRuns(runs);
  int              label = *std::max_element(labels.begin(), labels.end());
  std::vector<int> labelOf(components.number + 1, 0);
  for (const Component & component : Select(runs, components, rule))
  {
    labelOf[component.number] = ++label;
  }
  VoxelMask parts(mask.size(), 0);
  ForEachRun(runs, [&](std::size_t run, int j, int k) {
    const auto row = parts.begin() + static_cast<std::ptrdiff_t>(grid.Index(0, j, k));
    std::fill(row + runs.runs[run].begin, row + runs.runs[run].end, labelOf[components.ofRun[run]]);
  });
  ParallelForBlocks(mask.size(), [&](std::size_t voxel) {
    if (mask[voxel] != 0 && labels[voxel] == 0)
    {
      labels[voxel] = parts[voxel];
      if (core[voxel] == 0)
      {
        ForEachNeighbor(
          grid, voxel, [&](std::size_t neighbor) { labels[voxel] = std::max(labels[voxel], parts[neighbor]); });
      }
    }
  });
}

Image::Pointer
Shrunk(const Image * image, unsigned int factor)
{
  const auto filter = itk::BinShrinkImageFilter<Image, Image>::New();
  filter->SetInput(image);
  filter->SetShrinkFactors(
    itk::FixedArray<unsigned int, 3>(std::array<unsigned int, 3>{ { factor, factor, 1 } }.data()));
  filter->Update();
  return filter->GetOutput();
}

ObjectVolume
ReadScan(const Scan & scan, const std::string & dataFolder)
{
  const auto         image = Shrunk(ReadVolume(dataFolder + scan.file).image, scan.shrink);
  const VoxelGrid    grid = GridOf(image);
  std::vector<float> smooth(image->GetBufferPointer(), image->GetBufferPointer() + grid.NumberOfVoxels());
  SmoothVoxels(grid, { { scan.smoothing, scan.smoothing, scan.smoothing } }, smooth.data());
  VoxelMask labels(smooth.size(), 0);
  for (const PartRule & rule : scan.rules)
  {
    AddParts(smooth, rule, grid, labels);
  }
  ObjectVolume volume{ image, NewImageOn<Labels>(image) };
  std::copy(labels.begin(), labels.end(), volume.labels->GetBufferPointer());
  return volume;
}

ObjectVolume
ReadOrgans(const std::string & dataFolder)
{
  const auto [ct, organs] = ReadAbdomen(dataFolder);
  return { ct.image, MapVoxels<unsigned char>(organs.image.GetPointer(), [](float label) { return label; }) };
}

ObjectVolume
SamplePhantom(const std::string & preset, double noise)
{
  constexpr std::uint64_t side = 96;
  ShapePhantomOptions     options;
  options.noise = noise;
  options.blur = noise > 0.0 ? 0.6 : 0.0;
  options.seed = 11;
  const auto source = SampledScene(ShapeScene::Load(preset), itk::Size<3>::Filled(side), options);
  return { ToFloat(source->GetOutput()), source->GetLabelOutput() };
}
} // namespace

std::vector<ObjectVolumeSource>
ObjectVolumes(unsigned int scenes, const std::string & dataFolder)
{
  constexpr unsigned int          firstHeldBack = 201;
  std::vector<ObjectVolumeSource> sources;
  for (const unsigned int first : { 1U, firstHeldBack })
  {
    for (unsigned int seed = first; seed < first + scenes; ++seed)
    {
      sources.push_back({ "scene " + std::to_string(seed), "scene", first == firstHeldBack, [seed] {
                           const SceneVolume volume = RandomScene(seed);
                           return ObjectVolume{ volume.image, volume.labels };
                         } });
    }
  }
  bool isHeldBack = false;
  for (const std::string & preset : ShapeScene::GetPresetNames())
  {
    for (const double noise : { 0.0, 60.0 }) // HU
    {
      sources.push_back({ preset + (noise > 0.0 ? " with noise" : ""), "phantom", isHeldBack, [=] {
                           return SamplePhantom(preset, noise);
                         } });
    }
    isHeldBack = !isHeldBack;
  }
  if (!dataFolder.empty())
  {
    sources.push_back({ "abdomen", "scan", false, [=] { return ReadOrgans(dataFolder); } });
    for (const Scan & scan : scans)
    {
      sources.push_back(
        { scan.name, "scan", scan.isHeldBack, [&scan, dataFolder] { return ReadScan(scan, dataFolder); } });
    }
  }
  return sources;
}
