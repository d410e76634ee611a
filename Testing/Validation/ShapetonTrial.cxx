#include "ShapetonTrial.h"

#include "Overlaps.h"
#include "SampledScenes.h"

#include "shapetonHeatClassification.h"
#include "shapetonVisitDensity.h"

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace shapeton;

const WalkRule publishedWalk{ "shapetons, published",
                              DirectionSampling::SectorArea,
                              PathRule::Endpoint,
                              ParticlePlacement::Uniform };
const WalkRule controlledWalk{ "shapetons, controlled",
                               DirectionSampling::Uniform,
                               PathRule::Traversal,
                               ParticlePlacement::InitialHeat };

namespace
{
/** Sums over the voxels of a label. */
struct Sums
{
  double voxels{ 0.0 };
  double values{ 0.0 };
  double squares{ 0.0 };
};

std::map<int, Sums>
SumsOfObjects(const TrialVolume & volume, const itk::Image<float, 3> * field)
{
  std::map<int, Sums> objects;
  for (std::size_t i = 0; i < volume.GetNumberOfVoxels(); ++i)
  {
    if (const int label = volume.labels->GetBufferPointer()[i])
    {
      const double value = field->GetBufferPointer()[i];
      Sums &       sums = objects[label];
      sums.voxels += 1.0;
      sums.values += value;
      sums.squares += value * value;
    }
  }
  return objects;
}

std::vector<double>
Ranks(const std::vector<double> & values)
{
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return values[i] < values[j]; });
  std::vector<double> ranks(values.size());
  for (std::size_t first = 0; first < order.size();)
  {
    std::size_t last = first;
    while (last < order.size() && values[order[last]] == values[order[first]])
    {
      ++last;
    }
    for (std::size_t i = first; i < last; ++i)
    {
      ranks[order[i]] = 0.5 * static_cast<double>(first + last - 1);
    }
    first = last;
  }
  return ranks;
}
} // namespace

TrialVolume
MakeTrialScene(const std::string & name, const ShapeScene & scene, const itk::Size<3> & size)
{
  const auto  source = SampledScene(scene, size);
  TrialVolume volume{ name, ToFloat(source->GetOutput()), source->GetLabelOutput(), 0.0, 1.0 };
  const auto  end = volume.image->GetBufferPointer() + volume.GetNumberOfVoxels();
  volume.lower = *std::min_element(volume.image->GetBufferPointer(), end);
  volume.upper = *std::max_element(volume.image->GetBufferPointer(), end);
  return volume;
}

TrialVolume
MakeTrialPhantom(const std::string & preset, const itk::Size<3> & size)
{
  return MakeTrialScene(preset, ShapeScene::Load(preset), size);
}

Trial
RunHeat(const TrialVolume & volume, double p, std::uint64_t steps)
{
  auto filter = CumulativeHeatDiffusionImageFilter<itk::Image<float, 3>>::New();
  filter->SetInput(volume.image);
  filter->SetP(p);
  filter->SetIntensityWindow(volume.lower, volume.upper);
  filter->SetTimeSteps(steps);
  const Stopwatch watch;
  filter->Update();
  Trial trial;
  trial.method = "CHD";
  trial.settings = std::to_string(steps) + " steps";
  trial.field = filter->GetOutput();
  trial.seconds = watch.ProcessorSeconds();
  trial.steps = steps;
  return trial;
}

Trial
RunShapetons(const TrialVolume & volume, double p, const WalkRule & rule, const WalkSettings & settings)
{
  auto filter = ParticleDiffusionImageFilter<itk::Image<float, 3>>::New();
  filter->SetInput(volume.image);
  filter->SetP(p);
  filter->SetIntensityWindow(volume.lower, volume.upper);
  filter->SetShapetons(settings.shapetons);
  filter->SetDistance(settings.distance);
  filter->SetTimeSteps(settings.steps);
  filter->SetDirectionSampling(rule.sampling);
  filter->SetPathRule(rule.path);
  filter->SetPlacement(rule.placement);
  if (settings.startInObjects)
  {
    filter->SetMaskImage(volume.labels);
  }
  const Stopwatch watch;
  filter->Update();
  Trial trial;
  trial.method = rule.name + (settings.startInObjects ? ", from the objects" : "");
  trial.settings = std::to_string(settings.shapetons) + " x " + std::to_string(settings.steps);
  trial.seconds = watch.ProcessorSeconds();
  trial.visits = filter->GetOutput();
  trial.field = NormalizeVisits(trial.visits);
  trial.steps = settings.steps;
  trial.measures = filter->GetMeasures();
  return trial;
}

double
StepInVoxels(const TrialVolume & volume, double distance)
{
  const auto size = volume.image->GetLargestPossibleRegion().GetSize();
  const auto spacing = volume.image->GetSpacing();
  double     longest = 0.0;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    longest = std::max(longest, static_cast<double>(size[axis]) * spacing[axis]);
  }
  return distance * longest / std::min({ spacing[0], spacing[1], spacing[2] });
}

