// Flattening of colon-like tubes compared with Newton's method for conformal equivalence, CGAL's LSCM and ARAP on the
// cut surface, and the 2g solves of the holomorphic method. usage: FlatteningBenchmark [faces...]; default: 12000
// 55000. For the accuracy of the maps, see Utilities/run-validation flattening-accuracy.
#include "FlatteningTrial.h"
#include "NewtonFlattening.h"
#include "Times.h"

#include "shapetonColonFlattening.h"
#include "shapetonHarmonicSolver.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

namespace
{
using namespace shapeton;
namespace smp = CGAL::Surface_mesh_parameterization;
using CgalMesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

constexpr int facesOfPeers = 60000; // ARAP is slow

CgalMesh
ToCgal(const SurfaceMesh & mesh)
{
  CgalMesh                            result;
  std::vector<CgalMesh::Vertex_index> vertices;
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    vertices.push_back(result.add_vertex({ mesh.V(v, 0), mesh.V(v, 1), mesh.V(v, 2) }));
  }
  for (int f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    result.add_face(vertices[mesh.F(f, 0)], vertices[mesh.F(f, 1)], vertices[mesh.F(f, 2)]);
  }
  return result;
}

template <typename TParameterizer>
double
SecondsOfCgal(const SurfaceMesh & mesh, int times)
{
  CgalMesh surface = ToCgal(mesh);
  auto     uv = surface.add_property_map<CgalMesh::Vertex_index, CGAL::Simple_cartesian<double>::Point_2>("v:uv").first;
  const auto border = CGAL::Polygon_mesh_processing::longest_border(surface).first;
  return SecondsOf(
    [&] {
      if (smp::parameterize(surface, TParameterizer(), border, uv) != smp::OK)
      {
        std::printf("  (failed)\n");
      }
    },
    times);
}

void
CompareTimes(int faces)
{
  const TubeCase   plain(GenerateTube(faces, 0, 1));
  TubeMap          map;
  const double     ours = SecondsOf([&] { map = plain.Flatten(plain.lengths); }, 7);
  NewtonFlattening newton;
  const auto       flattenByNewton = [&] {
    const CutSurface cut = CutAlongPaths(plain.tube.mesh, plain.connectivity, { map.cutPath });
    newton = FlattenByNewton(plain.connectivity, plain.tube.mesh.F, plain.lengths, plain.ends, cut);
  };
  const double byNewton = SecondsOf(flattenByNewton, 7);
  std::printf("times, %d faces: u, cut, v %.3f s; Newton-CETM %.3f s (%d iterations%s)\n",
              plain.tube.mesh.NumberOfFaces(),
              ours,
              byNewton,
              newton.iterations,
              newton.hasConverged ? "" : ", STALLED");
  PrintBound("time relative to Newton-CETM", ours / byNewton, 0.55);
  std::printf("  CPU seconds: %.3f compared with %.3f\n",
              ProcessorSecondsOf([&] { plain.Flatten(plain.lengths); }),
              ProcessorSecondsOf(flattenByNewton));
  if (faces > facesOfPeers)
  {
    return;
  }
  const double byLscm = SecondsOfCgal<smp::LSCM_parameterizer_3<CgalMesh>>(map.flat, 3);
  const double byArap = SecondsOfCgal<smp::ARAP_parameterizer_3<CgalMesh>>(map.flat, 1);
  std::printf("  CGAL LSCM %.3f s, CGAL ARAP %.3f s on the cut surface\n", byLscm, byArap);
  PrintBound("time relative to CGAL LSCM", ours / byLscm, 0.25);
  PrintBound("time relative to CGAL ARAP", ours / byArap, 0.03);
}

/** Compares two Laplacians with separate factorizations to one factorization with 2g solves. */
void
CompareWithHolomorphicForms(int faces, int handles)
{
  const TubeCase         with(GenerateTube(faces, handles, 1));
  const SurfaceLaplacian laplacian = MakeSurfaceLaplacian(with.connectivity, with.lengths);
  const Eigen::MatrixXd  source = Eigen::MatrixXd::Random(laplacian.NumberOfVertices(), 1);
  const Eigen::MatrixXd  zero = Eigen::MatrixXd::Zero(1, 1);
  const auto             solve = [&](int factorizations, int solves) {
    for (int i = 0; i < factorizations; ++i)
    {
      const HarmonicSolver solver(laplacian, { 0 });
      for (int k = 0; k < solves / factorizations; ++k)
      {
        solver.Solve(zero, source);
      }
    }
  };
  const double pair = SecondsOf([&] { solve(2, 2); }, 3);
  const double forms = SecondsOf([&] { solve(1, 2 * handles); }, 2);
  std::printf("  %3d handles: 2 solves vs. %3d; %.3f s with 2 factorizations vs. %.3f s with one: %.2f\n",
              handles,
              2 * handles,
              pair,
              forms,
              pair / forms);
}

/** Detection and removal of handles. */
void
MeasureHandles(int faces, int handles)
{
  const TubeCase with(GenerateTube(faces, handles, 1));
  const TubeMap  map = with.Flatten(with.lengths);
  const double   seconds = ProcessorSecondsOf([&] {
    const HandleDetection detection = DetectHandles(with.connectivity, map.flat);
    RemoveHandles(with.tube.mesh, with.connectivity, detection.handles);
  });
  PrintBound("detection and removal of 100 handles, CPU seconds", seconds, 0.15);
}

void
MeasureWholeJob(int faces)
{
  const SurfaceMesh mesh = GenerateTube(faces, 0, 1).mesh;
  ColonFlattening   result;
  const double      seconds = SecondsOf([&] { result = FlattenColon(mesh, "the tube"); }, faces > facesOfPeers ? 1 : 3);
  std::printf("complete run, %d faces, heat diffusion metric, t = %.1f mm^2: %.2f s, peak of this run %.0f MB\n",
              result.surface.NumberOfFaces(),
              result.time,
              seconds,
              PeakMegabytes());
}
} // namespace

int
main(int argc, char * argv[])
{
  for (const int faces : NumbersOfFaces(argc, argv, { 12000, 55000 }))
  {
    CompareTimes(faces);
    for (const int handles : { 10, 43, 100 })
    {
      if (faces <= facesOfPeers && faces / handles >= 500)
      {
        CompareWithHolomorphicForms(faces, handles);
      }
    }
    if (faces / 100 >= 500)
    {
      MeasureHandles(faces, 100);
    }
    MeasureWholeJob(faces);
  }
  return EXIT_SUCCESS;
}
