#include "shapetonShapePhantomImageSource.h"
#include "shapetonJson.h"
#include "shapetonTestFrames.h"
#include "shapetonTestThreads.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>
#include <vector>

namespace
{
using Source = shapeton::ShapePhantomImageSource;
const double pi = std::acos(-1.0);

shapeton::ShapeScene
SceneOf(const std::string & objects, double background = 0.0)
{
  return shapeton::ShapeScene::FromJson(shapeton::Json::parse(R"({ "units": "mm", "background": )" +
                                                              std::to_string(background) + R"(, "objects": [)" +
                                                              objects + "] }"),
                                        "test");
}

Source::Pointer
MakeSource(const shapeton::ShapeScene & scene, unsigned int size, double spacing = 1.0)
{
  const auto source = Source::New();
  source->SetSize({ { size, size, size } });
  source->SetSpacing(Source::SpacingType(spacing));
  source->CenterOutput();
  source->SetScene(scene);
  return source;
}

// Anisotropic, rotated by 40 degrees about (1, 2, 3).
Source::Pointer
MakeObliqueSource(const shapeton::ShapeScene & scene)
{
  const auto source = Source::New();
  source->SetSize({ { 50, 40, 70 } });
  const double spacing[3] = { 0.9, 1.3, 0.7 };
  source->SetSpacing(spacing);
  const auto turn = Eigen::AngleAxisd(40 * pi / 180, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  Source::DirectionType direction;
  for (unsigned int i = 0; i < 9; ++i)
  {
    direction(i / 3, i % 3) = turn(i / 3, i % 3);
  }
  source->SetDirection(direction);
  source->CenterOutput();
  source->SetScene(scene);
  return source;
}

struct Counts
{
  double voxels{ 0.0 };
  double faces{ 0.0 }; // between voxels of label 0 and others
};

Counts
Count(const Source::LabelImageType * labels)
{
  Counts counts;
  basetest::ForVoxels(labels, [&](const auto & index, const auto &) {
    const bool isObject = labels->GetPixel(index) != 0;
    counts.voxels += isObject;
    for (unsigned int i = 0; i < 3; ++i)
    {
      auto next = index;
      if (++next[i] < static_cast<itk::IndexValueType>(labels->GetLargestPossibleRegion().GetSize(i)))
      {
        counts.faces += isObject != (labels->GetPixel(next) != 0);
      }
    }
  });
  return counts;
}

struct Statistics
{
  double mean;
  double deviation;
  double standardError; // of the mean
};

Statistics
StatisticsOf(const std::vector<double> & values)
{
  const Eigen::Map<const Eigen::ArrayXd> array(values.data(), static_cast<Eigen::Index>(values.size()));
  const double                           deviation = std::sqrt((array - array.mean()).square().mean());
  return { array.mean(), deviation, deviation / std::sqrt(values.size() - 1.0) };
}
} // namespace

// For a uniformly random lattice offset, the expected number of lattice points in a body of volume V is exactly V / h^3
// (Fubini). A lattice line through a convex body crosses two faces, unless the chord is between two lattice points. The
// expected number of faces across an axis is thus 2 / h^2 times the integral of min(1, chord / h) over the projection
// of the body. For smooth bodies of the sizes below, the integral is the projected area to 1e-3.
struct Body
{
  const char * object;
  double       volume;
  double       shadows; // sum of that integral over the three axes; 0 if not convex
};

constexpr double latticeSpacing = 0.8;

void
ExpectUnbiasedCounts(const Body & body)
{
  SCOPED_TRACE(body.object);
  constexpr double                       spacing = latticeSpacing;
  const auto                             source = MakeSource(SceneOf(body.object), 36, spacing);
  std::mt19937                           engine(11);
  std::uniform_real_distribution<double> uniform(-0.5 * spacing, 0.5 * spacing);
  std::vector<double>                    volumes, shadows;
  for (int sample = 0; sample < 40; ++sample)
  {
    source->CenterOutput();
    auto origin = source->GetOrigin();
    for (unsigned int i = 0; i < 3; ++i)
    {
      origin[i] += uniform(engine);
    }
    source->SetOrigin(origin);
    source->Update();
    ASSERT_TRUE(source->FindIncompleteObjects().empty());
    const Counts counts = Count(source->GetLabelOutput());
    volumes.push_back(counts.voxels * spacing * spacing * spacing);
    shadows.push_back(0.5 * counts.faces * spacing * spacing);
  }
  const Statistics volume = StatisticsOf(volumes);
  EXPECT_NEAR(volume.mean, body.volume, 4.0 * volume.standardError + 1e-9);
  EXPECT_LT(volume.standardError, 0.005 * body.volume); // required for the bound above
  if (body.shadows > 0.0)
  {
    const Statistics shadow = StatisticsOf(shadows);
    EXPECT_NEAR(shadow.mean, body.shadows, 4.0 * shadow.standardError + 1e-3 * body.shadows);
    EXPECT_LT(shadow.standardError, 0.005 * body.shadows);
  }
}

// Sphere: 3 pi r^2. Box a, b, c rotated by 30 degrees about z: faces along x and y are weighted by the cosine of their
// normal.
TEST(ShapePhantomImageSource, VoxelAndFaceCountsAreUnbiased)
{
  ExpectUnbiasedCounts({ R"({ "kind": "sphere", "radius": 10 })", 4.0 / 3.0 * pi * 1000.0, 300.0 * pi });
  ExpectUnbiasedCounts({ R"({ "kind": "box", "size": [10, 12, 16], "rotation": { "axis": [0, 0, 1], "angle": 30 } })",
                         10.0 * 12.0 * 16.0,
                         10.0 * 12.0 + 16.0 * (12.0 + 10.0) * (std::cos(pi / 6) + std::sin(pi / 6)) -
                           2.0 * 16.0 * latticeSpacing * std::cos(pi / 6) * std::sin(pi / 6) });
  ExpectUnbiasedCounts({ R"({ "kind": "ellipsoid", "radii": [6, 9, 12] })",
                         4.0 / 3.0 * pi * 6.0 * 9.0 * 12.0,
                         pi * (6.0 * 9.0 + 6.0 * 12.0 + 9.0 * 12.0) });
  ExpectUnbiasedCounts(
    { R"({ "kind": "cylinder", "radius": 6, "length": 20 })", pi * 720.0, pi * 36.0 + 2.0 * 12.0 * 20.0 });
  ExpectUnbiasedCounts({ R"({ "kind": "capsule", "radius": 6, "length": 12 })",
                         pi * 36.0 * 12.0 + 4.0 / 3.0 * pi * 216.0,
                         3.0 * pi * 36.0 + 2.0 * 12.0 * 12.0 });
  ExpectUnbiasedCounts(
    { R"({ "kind": "torus", "ringRadius": 9, "tubeRadius": 3, "rotation": { "axis": [1, 1, 0], "angle": 50 } })",
      2.0 * pi * pi * 9.0 * 9.0,
      0.0 });
  // Twisting preserves volume, as does bending if the centroid of the section is on the axis (Pappus).
  ExpectUnbiasedCounts({ R"({ "kind": "box", "size": [6, 7, 20], "deformations": [{ "kind": "twist", "angle": 90 },
                                                                                { "kind": "bend", "angle": 110 }] })",
                         6.0 * 7.0 * 20.0,
                         0.0 });
}

