#include "shapetonColonPhantomImageSource.h"
#include "shapetonPi.h"
#include "shapetonTestErrors.h"
#include "shapetonTestFrames.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <vector>

using Eigen::Vector3d;
using shapeton::ColonStructure;

namespace
{
shapeton::ColonPhantomParameters
Realistic(unsigned seed, const std::string & position = "supine")
{
  auto parameters = shapeton::ColonPhantomPreset("realistic");
  parameters.seed = seed;
  parameters.position = position;
  return parameters;
}

/** An examination with its complete ground truth. */
struct Exam
{
  explicit Exam(const shapeton::ColonPhantomParameters & parameters)
    : anatomy(parameters), fluid(anatomy), structures(anatomy, fluid)
  {}
  shapeton::ColonAnatomy    anatomy;
  shapeton::ColonFluid      fluid;
  shapeton::ColonStructures structures;
};

std::vector<Vector3d>
AxisOf(const shapeton::ColonStructures & structures, ColonStructure structure)
{
  const shapeton::CurveSet     curves = structures.Axes();
  const shapeton::SurfaceArray label = *shapeton::FindSurfaceArray(curves.cellArrays, "structure");
  std::vector<Vector3d>        axis;
  for (std::size_t i = 0; i < curves.curves.size(); ++i)
  {
    for (std::size_t k = 0; label.values(i, 0) == static_cast<int>(structure) && k < curves.curves[i].size(); ++k)
    {
      axis.push_back(curves.V.row(curves.curves[i][k]));
    }
  }
  return axis;
}

// HU at points, without blur, noise or slice profile.
std::vector<double>
IntensitiesAt(const shapeton::ColonPhantomParameters & parameters, const std::vector<Vector3d> & points)
{
  std::vector<double> values;
  const auto          source = shapeton::ColonPhantomImageSource::New();
  auto                noiseless = parameters;
  noiseless.noise = 0.0;
  noiseless.sliceThickness = 0.0;
  source->SetParameters(noiseless);
  source->SetBlur(0.0);
  source->SetSize({ { 2, 2, 2 } });
  const double spacing[3] = { 0.1, 0.1, 0.1 };
  source->SetSpacing(spacing);
  for (const Vector3d & p : points)
  {
    const double origin[3] = { p[0] - 0.05, p[1] - 0.05, p[2] - 0.05 };
    source->SetOrigin(origin);
    source->UpdateLargestPossibleRegion();
    values.push_back(source->GetOutput()->GetBufferPointer()[0]);
  }
  return values;
}
} // namespace

TEST(ColonValve, LipsStandAroundAMouth)
{
  for (unsigned seed = 1; seed <= 2; ++seed)
  {
    const shapeton::ColonAnatomy anatomy(Realistic(seed));
    const shapeton::ColonValve   valve = anatomy.Valve();
    const auto                   distanceAt = [&](const Vector3d & p) { return anatomy.Evaluate(p).distance; };
    EXPECT_EQ(valve.kind, "lips");
    EXPECT_NEAR(valve.direction.dot(valve.slit), 0.0, 1e-9);
    for (const Vector3d & crest : { valve.upperLip, valve.lowerLip })
    {
      EXPECT_LT(std::abs(distanceAt(crest)), 0.2) << seed;
      EXPECT_LT(distanceAt(crest - valve.direction), -0.5) << seed;
      EXPECT_NEAR((crest - valve.base).dot(valve.direction), valve.height, 1e-9);
      // The point above the mouth is below the crests.
      EXPECT_GT((crest - valve.mouth).dot(valve.direction), 0.08 * valve.height);
    }
    EXPECT_LT(std::abs(distanceAt(valve.mouth)), 0.2) << seed;
    EXPECT_GT(distanceAt(valve.mouth + valve.direction), 0.2) << seed;
    // The upper lip is closer to the ascending colon.
    EXPECT_LT(anatomy.Evaluate(valve.upperLip + valve.direction).arcLength,
              anatomy.Evaluate(valve.lowerLip + valve.direction).arcLength);
    EXPECT_EQ(anatomy.SegmentAt(valve.arcLength - 1.0), 5);
    EXPECT_EQ(anatomy.SegmentAt(valve.arcLength + 1.0), 6);
    for (const shapeton::ColonPolyp & polyp : anatomy.Polyps())
    {
      EXPECT_GT((polyp.base - valve.base).norm(), 0.5 * polyp.diameter + 3.0) << seed;
    }
  }
}

TEST(ColonValve, IsThePatients)
{
  const shapeton::ColonValve supine = shapeton::ColonAnatomy(Realistic(2)).Valve();
  const shapeton::ColonValve prone = shapeton::ColonAnatomy(Realistic(2, "prone")).Valve();
  EXPECT_EQ(supine.length, prone.length);
  EXPECT_EQ(supine.height, prone.height);
  EXPECT_EQ(supine.thickness, prone.thickness);
  EXPECT_NEAR(supine.arcLength / prone.arcLength, 1.0, 0.08);
}

