#include "ShapeCollection.h"
#include "SampledScenes.h"

#include "shapetonExceptions.h"
#include "shapetonImageGrid.h"
#include "shapetonParallelFor.h"
#include "shapetonPi.h"
#include "shapetonSquaredDistances.h"
#include "shapetonTestImages.h"
#include "shapetonVolumeReader.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace shapeton;

namespace
{
using Scene = nlohmann::ordered_json;
constexpr std::uint32_t purposeOfShapes = 0x53687074U; ///< of the random numbers

LabelMap::Pointer
ImageOf(const VoxelRuns & shape, const itk::ImageBase<3> * grid)
{
  const auto      image = NewImageOn<LabelMap>(grid, true);
  const VoxelGrid places = GridOf(grid);
  ForEachRun(shape, [&](std::size_t run, int j, int k) {
    float * row = image->GetBufferPointer() + places.Index(0, j, k);
    std::fill(row + shape.runs[run].begin, row + shape.runs[run].end, 1.0F);
  });
  return image;
}

/** Voxels of a label of a scene, or of all labels (0). */
LabelMap::Pointer
Sample(const ShapeScene & scene, unsigned int size, unsigned char label)
{
  const auto   source = SampledScene(scene, itk::Size<3>::Filled(size));
  const auto * labels = source->GetLabelOutput();
  const auto * values = labels->GetBufferPointer();
  return ImageOf(
    CollectRuns(GridOf(labels), [=](std::size_t i) { return label == 0 ? values[i] != 0 : values[i] == label; }),
    labels);
}

// ---- generated shapes ----

Scene
Ellipsoid(SceneDice & dice)
{
  const double a = dice.Between(0.3, 0.42);
  return Scene{ { { "kind", "ellipsoid" },
                  { "radii", { a * dice.Between(0.3, 1.0), a * dice.Between(0.3, 1.0), a } } } };
}

Scene
TwistedBox(SceneDice & dice)
{
  return Scene{ { { "kind", "box" },
                  { "size", { dice.Between(0.12, 0.25), dice.Between(0.12, 0.3), dice.Between(0.45, 0.7) } },
                  { "deformations", { { { "kind", "twist" }, { "angle", dice.Between(30.0, 180.0) } } } } } };
}

Scene
BentCapsule(SceneDice & dice)
{
  return Scene{ { { "kind", "capsule" },
                  { "radius", dice.Between(0.06, 0.1) },
                  { "length", dice.Between(0.4, 0.6) },
                  { "deformations", { { { "kind", "bend" }, { "angle", dice.Between(40.0, 170.0) } } } } } };
}

Scene
Ring(SceneDice & dice)
{
  return Scene{ { { "kind", "torus" }, { "ringRadius", 0.28 }, { "tubeRadius", dice.Between(0.05, 0.16) } } };
}

Scene
KnottyTube(SceneDice & dice)
{
  Scene points = Scene::array();
  for (int i = dice.Count(4, 7); i > 0; --i)
  {
    points.push_back(dice.Place(0.24));
  }
  return Scene{ { { "kind", "tube" }, { "radius", dice.Between(0.05, 0.08) }, { "points", points } } };
}

Scene
BallWithBumps(SceneDice & dice)
{
  const double wavelength = dice.Between(0.2, 0.45);
  return Scene{ { { "kind", "sphere" },
                  { "radius", 0.28 },
                  { "deformations",
                    { { { "kind", "bumps" },
                        { "amplitude", wavelength * dice.Between(0.06, 0.14) },
                        { "wavelength", wavelength } } } } } };
}

Scene
BodyWithLimbs(SceneDice & dice)
{
  Scene objects{ { { "kind", "ellipsoid" },
                   { "radii", { dice.Between(0.1, 0.18), dice.Between(0.1, 0.18), dice.Between(0.14, 0.24) } } } };
  for (int i = dice.Count(2, 5); i > 0; --i)
  {
    objects.push_back({ { "kind", "capsule" },
                        { "radius", dice.Between(0.04, 0.07) },
                        { "length", dice.Between(0.2, 0.36) },
                        { "center", dice.Place(0.13) },
                        { "rotation", dice.Turn() } });
  }
  return objects;
}

Scene
BoxWithRods(SceneDice & dice)
{
  Scene objects{ { { "kind", "box" },
                   { "size", { dice.Between(0.1, 0.3), dice.Between(0.15, 0.3), dice.Between(0.2, 0.4) } } } };
  for (int i = dice.Count(1, 2); i > 0; --i)
  {
    objects.push_back({ { "kind", "cylinder" },
                        { "radius", dice.Between(0.05, 0.1) },
                        { "length", dice.Between(0.4, 0.6) },
                        { "center", dice.Place(0.08) },
                        { "rotation", dice.Turn() } });
  }
  return objects;
}

CollectedShape
GeneratedShape(unsigned int seed)
{
  static const std::vector<std::pair<std::string, std::function<Scene(SceneDice &)>>> families{
    { "ellipsoid", Ellipsoid },           { "twisted box", TwistedBox },
    { "bent capsule", BentCapsule },      { "ring", Ring },
    { "knotty tube", KnottyTube },        { "ball with bumps", BallWithBumps },
    { "body with limbs", BodyWithLimbs }, { "box with rods", BoxWithRods }
  };
  const auto & [family, make] = families[seed % families.size()];
  SceneDice dice(seed, purposeOfShapes);
  Scene     objects = make(dice);
  for (Scene & object : objects)
  {
    object["label"] = 1;
  }
  const Scene scene{ { "units", "relative" }, { "objects", objects } };
  return { family + " " + std::to_string(seed), Sample(ShapeScene::FromJson(scene, family), 96, 0) };
}

// ---- real shapes ----

/** Crops an image to a shape, to save memory. */
LabelMap::Pointer
Cropped(const VoxelRuns & shape, const itk::ImageBase<3> * grid)
{
  VoxelBox box{ shape.size, { { 0, 0, 0 } } };
  ForEachRun(shape, [&](std::size_t run, int j, int k) {
    const std::array<int, 3> first{ { shape.runs[run].begin, j, k } }, last{ { shape.runs[run].end, j + 1, k + 1 } };
    for (int axis = 0; axis < 3; ++axis)
    {
      box.low[axis] = std::min(box.low[axis], first[axis]);
      box.high[axis] = std::max(box.high[axis], last[axis]);
    }
  });
  const auto            image = LabelMap::New();
  LabelMap::SizeType    size;
  itk::Index<3>         start;
  itk::Point<double, 3> origin;
  for (int axis = 0; axis < 3; ++axis)
  {
    start[axis] = grid->GetBufferedRegion().GetIndex()[axis] + box.low[axis];
    size[axis] = box.high[axis] - box.low[axis];
  }
  grid->TransformIndexToPhysicalPoint(start, origin);
  image->SetRegions(size);
  image->SetSpacing(grid->GetSpacing());
  image->SetDirection(grid->GetDirection());
  image->SetOrigin(origin);
  image->Allocate(true);
  const VoxelGrid places(size[0], size[1], size[2]);
  ForEachRun(shape, [&](std::size_t run, int j, int k) {
    float * row = image->GetBufferPointer() + places.Index(0, j - box.low[1], k - box.low[2]) - box.low[0];
    std::fill(row + shape.runs[run].begin, row + shape.runs[run].end, 1.0F);
  });
  return image;
}

// ---- copies ----

/** Differences between a copy and its shape. */
struct CopyPlan
{
  std::string     kind;
  double          degrees{ 0.0 };
  double          scale{ 1.0 };
  Eigen::Vector3d voxel{ 1.0, 1.0, 1.0 }; ///< in units of the original's smallest voxel side
  double          slant{ 0.0 };           ///< rotation of the image axes (degrees)
  double          noise{ 0.0 };           ///< share of boundary voxels that are flipped
};

std::vector<CopyPlan>
CopyPlans()
{
  const Eigen::Vector3d same(1.0, 1.0, 1.0);
  return { { "turned", 30.0, 1.0, same, 0.0, 0.0 }, { "half", 0.0, 0.5, same, 0.0, 0.0 },
           { "double", 0.0, 2.0, same, 0.0, 0.0 },  { "resampled", 0.0, 1.0, { 1.3, 1.3, 2.6 }, 25.0, 0.0 },
           { "noisy", 0.0, 1.0, same, 0.0, 0.2 },   { "all", 30.0, 0.8, { 0.9, 0.9, 1.8 }, 25.0, 0.2 } };
}

Eigen::Vector3d
RandomAxis(PhiloxStream & stream)
{
  for (;;)
  {
    const Eigen::Vector3d axis(2.0 * stream.Unit() - 1.0, 2.0 * stream.Unit() - 1.0, 2.0 * stream.Unit() - 1.0);
    if (axis.norm() > 0.2 && axis.norm() < 1.0)
    {
      return axis.normalized();
    }
  }
}

Eigen::Matrix3d
RandomTurn(double degrees, PhiloxStream & stream)
{
  return Eigen::AngleAxisd(degrees * shapeton::Pi / 180.0, RandomAxis(stream)).toRotationMatrix();
}

/** Image centered on another one, large enough for its rotated and scaled content. */
LabelMap::Pointer
ImageForCopy(const LabelMap *        shape,
             const CopyPlan &        plan,
             const Eigen::Matrix3d & axes,
             const Eigen::Vector3d & middle)
{
  const auto   size = shape->GetBufferedRegion().GetSize();
  const auto & spacing = shape->GetSpacing();
  double       diagonal = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    diagonal += std::pow(size[axis] * spacing[axis], 2);
  }
  const double            side = plan.scale * std::sqrt(diagonal);
  const double            unit = std::min({ spacing[0], spacing[1], spacing[2] });
  const auto              image = LabelMap::New();
  LabelMap::SizeType      voxels;
  LabelMap::SpacingType   distances;
  LabelMap::DirectionType cosines;
  Eigen::Vector3d         half;
  for (int axis = 0; axis < 3; ++axis)
  {
    distances[axis] = unit * plan.voxel[axis];
    voxels[axis] = static_cast<itk::SizeValueType>(std::ceil(side / distances[axis])) + 2;
    half[axis] = 0.5 * (voxels[axis] - 1) * distances[axis];
    for (int column = 0; column < 3; ++column)
    {
      cosines(axis, column) = axes(axis, column);
    }
  }
  const Eigen::Vector3d origin = middle - axes * half;
  image->SetRegions(voxels);
  image->SetSpacing(distances);
  image->SetDirection(cosines);
  image->SetOrigin(itk::Point<double, 3>(origin.data()));
  image->Allocate(true);
  return image;
}

