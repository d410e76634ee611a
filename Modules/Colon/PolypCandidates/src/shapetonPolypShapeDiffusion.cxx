#include "shapetonPolypShapeDiffusion.h"

#include "shapetonCandidateList.h"
#include "shapetonTissueBox.h"

#include "shapetonCumulativeHeatDiffusion.h"
#include "shapetonOpenEndedProgress.h"
#include "shapetonParticleDiffusion.h"
#include "shapetonSurfaceDiffusion.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace shapeton
{
namespace
{
constexpr double publishedSteepness = 15.0; // p of dissertation 3.5.2

std::vector<float>
HeatIn(const TissueBox & box)
{
  constexpr double                time = 10.0; // mm^2; chosen: a standard deviation of 4.5 mm
  CumulativeHeatDiffusionSettings settings;
  settings.p = publishedSteepness;
  settings.intensityWindow = { { 0.0, 1.0 } };
  const VolumeView volume(box.Intensities().data(), box.Size(), box.Spacing());
  const double     spacing = *std::min_element(volume.spacing.begin(), volume.spacing.end());
  settings.timeSteps =
    static_cast<std::uint64_t>(std::max(1.0, std::round(time / (settings.timeStepLength * spacing * spacing))));
  std::vector<float> heat(box.NumberOfVoxels());
  DiffuseCumulativeHeat(volume, settings, heat.data());
  return heat;
}

std::vector<float>
VisitsIn(const TissueBox &        box,
         ParticleDiffusionOptions options,
         double                   depth,
         std::uint64_t            steps,
         const Progress &         progress)
{
  options.intensityWindow = { { 0.0, 1.0 } };
  const std::vector<unsigned char> mask = box.TissueNearLumen(depth);
  std::vector<std::uint32_t>       visits(box.NumberOfVoxels());
  OpenEndedProgress                polls(progress, 100.0);
  const VolumeView                 volume(box.Intensities().data(), box.Size(), box.Spacing());
  ParticleDiffusion                diffusion(volume, options, mask.data(), visits.data(), [&polls] { polls.Step(); });
  diffusion.Run(steps, {}, [&polls](const ParticleMeasures &) { polls.Step(); });
  return std::vector<float>(visits.begin(), visits.end());
}

double
MeanOfTissue(const TissueBox & box, const std::vector<float> & values)
{
  double sum = 0.0, number = 0.0;
  for (std::size_t voxel = 0; voxel < values.size(); ++voxel)
  {
    sum += box.Intensities()[voxel] * values[voxel];
    number += box.Intensities()[voxel];
  }
  return number > 0.0 ? sum / number : 0.0;
}

/** For each vertex, the area fraction of the wall with a smaller value. */
Eigen::VectorXd
RanksByArea(const Eigen::VectorXd & values, const Eigen::VectorXd & areas)
{
  std::vector<int> order(values.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return values[a] < values[b]; });
  Eigen::VectorXd ranks(values.size());
  double          below = 0.0;
  for (const int vertex : order)
  {
    ranks[vertex] = below / areas.sum();
    below += areas[vertex];
  }
  return ranks;
}

/** Number of visits 1.5 mm below each vertex, smoothed over the wall. */
Eigen::VectorXd
DensityOnWall(const SurfaceMesh &         wall,
              const SurfaceConnectivity & connectivity,
              const SurfaceShape &        shape,
              const TissueBox &           box,
              const std::vector<float> &  visits)
{
  constexpr double depth = 1.5;         // mm
  constexpr double smoothingTime = 2.0; // mm^2; chosen: a standard deviation of 2 mm
  Eigen::MatrixXd  density = Eigen::MatrixXd::Zero(wall.V.rows(), 1);
  for (Eigen::Index i = 0; i < wall.V.rows(); ++i)
  {
    const Eigen::Vector3d below = (wall.V.row(i) - depth * shape.inwardNormals.row(i)).transpose();
    const std::ptrdiff_t  voxel = box.VoxelAt(below);
    density(i, 0) = voxel >= 0 ? visits[voxel] : 0.0;
  }
  DiffuseOverSurface(MakeSurfaceLaplacian(connectivity, EdgeLengths(connectivity, wall.V)), smoothingTime, density);
  return density;
}
} // namespace

