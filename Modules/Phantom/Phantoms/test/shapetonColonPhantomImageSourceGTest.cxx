#include "shapetonBodySampler.h"
#include "shapetonColonAbdomen.h"
#include "shapetonColonPhantomImageSource.h"
#include "shapetonVolumeWriter.h"
#include "shapetonTestThreads.h"
#include "shapetonTestFrames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <vector>
#include <set>

namespace
{
using Source = shapeton::ColonPhantomImageSource;
using LabelImage = Source::LabelImageType;

Source::Pointer
MakeSource(const shapeton::ColonPhantomParameters & parameters, itk::SizeValueType size, double extent = 358.4)
{
  const auto source = Source::New();
  source->SetSize({ { size, size, size } });
  const double spacing[3] = { extent / size, extent / size, extent / size };
  source->SetSpacing(spacing);
  source->CenterOutput();
  source->SetParameters(parameters);
  return source;
}

shapeton::ColonPhantomParameters
Standard(const std::string & position, double fluid, unsigned seed = 3)
{
  auto parameters = shapeton::ColonPhantomPreset("standard");
  parameters.position = position;
  parameters.fluid = fluid;
  parameters.seed = seed;
  return parameters;
}

// Mean and standard deviation of lumen voxels of one label at least `depth` mm from wall and level.
struct Statistics
{
  double      mean{ 0.0 };
  double      deviation{ 0.0 };
  std::size_t count{ 0 };
};

Statistics
IntensityOf(Source * source, unsigned char label, double depth)
{
  Statistics result;
  double     squares = 0.0;
  const auto lumen = source->GetLumenOutput();
  basetest::ForVoxels(lumen, [&](const auto & index, const auto & p) {
    const auto   point = basetest::ToEigen(p);
    const auto   sample = source->GetAnatomy().Evaluate(point);
    const double fromLevel = std::abs(source->GetFluid().DepthBelowLevel(point, sample.arcLength));
    if (lumen->GetPixel(index) == label && sample.distance >= depth && sample.arcLength >= 100.0 && fromLevel >= depth)
    {
      const double value = source->GetOutput()->GetPixel(index);
      result.mean += value;
      squares += value * value;
      ++result.count;
    }
  });
  result.mean /= static_cast<double>(result.count);
  result.deviation = std::sqrt(squares / static_cast<double>(result.count) - result.mean * result.mean);
  return result;
}

// Reference that evaluates every cell without skipping.
class NeverSkipped : public shapeton::PhantomBody
{
public:
  explicit NeverSkipped(std::shared_ptr<const shapeton::PhantomBody> body) : m_Body(std::move(body)) {}
  shapeton::BodyProbe
  Probe(const PointType &) const override
  {
    return { 0.0, 0.0 };
  }
  double
  Intensity(const PointType & p) const override
  {
    return m_Body->Intensity(p);
  }
  void
  Paint(const PointType & p, double width, double & value) const override
  {
    m_Body->Paint(p, width, value);
  }

private:
  std::shared_ptr<const shapeton::PhantomBody> m_Body;
};
} // namespace

// Visits a fixed sample of points in the lumen.
template <typename TVisitor>
void
VisitLumen(const shapeton::ColonAnatomy & anatomy, int points, const TVisitor & visit)
{
  Eigen::Vector3d low;
  Eigen::Vector3d high;
  anatomy.BoundingBox(1.0, low, high);
  std::uint64_t state = 1;
  const auto    next = [&state] {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return std::ldexp(static_cast<double>(state >> 11), -53);
  };
  for (int i = 0; i < points; ++i)
  {
    const Eigen::Vector3d share(next(), next(), next());
    const Eigen::Vector3d point = low + share.cwiseProduct(high - low);
    const auto            sample = anatomy.Evaluate(point);
    if (sample.distance > 0.0)
    {
      visit(point, sample.arcLength);
    }
  }
}

