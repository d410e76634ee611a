// Flattening of colon-like tubes beside Newton's method for conformal equivalence, LSCM and ARAP of CGAL on the cut
// surface, and the 2g solves of the holomorphic method; and what the map is worth without and with handles, by seeds.
// usage: FlatteningBenchmark [faces...] [decimated]; "decimated" adds surfaces of 1,000,000 faces simplified to 55,000.
#include "NewtonFlattening.h"

#include "itkColonFlattening.h"
#include "itkColonTube.h"
#include "itkHarmonicSolver.h"
#include "itkHeatDiffusionMetric.h"
#include "itkSurfaceSimplification.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <set>

namespace
{
using namespace itk;
namespace smp = CGAL::Surface_mesh_parameterization;
using CgalMesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

constexpr int facesOfPeers = 60000; // ARAP takes long

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
PrintBound(const char * text, double value, double asked, bool isLeast = false)
{
  const bool isMet = isLeast ? value >= asked : value <= asked;
  std::printf(
    "  %-66s %10.4g   asked %s %g   %s\n", text, value, isLeast ? ">=" : "<=", asked, isMet ? "met" : "NOT MET");
}

/** A tube, its Euclidean and heat diffusion lengths. */
struct Case
{
  explicit Case(const testsurfaces::ColonTube & generated)
    : tube(generated)
    , connectivity(tube.mesh)
    , ends(FindTubeEnds(tube.mesh, connectivity, "the tube"))
    , lengths(EdgeLengths(connectivity, tube.mesh.V))
  {}
  TubeMap
  Flatten(const Eigen::VectorXd & metric) const
  {
    return FlattenTube(tube.mesh, connectivity, metric, ends);
  }
  Eigen::VectorXd
  Diffused(double t) const
  {
    return HeatDiffusionMetricSolver(MakeSurfaceLaplacian(connectivity, tube.mesh.V)).Compute(t).edgeLengths;
  }
  FlatDistortion
  Distortion(const TubeMap & map, const Eigen::VectorXd & metric) const
  {
    return MeasureFlatDistortion(map.flat.F, FlatCoordinates(map.flat, "the map"), SidesOfFaces(connectivity, metric));
  }

  testsurfaces::ColonTube tube;
  SurfaceConnectivity     connectivity;
  TubeEnds                ends;
  Eigen::VectorXd         lengths;
};

testsurfaces::ColonTube
Generated(int faces, int handles, std::uint64_t seed)
{
  testsurfaces::ColonTubeOptions options;
  options.faces = faces;
  options.handles = handles;
  options.seed = seed;
  return testsurfaces::MakeColonTube(options);
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
      std::printf("  (it failed)\n");
    }
  });
}

void
CompareTimes(int faces)
{
  const Case       plain(Generated(faces, 0, 1));
  TubeMap          map;
  const double     ours = BestSeconds(7, [&] { map = plain.Flatten(plain.lengths); });
  NewtonFlattening newton;
  const double     byNewton = BestSeconds(5, [&] {
    const CutSurface cut = CutAlongPaths(plain.tube.mesh, plain.connectivity, { map.cutPath });
    newton = FlattenByNewton(plain.connectivity, plain.tube.mesh.F, plain.lengths, plain.ends, cut);
  });
  std::printf("times, %d faces: u, cut, v %.3f s; Newton-CETM %.3f s (%d iterations%s)\n",
              plain.tube.mesh.NumberOfFaces(),
              ours,
              byNewton,
              newton.iterations,
              newton.hasConverged ? "" : ", STALLED");
  PrintBound("time against Newton-CETM", ours / byNewton, 0.55);
  if (faces > facesOfPeers)
  {
    return;
  }
  const double byLscm = SecondsOfCgal<smp::LSCM_parameterizer_3<CgalMesh>>(map.flat, 3);
  const double byArap = SecondsOfCgal<smp::ARAP_parameterizer_3<CgalMesh>>(map.flat, 1);
  std::printf("  CGAL LSCM %.3f s, CGAL ARAP %.3f s on the cut surface\n", byLscm, byArap);
  PrintBound("time against CGAL LSCM", ours / byLscm, 0.25);
  PrintBound("time against CGAL ARAP", ours / byArap, 0.03);
}