void
MeasureShapeDiffusion(const SurfaceMesh &           wall,
                      const PolypLumenImage *       lumen,
                      std::vector<PolypCandidate> & candidates,
                      const Progress &              progress)
{
  constexpr double        margin = 12.0;    // mm; chosen
  constexpr double        step = 1.8;       // mm
  constexpr std::uint64_t steps = 200;      // chosen: a walk of 25 mm (root mean square) crosses the box
  constexpr int           shapetons = 4000; // chosen: bounds the time per candidate
  for (PolypCandidate & candidate : candidates)
  {
    progress((&candidate - candidates.data()) / static_cast<double>(candidates.size()));
    const std::vector<Eigen::Vector3d> points = PointsBelowSurface(wall, candidate);
    const TissueBox                    box(lumen, points, margin);
    candidate.features.heat = box.MeanAt(HeatIn(box), points);
    ParticleDiffusionOptions settings;
    settings.p = publishedSteepness;
    settings.shapetons = shapetons;
    settings.distance = std::min(1.0, step / box.LongestSide());
    const std::vector<float> visits = VisitsIn(box, settings, margin, steps, {});
    candidate.features.shapetonDensity = box.MeanAt(visits, points) / std::max(1e-12, MeanOfTissue(box, visits));
  }
}

std::vector<PolypCandidate>
FindPublishedPolypCandidates(const SurfaceMesh &           wall,
                             const PolypLumenImage *       lumen,
                             const itk::Image<float, 3> *  ct,
                             const PublishedPolypOptions & options)
{
  constexpr double depth = 8.0;                    // mm of tissue in which shapetons start
  constexpr double least = 0.96;                   // rank
  constexpr double narrowest = 3.0, widest = 40.0; // mm; chosen, not in the dissertation
  CheckOptions(options);
  const SurfaceConnectivity connectivity(wall);
  const SurfaceShape        shape =
    MeasureSurfaceShape(wall.V, connectivity, wall.F, 1.0, options.progress.Part("", 0.0, 0.3));
  std::vector<Eigen::Vector3d> corners = { wall.V.colwise().minCoeff().transpose(),
                                           wall.V.colwise().maxCoeff().transpose() };
  TissueBox                    box(lumen, corners, depth);
  if (ct != nullptr)
  {
    box.TakeIntensities(ct);
  }
  ParticleDiffusionOptions settings;
  settings.p = options.p;
  settings.shapetons = options.shapetons;
  settings.distance = options.distance;
  const std::vector<float> visits = VisitsIn(box, settings, depth, options.steps, options.progress.Part("", 0.3, 0.9));
  const double             sign = options.visited == VisitedWall::Least ? -1.0 : 1.0;
  const Eigen::VectorXd ranks = RanksByArea(sign * DensityOnWall(wall, connectivity, shape, box, visits), shape.areas);
  const std::vector<char> isLeftOut = FindNoWall(wall, connectivity);
  Eigen::VectorXd         level = ranks.array() - least;
  for (Eigen::Index i = 0; i < wall.V.rows(); ++i)
  {
    level[i] = isLeftOut[i] ? -1.0 : level[i];
  }
  std::vector<PolypCandidate> candidates;
  const WallPartLimits        limits{ -std::numeric_limits<double>::infinity(), narrowest };
  for (WallBulge & part : MeasureWallParts(wall, connectivity, shape, level, limits))
  {
    const PolypFeatures features = FeaturesOf(part);
    double              rank = 0.0, area = 0.0;
    for (const int vertex : part.vertices)
    {
      rank += shape.areas[vertex] * ranks[vertex];
      area += shape.areas[vertex];
    }
    const double score = (rank / area - least) / (1.0 - least) * features.roundness;
    if (part.greatestWidth <= widest && score >= 1.0 - options.sensitivity)
    {
      candidates.push_back(CandidateOf(std::move(part), features, score, wall));
    }
  }
  SortAndNumber(candidates);
  return candidates;
}
} // namespace shapeton