TEST(ColonValve, PoleIsTheFarthestOfTheCecum)
{
  for (const auto & parameters : { shapeton::ColonPhantomPreset("standard"), Realistic(3) })
  {
    const shapeton::ColonAnatomy anatomy(parameters);
    const Vector3d               pole = anatomy.CecalPole();
    EXPECT_LT(std::abs(anatomy.Evaluate(pole).distance), 0.2) << parameters.preset;
    const shapeton::CurveSet line = anatomy.Centerline();
    const Eigen::VectorXd    arcLength = shapeton::PointValues(line, "arcLength", "centerline");
    const double             valve = anatomy.Valve().arcLength;
    Eigen::Index             at = 0;
    (arcLength.array() - valve).abs().minCoeff(&at);
    const Vector3d           mouth = line.V.row(at);
    const shapeton::CurveSet wall = anatomy.Correspondence();
    const Eigen::VectorXd    segment = shapeton::PointValues(wall, "segment", "wall");
    for (Eigen::Index i = 0; i < wall.V.rows(); ++i)
    {
      const double distance = (wall.V.row(i).transpose() - mouth).norm();
      EXPECT_TRUE(segment[i] != 6 || distance < (pole - mouth).norm() + 3.0) << parameters.preset;
    }
  }
}

TEST(ColonStructures, IleumLeavesTheMouthAndTheColon)
{
  int open = 0;
  for (unsigned seed = 1; seed <= 4; ++seed)
  {
    auto parameters = Realistic(seed);
    parameters.ileumContent = "gas";
    parameters.fluid = 0.05;
    const Exam exam(parameters);
    const auto valve = exam.anatomy.Valve();
    const auto axis = AxisOf(exam.structures, ColonStructure::Ileum);
    ASSERT_NE(exam.structures.GetIleum(), nullptr);
    EXPECT_GT(exam.structures.GetIleum()->length, 35.0) << seed;
    EXPECT_LT((axis[0] - valve.mouth).norm(), 2.0);
    EXPECT_GT((axis.back() - valve.mouth).norm(), 25.0) << seed;
    for (std::size_t i = 15; i + 2 < axis.size(); ++i)
    {
      EXPECT_EQ(exam.structures.At(axis[i]), ColonStructure::Ileum) << seed << ' ' << i;
      EXPECT_LT(exam.anatomy.Evaluate(axis[i]).distance, 0.0) << seed << ' ' << i;
    }
    const bool isOpen = exam.structures.GetIleum()->isOpen;
    open += isOpen ? 1 : 0;
    const auto below = exam.structures.At(valve.mouth - 0.5 * valve.direction);
    EXPECT_EQ(below, isOpen ? ColonStructure::Ileum : ColonStructure::IleumWall) << seed;
  }
  EXPECT_GT(open, 0);
}

// Through the open valve, one tube outside the colon, with the same length in both positions.
TEST(ColonStructures, RefluxFillsTheSameIleumInBothPositions)
{
  for (const unsigned seed : { 14U, 20U, 45U })
  {
    std::map<std::string, double> lengths;
    for (const char * position : { "supine", "prone" })
    {
      const Exam         exam(Realistic(seed, position));
      const auto * const ileum = exam.structures.GetIleum();
      const auto         axis = AxisOf(exam.structures, ColonStructure::Ileum);
      ASSERT_TRUE(ileum->isRefluxed && ileum->isOpen) << seed;
      EXPECT_EQ(ileum->content, "gas");
      EXPECT_TRUE(ileum->bore >= 10.0 && ileum->bore <= 25.0) << seed;
      EXPECT_TRUE(ileum->length >= 50.0 && ileum->length <= 1500.0) << seed;
      // Loops that touch the colon are flattened; the slit is narrower.
      EXPECT_NEAR(1000.0 * ileum->volume / (0.25 * shapeton::Pi * ileum->bore * ileum->bore * ileum->length), 0.9, 0.2)
        << seed;
      lengths[position] = ileum->length;
      EXPECT_GT(exam.anatomy.Evaluate(axis[0]).distance, 0.0);
      for (std::size_t i = 1; i < axis.size(); ++i)
      {
        EXPECT_EQ(exam.structures.At(axis[i]), ColonStructure::Ileum) << seed << ' ' << position << ' ' << i;
        EXPECT_TRUE(i < 15 || exam.anatomy.Evaluate(axis[i]).distance < -2.0) << seed << ' ' << position << ' ' << i;
      }
    }
    EXPECT_NEAR(lengths["supine"] / lengths["prone"], 1.0, 0.1) << seed;
  }
}

TEST(ColonStructures, RefluxedIleumTouchesTheLumenAtTheValveOnly)
{
  const auto source = shapeton::ColonPhantomImageSource::New();
  source->SetParameters(Realistic(45));
  source->TruthOnlyOn();
  source->SetSize({ { 180, 180, 170 } });
  source->SetSpacing(shapeton::ColonPhantomImageSource::SpacingType(2.0));
  source->CenterOutput();
  source->Update();
  const auto * const  lumen = source->GetLumenOutput();
  const auto * const  structures = source->GetStructureOutput();
  const unsigned char ileum = static_cast<unsigned char>(ColonStructure::Ileum);
  const Vector3d      mouth = source->GetAnatomy().Valve().mouth;
  std::size_t         voxels = 0;
  basetest::ForVoxels(structures, [&](const auto & index, const auto &) {
    for (unsigned int side = 0; side < 6 && structures->GetPixel(index) == ileum; ++side)
    {
      auto next = index;
      next[side / 2] += side % 2 == 0 ? 1 : -1;
      itk::Point<double, 3> p;
      lumen->TransformIndexToPhysicalPoint(next, p);
      voxels += side == 0;
      EXPECT_EQ(lumen->GetPixel(index), 0);
      EXPECT_TRUE(lumen->GetPixel(next) == 0 || (basetest::ToEigen(p) - mouth).norm() < 15.0) << p;
    }
  });
  EXPECT_NEAR(8.0 * static_cast<double>(voxels) / 1000.0, source->GetStructures().GetIleum()->volume, 2.0);
}

