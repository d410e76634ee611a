#include "itkHaustralFolds.h"

#include "../../../Mesh/FlatColonGrid/test/itkFlatTestTubes.h"

#include <gtest/gtest.h>

namespace
{
itk::SurfaceMesh
SmoothCylinder()
{
  return flattubes::MakeCylinder({});
}
} // namespace

TEST(HaustralFolds, ASmoothCylinderHasNoneAndSaysSo)
{
  const itk::FlatColonGrid grid(SmoothCylinder());
  const auto               found = itk::FindHaustralFolds(grid);
  EXPECT_TRUE(found.folds.empty());
  EXPECT_EQ(found.warnings.size(), 1u);
  EXPECT_EQ(found.labels->GetLargestPossibleRegion().GetSize()[0], static_cast<unsigned int>(grid.Columns()));
}
