#include "shapetonSurfaceQuality.h"
#include "shapetonSurfaceReader.h"
#include "shapetonSurfaceRepair.h"
#include "shapetonSurfaceSimplification.h"

#include "gtest/gtest.h"

#include <algorithm>
#include <cstdlib>

namespace
{
std::string
MeshFolder()
{
  const char * const folder = std::getenv("SHAPETON_TEST_DATA_DIR");
  return folder && *folder ? std::string(folder) + "/meshes/" : "";
}

struct Fact
{
  const char * name;
  int          genus, loops;
};

TEST(SurfaceRealData, TopologyIsThatOfTheSourceAlsoWhenSimplified)
{
  if (MeshFolder().empty())
  {
    GTEST_SKIP() << "SHAPETON_TEST_DATA_DIR is not set";
  }
  for (const Fact & fact : { Fact{ "fertility.off", 4, 0 },
                             { "kitten.obj", 1, 0 },
                             { "elephant.off", 3, 0 },
                             { "hand.off", 0, 0 },
                             { "holes.off", 0, 7 },
                             { "face.obj", 0, 1 },
                             { "punctured-torus.obj", 1, 1 },
                             { "aorta-surface.stl", 0, 0 },
                             { "aorta-surface-open-ends.stl", 0, 3 },
                             { "colon-tube.stl", 0, 2 } })
  {
    SCOPED_TRACE(fact.name);
    const shapeton::SurfaceMesh    mesh = shapeton::ReadSurfaceFile(MeshFolder() + fact.name).mesh;
    const shapeton::SurfaceQuality quality = shapeton::InspectSurface(mesh);
    EXPECT_TRUE(quality.isManifold);
    EXPECT_EQ(quality.components.size(), 1u);
    EXPECT_EQ(quality.genus, fact.genus);
    EXPECT_EQ(static_cast<int>(quality.boundaryLoopLengths.size()), fact.loops);

    shapeton::SurfaceSimplificationSettings options;
    options.faces = mesh.NumberOfFaces() / 4;
    const shapeton::SurfaceQuality simple = shapeton::InspectSurface(shapeton::SimplifySurface(mesh, options));
    EXPECT_NEAR(simple.faces, options.faces, 1);
    EXPECT_TRUE(simple.isManifold);
    EXPECT_EQ(simple.genus, quality.genus);
    EXPECT_EQ(simple.boundaryLoopLengths.size(), quality.boundaryLoopLengths.size());
    // hand.off: 6 degrees
    EXPECT_GE(simple.smallestAngle.percentile1, std::min(15.0, quality.smallestAngle.percentile1));
    EXPECT_NEAR(simple.area, quality.area, 0.02 * quality.area);
  }
}

TEST(SurfaceRealData, ColonOfTenParts)
{
  if (MeshFolder().empty())
  {
    GTEST_SKIP() << "SHAPETON_TEST_DATA_DIR is not set";
  }
  const shapeton::SurfaceFile file = shapeton::ReadSurfaceFile(MeshFolder() + "SBU_F_Intestine_Large.glb");
  ASSERT_EQ(file.parts.size(), 10u);
  EXPECT_EQ(file.parts[2].name, "VH_F_ascending_colon");
  EXPECT_EQ(file.unit, shapeton::SurfaceUnit::Meter);
  const Eigen::RowVector3d extent = file.mesh.V.colwise().maxCoeff() - file.mesh.V.colwise().minCoeff();
  EXPECT_GT(extent.maxCoeff(), 200.0); // a colon in mm
  EXPECT_LT(extent.maxCoeff(), 600.0);
  shapeton::SurfaceReadOptions options;
  options.part = "VH_F_ascending_colon";
  options.component = -1; // its inner and outer wall
  EXPECT_EQ(shapeton::ReadSurface(MeshFolder() + "SBU_F_Intestine_Large.glb", options).mesh.NumberOfFaces(), 4968 / 3);
}

TEST(SurfaceRealData, TeapotIsRepaired)
{
  if (MeshFolder().empty())
  {
    GTEST_SKIP() << "SHAPETON_TEST_DATA_DIR is not set";
  }
  const shapeton::SurfaceMesh teapot = shapeton::ReadSurfaceFile(MeshFolder() + "teapot.obj").mesh;
  EXPECT_FALSE(shapeton::InspectSurface(teapot).isManifold);
  const shapeton::SurfaceQuality repaired = shapeton::InspectSurface(shapeton::RepairSurface(teapot));
  EXPECT_TRUE(repaired.isManifold);
  EXPECT_TRUE(repaired.isOriented);
}
} // namespace