TEST(ColonStructures, WhatTheScannerSees)
{
  auto parameters = Realistic(4);
  parameters.valveFat = 0.8125;
  parameters.valveHeight = 14.0;
  parameters.ileumContent = "fluid";
  const Exam            exam(parameters);
  const auto            valve = exam.anatomy.Valve();
  const auto            axis = AxisOf(exam.structures, ColonStructure::Ileum);
  const Vector3d        inLip = valve.upperLip - 6.0 * valve.direction;
  std::vector<Vector3d> points{ inLip, valve.upperLip - 1.0 * valve.direction, axis[axis.size() - 4] };
  ASSERT_EQ(exam.structures.At(inLip), ColonStructure::Valve);
  const auto values = IntensitiesAt(parameters, points);
  EXPECT_NEAR(values[0], -80.0, 2.0);
  EXPECT_NEAR(values[1], 50.0, 2.0);
  EXPECT_NEAR(values[2], exam.structures.GetIleum()->intensity, 2.0);
}

// Promontory, crest and pubis define the pelvic brim.
TEST(ColonStructures, BonesOfThePelvisAreInPlace)
{
  const std::vector<Vector3d> bones{ { 0, 72, -35 },    { 0, 80, -60 },   { 136, 34, -40 },
                                     { -136, 34, -40 }, { 8, -66, -150 }, { -8, -66, -150 } };
  const std::vector<double>   intensities = IntensitiesAt(Realistic(11), bones);
  for (std::size_t i = 0; i < bones.size(); ++i)
  {
    EXPECT_GT(intensities[i], 150.0) << bones[i].transpose();
  }
  EXPECT_NEAR(IntensitiesAt(Realistic(11), { { 0, -66, -150 } })[0], 100.0, 1.0); // the disc of the symphysis
  for (unsigned seed = 1; seed <= 10; ++seed)
  {
    const shapeton::ColonAnatomy anatomy(Realistic(seed));
    EXPECT_LT(anatomy.Evaluate({ 8, -66, -140 }).distance, -3.0) << seed;
    EXPECT_LT(anatomy.Evaluate({ 38, -58, -138 }).distance, -3.0) << seed;
    EXPECT_LT(anatomy.Evaluate({ -38, -58, -138 }).distance, -3.0) << seed;
  }
}

// Visits points of the lumen that are less than `reach` mm from the centerline between two arc lengths.
template <typename TVisitor>
void
VisitStretch(const shapeton::ColonAnatomy & anatomy, double begin, double end, double reach, const TVisitor & visit)
{
  constexpr double         step = 3.0; // mm
  const shapeton::CurveSet line = anatomy.Centerline();
  const Eigen::VectorXd    arcs = shapeton::PointValues(line, "arcLength", "centerline");
  for (Eigen::Index i = 0; i < line.V.rows(); ++i)
  {
    for (int n = 0; n < 1000 && arcs[i] >= begin && arcs[i] < end; ++n)
    {
      const Vector3d offset = step * Vector3d(n % 10 - 4.5, n / 10 % 10 - 4.5, n / 100 - 4.5);
      const Vector3d point = line.V.row(i).transpose() + offset;
      const auto     sample = anatomy.Evaluate(point);
      if (offset.norm() < reach && sample.distance > 0.0 && sample.arcLength >= begin && sample.arcLength < end)
      {
        visit(point, sample.arcLength);
      }
    }
  }
}

// Fluid fills the lumen up to a level above the stretch, with gas beyond both ends.
TEST(ColonFluid, AFilledStretchSeparatesGas)
{
  int wanted = 0;
  int found = 0;
  for (unsigned seed = 1; seed <= 13; ++seed)
  {
    const shapeton::ColonAnatomy anatomy(Realistic(seed, seed % 2 == 0 ? "supine" : "prone"));
    const double                 length = anatomy.GetParameters().filledStretch;
    if (length == 0.0)
    {
      continue;
    }
    ++wanted;
    const shapeton::ColonFluid fluid(anatomy);
    const auto [begin, end] = fluid.FilledStretch();
    if (end == begin)
    {
      continue;
    }
    ++found;
    EXPECT_GT(end - begin, 29.0) << seed;
    EXPECT_LT(end - begin, length + 50.0) << seed;
    EXPECT_TRUE(anatomy.SegmentAt(begin + 1.0) >= 2 && anatomy.SegmentAt(end - 1.0) <= 3) << seed;
    const auto dryBetween = [&](double from, double to) {
      int dry = 0;
      VisitStretch(
        anatomy, from, to, 20.0, [&](const Vector3d & p, double s) { dry += fluid.DepthBelowLevel(p, s) < 0.0; });
      return dry;
    };
    EXPECT_EQ(dryBetween(begin, end), 0) << seed;
    EXPECT_GT(dryBetween(begin - 20.0, begin), 0) << seed;
    EXPECT_GT(dryBetween(end, end + 20.0), 0) << seed;
    // One level on both sides.
    const shapeton::CurveSet line = anatomy.Centerline();
    const Eigen::VectorXd    arcs = shapeton::PointValues(line, "arcLength", "centerline");
    std::vector<double>      levels;
    for (Eigen::Index i = 0; i < line.V.rows(); ++i)
    {
      if (arcs[i] > begin - 2.0 && arcs[i] < end + 2.0)
      {
        const Vector3d point = line.V.row(i);
        levels.push_back(fluid.DepthBelowLevel(point, arcs[i]) - fluid.Down().dot(point));
      }
    }
    EXPECT_NEAR(*std::min_element(levels.begin(), levels.end()), *std::max_element(levels.begin(), levels.end()), 1e-6);
  }
  EXPECT_GE(wanted, 4);
  EXPECT_GE(found, wanted - 1);
}