Eigen::Vector3d
MiddleOf(const LabelMap * image)
{
  const auto            size = image->GetBufferedRegion().GetSize();
  itk::Point<double, 3> first, last;
  image->TransformIndexToPhysicalPoint(itk::Index<3>{ { 0, 0, 0 } }, first);
  image->TransformIndexToPhysicalPoint(itk::Index<3>{ { static_cast<itk::IndexValueType>(size[0]) - 1,
                                                        static_cast<itk::IndexValueType>(size[1]) - 1,
                                                        static_cast<itk::IndexValueType>(size[2]) - 1 } },
                                       last);
  return { 0.5 * (first[0] + last[0]), 0.5 * (first[1] + last[1]), 0.5 * (first[2] + last[2]) };
}

/** Flips voxels at the boundary with this probability. */
void
AddNoise(LabelMap * image, double probability, PhiloxStream & stream)
{
  const VoxelGrid          grid = GridOf(image);
  float *                  values = image->GetBufferPointer();
  std::vector<std::size_t> changing;
  for (std::size_t i = 0; i < grid.NumberOfVoxels(); ++i)
  {
    bool isAtBoundary = false;
    ForEachNeighbor(grid, i, [&](std::size_t j) { isAtBoundary = isAtBoundary || values[i] != values[j]; });
    if (isAtBoundary && stream.Unit() < probability)
    {
      changing.push_back(i);
    }
  }
  for (const std::size_t i : changing)
  {
    values[i] = 1.0F - values[i];
  }
}

