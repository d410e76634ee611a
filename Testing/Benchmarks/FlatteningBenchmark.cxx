// Flattening of colon-like tubes compared with Newton's method for conformal equivalence, CGAL's LSCM and ARAP on the
// cut surface, and the 2g solves of the holomorphic method. usage: FlatteningBenchmark [faces...]; default: 12000
// 55000. For the accuracy of the maps, see Utilities/run-validation flattening-accuracy.
#include "FlatteningTrial.h"
#include "NewtonFlattening.h"

#include "shapetonColonFlattening.h"
#include "shapetonHarmonicSolver.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace
{
using namespace shapeton;
namespace smp = CGAL::Surface_mesh_parameterization;
using CgalMesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

constexpr int facesOfPeers = 60000; // ARAP is slow

template <typename TBody>
double
BestSeconds(int times, const TBody & body)
{
  double best = 1e300;
  for (int i = 0; i < times; ++i)
  {
    const auto start = std::chrono::steady_clock::now();
    body();
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return best;
}

void
PrintBound(const char * text, double value, double asked)
{
  std::printf("  %-66s %10.4g   asked <= %g   %s\n", text, value, asked, value <= asked ? "met" : "NOT MET");
}

/** CPU seconds of all processors. */
template <typename TBody>
double
ProcessorSeconds(const TBody & body)
{
  const std::clock_t start = std::clock();
  body();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

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
  return BestSeconds(times, [&] {
    if (smp::parameterize(surface, TParameterizer(), border, uv) != smp::OK)
    {
      std::printf("  (failed)\n");
    }
  });
}

void
CompareTimes(int faces)
{
  const TubeCase   plain(GenerateTube(faces, 0, 1));
  TubeMap          map;
  const double     ours = BestSeconds(7, [&] { map = plain.Flatten(plain.lengths); });
  NewtonFlattening newton;
  const auto       flattenByNewton = [&] {
    const CutSurface cut = CutAlongPaths(plain.tube.mesh, plain.connectivity, { map.cutPath });
    newton = FlattenByNewton(plain.connectivity, plain.tube.mesh.F, plain.lengths, plain.ends, cut);
  };
  const double byNewton = BestSeconds(7, flattenByNewton);
  std::printf("times, %d faces: u, cut, v %.3f s; Newton-CETM %.3f s (%d iterations%s)\n",
              plain.tube.mesh.NumberOfFaces(),
              ours,
              byNewton,
              newton.iterations,
              newton.hasConverged ? "" : ", STALLED");
  PrintBound("time relative to Newton-CETM", ours / byNewton, 0.55);
  std::printf("  CPU seconds: %.3f compared with %.3f\n",
              ProcessorSeconds([&] { plain.Flatten(plain.lengths); }),
              ProcessorSeconds(flattenByNewton));
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
  const double pair = BestSeconds(3, [&] { solve(2, 2); });
  const double forms = BestSeconds(2, [&] { solve(1, 2 * handles); });
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
  const double   seconds = ProcessorSeconds([&] {
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
  const double seconds = BestSeconds(faces > facesOfPeers ? 1 : 3, [&] { result = FlattenColon(mesh, "the tube"); });
  rusage       usage;
  getrusage(RUSAGE_SELF, &usage);
  std::printf("complete run, %d faces, heat diffusion metric, t = %.1f mm^2: %.2f s, peak of this run %.0f MB\n",
              result.surface.NumberOfFaces(),
              result.time,
              seconds,
              static_cast<double>(usage.ru_maxrss) / 1024.0);
}
} // namespace

int
main(int argc, char * argv[])
{
  std::vector<int> numbers;
  for (int i = 1; i < argc; ++i)
  {
    numbers.push_back(std::atoi(argv[i]));
    if (numbers.back() < 2000)
    {
      std::fprintf(stderr, "usage: %s [NUMBER OF FACES >= 2000]...\n", argv[0]);
      return 2;
    }
  }
  for (const int faces : numbers.empty() ? std::vector<int>{ 12000, 55000 } : numbers)
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