// Within the stretch, the fluid surface falls along the colon with the given slope; elsewhere it is horizontal.
TEST(ColonFluid, ATiltedLevelFallsAlongTheColon)
{
  int found = 0;
  for (unsigned seed = 10; seed <= 24; ++seed)
  {
    const double wanted = shapeton::Drawn(Realistic(seed)).levelSlope;
    EXPECT_TRUE(wanted == 0.0 || (wanted >= 0.15 && wanted <= 0.35)) << seed;
    const shapeton::ColonAnatomy anatomy(Realistic(seed));
    const shapeton::ColonFluid   fluid(anatomy);
    const auto &                 tilted = fluid.GetTiltedLevel();
    if (wanted == 0.0 || tilted.slope == 0.0)
    {
      EXPECT_EQ(tilted.slope, 0.0) << seed;
      continue;
    }
    ++found;
    EXPECT_EQ(tilted.slope, wanted) << seed;
    const auto [low, high] = std::minmax(tilted.begin, tilted.end);
    EXPECT_TRUE(high - low > 19.0 && high - low < 37.0) << seed;
    const Vector3d down = fluid.Down();
    const auto depthAt = [&](const Vector3d & p) { return fluid.DepthBelowLevel(p, anatomy.Evaluate(p).arcLength); };
    std::vector<double> slopes;
    int                 gas = 0;
    int                 liquid = 0;
    VisitStretch(anatomy, low + 2.0, high - 2.0, 20.0, [&](const Vector3d & p, double s) {
      const double depth = fluid.DepthBelowLevel(p, s);
      ++(depth > 0.0 ? liquid : gas);
      if (std::abs(depth) < 2.0)
      {
        Vector3d gradient;
        for (int axis = 0; axis < 3; ++axis)
        {
          const Vector3d step = 0.2 * Vector3d::Unit(axis);
          gradient[axis] = (depthAt(p + step) - depthAt(p - step)) / 0.4;
        }
        slopes.push_back((gradient - gradient.dot(down) * down).norm() / gradient.dot(down));
      }
    });
    ASSERT_GT(slopes.size(), 20U) << seed;
    EXPECT_GT(gas, 20) << seed;
    EXPECT_GT(liquid, 20) << seed;
    std::nth_element(slopes.begin(), slopes.begin() + slopes.size() / 2, slopes.end());
    EXPECT_NEAR(slopes[slopes.size() / 2], wanted, 0.25 * wanted) << seed;
  }
  EXPECT_GE(found, 3);
}

// Areas (mm^2) of a patient's connected fluid levels.
std::vector<double>
AreasOfLevels(const shapeton::ColonAnatomy & anatomy, const shapeton::ColonFluid & fluid)
{
  constexpr double step = 1.0;  // mm
  constexpr int    block = 12;  // steps; half the diagonal is below ColonAnatomy::Reach
  constexpr double above = 0.1; // mm; half of the thickness of a level
  const Vector3d   up = -fluid.Down();
  const Vector3d   across = up.unitOrthogonal();
  const Vector3d   along = up.cross(across);
  Vector3d         low;
  Vector3d         high;
  anatomy.BoundingBox(0.0, low, high);
  const Vector3d      center = 0.5 * (low + high);
  const int           half = block * static_cast<int>(std::ceil(0.5 * (high - low).norm() / (block * step)));
  std::vector<double> areas;
  for (const shapeton::ColonPool & pool : fluid.Pools())
  {
    const auto pointAt = [&](double u, double v) {
      const Vector3d point = center + step * (u * across + v * along);
      return Vector3d(point + (pool.level - up.dot(point)) * up);
    };
    std::set<std::pair<int, int>> level;
    for (int u = -half; u < half; ++u)
    {
      for (int v = -half; v < half; ++v)
      {
        if (v % block == 0 && anatomy.Evaluate(pointAt(u, v + 0.5 * block)).distance <= -shapeton::ColonAnatomy::Reach)
        {
          v += block - 1; // no lumen in this row of points
          continue;
        }
        const Vector3d point = pointAt(u, v);
        const auto     sample = anatomy.Evaluate(point);
        if (sample.distance > 0.0 && std::abs(fluid.DepthBelowLevel(point, sample.arcLength)) < above)
        {
          level.insert({ u, v });
        }
      }
    }
    while (!level.empty())
    {
      std::vector<std::pair<int, int>> piece{ *level.begin() };
      level.erase(level.begin());
      for (std::size_t i = 0; i < piece.size(); ++i)
      {
        const auto [u, v] = piece[i];
        for (const auto & next : { std::make_pair(u - 1, v), { u + 1, v }, { u, v - 1 }, { u, v + 1 } })
        {
          if (level.erase(next) > 0)
          {
            piece.push_back(next);
          }
        }
      }
      areas.push_back(step * step * static_cast<double>(piece.size()));
    }
  }
  return areas;
}