// Two slices in the middle of the body along each of two axes, for baselines.
TEST(ColonPhantomImageSource, MiddleSlices)
{
  for (const unsigned axis : { 0U, 1U })
  {
    const auto       source = Source::New();
    Source::SizeType size{ { 180, 180, 170 } };
    size[axis] = 2;
    source->SetParameters(Standard("supine", 0.3));
    source->SetSize(size);
    source->SetSpacing(Source::SpacingType(2.0));
    source->CenterOutput();
    source->Update();
    const std::string name = axis == 0 ? "Sagittal" : "Coronal";
    shapeton::WriteVolume(source->GetOutput(), SHAPETON_TEST_TEMPORARY_DIR "/ColonPhantom" + name + ".nrrd");
  }
}

TEST(ColonPhantomImageSource, FluidHasTheShareAskedFor)
{
  for (const double share : { 0.0, 0.2, 0.6, 1.0 })
  {
    const shapeton::ColonAnatomy anatomy(Standard("supine", share));
    const shapeton::ColonFluid   fluid(anatomy);
    double                       wet = 0.0;
    double                       all = 0.0;
    VisitLumen(anatomy, 400000, [&](const Eigen::Vector3d & point, double arcLength) {
      wet += fluid.DepthBelowLevel(point, arcLength) > 0.0;
      all += 1.0;
    });
    EXPECT_GT(all, 20000.0);
    EXPECT_NEAR(wet / all, share, share == 0.0 || share == 1.0 ? 1e-12 : 0.005) << share;
  }
}

class EachPosition : public testing::TestWithParam<const char *>
{};

// A level is between points in gas and fluid that are 1.4 mm apart with only lumen in between, accurate to 0.4 mm.
TEST_P(EachPosition, FluidEndsInLevelsOnly)
{
  const shapeton::ColonAnatomy anatomy(Standard(GetParam(), 0.3));
  const shapeton::ColonFluid   fluid(anatomy);
  std::size_t                  faces = 0;
  std::size_t                  wrong = 0;
  const auto isInLumen = [&](const Eigen::Vector3d & p) { return anatomy.Evaluate(p).distance > 0.0; };
  VisitLumen(anatomy, 300000, [&](const Eigen::Vector3d & point, double arcLength) {
    const bool wet = fluid.DepthBelowLevel(point, arcLength) > 0.0;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      const Eigen::Vector3d next = point + 1.4 * Eigen::Vector3d::Unit(axis);
      if (!isInLumen(next) || !isInLumen(0.5 * (point + next)) ||
          (fluid.DepthBelowLevel(next, anatomy.Evaluate(next).arcLength) > 0.0) == wet)
      {
        continue;
      }
      const auto heights = std::minmax({ -fluid.Down().dot(point), -fluid.Down().dot(next) });
      ++faces;
      wrong += std::none_of(fluid.Pools().begin(), fluid.Pools().end(), [&heights](const shapeton::ColonPool & pool) {
        return pool.level > heights.first - 0.4 && pool.level < heights.second + 0.4;
      });
    }
  });
  EXPECT_GT(faces, 300U);
  EXPECT_LE(wrong, faces / 500);
}

TEST_P(EachPosition, LevelsArePerpendicularToGravityAndDiffer)
{
  const shapeton::ColonAnatomy anatomy(Standard(GetParam(), 0.2));
  const shapeton::ColonFluid   fluid(anatomy);
  const std::string            position = GetParam();
  const Eigen::Vector3d        down(position == "leftDecubitus" ? 1.0 : (position == "rightDecubitus" ? -1.0 : 0.0),
                             position == "supine" ? 1.0 : (position == "prone" ? -1.0 : 0.0),
                             0.0);
  EXPECT_GT(fluid.Down().dot(down), std::cos(1.0 * 3.14159265 / 180.0));
  ASSERT_GE(fluid.Pools().size(), 3U);
  double lowest = 1e9;
  double highest = -1e9;
  double volume = 0.0;
  for (const auto & pool : fluid.Pools())
  {
    EXPECT_GT(pool.level, pool.bottom);
    EXPECT_GE(pool.intensity, 600.0);
    EXPECT_LE(pool.intensity, 830.0);
    lowest = std::min(lowest, pool.level);
    highest = std::max(highest, pool.level);
    volume += pool.volume;
  }
  EXPECT_GT(highest - lowest, 5.0);
  EXPECT_NEAR(volume / fluid.LumenVolume(), 0.2, 0.001);
}

