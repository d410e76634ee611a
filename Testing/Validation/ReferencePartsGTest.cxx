#include "BestNodes.h"

#include "shapetonTestImages.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace shapeton;

namespace
{
constexpr int side = 24;

int
DistanceFromMiddle(const itk::Index<3> & index)
{
  int most = 0;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    most = std::max(most, std::abs(static_cast<int>(index[axis]) - side / 2));
  }
  return most;
}

/** A cube of side 15 with the label 2; in it one of side 7 with the label 1; a corner of 3^3 voxels with the label 3.
 */
ReferenceParts::Labels::Pointer
NestedCubes()
{
  const auto labels = basetest::NewImage<ReferenceParts::Labels>(itk::Size<3>::Filled(side));
  basetest::ForVoxels(labels, [&](const itk::Index<3> & index, const itk::Point<double, 3> &) {
    const int  distance = DistanceFromMiddle(index);
    const bool isInCorner = std::max({ index[0], index[1], index[2] }) < 3;
    labels->SetPixel(index, distance <= 3 ? 1 : distance <= 7 ? 2 : isInCorner ? 3 : 0);
  });
  return labels;
}
} // namespace

TEST(ReferenceParts, APartCountsWithOrWithoutWhatItEncloses)
{
  const auto           labels = NestedCubes();
  const ReferenceParts parts(labels);
  EXPECT_EQ(parts.GetLabels(), (std::vector<int>{ 1, 2 })); // the corner has 27 voxels
  const double                 inner = 7 * 7 * 7;
  const double                 outer = 15 * 15 * 15 - inner;
  const ReferenceParts::Counts shell{ 0.0, 0.0, outer, 0.0 };
  const ReferenceParts::Counts whole{ 0.0, inner, outer, 0.0 };
  EXPECT_DOUBLE_EQ(parts.Dice(2, shell.data(), outer), 1.0);
  EXPECT_DOUBLE_EQ(parts.Dice(2, whole.data(), inner + outer), 1.0);
  EXPECT_DOUBLE_EQ(parts.Dice(1, whole.data(), inner + outer), 2.0 * inner / (2.0 * inner + outer));
  EXPECT_DOUBLE_EQ(parts.BestDice(whole.data(), inner + outer), 1.0);
}

TEST(ReferenceParts, DepthsAreDistancesToTheOutside)
{
  const auto labels = NestedCubes();
  const auto depths = ReferenceParts(labels).DepthsOf(1);
  ASSERT_EQ(depths.voxels.size(), 343U);
  EXPECT_EQ(*std::max_element(depths.squares.begin(), depths.squares.end()), 16.0F); // the middle: 4 voxels
  EXPECT_EQ(*std::min_element(depths.squares.begin(), depths.squares.end()), 1.0F);
}

TEST(BestNodes, EachTreeHoldsItsKindOfSet)
{
  const auto           labels = NestedCubes();
  const ReferenceParts parts(labels);
  std::vector<float>   values(side * side * side);
  const auto           best = [&](float background, float inner, float outer, EdgeWeight weight) {
    std::transform(
      labels->GetBufferPointer(), labels->GetBufferPointer() + values.size(), values.begin(), [&](int label) {
        return label == 1 ? inner : label == 2 ? outer : background;
      });
    return BestNodes(values.data(), weight, parts);
  };
  const std::vector<double> all{ 1.0, 1.0 };
  EXPECT_EQ(best(0.0F, 2.0F, 1.0F, EdgeWeight::NegativeMinimum), all);
  EXPECT_EQ(best(2.0F, 0.0F, 1.0F, EdgeWeight::Maximum), all);
  EXPECT_EQ(best(0.0F, 1.0F, 3.0F, EdgeWeight::Difference), all); // a plateau in the middle
  EXPECT_LT(best(0.0F, 2.0F, 1.0F, EdgeWeight::Maximum)[0], 0.5);
}
