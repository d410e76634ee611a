#include "shapetonTubeUnfolding.h"

#include "shapetonColonFlattening.h"
#include "shapetonColonTube.h"
#include "shapetonHeatDiffusionMetric.h"
#include "shapetonRoughTube.h"
#include "shapetonSurfaceQuality.h"
#include "shapetonSurfaceReader.h"
#include "shapetonSurfaceWriter.h"
#include "shapetonTestFolder.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace
{
using namespace testsurfaces;

Eigen::VectorXd
StraightLengths(const shapeton::SurfaceMesh &         mesh,
                const shapeton::SurfaceConnectivity & connectivity,
                const shapeton::Progress &)
{
  return shapeton::EdgeLengths(connectivity, mesh.V);
}

shapeton::UnfoldedTube
Unfold(const shapeton::SurfaceMesh & mesh)
{
  const shapeton::SurfaceConnectivity connectivity(mesh);
  return shapeton::FlattenWithoutFolds(mesh, shapeton::FindTubeEnds(mesh, connectivity, "the tube"), StraightLengths);
}

int
FlipsOf(const shapeton::SurfaceMesh & flat)
{
  const auto isFlipped = shapeton::FlippedFaces(flat.F, shapeton::FlatCoordinates(flat, "the map"));
  return static_cast<int>(std::count(isFlipped.begin(), isFlipped.end(), 1));
}

/** Map computed in one solve. */
int
FlipsAtFirst(const shapeton::SurfaceMesh & mesh)
{
  const shapeton::SurfaceConnectivity connectivity(mesh);
  const shapeton::TubeEnds            ends = shapeton::FindTubeEnds(mesh, connectivity, "the tube");
  return FlipsOf(shapeton::FlattenTube(mesh, connectivity, StraightLengths(mesh, connectivity, {}), ends).flat);
}

/** Checks that wall faces belong to the original surface and that the removed area is reported. */
void
ExpectWallWithCaps(const shapeton::SurfaceMesh & before, const shapeton::UnfoldedTube & tube)
{
  const std::vector<char>              isCap = shapeton::FacesOfCaps(tube.surface);
  const shapeton::SurfaceArray * const points = shapeton::FindSurfaceArray(tube.surface.pointArrays, "wallPointId");
  const shapeton::SurfaceArray * const caps = shapeton::FindSurfaceArray(tube.surface.cellArrays, "cap");
  ASSERT_TRUE(points && caps);
  std::vector<int> wall;
  int              next = 0;
  for (int face = 0; face < tube.surface.NumberOfFaces(); ++face)
  {
    ASSERT_LE(caps->values(face, 0), static_cast<double>(tube.caps.size()));
    if (isCap[face])
    {
      continue;
    }
    wall.push_back(face);
    Eigen::RowVector3i corners;
    for (int k = 0; k < 3; ++k)
    {
      corners[k] = static_cast<int>(points->values(tube.surface.F(face, k), 0));
      ASSERT_EQ(before.V.row(corners[k]), tube.surface.V.row(tube.surface.F(face, k)));
    }
    while (next < before.NumberOfFaces() && before.F.row(next) != corners)
    {
      ++next;
    }
    ASSERT_LT(next, before.NumberOfFaces()) << face;
  }
  const shapeton::SurfaceMesh rest = shapeton::FacesOfSurface(tube.surface, wall);
  double                      area = shapeton::SurfaceArea(rest.V, rest.F);
  for (const shapeton::PouchCap & cap : tube.caps)
  {
    EXPECT_GT(cap.neck, 0.0);
    EXPECT_GT(cap.area, 0.0);
    area += cap.area;
  }
  EXPECT_NEAR(shapeton::SurfaceArea(before.V, before.F), area, 1e-9 * area);
  const shapeton::SurfaceConnectivity connectivity(tube.surface);
  EXPECT_NO_THROW(shapeton::FindTubeEnds(tube.surface, connectivity, "it"));
  EXPECT_EQ(0, connectivity.Components().front().genus);
}

/** Checks that the map is still flat after writing and reading. */
void
ExpectNoFolds(const RoughTubeOptions & rough, const shapeton::ColonFlatteningSettings & options)
{
  const shapeton::SurfaceMesh     mesh = MakeRoughTube(rough);
  const shapeton::ColonFlattening flat = shapeton::FlattenColon(mesh, "the tube", options);
  const basetest::Folder          folder;
  shapeton::WriteSurface(flat.map.flat, folder / "flat.vtp");
  EXPECT_EQ(0, FlipsOf(shapeton::ReadSurface(folder / "flat.vtp").mesh)) << "seed " << rough.seed;
  EXPECT_EQ(0, flat.distortion.flips);
  EXPECT_EQ(rough.ears, flat.ears);
  const double area = shapeton::SurfaceArea(mesh.V, mesh.F);
  double       cutOff = 0.0;
  for (const shapeton::PouchCap & cap : flat.caps)
  {
    cutOff += cap.area / area;
  }
  EXPECT_LE(cutOff, flat.cutOffAreaFraction * (1.0 + 1e-12));
}

/** Random tubes of these numbers, with all kinds of defects, in both metrics. */
void
ExpectNoFoldsOfTubes(int first, int last)
{
  for (int n = first; n <= last; ++n)
  {
    RoughTubeOptions rough;
    rough.seed = n;
    rough.around = 16 + n % 17;
    rough.along = 30 + n % 23;
    rough.noise = 0.15 * (n % 8);
    rough.pouches = n % 5;
    rough.pouchRings = 2 + n % 23;
    rough.needles = 3 * (n % 4);
    rough.ears = n % 3;
    shapeton::ColonFlatteningSettings options;
    options.metric = n % 2 == 0 ? shapeton::FlatMetric::Euclidean : shapeton::FlatMetric::HeatDiffusion;
    options.time = n % 2 == 0 ? 0.0 : 20.0;
    ExpectNoFolds(rough, options);
  }
}

void
ExpectNoFoldsWithoutHandles(int faces, int handles, const std::vector<std::uint64_t> & seeds)
{
  for (const std::uint64_t seed : seeds)
  {
    for (const auto metric : { shapeton::FlatMetric::Euclidean, shapeton::FlatMetric::HeatDiffusion })
    {
      shapeton::ColonFlatteningSettings options;
      options.metric = metric;
      options.topology = shapeton::SurfaceTopology::Denoised;
      const shapeton::ColonFlattening flat =
        shapeton::FlattenColon(MakeColonTube({ faces, handles, seed }).mesh, "the tube", options);
      EXPECT_EQ(0, flat.distortion.flips) << "seed " << seed << ", left " << flat.genusAfter;
      EXPECT_EQ(0, flat.genusAfter);
      EXPECT_EQ(0.0, flat.cutOffAreaFraction);
    }
  }
}
} // namespace