/** A pair of Laplacians, each with its factorisation, against one factorisation with 2g solves. */
void
CompareWithHolomorphicForms(int faces, int handles)
{
  const Case             with(Generated(faces, handles, 1));
  const SurfaceLaplacian laplacian = MakeSurfaceLaplacian(with.connectivity, with.lengths);
  const Eigen::MatrixXd  source = Eigen::MatrixXd::Random(laplacian.NumberOfVertices(), 1);
  const Eigen::MatrixXd  zero = Eigen::MatrixXd::Zero(1, 1);
  const auto             solve = [&](int factorisations, int solves) {
    for (int i = 0; i < factorisations; ++i)
    {
      const HarmonicSolver solver(laplacian, { 0 });
      for (int k = 0; k < solves / factorisations; ++k)
      {
        solver.Solve(zero, source);
      }
    }
  };
  const double pair = BestSeconds(3, [&] { solve(2, 2); });
  const double forms = BestSeconds(2, [&] { solve(1, 2 * handles); });
  std::printf("  %3d handles: 2 solves against %3d; %.3f s with 2 factorisations against %.3f s with one: %.2f\n",
              handles,
              2 * handles,
              pair,
              forms,
              pair / forms);
}

void
MeasurePlain(const Case & plain, double gapAsked, bool needsNewton)
{
  const TubeMap             map = plain.Flatten(plain.lengths);
  const FlatDistortion      distortion = plain.Distortion(map, plain.lengths);
  const DistortionQuantiles quantiles = QuantilesOfDilatation(distortion);
  PrintBound("flips", distortion.flips, 0);
  PrintBound("gap of the moduli, %", 100.0 * map.Gap(), gapAsked);
  PrintBound("dilatation, median", quantiles.median, 1.04);
  PrintBound("dilatation, 95 %", quantiles.p95, 1.10);
  const CutSurface       cut = CutAlongPaths(plain.tube.mesh, plain.connectivity, { map.cutPath });
  const NewtonFlattening newton =
    FlattenByNewton(plain.connectivity, plain.tube.mesh.F, plain.lengths, plain.ends, cut);
  if (!newton.hasConverged)
  {
    std::printf("  Newton-CETM stalls after %d iterations%s\n", newton.iterations, needsNewton ? "   NOT MET" : "");
    return;
  }
  const bool isInside = map.modulusV <= newton.modulus && newton.modulus <= map.modulusU;
  std::printf("  moduli %.6f <= Newton-CETM %.6f <= %.6f   %s\n",
              map.modulusV,
              newton.modulus,
              map.modulusU,
              isInside ? "met" : "NOT MET");
}

std::vector<SurfaceHandle>
TrueHandles(const testsurfaces::ColonTube & tube)
{
  std::vector<SurfaceHandle> handles;
  for (const auto & vertices : tube.handles)
  {
    SurfaceHandle handle;
    handle.vertices.assign(vertices.begin(), vertices.end());
    for (const int v : vertices)
    {
      handle.place += tube.mesh.V.row(v).transpose() / 6.0;
    }
    handles.push_back(handle);
  }
  return handles;
}

/** Detection on a map and removal, with the places of the handles where they are known. */
void
MeasureHandles(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity, const TubeMap & map, int handles)
{
  HandleDetection detection;
  HandleRemoval   removal;
  const double    seconds = BestSeconds(3, [&] {
    detection = DetectHandles(connectivity, map.flat);
    removal = RemoveHandles(mesh, connectivity, detection.handles);
  });
  std::printf(
    "  handles found %d of %d in %zu places, false alarms 0 of %d clusters, genus after removal %d, %.3f s   %s\n",
    detection.genus,
    handles,
    detection.handles.size(),
    detection.falseAlarms + static_cast<int>(detection.handles.size()),
    removal.genus,
    seconds,
    detection.genus == handles && removal.genus == 0 ? "met" : "NOT MET");
  if (mesh.NumberOfFaces() < facesOfPeers)
  {
    PrintBound("time of detection and removal, s", seconds, 0.15);
  }
}

/** Handles found whose place is within three mean edges of a true one, each of which serves once. */
int
Located(const std::vector<SurfaceHandle> & found, std::vector<SurfaceHandle> truth, double distance)
{
  int located = 0;
  for (const SurfaceHandle & handle : found)
  {
    const auto near = std::find_if(truth.begin(), truth.end(), [&](const SurfaceHandle & other) {
      return (other.place - handle.place).norm() < distance;
    });
    if (near != truth.end())
    {
      truth.erase(near);
      ++located;
    }
  }
  return located;
}

struct Moduli
{
  double u;
  double v;
};

double
Change(const Moduli & before, const TubeMap & after)
{
  return std::max(std::abs(after.modulusU / before.u - 1.0), std::abs(after.modulusV / before.v - 1.0));
}