// Lattice points farther than half a voxel diagonal from the surface are correct, so the error is at most the volume of
// that shell.
TEST(ShapePhantomImageSource, VoxelCountOfASphereStaysWithinTheShell)
{
  const double half = 0.5 * std::sqrt(3.0);
  for (const double radius : { 5.0, 8.3, 13.7 })
  {
    const auto source = MakeSource(SceneOf(R"({ "kind": "sphere", "radius": )" + std::to_string(radius) + " }"), 32);
    source->Update();
    const double voxels = Count(source->GetLabelOutput()).voxels;
    EXPECT_LE(voxels, 4.0 / 3.0 * pi * std::pow(radius + half, 3));
    EXPECT_GE(voxels, 4.0 / 3.0 * pi * std::pow(radius - half, 3));
  }
}

TEST(ShapePhantomImageSource, CubeOfFigure24IsExact)
{
  const auto source = MakeSource(shapeton::ShapeScene::Load("figure2.4"), 32);
  source->Update();
  const Counts counts = Count(source->GetLabelOutput());
  EXPECT_EQ(counts.voxels, 16.0 * 16.0 * 16.0);
  EXPECT_EQ(counts.faces, 6.0 * 16.0 * 16.0);
  EXPECT_EQ(source->GetOutput()->GetPixel({ { 16, 16, 16 } }), 1000);
  EXPECT_EQ(source->GetOutput()->GetPixel({ { 7, 16, 16 } }), 0);
  EXPECT_EQ(source->GetOutput()->GetPixel({ { 8, 16, 16 } }), 1000);
}