std::uint64_t
MatchedHeatSteps(const TrialVolume & volume, const WalkSettings & settings)
{
  const double steps = EquivalentHeatTimeSteps(static_cast<double>(settings.steps),
                                               StepInVoxels(volume, settings.distance),
                                               HeatDiffusionSolver::MaximumTimeStepLength);
  return std::max<std::uint64_t>(1, std::llround(steps));
}

std::map<int, double>
MeansOfObjects(const TrialVolume & volume, const itk::Image<float, 3> * field)
{
  std::map<int, double> means;
  for (const auto & [label, sums] : SumsOfObjects(volume, field))
  {
    means[label] = sums.values / sums.voxels;
  }
  return means;
}

double
VarianceBetweenObjects(const TrialVolume & volume, const itk::Image<float, 3> * field)
{
  Sums   all;
  double within = 0.0;
  for (const auto & [label, sums] : SumsOfObjects(volume, field))
  {
    within += sums.squares - sums.values * sums.values / sums.voxels;
    all.voxels += sums.voxels;
    all.values += sums.values;
    all.squares += sums.squares;
  }
  const double total = all.squares - all.values * all.values / all.voxels;
  return total > 0.0 ? 1.0 - within / total : 0.0;
}

ClassAgreement
CompareClasses(const TrialVolume & volume, const Trial & trial)
{
  const HeatClassification classification =
    trial.visits ? ClassifyVisits(trial.visits, trial.field) : ClassifyHeat(trial.field);
  Overlaps overlaps = OverlapsOf(
    volume.labels->GetBufferPointer(), classification.labels->GetBufferPointer(), volume.GetNumberOfVoxels());
  overlaps.erase(0);
  return { classification.classes.size() - 1, AdjustedRandIndex(overlaps) };
}

double
RankCorrelation(const std::vector<double> & a, const std::vector<double> & b)
{
  const std::vector<double> ranksA = Ranks(a), ranksB = Ranks(b);
  const double              mean = 0.5 * (static_cast<double>(a.size()) - 1.0);
  double                    aa = 0.0, bb = 0.0, ab = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    aa += (ranksA[i] - mean) * (ranksA[i] - mean);
    bb += (ranksB[i] - mean) * (ranksB[i] - mean);
    ab += (ranksA[i] - mean) * (ranksB[i] - mean);
  }
  return aa > 0.0 && bb > 0.0 ? ab / std::sqrt(aa * bb) : 0.0;
}

namespace
{
/** Means of both fields over a block; false if it contains a voxel outside of the objects. */
bool
BlockMeans(const TrialVolume &                  volume,
           const std::array<const float *, 2> & fields,
           const std::array<std::size_t, 3> &   first,
           std::size_t                          block,
           std::array<std::vector<double>, 2> & means)
{
  const auto            size = volume.image->GetLargestPossibleRegion().GetSize();
  std::array<double, 2> sums{};
  for (std::size_t z = first[2]; z < first[2] + block; ++z)
  {
    for (std::size_t y = first[1]; y < first[1] + block; ++y)
    {
      const std::size_t row = (z * size[1] + y) * size[0] + first[0];
      for (std::size_t voxel = row; voxel < row + block; ++voxel)
      {
        if (!volume.IsObject(voxel))
        {
          return false;
        }
        sums[0] += fields[0][voxel];
        sums[1] += fields[1][voxel];
      }
    }
  }
  means[0].push_back(sums[0]);
  means[1].push_back(sums[1]);
  return true;
}
} // namespace

double
RankCorrelationOfFields(const TrialVolume &          volume,
                        const itk::Image<float, 3> * a,
                        const itk::Image<float, 3> * b,
                        std::size_t                  block)
{
  const auto                         size = volume.image->GetLargestPossibleRegion().GetSize();
  std::array<std::vector<double>, 2> means;
  for (std::size_t z = 0; z + block <= size[2]; z += block)
  {
    for (std::size_t y = 0; y + block <= size[1]; y += block)
    {
      for (std::size_t x = 0; x + block <= size[0]; x += block)
      {
        BlockMeans(volume, { a->GetBufferPointer(), b->GetBufferPointer() }, { x, y, z }, block, means);
      }
    }
  }
  return RankCorrelation(means[0], means[1]);
}

double
MeanVisitsOfObjects(const TrialVolume & volume, const Trial & trial)
{
  double voxels = 0.0, visits = 0.0;
  for (std::size_t i = 0; i < volume.GetNumberOfVoxels(); ++i)
  {
    if (volume.IsObject(i))
    {
      voxels += 1.0;
      visits += trial.visits->GetBufferPointer()[i];
    }
  }
  return voxels > 0.0 ? visits / voxels : 0.0;
}