// The measured levels include those of the ground truth.
TEST(ColonFluid, SomeLevelsAreSmall)
{
  int found = 0;
  for (const unsigned seed : { 6U, 11U, 17U })
  {
    const shapeton::ColonAnatomy anatomy(Realistic(seed));
    const shapeton::ColonFluid   fluid(anatomy);
    const auto                   areas = AreasOfLevels(anatomy, fluid);
    EXPECT_LE(fluid.SmallLevels().size(), static_cast<std::size_t>(anatomy.GetParameters().smallLevels)) << seed;
    for (const shapeton::SmallLevel & level : fluid.SmallLevels())
    {
      ++found;
      EXPECT_TRUE(level.area >= 20.0 && level.area <= 60.0) << seed;
      EXPECT_GE(level.depth, 0.75) << seed;
      EXPECT_NEAR(fluid.DepthBelowLevel(level.position, level.arcLength), 0.0, 1e-6) << seed;
      EXPECT_TRUE(std::any_of(
        areas.begin(), areas.end(), [&level](double area) { return std::abs(area - level.area) < 0.2 * level.area; }))
        << seed << ' ' << level.area;
    }
  }
  EXPECT_GE(found, 2);
}

// Walls touch, lumens do not.
TEST(ColonStructures, ALoopOfIleumTouchesTheSigmoid)
{
  int found = 0;
  for (unsigned seed = 2; seed <= 8; ++seed)
  {
    auto parameters = Realistic(seed);
    parameters.ileumReflux = "none";
    const Exam         exam(parameters);
    const auto * const contact = exam.structures.GetSigmoidContact();
    const double       wanted = exam.anatomy.GetParameters().sigmoidContact;
    const auto         axis = AxisOf(exam.structures, ColonStructure::SmallBowel);
    EXPECT_EQ(contact == nullptr, axis.empty()) << seed;
    if (!contact)
    {
      continue;
    }
    ++found;
    EXPECT_TRUE(wanted >= 40.0 && wanted <= 80.0) << seed;
    EXPECT_GT(contact->length, 18.0) << seed;
    EXPECT_LT(contact->length, 90.0) << seed;
    EXPECT_EQ(exam.anatomy.SegmentAt(contact->arcLength[0]), 2) << seed;
    EXPECT_EQ(exam.anatomy.SegmentAt(contact->arcLength[1]), 2) << seed;
    int                   touching = 0;
    std::vector<Vector3d> between;
    for (std::size_t i = 1; i + 1 < axis.size(); ++i)
    {
      const Vector3d along = (axis[i + 1] - axis[i - 1]).normalized();
      bool           touches = false;
      for (int n = 0; n < 24; ++n)
      {
        const Vector3d side = Eigen::AngleAxisd(shapeton::Pi / 12.0 * n, along) * along.unitOrthogonal();
        // The last point of the loop in this direction.
        double r = 0.5 * contact->bore;
        while (r > 0.0 && exam.structures.At(axis[i] + r * side) != ColonStructure::SmallBowel)
        {
          r -= 0.25;
        }
        const double gap = -exam.anatomy.Evaluate(axis[i] + r * side).distance;
        EXPECT_GT(gap, 3.4) << seed;
        if (gap < 3.6)
        {
          touches = true;
          between.push_back(axis[i] + (r + 1.75) * side);
        }
      }
      touching += touches ? 1 : 0;
    }
    EXPECT_GT(touching, static_cast<int>(axis.size() / 2)) << seed;
    const auto values = IntensitiesAt(parameters, { axis[axis.size() / 2], between[between.size() / 2] });
    EXPECT_NEAR(values[0], contact->intensity, 2.0) << seed;
    EXPECT_NEAR(values[1], 50.0, 2.0) << seed;
  }
  EXPECT_GE(found, 2);
}

TEST(ColonStructures, SpasmsAreNarrow)
{
  int found = 0;
  for (unsigned seed = 1; seed <= 16; ++seed)
  {
    const auto   drawn = shapeton::Drawn(Realistic(seed));
    const double length = drawn.spasm;
    EXPECT_TRUE(length == 0.0 || (length >= 50.0 && length <= 150.0)) << seed;
    if (length == 0.0)
    {
      continue;
    }
    const shapeton::ColonAnatomy anatomy(Realistic(seed));
    const shapeton::CurveSet     line = anatomy.Centerline();
    const auto &                 arcs = shapeton::FindSurfaceArray(line.pointArrays, "arcLength")->values;
    const auto &                 radii = shapeton::FindSurfaceArray(line.pointArrays, "radius")->values;
    double                       narrow = 0.0;
    for (Eigen::Index i = 1; i < line.V.rows(); ++i)
    {
      const bool isNarrow = 2.0 * radii(i, 0) >= 7.5 && 2.0 * radii(i, 0) <= 14.5;
      narrow += isNarrow && anatomy.SegmentAt(arcs(i, 0)) == 2 ? arcs(i, 0) - arcs(i - 1, 0) : 0.0;
    }
    EXPECT_GT(narrow, 0.8 * length) << seed;
    ++found;
  }
  EXPECT_GE(found, 2);
}