TEST(TubeUnfolding, MapWithoutFoldsIsThatOfOneSolve)
{
  const shapeton::SurfaceMesh         mesh = MakeColonTube({ 6000, 0, 1, 750.0 }).mesh;
  const shapeton::SurfaceConnectivity connectivity(mesh);
  const shapeton::TubeEnds            ends = shapeton::FindTubeEnds(mesh, connectivity, "the tube");
  const auto plain = shapeton::FlattenTube(mesh, connectivity, StraightLengths(mesh, connectivity, {}), ends);
  const shapeton::UnfoldedTube tube = Unfold(mesh);
  EXPECT_EQ(1, tube.solves);
  EXPECT_TRUE(tube.caps.empty());
  EXPECT_EQ(mesh.F, tube.surface.F);
  EXPECT_TRUE(shapeton::FacesOfCaps(tube.surface).empty());
  EXPECT_EQ(shapeton::FlatCoordinates(plain.flat, "it"), shapeton::FlatCoordinates(tube.map.flat, "it"));
  EXPECT_EQ(plain.flat.F, tube.map.flat.F);
  EXPECT_EQ(plain.flat.pointArrays.size(), tube.map.flat.pointArrays.size());
}

TEST(TubeUnfolding, NoiseIsUnfoldedWithoutCaps)
{
  int folded = 0;
  for (const std::uint64_t seed : { 1, 2, 3, 4, 5, 6 })
  {
    RoughTubeOptions rough;
    rough.seed = seed;
    rough.noise = 0.7;
    const shapeton::SurfaceMesh  mesh = MakeRoughTube(rough);
    const shapeton::UnfoldedTube tube = Unfold(mesh);
    const bool                   isFolded = FlipsAtFirst(mesh) > 0;
    folded += isFolded;
    EXPECT_EQ(isFolded, tube.solves > 1);
    EXPECT_EQ(0, FlipsOf(tube.map.flat));
    EXPECT_TRUE(tube.caps.empty());
    EXPECT_EQ(mesh.F, tube.surface.F);
    EXPECT_GE(tube.map.Gap(), 0.0);
  }
  EXPECT_GE(folded, 3);
}

