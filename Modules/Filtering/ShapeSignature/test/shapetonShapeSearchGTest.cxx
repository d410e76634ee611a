#include "shapetonSampledShapes.h"
#include "shapetonShapeSearch.h"

#include <gtest/gtest.h>

using namespace shapeton;
using namespace signaturetest;

namespace
{
ShapeSignature
SignatureOf(const Solid & solid)
{
  const auto image = MakeImage({ 56, 56, 56 });
  Draw(image, solid);
  return ComputeShapeSignature(VoxelsOfLabel(image, 1), image);
}

const std::vector<NamedShape> &
Entries()
{
  static const std::vector<NamedShape> entries{ { "ball", SignatureOf(Ball(14.0)) },
                                                { "block", SignatureOf(Box({ 12.0, 20.0, 32.0 })) },
                                                { "hammer", SignatureOf(Hammer()) } };
  return entries;
}
} // namespace

TEST(ShapeSearch, FindsCopiesAndIsSureOfThem)
{
  const auto found = FindShape(SignatureOf(Turned(Scaled(Hammer(), 0.8), 30.0, { 1.0, 1.0, 0.0 })), Entries(), { 2 });
  ASSERT_EQ(found.neighbors.size(), 2U);
  EXPECT_EQ(Entries()[found.neighbors[0].entry].name, "hammer");
  EXPECT_LT(found.neighbors[0].distance, found.neighbors[1].distance);
  EXPECT_GT(found.probability, 0.9);
  EXPECT_FALSE(found.IsUnknown());
}

TEST(ShapeSearch, SaysUnknownForAShapeThatIsNotThere)
{
  const auto ring = [](const Eigen::Vector3d & p) { return std::hypot(std::hypot(p[0], p[1]) - 18.0, p[2]) <= 5.0; };
  EXPECT_TRUE(FindShape(SignatureOf(ring), Entries(), { 1 }).IsUnknown());
}

TEST(ShapeSearch, DistanceIsAMetricOfSignaturesUpToVolume)
{
  const ShapeSignature & a = Entries()[0].signature;
  const ShapeSignature & b = Entries()[1].signature;
  const ShapeSignature & c = Entries()[2].signature;
  EXPECT_EQ(SignatureDistance(a, a), 0.0);
  EXPECT_EQ(SignatureDistance(a, b), SignatureDistance(b, a));
  EXPECT_LE(SignatureDistance(a, c), SignatureDistance(a, b) + SignatureDistance(b, c));
  ShapeSignature larger = a; // all dimensionless measures are unchanged
  larger.volume *= 8.0;
  larger.surface *= 4.0;
  EXPECT_NEAR(SignatureDistance(a, larger), 0.0, 1e-12);
}

TEST(ShapeSearch, ProbabilityFallsWithDistanceAndRisesWithMargin)
{
  EXPECT_GT(ProbabilityOfSameShape(0.5, 3.0), ProbabilityOfSameShape(1.0, 3.0));
  EXPECT_GT(ProbabilityOfSameShape(1.0, 3.0), ProbabilityOfSameShape(1.0, 1.5));
  EXPECT_EQ(ProbabilityOfSameShape(1.0, 10.0), ProbabilityOfSameShape(1.0, 1000.0)); // as documented
  EXPECT_GT(ProbabilityOfSameShape(100.0, 1.0), 0.0);
  EXPECT_LT(ProbabilityOfSameShape(0.0, 10.0), 1.0);
}

TEST(ShapeSearch, EntriesOfOneNameGiveNoMarginToEachOther)
{
  const std::vector<NamedShape> twice{ { "hammer", Entries()[2].signature },
                                       { "hammer", SignatureOf(Turned(Hammer(), 20.0, { 0.0, 1.0, 0.0 })) },
                                       Entries()[0] };
  const std::vector<NamedShape> once{ twice[0], twice[2] };
  const ShapeSignature          copy = SignatureOf(Scaled(Hammer(), 0.9));
  const auto                    nearest = [&](const std::vector<NamedShape> & entries) {
    return FindShape(copy, entries, { 9 }).probability;
  };
  EXPECT_GE(nearest(twice), nearest(once)); // entries with the same name do not reduce the margin
  EXPECT_THROW(FindShape(copy, {}, { 1 }), std::invalid_argument);
}