TEST(ColonStructures, CatheterIsARingOfItsSize)
{
  for (const char * kind : { "central", "rigid", "soft" })
  {
    auto parameters = Realistic(5);
    parameters.catheter = kind;
    parameters.balloon = "none";
    parameters.catheterHoles = 1;
    const Exam exam(parameters);
    const auto catheter = *exam.structures.GetCatheter();
    const auto axis = AxisOf(exam.structures, ColonStructure::Catheter);
    EXPECT_EQ(catheter.tip, axis.back());
    const double          outer = 0.5 * catheter.bore + catheter.wall;
    std::vector<Vector3d> bore, wall;
    ASSERT_GE(axis.size(), 8U) << kind;
    for (std::size_t i = 7; i + 3 < axis.size(); ++i)
    {
      const Vector3d along = (axis[i + 1] - axis[i - 1]).normalized();
      const Vector3d side = Eigen::AngleAxisd(0.8 * i, along) * along.unitOrthogonal();
      EXPECT_EQ(exam.structures.At(axis[i] + (outer - 0.1) * side), ColonStructure::Catheter) << kind;
      EXPECT_NE(exam.structures.At(axis[i] + (outer + 0.5) * side), ColonStructure::Catheter) << kind;
      EXPECT_GT(exam.anatomy.Evaluate(axis[i]).distance, outer - 0.1) << kind;
      if (i % 4 == 0)
      {
        bore.push_back(axis[i]);
        wall.push_back(axis[i] + (outer - 0.5 * catheter.wall) * side);
      }
    }
    for (const double value : IntensitiesAt(parameters, bore))
    {
      EXPECT_NEAR(value, -994.0, 2.0) << kind;
    }
    for (const double value : IntensitiesAt(parameters, wall))
    {
      EXPECT_NEAR(value, catheter.intensity, 2.0) << kind;
    }
  }
}

TEST(ColonStructures, BalloonFillsWhatTheRectumLeaves)
{
  auto parameters = Realistic(6);
  parameters.catheter = "soft";
  parameters.balloonDiameter = 30.0;
  for (const char * content : { "gas", "fluid" })
  {
    parameters.balloon = content;
    const Exam exam(parameters);
    const auto catheter = *exam.structures.GetCatheter();
    ASSERT_EQ(catheter.balloon, content);
    EXPECT_GT(catheter.balloonDiameter, 25.0);
    EXPECT_LE(catheter.balloonDiameter, 30.0);
    const double radius = 0.5 * catheter.balloonDiameter;
    EXPECT_GT((catheter.tip - catheter.balloonCenter).norm(), radius);
    for (int n = 0; n < 100; ++n) // on a spiral around the ball
    {
      const double   z = (n - 49.5) / 50.0, across = std::sqrt(1.0 - z * z);
      const Vector3d direction(across * std::cos(2.4 * n), across * std::sin(2.4 * n), z);
      EXPECT_GT(exam.anatomy.Evaluate(catheter.balloonCenter + radius * direction).distance, 0.0) << n;
    }
    const Vector3d side = Vector3d::UnitX();
    EXPECT_EQ(exam.structures.At(catheter.balloonCenter + (radius - 0.5) * side), ColonStructure::Balloon);
    EXPECT_EQ(exam.structures.At(catheter.balloonCenter + (radius + 0.5) * side), ColonStructure::None);
    const auto values = IntensitiesAt(
      parameters, { catheter.balloonCenter + (radius - 2.0) * side, catheter.balloonCenter + (radius - 0.5) * side });
    EXPECT_NEAR(values[0], std::string(content) == "gas" ? -994.0 : 8.0, 2.0);
    EXPECT_NEAR(values[1], 100.0, 2.0);
  }
}

TEST(ColonStructures, ResidueLiesInTheLumenWhereItsKindDoes)
{
  auto parameters = Realistic(2);
  parameters.stool = 12;
  parameters.bubbles = 10;
  parameters.foam = 3;
  const Exam                    exam(parameters);
  std::map<ColonStructure, int> counts;
  for (const shapeton::ColonResidue & one : exam.structures.GetResidue())
  {
    ++counts[one.structure];
    const auto   sample = exam.anatomy.Evaluate(one.position);
    const double depth = exam.fluid.DepthBelowLevel(one.position, sample.arcLength);
    EXPECT_GT(sample.distance, 0.0) << one.kind;
    EXPECT_TRUE(one.structure != ColonStructure::Bubble || depth > 0.5 * one.diameter) << depth;
    EXPECT_TRUE(one.structure != ColonStructure::Foam || (depth < 0.0 && depth > -3.0)) << depth;
    if (one.structure == ColonStructure::Bubble)
    {
      EXPECT_EQ(exam.structures.At(one.position), ColonStructure::Bubble);
    }
    // Residue is only inside the lumen.
    for (int axis = 0; axis < 3; ++axis)
    {
      for (const double side : { -0.3, 0.3 })
      {
        const Vector3d       beside = one.position + side * one.diameter * Vector3d::Unit(axis);
        const ColonStructure structure = exam.structures.At(beside);
        EXPECT_TRUE(structure != one.structure || exam.anatomy.Evaluate(beside).distance > 0.0) << one.kind;
      }
    }
  }
  EXPECT_GE(counts[ColonStructure::Stool], 10);
  EXPECT_GE(counts[ColonStructure::Bubble], 7);
  EXPECT_GE(counts[ColonStructure::Foam], 1);
}

