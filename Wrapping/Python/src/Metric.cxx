#include "Bindings.h"
#include "Conversions.h"

#include "shapetonDiffusionTime.h"
#include "shapetonExceptions.h"
#include "shapetonHeatDiffusionMetric.h"
#include "shapetonHeatKernel.h"
#include "shapetonSurfaceDiffusion.h"

namespace shapeton::python
{
namespace
{
using Edges = Eigen::Matrix<int, Eigen::Dynamic, 2, Eigen::RowMajor>;

/** A surface on which diffusion is defined. */
struct Manifold
{
  explicit Manifold(const SurfaceMesh & mesh) : connectivity(mesh)
  {
    RequireOneManifold(connectivity, "the mesh");
    laplacian = MakeSurfaceLaplacian(connectivity, mesh.V);
  }

  SurfaceConnectivity connectivity;
  SurfaceLaplacian    laplacian;
};

Edges
EdgesOf(const SurfaceMesh & mesh)
{
  const SurfaceConnectivity connectivity(mesh);
  Edges                     edges(connectivity.NumberOfEdges(), 2);
  for (int edge = 0; edge < connectivity.NumberOfEdges(); ++edge)
  {
    edges(edge, 0) = connectivity.VerticesOfEdge(edge)[0];
    edges(edge, 1) = connectivity.VerticesOfEdge(edge)[1];
  }
  return edges;
}

double
DefaultTime(const Manifold & surface, const SurfaceMesh & mesh)
{
  const double edge = MeanEdgeAt55000Faces(surface.connectivity, EdgeLengths(surface.connectivity, mesh.V));
  return 8.0 * edge * edge; // default of ConformalMap
}

SurfaceSpectrum
Spectrum(const Manifold & surface, int pairs, const Progress & progress)
{
  SurfaceSpectrumOptions options;
  options.progress = progress.Part("Finding eigenpairs", 0.1, 1.0);
  return ComputeSurfaceSpectrum(surface.laplacian, pairs, options);
}

HeatDiffusionMetric
Metric(const SurfaceMesh & mesh, std::optional<double> time, std::optional<int> pairs, const Progress & progress)
{
  progress("Preparing", 0.0);
  const Manifold surface(mesh);
  const double   t = time ? *time : DefaultTime(surface, mesh);
  if (!pairs)
  {
    return ComputeHeatDiffusionMetric(
      surface.connectivity, surface.laplacian, t, progress.Part("Computing the metric", 0.1, 1.0));
  }
  const SurfaceSpectrum spectrum = Spectrum(surface, *pairs, progress);
  return TruncatedHeatDiffusionMetric(surface.laplacian, spectrum, t, *pairs);
}

py::array
DiffuseOver(const SurfaceMesh & mesh, const py::array_t<double> & values, double time, const Progress & progress)
{
  auto columns = values.cast<Eigen::MatrixXd>(); // one column for a plain array
  {
    const WithoutGil withoutGil;
    progress("Preparing", 0.0);
    DiffuseOverSurface(Manifold(mesh).laplacian, time, columns, progress.Part("Diffusing", 0.3, 1.0));
  }
  return values.ndim() == 1 ? py::cast(Eigen::VectorXd(columns.col(0))) : py::cast(columns);
}

void
AddSpectrum(py::module_ & module)
{
  py::class_<SurfaceSpectrum>(module, "SurfaceSpectrum", "The smoothest eigenfunctions of a surface of n vertices.")
    .def_readonly("eigenvalues", &SurfaceSpectrum::eigenvalues, "k, ascending from 0; 1/mm^2.")
    .def_readonly("eigenfunctions", &SurfaceSpectrum::eigenfunctions, "n x k, in columns; 1/mm. A view.")
    .def_readonly("residuals", &SurfaceSpectrum::residuals, "k, relative to the largest eigenvalue.")
    .def("heat_kernel",
         &HeatKernel,
         "p"_a,
         "q"_a,
         "time"_a,
         "Heat at vertex q at `time` (mm^2) from a unit source at vertex p; 1/mm^2.")
    .def("signature",
         &HeatKernelSignature,
         "time"_a,
         ReleaseGil(),
         "The heat kernel signature, n values: the remaining heat of a unit source at each vertex; 1/mm^2.")
    .def("signature_times",
         &HeatKernelSignatureTimes,
         "number"_a = 4,
         "Suggested times (mm^2) for the signature, logarithmically spaced.")
    .def("diffusion_distance",
         &DiffusionDistance,
         "p"_a,
         "q"_a,
         "time"_a,
         "The diffusion distance: L2 distance at `time` (mm^2) of the heat of unit sources at two vertices; 1/mm.")
    .def("diffusion_distances",
         &DiffusionDistances,
         "p"_a,
         "time"_a,
         ReleaseGil(),
         "The distances from vertex p to all vertices, n values; 1/mm.")
    .def("share_of_last_pair",
         &ShareOfLastPair,
         "time"_a,
         "Remaining fraction of the last pair at `time` (mm^2): order of magnitude of the truncation error.")
    .def("__repr__", [](const SurfaceSpectrum & spectrum) {
      return "<shapeton.surfaces.SurfaceSpectrum of " + std::to_string(spectrum.NumberOfPairs()) + " eigenpairs>";
    });

  module.def("spectrum",
             Reporting(+[](const SurfaceMesh & mesh, int pairs, const Progress & progress) {
               progress("Preparing", 0.0);
               return Spectrum(Manifold(mesh), pairs, progress);
             }),
             ReleaseGil());
}
} // namespace

void
AddMetric(py::module_ & module)
{
  AddSpectrum(module);
  py::class_<HeatDiffusionMetric>(module, "HeatDiffusionMetric", "Heat diffusion distances along all edges.")
    .def_readonly(
      "edge_lengths", &HeatDiffusionMetric::edgeLengths, "Edge lengths in the order of `surface_edges`; 1/mm.")
    .def_readonly("time", &HeatDiffusionMetric::time, "mm^2.")
    .def_readonly("eigenpairs", &HeatDiffusionMetric::eigenpairs, "Number of eigenpairs; 0 for all.")
    .def_readonly(
      "drowned_edges",
      &HeatDiffusionMetric::drownedEdges,
      "Edges with a length below rounding error, for example at the tip of a needle; set to the shortest possible "
      "length.");

  module.def("surface_edges", &EdgesOf, ReleaseGil());
  module.def(
    "edge_lengths",
    [](const SurfaceMesh & mesh) { return EdgeLengths(SurfaceConnectivity(mesh), mesh.V); },
    ReleaseGil());
  module.def("heat_diffusion_metric", Reporting(&Metric), ReleaseGil());
  module.def("diffuse_over_surface", Reporting(&DiffuseOver));
}
} // namespace shapeton::python