/** Creates a copy by nearest-neighbor interpolation. */
LabelMap::Pointer
CopyOf(const LabelMap * shape, const CopyPlan & plan, PhiloxStream & stream)
{
  const Eigen::Matrix3d turn = RandomTurn(plan.degrees, stream);
  const Eigen::Vector3d middle = MiddleOf(shape);
  const auto            copy = ImageForCopy(shape, plan, RandomTurn(plan.slant, stream), middle);
  const VoxelGrid       grid = GridOf(copy);
  const Eigen::Matrix3d back = turn.transpose() / plan.scale;
  for (std::size_t i = 0; i < grid.NumberOfVoxels(); ++i)
  {
    const auto            voxel = grid.Voxel(i);
    itk::Point<double, 3> point;
    copy->TransformIndexToPhysicalPoint(itk::Index<3>{ { voxel[0], voxel[1], voxel[2] } }, point);
    const Eigen::Vector3d source = middle + back * (Eigen::Vector3d(point[0], point[1], point[2]) - middle);
    itk::Index<3>         index;
    if (shape->TransformPhysicalPointToIndex(itk::Point<double, 3>(source.data()), index))
    {
      copy->GetBufferPointer()[i] = shape->GetPixel(index);
    }
  }
  if (plan.noise > 0.0)
  {
    AddNoise(copy, plan.noise, stream);
  }
  return copy;
}
} // namespace

std::vector<CollectedShape>
PresetShapes()
{
  const struct
  {
    const char *  preset;
    unsigned char label;
    const char *  name;
  } shapes[] = { { "figure3.4", 1, "cube" },        { "figure3.4", 2, "cuboid 2:1:1" },
                 { "figure3.4", 4, "ball" },        { "figure3.5", 1, "cuboid 3:1:1" },
                 { "figure3.5", 2, "bent cuboid" }, { "figure3.5", 4, "ball with bumps" },
                 { "hydrogen", 2, "lobe" },         { "hydrogen", 4, "ring" },
                 { "vessels", 1, "thin vessels" },  { "vessels", 2, "large vessel" },
                 { "vessels", 3, "aneurysm" } };
  std::vector<CollectedShape> collection;
  for (const auto & shape : shapes)
  {
    const auto image = Sample(ShapeScene::Load(shape.preset), 128, shape.label);
    collection.push_back({ shape.name, Cropped(VoxelsOfLabel(image, 1), image) });
  }
  return collection;
}

