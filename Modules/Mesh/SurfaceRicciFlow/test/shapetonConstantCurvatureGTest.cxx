#include "shapetonSurfaceRicciFlow.h"

#include "shapetonGenusSurfaces.h"
#include "shapetonPlanarDomains.h"
#include "shapetonSurfaceReader.h"
#include "shapetonSurfaceRemeshing.h"
#include "shapetonSurfaceRepair.h"

#include <gtest/gtest.h>

#include <cstdlib>

using namespace shapeton;
using namespace testsurfaces;

namespace
{
/** The metric of constant curvature by genus, checked with the law of cosines. */
void
ExpectConstantCurvature(const SurfaceMesh & mesh, int genus)
{
  const SurfaceRicciFlow flow = FlowSurface(mesh, {}, "the surface");
  EXPECT_EQ(flow.genus, genus);
  EXPECT_LE(flow.residual, 1e-10);
  EXPECT_EQ(flow.geometry,
            genus == 0   ? RicciGeometry::Spherical
            : genus == 1 ? RicciGeometry::Euclidean
                         : RicciGeometry::Hyperbolic);
  if (genus != 1)
  {
    EXPECT_NEAR(flow.area, 4 * Pi * std::abs(genus - 1), 1e-8); // Gauss and Bonnet
  }
  EXPECT_LE(DefectsOfResult(flow, mesh.NumberOfVertices()).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_LT(flow.layoutResidual, 1e-6);
}

SurfaceMesh
MeshOfData(const std::string & name)
{
  SurfaceReadOptions options;
  options.anyExtent = true;
  return RepairSurface(
    ReadSurface(std::string(std::getenv("SHAPETON_TEST_DATA_DIR")) + "/meshes/" + name, options).mesh);
}

/** Length cross ratio of an edge, invariant under scales at vertices. */
double
CrossRatio(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity, const VertexMatrix & V, int edge)
{
  const auto & [a, b] = connectivity.VerticesOfEdge(edge);
  std::array<int, 2> opposite{};
  for (int i = 0; i < 2; ++i)
  {
    const int f = connectivity.FacesOfEdge(edge)[i];
    opposite[i] = mesh.F(f, 0) + mesh.F(f, 1) + mesh.F(f, 2) - a - b;
  }
  const auto length = [&](int p, int q) { return (V.row(p) - V.row(q)).norm(); };
  return length(a, opposite[0]) * length(b, opposite[1]) / (length(b, opposite[0]) * length(a, opposite[1]));
}
} // namespace

TEST(ConstantCurvature, GeneratedSurfacesOfGenus1To4)
{
  for (int genus = 1; genus <= 4; ++genus)
  {
    ExpectConstantCurvature(ChainOfRings(genus, 7), genus);
  }
}

TEST(ConstantCurvature, RealSurfacesOfGenus1To4)
{
  const char * const folder = std::getenv("SHAPETON_TEST_DATA_DIR");
  if (!folder || *folder == '\0')
  {
    GTEST_SKIP() << "SHAPETON_TEST_DATA_DIR is not set";
  }
  ExpectConstantCurvature(MeshOfData("kitten.obj"), 1);
  ExpectConstantCurvature(MeshOfData("elephant.off"), 3);
  ExpectConstantCurvature(MeshOfData("fertility.off"), 4);
  ExpectConstantCurvature(MeshOfData("hand.off"), 0);
}

TEST(ConstantCurvature, InversiveDistanceOnGenus2)
{
  SurfaceRemeshingSettings remeshing;
  remeshing.edgeLength = 1.5;
  const SurfaceMesh        mesh = RemeshSurface(ChainOfRings(2, 7), remeshing);
  SurfaceRicciFlowSettings options;
  options.scheme = RicciScheme::InversiveDistance;
  const SurfaceRicciFlow flow = FlowSurface(mesh, options, "the surface");
  EXPECT_LE(flow.residual, 1e-10);
  EXPECT_NEAR(flow.area, 4 * Pi, 1e-8);
  EXPECT_EQ(flow.triangles, mesh.F);
  EXPECT_LE(DefectsOfResult(flow, mesh.NumberOfVertices()).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(ConstantCurvature, HyperbolicSurfaceWithStraightBoundary)
{
  SurfaceRicciFlowSettings options;
  options.geometry = RicciGeometry::Hyperbolic;
  const SurfaceMesh torus = Torus(40, 20, 2.0, 1.0);
  const SurfaceMesh mesh = FacesWhere(
    torus, [&](int f) { return torus.V.row(torus.F(f, 0)).head<2>().norm() < 2.9 || torus.V(torus.F(f, 0), 0) < 2.0; });
  const SurfaceRicciFlow flow = FlowSurface(mesh, options, "the torus");
  EXPECT_EQ(flow.genus, 1);
  EXPECT_EQ(flow.boundaries, 1);
  EXPECT_LE(flow.residual, 1e-10);
  EXPECT_NEAR(flow.area, 2 * Pi, 1e-8);
}

TEST(ConstantCurvature, FlatMetricOfGenus2WithOneCone)
{
  SurfaceRicciFlowSettings options;
  options.cones = { 11 };
  const SurfaceMesh      mesh = ChainOfRings(2, 7);
  const SurfaceRicciFlow flow = FlowSurface(mesh, options, "the surface");
  EXPECT_LE(flow.residual, 1e-10);
  Eigen::VectorXd defects = DefectsOfResult(flow, mesh.NumberOfVertices());
  EXPECT_NEAR(defects[11], -4 * Pi, 1e-6);
  defects[11] = 0.0;
  EXPECT_LE(defects.cwiseAbs().maxCoeff(), 1e-6);
}

TEST(ConstantCurvature, SphereOfAnInscribedPolyhedronIsAMoebiusImage)
{
  // The vertices of a boosted sphere: the polyhedron is unique up to Moebius transformations (Rivin).
  SurfaceMesh mesh = Icosphere(3, 1.0);
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    const Eigen::RowVector3d x = mesh.V.row(v);
    const double             time = (1.0 - 0.6 * x[2]) / 0.8;
    mesh.V.row(v) << x[0] / time, x[1] / time, (x[2] - 0.6) / 0.8 / time;
  }
  const SurfaceRicciFlow flow = FlowSurface(mesh, {}, "the sphere");
  const SurfaceArray *   sphere = FindSurfaceArray(flow.flat.pointArrays, "sphere");
  ASSERT_TRUE(sphere);
  const VertexMatrix        places = sphere->values;
  const SurfaceConnectivity connectivity(mesh);
  EXPECT_LE((places.rowwise().norm().array() - 1.0).abs().maxCoeff(), 1e-14);
  for (int e = 0; e < connectivity.NumberOfEdges(); ++e)
  {
    EXPECT_NEAR(CrossRatio(mesh, connectivity, places, e), CrossRatio(mesh, connectivity, mesh.V, e), 1e-9);
  }
}

TEST(ConstantCurvature, RoughSpheres)
{
  for (const double amplitude : { 0.05, 0.1, 0.2, 0.3 })
  {
    const SurfaceMesh      mesh = Roughened(Icosphere(3, 1.0), amplitude, 3);
    const SurfaceRicciFlow flow = FlowSurface(mesh, {}, "the sphere");
    EXPECT_LE(flow.residual, 1e-10);
    EXPECT_NEAR(flow.area, 4 * Pi, 1e-9);
    EXPECT_LE(DefectsOfResult(flow, mesh.NumberOfVertices()).cwiseAbs().maxCoeff(), 1e-6);
  }
}

TEST(ConstantCurvature, AnEllipsoidOfRevolutionKeepsItsParallels)
{
  // The conformal map of a spheroid to the sphere preserves parallels and meridians; the equator maps to the equator.
  SurfaceMesh mesh = Icosphere(4, 1.0);
  mesh.V.col(2) *= 2.0;
  const SurfaceRicciFlow flow = FlowSurface(mesh, {}, "the spheroid");
  const VertexMatrix     places = FindSurfaceArray(flow.flat.pointArrays, "sphere")->values;
  // Rotate so that the images of the poles are on the axis.
  Eigen::Index top = 0, bottom = 0;
  mesh.V.col(2).maxCoeff(&top);
  mesh.V.col(2).minCoeff(&bottom);
  const Eigen::RowVector3d axis = (places.row(top) - places.row(bottom)).normalized();
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    if (std::abs(mesh.V(v, 2)) < 1e-12)
    {
      EXPECT_NEAR(places.row(v).dot(axis), 0.0, 5e-3);
    }
  }
}