// The line-by-line search for near objects does not change the result.
TEST(ShapePhantomImageSource, LabelsAreTheSignOfTheDistanceInAnObliqueImage)
{
  for (const auto & preset : shapeton::ShapeScene::GetPresetNames())
  {
    const auto source = MakeObliqueSource(shapeton::ShapeScene::Load(preset));
    source->SetBlur(0.8);
    source->SetNoise(30.0);
    source->Update();
    auto scene = source->GetScene();
    scene.SetUnitLength(50 * 0.9); // the shortest extent
    const auto * labels = source->GetLabelOutput();
    std::size_t  differences = 0;
    basetest::ForVoxels(labels, [&](const auto & index, const auto & point) {
      differences += labels->GetPixel(index) != scene.GetLabel(point);
    });
    EXPECT_EQ(differences, 0U) << preset;
    EXPECT_TRUE(source->FindIncompleteObjects().empty()) << preset;
  }
}

TEST(ShapePhantomImageSource, ObliqueImageSamplesTheSamePhysicalScene)
{
  // The tensor of second moments of a box is diag(a^2, b^2, c^2) / 12.
  const auto scene = SceneOf(R"({ "kind": "box", "size": [10, 14, 18], "center": [3, -2, 1] })");
  const auto straight = MakeSource(scene, 40);
  const auto oblique = MakeObliqueSource(scene);
  for (const auto & source : { straight, oblique })
  {
    source->Update();
    const auto * const labels = source->GetLabelOutput();
    const double       voxel = source->GetSpacing()[0] * source->GetSpacing()[1] * source->GetSpacing()[2];
    double             volume = 0.0;
    Eigen::Vector3d    mean = Eigen::Vector3d::Zero();
    Eigen::Matrix3d    second = Eigen::Matrix3d::Zero();
    basetest::ForVoxels(labels, [&](const auto & index, const auto & point) {
      const double          share = labels->GetPixel(index) == 1 ? voxel : 0.0;
      const Eigen::Vector3d p = basetest::ToEigen(point);
      volume += share;
      mean += share * p;
      second += share * p * p.transpose();
    });
    mean /= volume;
    second = second / volume - mean * mean.transpose();
    EXPECT_NEAR(volume, 2520.0, 0.03 * 2520.0);
    EXPECT_LT((mean - Eigen::Vector3d(3, -2, 1)).cwiseAbs().maxCoeff(), 0.15);
    const Eigen::Vector3d squares = Eigen::Vector3d(10 * 10, 14 * 14, 18 * 18) / 12.0;
    EXPECT_LT((second - Eigen::Matrix3d(squares.asDiagonal())).cwiseAbs().maxCoeff(), 0.35);
  }
}

