#include "ColonTrial.h"
#include "PolypTrial.h"
#include "SampledScenes.h"
#include "Tables.h"
#include "Times.h"

#include "itkLinearInterpolateImageFunction.h"
#include "shapetonSurfaceLocator.h"
#include "shapetonSurfaceQuality.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <cmath>

using namespace shapeton;

namespace
{
using Source = ColonPhantomImageSource;
using Interpolator = itk::LinearInterpolateImageFunction<itk::Image<float, 3>>;

Eigen::Vector3d
VoxelCenter(const itk::ImageBase<3> * image, std::size_t offset)
{
  const auto point =
    image->TransformIndexToPhysicalPoint<double>(image->ComputeIndex(static_cast<itk::OffsetValueType>(offset)));
  return { point[0], point[1], point[2] };
}

void
MeasureLumen(const ColonModel & model, Source * truth, ColonErrors & errors)
{
  const auto * const labels = model.lumen.labels.GetPointer();
  const auto * const lumen = truth->GetLumenOutput();
  const auto         voxels = labels->GetLargestPossibleRegion().GetNumberOfPixels();
  const auto &       spacing = labels->GetSpacing();
  const double       voxelMl = 1e-3 * spacing[0] * spacing[1] * spacing[2];
  std::size_t        both = 0;
  std::size_t        found = 0;
  std::size_t        real = 0;
  for (std::size_t i = 0; i < voxels; ++i)
  {
    const bool isFound = labels->GetBufferPointer()[i] != 0;
    const bool isReal = lumen->GetBufferPointer()[i] != 0;
    both += isFound && isReal;
    found += isFound;
    real += isReal;
    if (isFound && !isReal && truth->GetAnatomy().Evaluate(VoxelCenter(labels, i)).distance < -2.0)
    {
      errors.leakMl += voxelMl;
    }
  }
  errors.dice = 2.0 * static_cast<double>(both) / static_cast<double>(found + real);
  errors.lumen = MeasureSurfaceDistances(labels, lumen);
}

/** Every n-th vertex; about `count` vertices in total. */
std::vector<int>
SomeVertices(const SurfaceMesh & mesh, int count)
{
  std::vector<int> vertices;
  const int        step = std::max(1, mesh.NumberOfVertices() / count);
  for (int v = 0; v < mesh.NumberOfVertices(); v += step)
  {
    vertices.push_back(v);
  }
  return vertices;
}

/** 1 for the vertices of synthetic faces. */
std::vector<char>
BridgedVertices(const SurfaceMesh & mesh)
{
  std::vector<char>          isBridged(static_cast<std::size_t>(mesh.NumberOfVertices()), 0);
  const SurfaceArray * const bridged = FindSurfaceArray(mesh.cellArrays, "bridged");
  for (int f = 0; bridged && f < mesh.NumberOfFaces(); ++f)
  {
    for (int k = 0; k < 3 && bridged->values(f, 0) != 0.0; ++k)
    {
      isBridged[static_cast<std::size_t>(mesh.F(f, k))] = 1;
    }
  }
  return isBridged;
}

void
MeasureSurface(const ColonModel & model, Source * truth, ColonErrors & errors)
{
  constexpr int        samples = 60000;
  const SurfaceMesh    wall = truth->GetAnatomy().Wall(0.7);
  const SurfaceLocator trueWall(wall.V, wall.F);
  const SurfaceMesh &  raw = model.wall.raw;
  const auto           isBridged = BridgedVertices(raw);
  std::vector<double>  distances;
  std::vector<double>  atLevels;
  for (const int v : SomeVertices(raw, samples))
  {
    if (isBridged[static_cast<std::size_t>(v)])
    {
      continue;
    }
    const Eigen::Vector3d p = raw.V.row(v);
    const double          distance = trueWall.FindClosest(p).distance;
    distances.push_back(distance);
    const auto sample = truth->GetAnatomy().Evaluate(p);
    if (sample.segment > 0 && std::abs(truth->GetFluid().DepthBelowLevel(p, sample.arcLength)) < 3.0)
    {
      atLevels.push_back(distance);
    }
  }
  errors.surfaceMedian = LowerQuantile(distances, 0.5);
  errors.surface95 = LowerQuantile(distances, 0.95);
  errors.level95 = LowerQuantile(atLevels, 0.95);
  const SurfaceLocator ours(raw.V, raw.F);
  std::vector<double>  missed;
  for (const int v : SomeVertices(wall, samples))
  {
    missed.push_back(ours.FindClosest(wall.V.row(v)).distance);
  }
  errors.missed95 = LowerQuantile(missed, 0.95);
}

/** Checks whether true tissue keeps 90 % of its volume in the cleansed CT. */
class TissueKeeper
{
public:
  TissueKeeper(const ColonModel & model, const ColonAnatomy & anatomy)
    : m_Anatomy(anatomy), m_Thresholds(model.lumen.thresholds), m_Interpolator(Interpolator::New())
  {
    m_Interpolator->SetInputImage(model.cleansed);
  }