void
MeasureWithHandles(int            faces,
                   int            handles,
                   std::uint64_t  seed,
                   double         t,
                   const Moduli & euclidean,
                   const Moduli & diffused)
{
  const Case                       with(Generated(faces, handles, seed));
  const Eigen::VectorXd            metric = with.Diffused(t);
  const TubeMap                    inSpace = with.Flatten(with.lengths);
  const TubeMap                    map = with.Flatten(metric);
  const std::vector<SurfaceHandle> truth = TrueHandles(with.tube);
  std::printf(" seed %d, %d handles, t = %.1f mm^2\n", static_cast<int>(seed), handles, t);
  PrintBound("change of modulus U, %", 100.0 * std::abs(map.modulusU / diffused.u - 1.0), handles > 43 ? 0.5 : 0.3);
  PrintBound("change of modulus V, %", 100.0 * std::abs(map.modulusV / diffused.v - 1.0), handles > 43 ? 4.0 : 1.0);
  PrintBound("Euclidean over diffusion, greater change", Change(euclidean, inSpace) / Change(diffused, map), 4.0, true);
  const FlatDistortion    distortion = with.Distortion(map, metric);
  const std::vector<char> isNear = FacesNearHandles(with.connectivity, truth, 3);
  int                     away = 0;
  for (std::size_t f = 0; f < isNear.size(); ++f)
  {
    away += distortion.isFlipped[f] && !isNear[f] ? 1 : 0;
  }
  PrintBound("flips farther than 3 rings from a handle", away, 0);
  std::set<int> ofHandles;
  for (const SurfaceHandle & handle : truth)
  {
    ofHandles.insert(handle.vertices.begin(), handle.vertices.end());
  }
  PrintBound("vertices of handles on the cut",
             std::count_if(map.cutPath.begin(), map.cutPath.end(), [&](int v) { return ofHandles.count(v) > 0; }),
             0);
  MeasureHandles(with.tube.mesh, with.connectivity, map, handles);
  const HandleDetection detection = DetectHandles(with.connectivity, map.flat);
  const int             located = Located(detection.handles, truth, 3.0 * with.lengths.mean());
  PrintBound("places within 3 edges of a true one, of those found",
             static_cast<double>(located) / static_cast<double>(detection.handles.size()),
             1.0,
             true);
}

void
MeasureSeed(int faces, std::uint64_t seed)
{
  const Case   plain(Generated(faces, 0, seed));
  const double edge = MeanEdgeAt55000Faces(plain.connectivity, plain.lengths);
  const double t = 8.0 * edge * edge;
  std::printf(" seed %d, no handles, Euclidean\n", static_cast<int>(seed));
  MeasurePlain(plain, 0.3, true);
  const TubeMap euclidean = plain.Flatten(plain.lengths);
  const TubeMap diffused = plain.Flatten(plain.Diffused(t));
  for (const int handles : { 10, 43, 100 })
  {
    if (faces / handles >= 500)
    {
      MeasureWithHandles(
        faces, handles, seed, t, { euclidean.modulusU, euclidean.modulusV }, { diffused.modulusU, diffused.modulusV });
    }
  }
}

void
MeasureDecimated(std::uint64_t seed, int handles)
{
  SurfaceSimplificationOptions options;
  options.targetFaces = 55000;
  testsurfaces::ColonTube tube = Generated(1000000, handles, seed);
  tube.mesh = SimplifySurface(tube.mesh, options);
  const Case decimated(tube);
  std::printf(" seed %d, 1,000,000 faces decimated to %d, %d handles, Euclidean\n",
              static_cast<int>(seed),
              tube.mesh.NumberOfFaces(),
              handles);
  if (handles == 0)
  {
    MeasurePlain(decimated, 0.5, false);
    return;
  }
  MeasureHandles(tube.mesh, decimated.connectivity, decimated.Flatten(decimated.lengths), handles);
}

void
MeasureWholeJob(int faces)
{
  const SurfaceMesh mesh = Generated(faces, 0, 1).mesh;
  ColonFlattening   result;
  const double seconds = BestSeconds(faces > facesOfPeers ? 1 : 3, [&] { result = FlattenColon(mesh, "the tube"); });
  rusage       usage;
  getrusage(RUSAGE_SELF, &usage);
  std::printf("whole job, %d faces, heat diffusion metric, t = %.1f mm^2: %.2f s, peak of this run %.0f MB\n",
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
  bool             withDecimated = false;
  for (int i = 1; i < argc; ++i)
  {
    withDecimated = withDecimated || std::strcmp(argv[i], "decimated") == 0;
    if (std::atoi(argv[i]) > 0)
    {
      numbers.push_back(std::atoi(argv[i]));
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
    MeasureWholeJob(faces);
    for (std::uint64_t seed = 1; seed <= 3 && faces < 500000; ++seed)
    {
      MeasureSeed(faces, seed);
    }
  }
  for (std::uint64_t seed = 1; withDecimated && seed <= 3; ++seed)
  {
    MeasureDecimated(seed, 0);
    MeasureDecimated(seed, 43);
    MeasureDecimated(seed, 100);
  }
  return EXIT_SUCCESS;
}