std::vector<CollectedShape>
GeneratedShapes(unsigned int firstSeed, int number)
{
  std::vector<CollectedShape> collection;
  for (int i = 0; i < number; ++i)
  {
    const CollectedShape shape = GeneratedShape(firstSeed + i);
    collection.push_back({ shape.name, Cropped(VoxelsOfLabel(shape.image, 1), shape.image) });
  }
  return collection;
}

std::vector<CollectedShape>
BonesOfFeet(const std::string & dataFolder, std::size_t number)
{
  constexpr float             dense = 350.0F;    // HU
  constexpr float             depth = 2.0F;      // mm: bones are connected by bridges thinner than twice this
  constexpr std::size_t       leastVoxels = 900; // deeper than `depth`
  const Volume                ct = ReadVolume(dataFolder + "/ct/visible-female-ankle");
  const VoxelGrid             grid = GridOf(ct.image);
  const std::array<double, 3> spacing{ ct.image->GetSpacing()[0],
                                       ct.image->GetSpacing()[1],
                                       ct.image->GetSpacing()[2] };
  std::vector<unsigned char>  bone(grid.NumberOfVoxels());
  std::transform(ct.image->GetBufferPointer(),
                 ct.image->GetBufferPointer() + bone.size(),
                 bone.begin(),
                 [=](float value) { return value >= dense ? 1 : 0; });
  const VoxelValues           squares = SquaredDistances(grid, spacing, bone);
  const auto                  deep = CollectRuns(grid, [&](std::size_t i) { return squares[i] > depth * depth; });
  std::vector<CollectedShape> collection;
  for (const VoxelRuns & core : ComponentsOf(deep, leastVoxels))
  {
    std::vector<unsigned char> outside(bone.size(), 1);
    ForEachRun(core, [&](std::size_t run, int j, int k) {
      std::fill(outside.begin() + grid.Index(core.runs[run].begin, j, k),
                outside.begin() + grid.Index(core.runs[run].end, j, k),
                0);
    });
    const VoxelValues toCore = SquaredDistances(grid, spacing, outside);
    const auto grown = CollectRuns(grid, [&](std::size_t i) { return bone[i] != 0 && toCore[i] <= depth * depth; });
    if (collection.size() < number)
    {
      collection.push_back({ "bone " + std::to_string(collection.size() + 1), Cropped(grown, ct.image) });
    }
  }
  return collection;
}

std::vector<CollectedShape>
Organs(const std::string & dataFolder, std::size_t number)
{
  constexpr std::size_t leastVoxels = 1000;
  const Volume          labels = ReadVolume(dataFolder + "/ct/totalsegmentator/example_seg.nii.gz");
  std::vector<std::pair<std::size_t, CollectedShape>> organs;
  for (const int label : LabelsOf(labels.image))
  {
    const VoxelRuns organ = VoxelsOfLabel(labels.image, label);
    if (CountVoxels(organ) >= leastVoxels)
    {
      organs.push_back({ CountVoxels(organ), { "organ " + std::to_string(label), Cropped(organ, labels.image) } });
    }
  }
  std::stable_sort(organs.begin(), organs.end(), [](const auto & a, const auto & b) { return a.first > b.first; });
  std::vector<CollectedShape> collection;
  for (std::size_t i = 0; i < std::min(number, organs.size()); ++i)
  {
    collection.push_back(organs[i].second);
  }
  return collection;
}

MeasuredShape
Measure(const CollectedShape & shape, unsigned int seed)
{
  MeasuredShape measured;
  measured.name = shape.name;
  measured.original = ComputeShapeSignature(VoxelsOfLabel(shape.image, 1), shape.image);
  PhiloxStream stream(seed, 1, purposeOfShapes);
  for (const CopyPlan & plan : CopyPlans())
  {
    const auto copy = CopyOf(shape.image, plan, stream);
    try
    {
      measured.copies.push_back({ plan.kind, ComputeShapeSignature(VoxelsOfLabel(copy, 1), copy) });
    }
    catch (const InputError &)
    {
      continue; // too small for a signature
    }
  }
  return measured;
}

std::vector<MeasuredShape>
Measure(const std::vector<CollectedShape> & shapes)
{
  std::vector<MeasuredShape> measured(shapes.size());
  ParallelFor(shapes.size(),
              [&](std::size_t i) { measured[i] = Measure(shapes[i], static_cast<unsigned int>(i) + 1); });
  return measured;
}