TEST(ShapePhantomImageSource, BlurIsTheGaussianIntegralAcrossAPlaneFace)
{
  // The face z = 0.37 of a box that extends far beyond the volume in x and y.
  const auto source = MakeSource(
    SceneOf(R"({ "kind": "box", "size": [400, 400, 100], "center": [0, 0, -49.63], "intensity": 1000 })", -200.0),
    24,
    0.5);
  constexpr double blur = 1.1;
  source->SetBlur(blur);
  source->Update();
  const auto * image = source->GetOutput();
  basetest::ForVoxels(image, [&](const auto & index, const auto & point) {
    const double expected = -200.0 + 1200.0 * 0.5 * std::erfc((point[2] - 0.37) / (blur * std::sqrt(2.0)));
    EXPECT_NEAR(image->GetPixel(index), expected, 0.5 + 1e-6);
  });
}

TEST(ShapePhantomImageSource, EqualIntensitiesAreAUnionAndOthersPaintOver)
{
  // Two overlapping halves of a sphere without a seam, with a cavity inside.
  const auto source = MakeSource(SceneOf(R"(
      { "kind": "sphere", "radius": 9, "center": [-1, 0, 0], "intensity": 500 },
      { "kind": "sphere", "radius": 9, "center": [1, 0, 0], "intensity": 500 },
      { "kind": "sphere", "radius": 3, "intensity": -1000, "label": 0 })"),
                                 32);
  source->SetBlur(0.5);
  source->Update();
  const auto * image = source->GetOutput();
  basetest::ForVoxels(image, [&](const auto & index, const auto & point) {
    const auto   share = [](double distance) { return 0.5 * std::erfc(distance / (0.5 * std::sqrt(2.0))); };
    const auto   distanceTo = [&point](double x) { return std::hypot(point[0] - x, point[1], point[2]); };
    const double spheres = 500.0 * share(std::min(distanceTo(-1.0), distanceTo(1.0)) - 9.0);
    const double expected = spheres + share(distanceTo(0.0) - 3.0) * (-1000.0 - spheres);
    EXPECT_NEAR(image->GetPixel(index), expected, 0.5 + 1e-6);
  });
}

TEST(ShapePhantomImageSource, NoiseIsNormal)
{
  const auto source = MakeSource(SceneOf("", 100.0), 64);
  source->SetNoise(50.0);
  source->SetSeed(5);
  source->Update();
  const short * const values = source->GetOutput()->GetBufferPointer();
  const int           number = 64 * 64 * 64;
  std::vector<double> normalized;
  double              neighbors = 0.0;
  std::array<int, 4>  beyond{ { 0, 0, 0, 0 } };
  for (int i = 0; i < number; ++i)
  {
    const double z = (values[i] - 100.0) / 50.0;
    normalized.push_back(z);
    neighbors += i > 0 ? z * (values[i - 1] - 100.0) / 50.0 : 0.0;
    for (int k = 0; k < 4; ++k)
    {
      beyond[k] += std::abs(values[i] - 100.0) > 50.0 * k + 0.5;
    }
  }
  const double     standardError = 1.0 / std::sqrt(number);
  const Statistics statistics = StatisticsOf(normalized);
  EXPECT_NEAR(statistics.mean, 0.0, 4.0 * standardError);
  const double rounding = 1.0 / 12.0 / 2500.0; // variance added by rounding to integer HU
  EXPECT_NEAR(statistics.deviation, std::sqrt(1.0 + rounding), 4.0 * standardError / std::sqrt(2.0));
  EXPECT_NEAR(neighbors / number, 0.0, 4.0 * standardError);
  for (int k = 0; k < 4; ++k)
  {
    const double share = std::erfc((50.0 * k + 0.5) / 50.0 / std::sqrt(2.0));
    EXPECT_NEAR(beyond[k] / static_cast<double>(number), share, 4.0 * std::sqrt(share / number)) << k;
  }
}