TEST(TubeUnfolding, MetricThatFoldsEverywhereIsUnfolded)
{
  // Random lengths of 1 or nearly 2: half of the triangles are needles with large negative weights.
  const shapeton::TubeMetric metric =
    [](const shapeton::SurfaceMesh &, const shapeton::SurfaceConnectivity & connectivity, const shapeton::Progress &) {
      Eigen::VectorXd lengths(connectivity.NumberOfEdges());
      for (Eigen::Index edge = 0; edge < lengths.size(); ++edge)
      {
        const auto random = shapeton::Philox4x32(3, { static_cast<std::uint32_t>(edge), 0, 0, 0 });
        lengths[edge] = shapeton::UnitFloat(random.a) < 0.5 ? 1.0 : 1.999;
      }
      return lengths;
    };
  const shapeton::SurfaceMesh         mesh = MakeRoughTube({});
  const shapeton::SurfaceConnectivity connectivity(mesh);
  const shapeton::TubeEnds            ends = shapeton::FindTubeEnds(mesh, connectivity, "the tube");
  const auto plain = shapeton::FlattenTube(mesh, connectivity, metric(mesh, connectivity, {}), ends);
  EXPECT_GT(FlipsOf(plain.flat), 50);
  const shapeton::UnfoldedTube tube = shapeton::FlattenWithoutFolds(mesh, ends, metric);
  EXPECT_EQ(0, FlipsOf(tube.map.flat));
  EXPECT_GT(tube.solves, 2);
  EXPECT_GE(tube.map.modulusU, plain.modulusU); // Dirichlet's principle
  EXPECT_LE(tube.map.modulusV, plain.modulusV);
}

TEST(TubeUnfolding, BlindPouchesAreCutOffAndListed)
{
  RoughTubeOptions rough;
  rough.noise = 0.3;
  rough.pouches = 3;
  rough.pouchRings = 10;
  const shapeton::SurfaceMesh  mesh = MakeRoughTube(rough);
  const shapeton::UnfoldedTube tube = Unfold(mesh);
  EXPECT_GT(FlipsAtFirst(mesh), 0);
  EXPECT_EQ(0, FlipsOf(tube.map.flat));
  ASSERT_EQ(3U, tube.caps.size());
  ExpectWallWithCaps(mesh, tube);
  for (const shapeton::PouchCap & cap : tube.caps)
  {
    EXPECT_LT(cap.neck, 25.0);
    EXPECT_NEAR(30.0, cap.place.head<2>().norm(), 15.0);
  }
}

/** In a deep pouch, diffusion distances are below the error of the default number of poles. */
TEST(TubeUnfolding, DeepPouchesAreMeasuredByMorePoles)
{
  RoughTubeOptions rough;
  rough.around = 48;
  rough.along = 80;
  rough.noise = 0.2;
  rough.pouches = 5;
  rough.pouchRings = 30;
  const shapeton::SurfaceMesh               mesh = MakeRoughTube(rough);
  const shapeton::SurfaceConnectivity       connectivity(mesh);
  const double                              h = shapeton::EdgeLengths(connectivity, mesh.V).mean();
  const double                              t = 30.0 * h * h;
  const shapeton::HeatDiffusionMetricSolver solver(shapeton::MakeSurfaceLaplacian(connectivity, mesh.V));
  EXPECT_FALSE(shapeton::AreTriangles(connectivity, solver.Compute(t).edgeLengths));
  shapeton::ColonFlatteningSettings options;
  options.metric = shapeton::FlatMetric::HeatDiffusion;
  options.time = t;
  ExpectNoFolds(rough, options);
}