TEST(ColonStructures, DiverticulaHoldWhatTheTruthSays)
{
  auto parameters = Realistic(3);
  parameters.diverticula = 40;
  parameters.stool = parameters.bubbles = parameters.foam = 0;
  parameters.fluid = 0.4;
  const Exam                 exam(parameters);
  std::vector<Vector3d>      points;
  std::map<std::string, int> contents;
  for (const shapeton::ColonDiverticulum & one : exam.structures.GetDiverticula())
  {
    ++contents[one.content];
    // 1 mm above the bottom.
    const Vector3d axis = (one.position - one.mouth).normalized();
    points.push_back(one.position + (0.5 * one.diameter - 1.0) * axis);
    EXPECT_EQ(exam.structures.At(one.position), ColonStructure::Diverticulum) << one.id;
    EXPECT_EQ(exam.structures.At(points.back()), ColonStructure::Diverticulum) << one.id;
    EXPECT_NE(exam.structures.At(one.mouth - 2.0 * axis), ColonStructure::Diverticulum) << one.id;
    const double depth = exam.fluid.DepthBelowLevel(one.position, one.arcLength);
    EXPECT_TRUE(one.content == "stool" || one.content == (depth > 0.0 ? "fluid" : "gas")) << one.id;
    EXPECT_EQ(one.content == "stool", one.intensity > 0.0) << one.id;
  }
  EXPECT_GT(contents["stool"], 1);
  EXPECT_GT(contents["gas"], 1);
  EXPECT_GT(contents["fluid"], 1);
  const auto values = IntensitiesAt(parameters, points);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const auto & one = exam.structures.GetDiverticula()[i];
    const double depth = exam.fluid.DepthBelowLevel(points[i], one.arcLength);
    const double fluid = depth > 0.0 ? exam.fluid.Intensity(points[i], one.arcLength) : -994.0;
    if (one.content == "stool" || std::abs(depth) > 0.2)
    {
      EXPECT_NEAR(values[i], one.content == "stool" ? one.intensity : fluid, 3.0) << one.id;
    }
  }
}

TEST(ColonStructures, SmallBowelHoldsWhatItIsGiven)
{
  for (const double tagged : { 0.0, 1.0 })
  {
    auto parameters = Realistic(3);
    parameters.smallBowelTagged = tagged;
    parameters.stomachIntensity = 321.0;
    const Exam            exam(parameters);
    std::vector<Vector3d> bowel, stomach;
    for (int i = 0; i < 30 * 30 * 40; ++i)
    {
      const Vector3d point(-90.0 + 6.1 * (i % 30), -85.0 + 3.7 * (i / 30 % 30), -110.0 + 6.3 * (i / 900));
      const auto     structure = exam.structures.At(point);
      EXPECT_TRUE(structure != ColonStructure::SmallBowel || exam.anatomy.Evaluate(point).distance < 0.0);
      (structure == ColonStructure::SmallBowel ? bowel : stomach).push_back(point);
      if (structure != ColonStructure::SmallBowel && structure != ColonStructure::Stomach)
      {
        stomach.pop_back();
      }
    }
    ASSERT_GT(bowel.size(), 100U);
    ASSERT_GT(stomach.size(), 20U);
    std::vector<Vector3d> points{ stomach[stomach.size() / 2] };
    for (std::size_t i = 0; i < bowel.size(); i += bowel.size() / 12)
    {
      points.push_back(bowel[i]);
    }
    const auto values = IntensitiesAt(parameters, points);
    EXPECT_TRUE(std::abs(values[0] - 321.0) < 2.0 || values[0] < -900.0) << values[0];
    int fluid = 0;
    for (std::size_t i = 1; i < values.size(); ++i)
    {
      fluid += values[i] > -500.0 ? 1 : 0;
      EXPECT_TRUE(values[i] < -500.0 || (tagged > 0.5 ? values[i] > 150.0 : values[i] < 100.0)) << values[i];
    }
    EXPECT_GT(fluid, 5);
  }
}

TEST(ColonStructures, WithoutACatheterTheAnalCanalIsClosed)
{
  auto parameters = Realistic(7);
  parameters.catheter = "none";
  const Exam exam(parameters);
  EXPECT_EQ(exam.structures.GetCatheter(), nullptr);
  const auto line = exam.anatomy.Centerline();
  const auto arcLength = shapeton::PointValues(line, "arcLength", "centerline");
  for (Eigen::Index i = 0; i < line.V.rows() && arcLength[i] < 60.0; ++i)
  {
    const double distance = exam.anatomy.Evaluate(line.V.row(i)).distance;
    EXPECT_TRUE(arcLength[i] > 20.0 || distance < 0.0) << arcLength[i];
    EXPECT_TRUE(arcLength[i] < 45.0 || distance > 0.0) << arcLength[i];
  }
}