// The known answer of Random123 for Philox4x32-10 with counter 0 and key 0 starts with 6627e8d5 e169c58d: the uniform
// number 0.39905... with normal quantile -0.25581.
TEST(ShapePhantomImageSource, NoiseFollowsPhilox)
{
  const auto source = MakeSource(SceneOf(""), 2);
  source->SetNoise(10000.0);
  source->SetScene(SceneOf("", 10000.0));
  source->Update();
  const double uniform = 0x6627e8d5 / 4294967296.0;
  const double z = (source->GetOutput()->GetBufferPointer()[0] - 10000.0) / 10000.0;
  EXPECT_NEAR(0.5 * std::erfc(-z / std::sqrt(2.0)), uniform, 3e-5); // one HU is 1e-4 in z
}

TEST(ShapePhantomImageSource, SeedsGiveIndependentNoise)
{
  const auto source = MakeSource(SceneOf(""), 32);
  source->SetNoise(100.0);
  source->Update();
  const std::string first = basetest::BytesOf(source->GetOutput());
  source->SetSeed(1);
  source->Update();
  const std::string second = basetest::BytesOf(source->GetOutput());
  const auto *      a = reinterpret_cast<const short *>(first.data());
  const auto *      b = reinterpret_cast<const short *>(second.data());
  const int         number = 32 * 32 * 32;
  double            correlation = 0.0;
  for (int i = 0; i < number; ++i)
  {
    correlation += a[i] * b[i] / 1e4;
  }
  EXPECT_NEAR(correlation / number, 0.0, 4.0 / std::sqrt(number));
}

TEST(ShapePhantomImageSource, SameBytesForAnyNumberOfThreads)
{
  const auto source = MakeObliqueSource(shapeton::ShapeScene::Load("figure3.5"));
  source->SetBlur(0.7);
  source->SetNoise(20.0);
  std::set<std::string> images;
  std::set<std::string> labels;
  for (const unsigned int threads : { 1U, 2U, 3U, 8U })
  {
    source->SetNumberOfWorkUnits(threads);
    source->Modified();
    source->Update();
    images.insert(basetest::BytesOf(source->GetOutput()));
    labels.insert(basetest::BytesOf(source->GetLabelOutput()));
  }
  EXPECT_EQ(images.size(), 1U);
  EXPECT_EQ(labels.size(), 1U);
}

TEST(ShapePhantomImageSource, APieceEqualsTheSamePartOfTheWhole)
{
  const auto whole = MakeObliqueSource(shapeton::ShapeScene::Load("vessels"));
  const auto piece = MakeObliqueSource(shapeton::ShapeScene::Load("vessels"));
  for (const auto & source : { whole, piece })
  {
    source->SetBlur(1.5);
    source->SetNoise(5.0);
  }
  whole->Update();
  const Source::RegionType region({ { 13, 11, 30 } }, { { 20, 9, 25 } });
  piece->GetOutput()->SetRequestedRegion(region);
  piece->GetOutput()->Update();
  EXPECT_EQ(piece->GetOutput()->GetBufferedRegion(), region);
  basetest::ForVoxels(piece->GetOutput(), [&](const auto & index, const auto &) {
    ASSERT_EQ(piece->GetOutput()->GetPixel(index), whole->GetOutput()->GetPixel(index));
    ASSERT_EQ(piece->GetLabelOutput()->GetPixel(index), whole->GetLabelOutput()->GetPixel(index));
  });
}