INSTANTIATE_TEST_SUITE_P(ColonPhantomImageSource,
                         EachPosition,
                         testing::Values("supine", "prone", "leftDecubitus", "rightDecubitus"));

// A point on the centerline in gas above sufficiently deep fluid.
Eigen::Vector3d
PlaceOverFluid(Source * source)
{
  const auto            line = source->GetAnatomy().Centerline();
  const Eigen::VectorXd arcLength = shapeton::PointValues(line, "arcLength", "centerline");
  const Eigen::VectorXd radius = shapeton::PointValues(line, "radius", "centerline");
  for (const int vertex : line.curves[0])
  {
    const Eigen::Vector3d place = line.V.row(vertex);
    const double          depth = source->GetFluid().DepthBelowLevel(place, arcLength[vertex]);
    if (arcLength[vertex] > 150.0 && depth < -3.0 && depth > 12.0 - radius[vertex])
    {
      return place;
    }
  }
  throw std::logic_error("no place over fluid");
}

void
CenterOver(Source * source, const Eigen::Vector3d & place)
{
  source->CenterOutput();
  auto origin = source->GetOrigin();
  for (unsigned int i = 0; i < 3; ++i)
  {
    origin[i] += place[i];
  }
  source->SetOrigin(origin);
}

itk::Index<3>
IndexAt(const itk::ImageBase<3> * image, const Eigen::Vector3d & point)
{
  const double values[3] = { point[0], point[1], point[2] };
  return image->TransformPhysicalPointToIndex(itk::Point<double, 3>(values));
}

void
ExpectThatSkippingChangesNothing(Source * source, const std::vector<itk::Index<3>> & indices)
{
  const auto &            structures = source->GetStructures();
  const auto              bodies = shapeton::MakeColonAbdomen(source->GetAnatomy(), source->GetFluid(), structures);
  shapeton::PhantomBodies all;
  for (const auto & body : bodies)
  {
    all.push_back(std::make_shared<NeverSkipped>(body));
  }
  const shapeton::BodySampler fast(bodies, source->GetOutput(), { { 0.75, 0.75, 0.75 } }, shapeton::airIntensity);
  const shapeton::BodySampler slow(all, source->GetOutput(), { { 0.75, 0.75, 0.75 } }, shapeton::airIntensity);
  itk::ImageRegion<3>         tile;
  tile.SetSize({ { 12, 12, 12 } });
  for (const auto & index : indices)
  {
    tile.SetIndex(index);
    const auto quick = fast.Sample(tile);
    const auto exact = slow.Sample(tile);
    double     largest = 0.0;
    for (std::size_t i = 0; i < quick.size(); ++i)
    {
      largest = std::max(largest, std::abs(static_cast<double>(quick[i]) - exact[i]));
    }
    EXPECT_LT(largest, 0.5) << source->GetParameters().preset << ' ' << source->GetParameters().lungs << ' ' << index;
  }
}

TEST(ColonPhantomImageSource, SkippingBlocksChangesNothing)
{
  auto realistic = shapeton::ColonPhantomPreset("realistic");
  realistic.catheter = "rigid";
  realistic.balloon = "gas";
  realistic.ileumContent = "fluid";
  for (const auto & parameters : { Standard("supine", 0.25), realistic })
  {
    const auto source = MakeSource(parameters, 256);
    source->UpdateOutputInformation();
    ExpectThatSkippingChangesNothing(source,
                                     { { { 40, 130, 90 } },
                                       { { 190, 150, 130 } },
                                       { { 120, 80, 100 } },
                                       { { 60, 90, 215 } },
                                       IndexAt(source->GetOutput(), source->GetAnatomy().Valve().base),
                                       IndexAt(source->GetOutput(), source->GetStructures().GetCatheter()->tip) });
  }
}