TEST(ColonPhantomParameters, SharesOfPatientsAreAsDocumented)
{
  std::map<std::string, int> counts;
  constexpr int              patients = 2000;
  for (unsigned seed = 0; seed < patients; ++seed)
  {
    const auto drawn = shapeton::Drawn(Realistic(seed));
    EXPECT_NO_THROW(shapeton::RequireValid(drawn));
    EXPECT_EQ(drawn.catheter, shapeton::Drawn(Realistic(seed, "prone")).catheter);
    ++counts["catheter " + drawn.catheter];
    ++counts["ileum " + drawn.ileumContent];
    ++counts["kernel " + drawn.kernel];
    counts["fatty"] += drawn.valveFat > 0.5;
    counts["refluxed"] += drawn.ileumReflux == "gas";
    counts["risen"] += drawn.sigmoidRise >= 30.0;
    counts["straight"] += drawn.sigmoidStraightness >= 0.7;
    counts["spastic"] += drawn.spasm >= 50.0;
    counts["filled"] += drawn.filledStretch >= 30.0;
    counts["tilted"] += drawn.levelSlope >= 0.15;
    counts["small levels"] += drawn.smallLevels > 0;
    counts["touched"] += drawn.sigmoidContact >= 40.0;
    EXPECT_TRUE(drawn.sigmoidRise == 0.0 || drawn.lengths[1] >= 650.0);
    EXPECT_TRUE(drawn.sigmoidStraightness == 0.0 || drawn.lengths[1] <= 550.0);
    EXPECT_TRUE(drawn.noise >= 15.0 && drawn.noise <= 60.0);
  }
  // With reflux, the ileum is never collapsed. Sigmoid lengths are uniform in 350 to 1200 mm; those of 650 mm and more
  // may rise, those of 550 mm and less may be straight.
  for (const auto & [name, share] : std::map<std::string, double>{ { "catheter none", 0.4 },
                                                                   { "catheter rigid", 0.3 },
                                                                   { "refluxed", 0.3 },
                                                                   { "ileum collapsed", 0.7 * 0.3 },
                                                                   { "kernel sharp", 1.0 / 3.0 },
                                                                   { "fatty", 0.7 },
                                                                   { "spastic", 0.25 },
                                                                   { "filled", 0.4 },
                                                                   { "tilted", 0.3 },
                                                                   { "small levels", 0.4 },
                                                                   { "touched", 0.4 },
                                                                   { "risen", 0.6 * 550.0 / 850.0 },
                                                                   { "straight", 0.6 * 200.0 / 850.0 } })
  {
    EXPECT_NEAR(counts[name], share * patients, 80) << name;
  }
}

TEST(ColonPhantomParameters, WhatIsGivenMovesNothingThatIsDrawn)
{
  auto given = Realistic(8);
  given.catheterBore = 4.5;
  given.valveHeight = 9.0;
  const auto free = shapeton::Drawn(Realistic(8));
  const auto drawn = shapeton::Drawn(given);
  EXPECT_EQ(drawn.catheterBore, 4.5);
  EXPECT_EQ(drawn.valveHeight, 9.0);
  EXPECT_EQ(drawn.catheterWall, free.catheterWall);
  EXPECT_EQ(drawn.balloonDiameter, free.balloonDiameter);
  EXPECT_EQ(drawn.valveFat, free.valveFat);
  EXPECT_EQ(drawn.ileumContent, free.ileumContent);
}

TEST(ColonPhantomParameters, RefusesWhatIsOutOfRangeOrDoesNotFit)
{
  using Parameters = shapeton::ColonPhantomParameters;
  const auto refuses = [](const std::function<void(Parameters &)> & change, const std::string & message) {
    auto parameters = shapeton::ColonPhantomPreset("standard");
    change(parameters);
    EXPECT_TRUE(basetest::Refuses<shapeton::ParameterError>([&] { shapeton::RequireValid(parameters); }, message));
  };
  refuses([](Parameters & p) { p.distension = 2.0; }, "\"distension\"");
  refuses([](Parameters & p) { p.position = "standing"; }, "\"position\"");
  refuses([](Parameters & p) { p.fluid = 1.5; }, "\"fluid\"");
  refuses([](Parameters & p) { p.lengths[1] = 5000.0; }, "");
  refuses([](Parameters & p) { p.valveLength = 20.0; }, "require a valve with lips");
  refuses([](Parameters & p) { p.valve = "lips", p.ileumReflux = "gas", p.ileumContent = "fluid"; },
          "gas in the ileum");
  refuses([](Parameters & p) { p.valve = "lips", p.ileumContent = "soup"; }, "\"ileumContent\"");
  refuses([](Parameters & p) { p = Realistic(1), p.catheterBore = 20.0; }, "\"catheterBore\"");
  refuses([](Parameters & p) { p = Realistic(1), p.balloon = "open"; }, "\"balloon\"");
  refuses([](Parameters & p) { p.lungs = "deepBreath"; }, "\"lungs\": \"deepBreath\" is not one of plain");
  refuses([](Parameters & p) { p.lungDensity = -800.0; }, "requires a whole chest");
  refuses([](Parameters & p) { p.lungs = "inspiration", p.lungDensity = -1000.0; }, "-1000 is less than");
  refuses([](Parameters & p) { p.contents = { "colon", "brain" }; }, "\"contents\": \"brain\" is not");
  Parameters wrong = shapeton::ColonPhantomPreset("standard");
  wrong.valve = "lips";
  wrong.valveLength = 20.0;
  EXPECT_NO_THROW(shapeton::RequireValid(wrong));
  wrong.fluid = 1.5;
  EXPECT_THROW(shapeton::ColonAnatomy{ wrong }, shapeton::ParameterError);
  EXPECT_THROW(shapeton::ColonPhantomImageSource::New()->SetParameters(wrong), shapeton::ParameterError);
  EXPECT_THROW(shapeton::ColonPhantomPreset("easy"), shapeton::ParameterError);
}