  /** Compares volumes within `radius` of the centers, from `depth` mm below the true surface to 1.5 mm above it, the
   * reach of the blur. The found volume is the sum of the tissue fractions, which blur and interpolation preserve. */
  bool
  IsKept(const std::vector<Eigen::Vector3d> & centers, double radius, double depth) const
  {
    constexpr double step = 0.5;
    constexpr double margin = 1.5;
    double           tissue = 0.0;
    double           kept = 0.0;
    const int        reach = static_cast<int>(std::ceil(radius / step));
    const int        side = 2 * reach + 1;
    for (const Eigen::Vector3d & center : centers)
    {
      for (int i = 0; i < side * side * side; ++i)
      {
        const Eigen::Vector3d offset(i % side - reach, i / side % side - reach, i / (side * side) - reach);
        if (step * offset.norm() > radius)
        {
          continue;
        }
        const Eigen::Vector3d p = center + step * offset;
        const double          distance = m_Anatomy.Evaluate(p).distance;
        if (distance >= -depth && distance <= margin)
        {
          tissue += distance < 0.0;
          kept += this->TissueAt(p);
        }
      }
    }
    return kept >= 0.9 * tissue;
  }

private:
  /** Tissue fraction of a value, 0 to 1. */
  double
  TissueAt(const Eigen::Vector3d & p) const
  {
    const itk::Point<double, 3> point(p.data());
    const double                value = m_Interpolator->IsInsideBuffer(point) ? m_Interpolator->Evaluate(point) : 0.0;
    return std::clamp((value - m_Thresholds.gas) / (m_Thresholds.tissue - m_Thresholds.gas), 0.0, 1.0);
  }

  const ColonAnatomy &  m_Anatomy;
  ColonThresholds       m_Thresholds;
  Interpolator::Pointer m_Interpolator;
};

/** The true centerline. */
class TrueLine
{
public:
  explicit TrueLine(const ColonAnatomy & anatomy)
    : m_Anatomy(anatomy)
    , m_Line(anatomy.Centerline())
    , m_ArcLength(PointValues(m_Line, "arcLength", "the true centerline"))
  {}

