#include "Bindings.h"
#include "Conversions.h"
#include "Options.h"

#include "shapetonConformalType.h"
#include "shapetonEmbeddingVerification.h"
#include "shapetonExceptions.h"
#include "shapetonGraphComparison.h"
#include "shapetonGraphCurvature.h"
#include "shapetonGraphEmbedding.h"
#include "shapetonGraphFamilies.h"
#include "shapetonGraphGenus.h"
#include "shapetonGraphReader.h"

#include <algorithm>
#include <functional>

namespace shapeton::python
{
namespace
{
using Certificate = EmbeddingCertificate;

Graph
MakeGraph(int nodes, const py::object & rows, const std::vector<std::string> & names)
{
  const py::array edges = py::array::ensure(rows);
  if (!edges)
  {
    throw py::error_already_set();
  }
  const bool isEmpty = edges.size() == 0;
  const char kind = edges.dtype().kind();
  RequireParameter(isEmpty || ((kind == 'i' || kind == 'u') && edges.ndim() == 2 && edges.shape(1) == 2),
                   "the parameter \"edges\" must have two integers per row");
  const auto ends = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>(edges);
  Graph      graph{ nodes, {}, names };
  for (py::ssize_t e = 0; e < (isEmpty ? 0 : ends.shape(0)); ++e)
  {
    for (const std::int64_t end : { ends.at(e, 0), ends.at(e, 1) })
    {
      if (end < 0 || end >= nodes)
      {
        throw InputError("edge " + std::to_string(e) + " refers to node " + std::to_string(end) + ", but there are " +
                         std::to_string(nodes));
      }
    }
    graph.edges.push_back({ static_cast<int>(ends.at(e, 0)), static_cast<int>(ends.at(e, 1)) });
  }
  RequireSound(graph, "the graph");
  return graph;
}

/** Marks a view of a checked object as read-only. */
py::array
ReadOnly(py::array && view)
{
  py::detail::array_proxy(view.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return std::move(view);
}

py::array
EdgesOf(const Graph & graph, const py::handle & owner)
{
  const int * const first = graph.edges.empty() ? nullptr : graph.edges.front().data();
  return ReadOnly(py::array_t<int>({ static_cast<py::ssize_t>(graph.edges.size()), py::ssize_t{ 2 } }, first, owner));
}

Certificate
Embed(const Graph &                                        graph,
      const Given<GenusOptions> &                          givenGenus,
      const std::optional<std::vector<std::vector<int>>> & rotation,
      const Given<GraphEmbeddingOptions> &                 given,
      const Progress &                                     progress)
{
  RequireParameter(!rotation || !givenGenus.options.genus,
                   "the parameter \"rotation\" determines the genus; omit \"genus\"");
  GraphEmbeddingSettings options;
  static_cast<GraphEmbeddingOptions &>(options) = given.options;
  options.isRotationFree = !rotation;
  if (rotation)
  {
    options.progress = progress.Part("Packing circles", 0.0, 1.0);
    return EmbedGraph(graph, CombinatorialMap(graph, *rotation), options);
  }
  const GenusSettings search{ givenGenus.options, progress.Part("Finding the genus", 0.0, 0.5) };
  options.progress = progress.Part("Packing circles", 0.5, 1.0);
  const SurfaceEmbedding surface = FindEmbedding(graph, search);
  Certificate            certificate = EmbedGraph(graph, surface.map, options);
  certificate.statistics.emplace_back("genusLowerBound", surface.lowerBound);
  return certificate;
}

/** Numbers of a certificate as rows, one per circle. */
py::array
Rows(const std::vector<double> & numbers, const Certificate & certificate, const py::handle & owner)
{
  const auto columns = static_cast<py::ssize_t>(CoordinatesOf(certificate.geometry));
  return ReadOnly(
    py::array_t<double>({ static_cast<py::ssize_t>(numbers.size()) / columns, columns }, numbers.data(), owner));
}

py::array
Row(const std::vector<double> & numbers, const py::handle & owner)
{
  return ReadOnly(py::array_t<double>(static_cast<py::ssize_t>(numbers.size()), numbers.data(), owner));
}

py::dict
DictOf(const std::vector<std::pair<std::string, double>> & numbers)
{
  py::dict dictionary;
  for (const auto & [name, value] : numbers)
  {
    dictionary[py::str(name)] = value;
  }
  return dictionary;
}

/** A property that is a view of the certificate's numbers. */
template <typename TView>
auto
View(const TView & view)
{
  return [view](const py::object & self) { return view(self.cast<const Certificate &>(), self); };
}

void
AddGraph(py::module_ & module)
{
  py::class_<Graph>(module, "Graph", "An undirected graph; loops and multiple edges are allowed.")
    .def(py::init(&MakeGraph))
    .def_readonly("nodes", &Graph::nodes, "Number of nodes.")
    .def_property_readonly(
      "edges",
      [](const py::object & self) { return EdgesOf(self.cast<const Graph &>(), self); },
      "m x 2, int32: the ends of each edge; a read-only view.")
    .def_readonly("names", &Graph::names, "None, or one per node.")
    .def("__reduce__",
         [](const py::object & self) {
           return py::make_tuple(py::type::of(self),
                                 py::make_tuple(self.attr("nodes"), self.attr("edges"), self.attr("names")));
         })
    .def("__repr__", [](const Graph & graph) {
      return "<shapeton.graphs.Graph " + std::to_string(graph.nodes) + " nodes, " + std::to_string(graph.edges.size()) +
             " edges>";
    });

  module.def(
    "read_graph", [](const Path & path) { return ReadGraph(path.text).graph; }, ReleaseGil());
  module.def(
    "write_graph", [](const Graph & graph, const Path & path) { WriteGraphML(graph, path.text); }, ReleaseGil());
  module.def("complete_graph", &CompleteGraph);
  module.def("complete_bipartite_graph", &CompleteBipartiteGraph);
  module.def("grid_graph", &GridGraph);
  module.def("regular_tiling_graph", &RegularTilingGraph);
  module.def(
    "planar_part", [](const Graph & graph) { return GraphWithEdges(graph, PlanarEdges(graph)); }, ReleaseGil());
  module.def("hypercube_graph", &HypercubeGraph);
  module.def("torus_grid", [](int columns, int rows, bool diagonals) {
    const CombinatorialMap map = TorusGridMap(columns, rows, diagonals);
    return std::make_pair(map.ToGraph(), map.GetRotation());
  });
}

void
AddCertificate(py::module_ & module)
{
  py::class_<Certificate>(module, "EmbeddingCertificate", R"(A graph embedded on a surface with its circle packing.

Positions are unit vectors on the sphere (radius: the angle of a cap), otherwise (x, y) in the plane or in the Poincare
disk (radius: a length; in the disk, hyperbolic). Half-edge 2e leaves the first end of edge e, 2e + 1 the second.)")
    .def_readonly("graph", &Certificate::graph, "Graph.")
    .def_readonly("genus", &Certificate::genus, "Genus of the surface.")
    .def_property_readonly(
      "geometry",
      [](const Certificate & c) { return NameOf(c.geometry); },
      "\"spherical\" (genus 0), \"euclidean\" (1) or \"hyperbolic\".")
    .def_readonly(
      "rotation", &Certificate::rotation, "Outgoing half-edges of all nodes, counterclockwise, in one list.")
    .def_readonly("packed", &Certificate::packed, "The 3-connected graph, including dummy nodes.")
    .def_readonly(
      "subdivided", &Certificate::subdivided, "Edges subdivided into paths of the packed graph, as half-edges.")
    .def_property_readonly(
      "node_positions",
      View([](const Certificate & c, const py::handle & owner) { return Rows(c.nodePositions, c, owner); }),
      "One row per packed node, starting with the graph's nodes; a view.")
    .def_property_readonly(
      "node_radii",
      View([](const Certificate & c, const py::handle & owner) { return Row(c.nodeRadii, owner); }),
      "Radii of the circles of the packed nodes; a view.")
    .def_property_readonly(
      "face_positions",
      View([](const Certificate & c, const py::handle & owner) { return Rows(c.facePositions, c, owner); }),
      "One row per face of the packed graph; a view.")
    .def_property_readonly(
      "face_radii",
      View([](const Certificate & c, const py::handle & owner) { return Row(c.faceRadii, owner); }),
      "Radii of the circles of the faces; a view.")
    .def_property_readonly("periods",
                           View([](const Certificate & c, const py::handle & owner) { return Row(c.periods, owner); }),
                           "Periods of the torus: x1, y1, x2, y2; empty on other surfaces.")
    .def_property_readonly(
      "statistics", [](const Certificate & c) { return DictOf(c.statistics); }, "Measurements by name.")
    .def_readonly("warnings", &Certificate::warnings, "Doubtful results, one per line.")
    .def("__repr__", [](const Certificate & c) {
      return "<shapeton.graphs.EmbeddingCertificate of " + std::to_string(c.graph.nodes) + " nodes, genus " +
             std::to_string(c.genus) + ", " + NameOf(c.geometry) + ">";
    });

  module.def(
    "read_certificate", [](const Path & path) { return ReadEmbeddingCertificate(path.text); }, ReleaseGil());
  module.def(
    "write_certificate",
    [](const Certificate & certificate, const Path & path) { WriteEmbeddingCertificate(certificate, path.text); },
    ReleaseGil());
}

/** Numbers of a result, one per element of a list. */
template <typename TValue, typename TElement>
py::array
Collected(const std::vector<TElement> & elements, const std::function<TValue(const TElement &)> & valueOf)
{
  py::array_t<TValue> values(static_cast<py::ssize_t>(elements.size()));
  std::transform(elements.begin(), elements.end(), values.mutable_data(), valueOf);
  return values;
}

py::dict
DictOf(const TypeEvidence & evidence)
{
  return py::dict("type"_a = NameOf(evidence.type),
                  "decay"_a = evidence.decay,
                  "limit"_a = evidence.limit,
                  "far_limit"_a = evidence.farLimit);
}

template <typename TValue>
auto
OfBalls(TValue PackedBall::*member)
{
  return [member](const ConformalTypeResult & result) {
    return Collected<TValue, PackedBall>(result.balls, [member](const PackedBall & ball) { return ball.*member; });
  };
}

void
AddCurvature(py::module_ & module)
{
  const auto part = [](std::int64_t ExactNumber::*member) {
    return [member](const GraphCurvature & curvature) {
      return Collected<std::int64_t, ExactNumber>(curvature.edges,
                                                  [member](const ExactNumber & n) { return n.*member; });
    };
  };
  py::class_<GraphCurvature>(module, "GraphCurvature", "Discrete Ricci curvature of a graph; no unit.")
    .def_property_readonly(
      "edges",
      [](const GraphCurvature & curvature) {
        return Collected<double, ExactNumber>(curvature.edges, [](const ExactNumber & n) { return n.Value(); });
      },
      "One per edge; NaN for loops.")
    .def_property_readonly(
      "numerators", part(&ExactNumber::numerator), "Numerators of the exact curvatures of edges, int64.")
    .def_property_readonly(
      "denominators", part(&ExactNumber::denominator), "Denominators of the exact curvatures, int64; 0 for loops.")
    .def_property_readonly(
      "triangles",
      [](const GraphCurvature & curvature) {
        return Collected<int, int>(curvature.triangles, [](const int & n) { return n; });
      },
      "Common neighbors of the ends of each edge.")
    .def_property_readonly(
      "node_means",
      [](const py::object & self) { return Row(self.cast<const GraphCurvature &>().nodeMeans, self); },
      "Mean over the edges of each node; NaN without edges; a view.")
    .def_property_readonly(
      "node_sums",
      [](const py::object & self) { return Row(self.cast<const GraphCurvature &>().nodeSums, self); },
      "Sum over the edges of each node; a view.");
  module.def("ricci_curvature",
             Reporting(+[](const Graph & graph, const Given<GraphCurvatureOptions> & given, const Progress & progress) {
               return MeasureCurvature(graph, { given.options, progress.Part("Measuring curvature", 0.0, 1.0) });
             }),
             ReleaseGil());
}

void
AddConformalType(py::module_ & module)
{
  using Result = ConformalTypeResult;
  py::class_<Result>(module, "ConformalTypeResult", "Balls of growing radius, their packings, and the verdict.")
    .def_property_readonly(
      "type", [](const Result & r) { return NameOf(r.type); }, "\"parabolic\", \"hyperbolic\" or \"not decided\".")
    .def_readonly("root", &Result::root, "Node at the center of the balls.")
    .def_property_readonly(
      "limit_radius",
      [](const Result & r) { return py::make_tuple(r.leastLimitRadius, r.limitRadius); },
      "Extrapolated hyperbolic radius of the circle of the root, two values; 0 if parabolic, NaN if not decided.")
    .def_property_readonly("radii", OfBalls(&PackedBall::radius), "Radius of each ball, edges.")
    .def_property_readonly("nodes", OfBalls(&PackedBall::nodes), "Nodes of each ball.")
    .def_property_readonly(
      "root_radii", OfBalls(&PackedBall::rootRadius), "Hyperbolic radius of the circle of the root in each ball.")
    .def_property_readonly("moduli", OfBalls(&PackedBall::modulus), "-log tanh(r / 2) of the root radii.")
    .def_property_readonly("resistances",
                           OfBalls(&PackedBall::resistance),
                           "Effective resistance from the root to the boundary of each ball.")
    .def_property_readonly(
      "packing",
      [](const Result & r) { return DictOf(r.packing); },
      "Growth of the moduli: type, decay, limit, far_limit.")
    .def_property_readonly(
      "resistance",
      [](const Result & r) { return DictOf(r.resistance); },
      "Growth of the resistances: type, decay, limit, far_limit.");
  module.def(
    "conformal_type",
    Reporting(+[](const Graph & graph, int root, const Given<ConformalTypeOptions> & given, const Progress & progress) {
      return FindConformalType(graph, { given.options, root, progress });
    }),
    ReleaseGil());
  module.def(
    "conformal_type_of_sequence",
    Reporting(+[](const std::vector<Graph> & graphs, const std::vector<int> & roots, const Progress & progress) {
      RequireParameter(!graphs.empty() && graphs.size() == roots.size() &&
                         *std::min_element(roots.begin(), roots.end()) >= 0,
                       "the parameter \"roots\" must have one node per graph");
      return FindConformalType(graphs, roots, progress);
    }),
    ReleaseGil());
}
} // namespace

void
AddGraphs(py::module_ & module)
{
  AddGraph(module);
  AddCertificate(module);
  AddCurvature(module);
  AddConformalType(module);
  py::class_<EmbeddingVerdict>(module, "EmbeddingVerdict", "Result of `verify_embedding`.")
    .def_property_readonly(
      "is_valid",
      [](const EmbeddingVerdict & v) { return v.refusal.empty(); },
      "Whether the absence of crossings is proven.")
    .def_readonly("refusal", &EmbeddingVerdict::refusal, "The first failed condition; otherwise empty.")
    .def_property_readonly(
      "measures", [](const EmbeddingVerdict & v) { return DictOf(v.measures); }, "Measurements by name.");
  py::class_<GraphComparison>(module, "GraphComparison", "Comparison of two graphs.")
    .def_readonly("isomorphic", &GraphComparison::isomorphic, "Whether the graphs are isomorphic.")
    .def_readonly("a", &GraphComparison::a, "Certificate of the first graph in canonical order.")
    .def_readonly("b", &GraphComparison::b, "Certificate of the second graph in canonical order.")
    .def_readonly(
      "differences", &GraphComparison::differences, "Differences as sentences; empty for isomorphic graphs.")
    .def_property_readonly(
      "correspondence",
      [](const GraphComparison & c) { return c.correspondence.image; },
      "Corresponding node of `b.graph` for each node of `a.graph`, or -1.")
    .def_property_readonly(
      "correspondence_by",
      [](const GraphComparison & c) { return c.correspondence.by; },
      "\"isomorphism\", \"names\", \"neighborhoods\" or \"none\".");

  module.def("embed_graph", Reporting(&Embed), ReleaseGil());
  module.def("verify_embedding", &VerifyEmbedding, ReleaseGil());
  module.def(
    "compare_graphs",
    Reporting(+[](const Graph & a, const Graph & b, const Given<GenusOptions> & given, const Progress & progress) {
      return CompareGraphs(a, b, { given.options, {} }, {}, progress);
    }),
    ReleaseGil());
}
} // namespace shapeton::python