TEST(TubeUnfolding, EarsAreTrimmed)
{
  RoughTubeOptions rough;
  rough.ears = 4;
  shapeton::SurfaceMesh mesh = MakeRoughTube(rough);
  mesh.fieldArrays.push_back({ "rectumLoop", Eigen::Vector3d(0, mesh.NumberOfVertices() - 4, 1), true });
  const double                    area = shapeton::SurfaceArea(mesh.V, mesh.F);
  const shapeton::ColonFlattening flat = shapeton::FlattenColon(mesh, "it");
  EXPECT_EQ(4, flat.ears);
  EXPECT_EQ(0, flat.distortion.flips);
  EXPECT_EQ("rectumLoop", flat.rectumFrom);
  EXPECT_NEAR(area * (1.0 - flat.cutOffAreaFraction), shapeton::SurfaceArea(flat.surface.V, flat.surface.F), 1e-6);
  EXPECT_EQ(2, shapeton::FindSurfaceArray(flat.surface.fieldArrays, "rectumLoop")->values.rows());
}

TEST(TubeUnfolding, HandlesAreLetBe)
{
  const shapeton::UnfoldedTube tube = Unfold(MakeColonTube({ 6000, 4, 1, 750.0 }).mesh);
  EXPECT_GT(FlipsOf(tube.map.flat), 0);
  EXPECT_TRUE(tube.caps.empty());
}

TEST(TubeUnfolding, TubesWithoutTheirHandlesHaveNoFolds) { ExpectNoFoldsWithoutHandles(12000, 10, { 1, 2, 3 }); }

TEST(TubeUnfolding, LongTubesWithoutTheirHandlesHaveNoFolds)
{
  ExpectNoFoldsWithoutHandles(55000, 43, { 11, 12, 13, 14, 15, 16 });
  ExpectNoFoldsWithoutHandles(55000, 100, { 11, 12, 13, 14, 15, 16 });
}

TEST(TubeUnfolding, FewGeneratedTubes) { ExpectNoFoldsOfTubes(1, 8); }

TEST(TubeUnfolding, ManyGeneratedTubes) { ExpectNoFoldsOfTubes(9, 208); }

TEST(TubeUnfolding, MeshesOfOthers)
{
  const char * const folder = std::getenv("SHAPETON_TEST_DATA_DIR");
  if (!folder || !*folder)
  {
    GTEST_SKIP() << "SHAPETON_TEST_DATA_DIR is not set";
  }
  shapeton::SurfaceReadOptions sigmoid, transverse;
  sigmoid.part = "VH_F_sigmoid_colon";
  transverse.part = "VH_F_transverse_colon";
  sigmoid.component = transverse.component = 1;
  const std::string meshes = std::string(folder) + "/meshes/";
  for (const auto & surface : { shapeton::ReadSurface(meshes + "colon-tube.stl"),
                                shapeton::ReadSurface(meshes + "SBU_F_Intestine_Large.glb", sigmoid),
                                shapeton::ReadSurface(meshes + "SBU_F_Intestine_Large.glb", transverse) })
  {
    for (const auto metric : { shapeton::FlatMetric::Euclidean, shapeton::FlatMetric::HeatDiffusion })
    {
      shapeton::ColonFlatteningSettings options;
      options.metric = metric;
      options.topology = shapeton::SurfaceTopology::Denoised;
      const shapeton::ColonFlattening flat = shapeton::FlattenColon(surface.mesh, "the tube", options);
      EXPECT_EQ(0, FlipsOf(flat.map.flat));
      EXPECT_LT(flat.cutOffAreaFraction, 0.02);
    }
  }
}