  /** Arc length of a point in or near the lumen, and its distance from the line, with points about 2 mm apart. The
   * arc length is looked up in the lumen, because the closest point of the line may be in an adjacent loop or collapsed
   * section. */
  double
  Place(const Eigen::Vector3d & p, double & distance) const
  {
    Eigen::Index index = 0;
    distance = std::sqrt((m_Line.V.rowwise() - p.transpose()).rowwise().squaredNorm().minCoeff(&index));
    const auto sample = m_Anatomy.Evaluate(p);
    return sample.segment > 0 ? sample.arcLength : m_ArcLength[index];
  }

private:
  const ColonAnatomy & m_Anatomy;
  CurveSet             m_Line;
  Eigen::VectorXd      m_ArcLength;
};

void
MeasurePolyps(const ColonAnatomy & anatomy, const TissueKeeper & keeper, ColonErrors & errors)
{
  for (const ColonPolyp & polyp : VisiblePolyps(anatomy))
  {
    if (polyp.diameter >= 6.0)
    {
      // Voxels deeper than 1.5 mm are in the interior of the structure, or in fat beyond the wall.
      ++errors.polyps;
      errors.keptPolyps += keeper.IsKept({ polyp.position }, 0.5 * polyp.diameter + 1.5, 1.5);
    }
  }
}

void
MeasureFolds(Source * truth, const TissueKeeper & keeper, ColonErrors & errors)
{
  const CurveSet             folds = truth->GetAnatomy().Folds();
  const SurfaceArray * const thickness = FindSurfaceArray(folds.cellArrays, "thickness");
  const SurfaceArray * const height = FindSurfaceArray(folds.cellArrays, "height");
  const SurfaceArray * const arcLength = FindSurfaceArray(folds.cellArrays, "arcLength");
  for (std::size_t f = 0; f < folds.curves.size(); ++f)
  {
    const auto                   row = static_cast<Eigen::Index>(f);
    std::vector<Eigen::Vector3d> crest;
    bool                         isSubmerged = thickness->values(row, 0) >= 2.5;
    for (const int v : folds.curves[f])
    {
      const Eigen::Vector3d p = folds.V.row(v);
      crest.push_back(p);
      isSubmerged = isSubmerged && truth->GetFluid().DepthBelowLevel(p, arcLength->values(row, 0)) > 0.0;
    }
    if (isSubmerged)
    {
      ++errors.folds;
      // Points inside a fold are at most half its thickness deep; anything deeper near its root is the wall.
      const double half = 0.5 * thickness->values(row, 0);
      errors.keptFolds += keeper.IsKept(crest, std::max(0.8 * height->values(row, 0), half + 1.5), half + 0.25);
    }
  }
}

/** Counts the jumps and reversals of the found line along the true line. */
void
MeasureOrder(const CurveSet & line, const Eigen::VectorXd & gap, const TrueLine & trueLine, ColonErrors & errors)
{
  double before = -1.0;
  bool   isAfterGap = false;
  double sum = 0.0;
  int    count = 0;
  for (Eigen::Index i = 0; i < line.V.rows(); ++i)
  {
    if (gap[i] != 0.0)
    {
      isAfterGap = true;
      continue;
    }
    double       distance = 0.0;
    const double place = trueLine.Place(line.V.row(i), distance);
    sum += distance;
    ++count;
    if (before >= 0.0 && isAfterGap)
    {
      errors.isOrderRight = errors.isOrderRight && place > before && place - before < 250.0;
    }
    else if (before >= 0.0)
    {
      errors.shortCuts += place - before > 40.0 || place - before < -20.0;
    }
    isAfterGap = false;
    before = place;
  }
  errors.meanLineDistance = sum / std::max(1, count);
}

void
MeasureLine(const ColonModel & model, Source * truth, ColonErrors & errors)
{
  const CurveSet        trueCurve = truth->GetAnatomy().Centerline();
  const CurveSet &      line = model.centerline.curve;
  const Eigen::VectorXd gap = PointValues(line, "gap", "the centerline");
  const Eigen::VectorXd radius = PointValues(trueCurve, "radius", "the true centerline");
  const Eigen::VectorXd collapsed = PointValues(trueCurve, "collapsed", "the true centerline");
  errors.lengthError = model.centerline.length / truth->GetAnatomy().Length() - 1.0;
  MeasureOrder(line, gap, TrueLine(truth->GetAnatomy()), errors);
  int covered = 0;
  int open = 0;
  for (Eigen::Index i = 0; i < trueCurve.V.rows(); ++i)
  {
    if (collapsed[i] == 0.0)
    {
      const double distance = std::sqrt((line.V.rowwise() - trueCurve.V.row(i)).rowwise().squaredNorm().minCoeff());
      ++open;
      covered += distance <= std::max(5.0, radius[i]);
    }
  }
  errors.covered = static_cast<double>(covered) / std::max(1, open);
}

void
MeasureMeshes(const ColonModel & model, ColonErrors & errors)
{
  const ColonWall & wall = model.wall;
  errors.areTubes = true;
  int genusRepaired = -1;
  for (const SurfaceMesh * mesh : { &wall.raw, &wall.repaired, &wall.simplified })
  {
    const SurfaceQuality quality = InspectSurface(*mesh);
    errors.areTubes = errors.areTubes && quality.isManifold && quality.components.size() == 1 &&
                      quality.boundaryLoopLengths.size() == 2 && quality.defects.AreNone();
    if (mesh == &wall.repaired)
    {
      genusRepaired = quality.genus.value_or(-1);
    }
    if (mesh == &wall.simplified)
    {
      errors.faces = quality.faces;
      errors.smallestAngle = quality.smallestAngle.percentile1;
      errors.isGenusKept = quality.genus.value_or(-2) == genusRepaired;
    }
  }
  errors.genusRaw = wall.report.rawGenus;
  errors.genusRepaired = genusRepaired;
  errors.changedMl = wall.report.topology.cutVolume;
}
} // namespace

ColonErrors
TryColon(const LandmarkCase & one, int faces)
{
  const auto         truth = MakePhantom(one);
  const auto         ct = ToFloat(truth->GetOutput());
  ColonModelSettings options;
  options.position = one.parameters.position;
  options.faces = faces;
  ColonErrors     errors;
  const Stopwatch watch;
  try
  {
    const ColonModel model = BuildColonModel(ct.GetPointer(), options);
    errors.seconds = watch.Seconds();
    errors.failure = model.failure;
    MeasureLumen(model, truth, errors);
    if (model.failure.empty())
    {
      MeasureSurface(model, truth, errors);
      const TissueKeeper keeper(model, truth->GetAnatomy());
      MeasurePolyps(truth->GetAnatomy(), keeper, errors);
      MeasureFolds(truth, keeper, errors);
      MeasureLine(model, truth, errors);
      MeasureMeshes(model, errors);
    }
  }
  catch (const Exception & error)
  {
    errors.failure = error.what();
  }
  return errors;
}