// Hilum, fissures, an apex, the diaphragm, shoulder blade, breastbone.
TEST(ColonPhantomImageSource, SkippingBlocksChangesNothingInTheChest)
{
  for (const char * lungs : { "inspiration", "emphysema" })
  {
    auto parameters = Standard("supine", 0.25);
    parameters.lungs = lungs;
    const auto   source = MakeSource(parameters, 256);
    const double center[3] = { 0.0, 0.0, 240.0 };
    source->CenterOutput(Source::PointType(center));
    source->UpdateOutputInformation();
    std::vector<itk::Index<3>> indices;
    for (const Eigen::Vector3d & place : { Eigen::Vector3d(-50, 10, 235),
                                           Eigen::Vector3d(-70, 20, 205),
                                           Eigen::Vector3d(50, 20, 320),
                                           Eigen::Vector3d(-75, 0, 175),
                                           Eigen::Vector3d(95, 80, 275),
                                           Eigen::Vector3d(-8, -95, 250) })
    {
      indices.push_back(IndexAt(source->GetOutput(), place));
    }
    ExpectThatSkippingChangesNothing(source, indices);
  }
}

TEST(ColonPhantomImageSource, PolypsOfRealisticPatientsAreSoftTissueThroughout)
{
  auto parameters = shapeton::ColonPhantomPreset("realistic");
  parameters.noise = 0.0;
  parameters.stool = 0;
  parameters.polyps = 4;
  const auto source = MakeSource(parameters, 9, 6.3);
  int        large = 0;
  for (const shapeton::ColonPolyp & polyp : source->GetAnatomy().Polyps())
  {
    if (polyp.kind == "sessile" && polyp.height > 5.0)
    {
      const Eigen::Vector3d axis = (polyp.position - polyp.base).normalized();
      CenterOver(source, polyp.base + 1.5 * axis);
      source->UpdateLargestPossibleRegion();
      EXPECT_NEAR(source->GetOutput()->GetPixel({ { 4, 4, 4 } }), 50, 15) << polyp.id;
      ++large;
    }
  }
  EXPECT_GT(large, 0);
}

// Reference by voxel centers, without skipping blocks.
TEST(ColonPhantomImageSource, StructuresAreThoseAtTheVoxels)
{
  auto parameters = shapeton::ColonPhantomPreset("realistic");
  parameters.seed = 2;
  const auto source = MakeSource(parameters, 48, 96.0);
  CenterOver(source, source->GetAnatomy().Valve().base);
  source->TruthOnlyOn();
  source->Update();
  const auto         labels = source->GetStructureOutput();
  std::map<int, int> counts;
  basetest::ForVoxels(labels, [&](const auto & index, const auto & point) {
    const auto structure = source->GetStructures().At(basetest::ToEigen(point));
    ASSERT_EQ(labels->GetPixel(index), static_cast<int>(structure)) << index;
    ++counts[labels->GetPixel(index)];
  });
  EXPECT_GT(counts[1], 100);
  EXPECT_GT(counts[2] + counts[3], 100);
}

TEST(ColonPhantomImageSource, GasAndFluidHaveTheirIntensities)
{
  auto parameters = Standard("supine", 0.3);
  parameters.noise = 10.0;
  const auto source = MakeSource(parameters, 40, 56.0);
  CenterOver(source, PlaceOverFluid(source));
  source->UpdateLargestPossibleRegion();
  const auto gas = IntensityOf(source, 1, 3.5);
  ASSERT_GT(gas.count, 300U);
  EXPECT_NEAR(gas.mean, -994.0, 3.0);
  EXPECT_NEAR(gas.deviation, 10.0, 1.5);
  const auto fluid = IntensityOf(source, 2, 3.5);
  ASSERT_GT(fluid.count, 100U);
  EXPECT_GT(fluid.mean, 230.0); // an unmixed wedge
  EXPECT_LT(fluid.mean, 880.0);
}

