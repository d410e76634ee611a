// Flattening of colon-like tubes beside Newton's method for conformal equivalence, LSCM and ARAP of CGAL on the cut
// surface, and the 2g solves of the holomorphic method; and what the map is worth without and with handles, by seeds.
// usage: FlatteningBenchmark [faces...] [decimated]; without arguments 12000 55000; "decimated" takes surfaces of
// 1,000,000 faces that are simplified to 55,000.
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

#include <Eigen/Eigenvalues>

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
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

/** Seconds of all processors. */
template <typename TBody>
double
ProcessorSeconds(const TBody & body)
{
  const std::clock_t start = std::clock();
  body();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
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
Generated(int faces, int handles, std::uint64_t seed, int span = 4)
{
  testsurfaces::ColonTubeOptions options;
  options.faces = faces;
  options.handles = handles;
  options.seed = seed;
  options.handleSpan = span;
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
  PrintBound("time against Newton-CETM", ours / byNewton, 0.55);
  std::printf("  seconds of all processors: %.3f against %.3f\n",
              ProcessorSeconds([&] { plain.Flatten(plain.lengths); }),
              ProcessorSeconds(flattenByNewton));
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
  const double    seconds = ProcessorSeconds([&] {
    detection = DetectHandles(connectivity, map.flat);
    removal = RemoveHandles(mesh, connectivity, detection.handles);
  });
  std::printf("  handles found %d of %d in %zu places, clusters rejected %d, genus after removal %d, %.3f s   %s\n",
              detection.genus,
              handles,
              detection.handles.size(),
              detection.falseAlarms,
              removal.genus,
              seconds,
              detection.genus == handles && removal.genus == 0 ? "met" : "NOT MET");
  if (mesh.NumberOfFaces() < facesOfPeers)
  {
    PrintBound("detection and removal, seconds of one processor", seconds, 0.15);
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

/** What of a map without handles one with handles shall keep. */
struct Reference
{
  double t;
  Moduli euclidean;
  Moduli diffused;
};

void
MeasureChanges(const Reference & reference, const TubeMap & inSpace, const TubeMap & map, int handles)
{
  const auto   change = [](double before, double after) { return 100.0 * std::abs(after / before - 1.0); };
  const double u = change(reference.diffused.u, map.modulusU);
  const double v = change(reference.diffused.v, map.modulusV);
  PrintBound("change of modulus U, %", u, handles > 43 ? 0.5 : 0.3);
  PrintBound("change of modulus V, %", v, handles > 43 ? 4.0 : 1.0);
  if (handles >= 43)
  {
    PrintBound("Euclidean over diffusion, U", change(reference.euclidean.u, inSpace.modulusU) / u, 4.0, true);
    PrintBound("Euclidean over diffusion, V", change(reference.euclidean.v, inSpace.modulusV) / v, 4.0, true);
  }
}

void
MeasureWithHandles(int faces, int handles, int span, std::uint64_t seed, const Reference & reference)
{
  const Case                       with(Generated(faces, handles, seed, span));
  const Eigen::VectorXd            metric = with.Diffused(reference.t);
  const TubeMap                    map = with.Flatten(metric);
  const std::vector<SurfaceHandle> truth = TrueHandles(with.tube);
  std::printf(" seed %d, %d handles between faces %d edges apart, t = %.1f mm^2\n",
              static_cast<int>(seed),
              handles,
              span,
              reference.t);
  MeasureChanges(reference, with.Flatten(with.lengths), map, handles);
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

/** A tube with polyps: round bumps inwards around vertices far apart; the faces of each. */
struct PolypTube
{
  testsurfaces::ColonTube       tube;
  std::vector<std::vector<int>> polyps;
};

PolypTube
WithPolyps(int faces, std::uint64_t seed, double radius)
{
  PolypTube          result{ Generated(faces, 0, seed), {} };
  SurfaceMesh &      mesh = result.tube.mesh;
  const VertexMatrix before = mesh.V;
  VertexMatrix       normals = VertexMatrix::Zero(before.rows(), 3);
  constexpr int      number = 20;
  for (int f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    const Eigen::Vector3d a = before.row(mesh.F(f, 0)), b = before.row(mesh.F(f, 1)), c = before.row(mesh.F(f, 2));
    for (int k = 0; k < 3; ++k)
    {
      normals.row(mesh.F(f, k)) += (b - a).cross(c - a).transpose();
    }
  }
  for (int i = 0; i < number; ++i)
  {
    const int                centre = static_cast<int>(before.rows() * (i + 1.0 + 0.37 * seed) / (number + 3.0));
    const Eigen::RowVector3d inwards = -normals.row(centre).normalized();
    for (int v = 0; v < mesh.NumberOfVertices(); ++v)
    {
      const Eigen::RowVector3d away = before.row(v) - before.row(centre);
      const double             across = (away - away.dot(inwards) * inwards).norm() / radius;
      if (away.norm() < 2.0 * radius && across < 1.0)
      {
        mesh.V.row(v) += 0.8 * radius * std::pow(std::cos(0.5 * testsurfaces::colontube::pi * across), 2) * inwards;
      }
    }
    result.polyps.emplace_back();
    for (int f = 0; f < mesh.NumberOfFaces(); ++f)
    {
      const bool isNear = (before.row(mesh.F(f, 0)) - before.row(centre)).norm() < radius;
      if (isNear)
      {
        result.polyps.back().push_back(f);
      }
    }
  }
  return result;
}

/** The ratio of the axes of the ellipse with the second moments of these faces on the map; corners weigh as the faces.
 */
double
AspectRatio(const SurfaceMesh & flat, const std::vector<int> & faces)
{
  const Eigen::MatrixX2d uv = FlatCoordinates(flat, "the map");
  Eigen::Vector2d        first = Eigen::Vector2d::Zero();
  Eigen::Matrix2d        second = Eigen::Matrix2d::Zero();
  double                 sum = 0.0;
  const double           period = FlatCircumference(flat, "the map");
  const double           reference = uv(flat.F(faces.front(), 0), 1);
  for (const int f : faces)
  {
    Eigen::RowVector2d a = uv.row(flat.F(f, 0)), b = uv.row(flat.F(f, 1)), c = uv.row(flat.F(f, 2));
    const double       area = std::abs((b - a)[0] * (c - a)[1] - (b - a)[1] * (c - a)[0]);
    Eigen::Vector2d    centre = (a + b + c).transpose() / 3.0;
    centre[1] -= period * std::round((centre[1] - reference) / period);
    first += area * centre;
    second += area * centre * centre.transpose();
    sum += area;
  }
  const Eigen::Matrix2d covariance = second / sum - first * first.transpose() / (sum * sum);
  const Eigen::Vector2d axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(covariance).eigenvalues();
  return std::sqrt(axes[1] / axes[0]);
}

void
MeasurePolyps(int faces, std::uint64_t seed, double t)
{
  const double    radius = faces < 100000 ? 10.0 : 5.0;
  const PolypTube polyps = WithPolyps(faces, seed, radius);
  const Case      with(polyps.tube);
  const TubeMap   inSpace = with.Flatten(with.lengths);
  const TubeMap   map = with.Flatten(with.Diffused(t));
  double          worst = 0.0;
  double          widest = 0.0;
  for (const std::vector<int> & polyp : polyps.polyps)
  {
    const double euclidean = AspectRatio(inSpace.flat, polyp);
    const double diffused = AspectRatio(map.flat, polyp);
    worst = std::max(worst, 100.0 * std::abs(diffused / euclidean - 1.0));
    widest = std::max(widest, diffused);
  }
  std::printf(" seed %d, %zu round polyps of radius %.0f mm, t = %.1f mm^2, largest aspect ratio %.2f\n",
              static_cast<int>(seed),
              polyps.polyps.size(),
              radius,
              t,
              widest);
  PrintBound("aspect ratio, diffusion against Euclidean, greatest difference, %", worst, 15.0);
}

void
MeasureSeed(int faces, std::uint64_t seed)
{
  const Case   plain(Generated(faces, 0, seed));
  const double edge = MeanEdgeAt55000Faces(plain.connectivity, plain.lengths);
  const double t = 8.0 * edge * edge;
  std::printf(" seed %d, no handles, Euclidean\n", static_cast<int>(seed));
  MeasurePlain(plain, 0.3, true);
  const TubeMap   euclidean = plain.Flatten(plain.lengths);
  const TubeMap   diffused = plain.Flatten(plain.Diffused(t));
  const Reference reference{ t, { euclidean.modulusU, euclidean.modulusV }, { diffused.modulusU, diffused.modulusV } };
  MeasurePolyps(faces, seed, t);
  for (const int handles : { 10, 43, 100 })
  {
    for (const int span : { 2, 4 })
    {
      if (faces / handles >= 500)
      {
        MeasureWithHandles(faces, handles, span, seed, reference);
      }
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
  if (argc == 1)
  {
    numbers = { 12000, 55000 };
  }
  for (const int faces : numbers)
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