TEST(ShapePhantomImageSource, VesselTreeIsOnePieceWithThreeLabels)
{
  const auto source = MakeSource(shapeton::ShapeScene::Load("vessels"), 96);
  source->Update();
  const auto *                      labels = source->GetLabelOutput();
  const auto                        region = labels->GetLargestPossibleRegion();
  std::set<unsigned char>           found;
  std::size_t                       voxels = 0;
  Source::LabelImageType::IndexType seed{};
  basetest::ForVoxels(labels, [&](const auto & index, const auto &) {
    if (labels->GetPixel(index) != 0)
    {
      found.insert(labels->GetPixel(index));
      ++voxels;
      seed = index;
    }
  });
  EXPECT_EQ(found, (std::set<unsigned char>{ 1, 2, 3 }));

  std::vector<bool>                              seen(region.GetNumberOfPixels(), false);
  std::vector<Source::LabelImageType::IndexType> stack{ seed };
  std::size_t                                    reached = 0;
  seen[labels->ComputeOffset(seed)] = true;
  while (!stack.empty())
  {
    const auto index = stack.back();
    stack.pop_back();
    ++reached;
    for (unsigned int side = 0; side < 6; ++side)
    {
      auto next = index;
      next[side / 2] += side % 2 == 0 ? 1 : -1;
      if (region.IsInside(next) && labels->GetPixel(next) != 0 && !seen[labels->ComputeOffset(next)])
      {
        seen[labels->ComputeOffset(next)] = true;
        stack.push_back(next);
      }
    }
  }
  EXPECT_EQ(reached, voxels);
}

TEST(ShapePhantomImageSource, NamesObjectsThatTheVolumeCutsOrMisses)
{
  const auto source = MakeSource(SceneOf(R"({ "name": "whole", "kind": "sphere", "radius": 3 },
                                            { "name": "cut", "kind": "sphere", "radius": 3, "center": [7, 0, 0] },
                                            { "name": "missed", "kind": "sphere", "radius": 3, "center": [0, 99, 0] })"),
                                 20);
  source->UpdateOutputInformation();
  EXPECT_EQ(source->FindIncompleteObjects(), (std::vector<std::string>{ "cut", "missed" }));
}

TEST(ShapePhantomImageSource, LabelsThatAreTakenAwayAreMadeAnew)
{
  const auto source = MakeSource(SceneOf(R"({ "name": "ball", "kind": "sphere", "radius": 3 })"), 20);
  source->Update();
  const shapeton::ShapePhantomImageSource::LabelImageType::Pointer labels = source->GetLabelOutput();
  labels->DisconnectPipeline();
  source->Modified();
  source->Update();
  ASSERT_NE(dynamic_cast<decltype(labels.GetPointer())>(source->GetIndexedOutputs()[1].GetPointer()), nullptr);
  const auto number = labels->GetBufferedRegion().GetNumberOfPixels();
  EXPECT_TRUE(std::equal(
    labels->GetBufferPointer(), labels->GetBufferPointer() + number, source->GetLabelOutput()->GetBufferPointer()));
}

TEST(ShapePhantomImageSource, TakesTheGridOfAReferenceImage)
{
  const auto direct = MakeObliqueSource(shapeton::ShapeScene::Load("figure2.7b"));
  direct->Update();
  const auto referred = Source::New();
  referred->SetScene(shapeton::ShapeScene::Load("figure2.7b"));
  referred->SetReferenceImage(direct->GetOutput());
  referred->UseReferenceImageOn();
  referred->Update();
  EXPECT_EQ(referred->GetOutput()->GetDirection(), direct->GetOutput()->GetDirection());
  EXPECT_EQ(basetest::BytesOf(referred->GetOutput()), basetest::BytesOf(direct->GetOutput()));
  EXPECT_EQ(basetest::BytesOf(referred->GetLabelOutput()), basetest::BytesOf(direct->GetLabelOutput()));
}

TEST(ShapePhantomImageSource, ValuesStayInTheRangeOfACTSeries)
{
  const auto source = MakeSource(SceneOf(R"({ "kind": "sphere", "radius": 5, "intensity": 31743 })", -1024.0), 16);
  source->SetNoise(3000.0);
  source->Update();
  const short * const values = source->GetOutput()->GetBufferPointer();
  const auto [lowest, highest] = std::minmax_element(values, values + 16 * 16 * 16);
  EXPECT_EQ(*lowest, -1024);
  EXPECT_EQ(*highest, 31743);
}