TEST(ColonPhantomImageSource, SameBytesForAnyNumberOfThreads)
{
  for (const auto & [preset, lungs, center] : { std::tuple("standard", "plain", 0.0),
                                                { "hard", "plain", 0.0 },
                                                { "realistic", "plain", 0.0 },
                                                { "standard", "emphysema", 240.0 } })
  {
    auto parameters = shapeton::ColonPhantomPreset(preset);
    parameters.seed = 3;
    parameters.position = "prone";
    parameters.lungs = lungs;
    const auto   source = MakeSource(parameters, 36);
    const double middle[3] = { 0.0, 0.0, center };
    source->CenterOutput(Source::PointType(middle));
    std::set<std::string> images;
    for (const unsigned int threads : { 1U, 2U, 3U })
    {
      source->SetNumberOfWorkUnits(threads);
      source->Modified();
      source->UpdateLargestPossibleRegion();
      images.insert(basetest::BytesOf(source->GetOutput()) + basetest::BytesOf(source->GetLumenOutput()) +
                    basetest::BytesOf(source->GetSegmentOutput()) + basetest::BytesOf(source->GetStructureOutput()));
    }
    EXPECT_EQ(images.size(), 1U) << preset << ' ' << lungs;
  }
}

// Axes z, -x, -y of the first grid, with the same voxels in space.
TEST(ColonPhantomImageSource, TheTruthAloneIsThatOfTheImage)
{
  const auto whole = MakeSource(Standard("prone", 0.3), 48);
  const auto truth = MakeSource(Standard("prone", 0.3), 48);
  truth->TruthOnlyOn();
  whole->Update();
  truth->Update();
  const auto   pixels = whole->GetLumenOutput()->GetLargestPossibleRegion().GetNumberOfPixels();
  const auto * lumen = truth->GetLumenOutput()->GetBufferPointer();
  const auto * segments = truth->GetSegmentOutput()->GetBufferPointer();
  EXPECT_TRUE(std::equal(lumen, lumen + pixels, whole->GetLumenOutput()->GetBufferPointer()));
  EXPECT_TRUE(std::equal(segments, segments + pixels, whole->GetSegmentOutput()->GetBufferPointer()));
  EXPECT_GT(std::count(lumen, lumen + pixels, 1), 100);
  EXPECT_EQ(truth->GetOutput()->GetBufferedRegion().GetNumberOfPixels(), 0U);
}

TEST(ColonPhantomImageSource, AnObliqueGridSamplesTheSameLumen)
{
  auto parameters = Standard("supine", 0.3);
  parameters.noise = 0.0;
  const auto source = MakeSource(parameters, 40, 56.0);
  source->SetDirection(basetest::Rotation(1, std::asin(0.6)));
  CenterOver(source, PlaceOverFluid(source));
  source->UpdateLargestPossibleRegion();
  const auto  lumen = source->GetLumenOutput();
  std::size_t gas = 0;
  std::size_t fluid = 0;
  basetest::ForVoxels(lumen, [&](const auto & index, const auto & p) {
    const auto point = basetest::ToEigen(p);
    const auto sample = source->GetAnatomy().Evaluate(point);
    EXPECT_EQ(lumen->GetPixel(index) != 0, sample.distance > 0.0);
    EXPECT_EQ(source->GetSegmentOutput()->GetPixel(index), sample.distance > 0.0 ? sample.segment : 0);
    const double depth = source->GetFluid().DepthBelowLevel(point, sample.arcLength);
    if (lumen->GetPixel(index) != 0 && sample.distance >= 4.5 && std::abs(depth) >= 4.5)
    {
      const double expected = depth > 0.0 ? source->GetFluid().Intensity(point, sample.arcLength) : -994.0;
      EXPECT_EQ(lumen->GetPixel(index), depth > 0.0 ? 2 : 1);
      EXPECT_NEAR(source->GetOutput()->GetPixel(index), expected, 40.0);
      gas += depth < 0.0;
      fluid += depth > 0.0;
    }
  });
  EXPECT_GT(gas, 300U);
  EXPECT_GT(fluid, 50U);
}
