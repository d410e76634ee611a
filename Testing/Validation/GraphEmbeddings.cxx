#include "Tables.h"
#include "Times.h"
#include "ValidationReport.h"
#include "GraphPackingPeers.h"

#include "shapetonDynamicEmbedding.h"
#include "shapetonEmbeddingVerification.h"
#include "shapetonGraphEmbedding.h"
#include "shapetonGraphFamilies.h"
#include "shapetonGraphGenus.h"
#include "shapetonGraphReader.h"
#include "shapetonSensorNetwork.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <filesystem>
#include <functional>

using namespace shapeton;

namespace
{
/** Graphs with more edges and a genus above 20 are skipped, because the search takes minutes. */
constexpr std::size_t mostEdges = 1000;
constexpr std::size_t largestGenus = 20;

/** Euler's formula: edges <= 3 (nodes - 2 + 2 genus). */
bool
IsLeftOut(const Graph & graph)
{
  return graph.edges.size() > std::max(mostEdges, 3 * (graph.nodes - 2 + 2 * largestGenus));
}

double
ValueOf(const std::vector<std::pair<std::string, double>> & values, const std::string & name)
{
  const auto found = std::find_if(values.begin(), values.end(), [&](const auto & v) { return v.first == name; });
  return found == values.end() ? 0.0 : found->second;
}

/** Results of the graphs of one folder or file. */
struct GraphSet
{
  void
  Add(const Graph & graph);
  void
  Add(const GraphSet & set);

  int    graphs{ 0 };
  int    accepted{ 0 };
  int    largest{ 0 }; ///< largest genus
  double residual{ 0.0 };
  double tangency{ 0.0 };
  double orthogonality{ 0.0 };
  /** Radii of node circles: on the sphere, in the disk, and on the torus relative to its shorter period. */
  std::vector<double> caps;
};

void
GraphSet::Add(const Graph & graph)
{
  const SurfaceEmbedding surface = FindEmbedding(graph);
  GraphEmbeddingSettings options;
  options.isRotationFree = true;
  const EmbeddingCertificate certificate = EmbedGraph(graph, surface.map, options);
  const EmbeddingVerdict     verdict = VerifyEmbedding(certificate);
  const double               unit = UnitOfSurface(certificate);
  ++graphs;
  accepted += verdict.refusal.empty();
  largest = std::max(largest, certificate.genus);
  residual = std::max(residual, ValueOf(certificate.statistics, "residual"));
  tangency = std::max(tangency, ValueOf(verdict.measures, "tangency"));
  orthogonality = std::max(orthogonality, ValueOf(verdict.measures, "orthogonality"));
  for (int node = 0; node < graph.nodes; ++node)
  {
    caps.push_back(certificate.nodeRadii[node] / unit);
  }
}

void
GraphSet::Add(const GraphSet & set)
{
  graphs += set.graphs;
  accepted += set.accepted;
  largest = std::max(largest, set.largest);
  residual = std::max(residual, set.residual);
  tangency = std::max(tangency, set.tangency);
  orthogonality = std::max(orthogonality, set.orthogonality);
  caps.insert(caps.end(), set.caps.begin(), set.caps.end());
}

/** Files of a folder, or one file, sorted by name. */
std::vector<std::string>
FilesOf(const std::string & path)
{
  std::vector<std::string> files;
  if (!std::filesystem::is_directory(path))
  {
    return { path };
  }
  for (const auto & entry : std::filesystem::recursive_directory_iterator(path))
  {
    if (entry.is_regular_file() && entry.path().filename() != "LICENSE.matpower")
    {
      files.push_back(entry.path().string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

int
CountBelow(const std::vector<double> & caps, double limit)
{
  return static_cast<int>(std::count_if(caps.begin(), caps.end(), [=](double cap) { return cap < limit; }));
}

/** `hasBounds`: the bound of small circles applies to complete sets only. */
void
AddSet(const std::string & name, const GraphSet & set, bool hasBounds, ValidationReport & report, CsvTable & table)
{
  const int    small = CountBelow(set.caps, 1e-4);
  const double smallest = *std::min_element(set.caps.begin(), set.caps.end());
  const bool   isExact =
    set.accepted == set.graphs && set.residual <= 1e-12 && set.tangency <= 1e-9 && set.orthogonality <= 1e-10;
  const bool areLarge = smallest >= 1e-6 && (name != "rome" || small <= 0.03 * static_cast<double>(set.caps.size()));
  table.AddRow(Cells() << name << RatioOf(set.accepted, set.graphs) << set.largest << Rounded(set.residual, 2)
                       << Rounded(set.tangency, 2) << Rounded(set.orthogonality, 2) << report.Check(isExact)
                       << Rounded(smallest, 2) << RatioOf(small, static_cast<int>(set.caps.size()))
                       << (hasBounds ? report.Check(areLarge) : ""));
}

void
EmbedFiles(const ValidationSettings & settings, ValidationReport & report)
{
  if (settings.dataFolder.empty())
  {
    report.AddText("The graphs of SHAPETON_TEST_DATA_DIR were not at hand.");
    return;
  }
  CsvTable table(Columns("graphs | certificate accepted | largest genus | residual | tangency | orthogonality | exact "
                         "| smallest circle | circles below 1e-4 | large enough"));
  GraphSet all;
  std::string smallOfRome;
  std::string leftOut;
  for (const char * const name : { "rome", "north", "power", "named", "karate.gml", "3elt.graph" })
  {
    GraphSet set;
    int      number = 0;
    for (const std::string & file : FilesOf(settings.dataFolder + "/graphs/" + name))
    {
      const Graph graph = ReadGraph(file).graph;
      if (IsLeftOut(graph))
      {
        leftOut += (leftOut.empty() ? "" : ", ") + std::filesystem::path(file).stem().string();
      }
      else if (!settings.quick || number++ % 10 == 0)
      {
        set.Add(graph);
      }
    }
    AddSet(name, set, !settings.quick, report, table);
    smallOfRome = smallOfRome.empty() ? table.GetRows().back()[8] : smallOfRome; // the first set
    all.Add(set);
  }
  CsvTable extremes({ "extreme of all graphs", "value", "bound" });
  extremes.AddRow({ "certificates accepted", RatioOf(all.accepted, all.graphs), "all" });
  extremes.AddRow({ "residual", Rounded(all.residual, 2), "1e-12" });
  extremes.AddRow({ "tangency on the unit sphere", Rounded(all.tangency, 2), "1e-9" });
  extremes.AddRow({ "orthogonality on the unit sphere", Rounded(all.orthogonality, 2), "1e-10" });
  extremes.AddRow(Cells() << "smallest circle of a node"
                          << Rounded(*std::min_element(all.caps.begin(), all.caps.end()), 2) << "at least 1e-6");
  extremes.AddRow({ "circles below 1e-4 in rome", smallOfRome, "3 %" });
  report.AddText("Each graph is embedded with the genus found by the search, and its certificate is verified.");
  report.AddTable(extremes);
  report.AddRows("sets", table);
  if (!leftOut.empty())
  {
    report.AddText("Skipped (more than " + std::to_string(mostEdges) + " edges and genus above " +
                   std::to_string(largestGenus) + "): " + leftOut + ".");
  }
}

void
FindGenera(bool isQuick, ValidationReport & report)
{
  struct Known
  {
    std::string name;
    Graph       graph;
    int         genus;
  };
  std::vector<Known> graphs = {
    { "K5", CompleteGraph(5), 1 }, { "K3,3", CompleteBipartiteGraph(3, 3), 1 },       { "K7", CompleteGraph(7), 1 },
    { "K8", CompleteGraph(8), 2 }, { "Petersen", GeneralizedPetersenGraph(5, 2), 1 }, { "Q4", HypercubeGraph(4), 1 }
  };
  if (!isQuick)
  {
    graphs.insert(graphs.end(),
                  { { "K9", CompleteGraph(9), 3 },
                    { "K10", CompleteGraph(10), 4 },
                    { "K12", CompleteGraph(12), 6 },
                    { "K13", CompleteGraph(13), 8 },
                    { "K15", CompleteGraph(15), 12 },
                    { "Q5", HypercubeGraph(5), 5 } });
  }
  CsvTable table({ "graph", "genus found", "bound", "" });
  for (const Known & known : graphs)
  {
    const int genus = FindEmbedding(known.graph).map.Genus();
    table.AddRow(Cells() << known.name << genus << known.genus << report.Check(genus <= known.genus));
  }
  report.AddText("The search finds the genus of all known graphs except K15 (genus 11), for which the bound is 12.");
  report.AddRows("genera", table);
}

std::string
Measured(double seconds)
{
  return Rounded(seconds, 2) + " s";
}

void
CompareWithSfdp(bool isQuick, ValidationReport & report)
{
  const int            side = isQuick ? 20 : 55;
  SensorNetworkOptions options;
  options.nodes = isQuick ? 400 : 3000;
  options.range = 2200.0 / std::sqrt(options.nodes);
  const std::vector<std::pair<std::string, Graph>> graphs = {
    { "triangles on a sphere", peers::GridOnSphere(side).ToGraph() },
    { "sensor network, Gabriel graph", SensorNetwork(options).GetGraph() },
    { "path of 80", PathGraph(80) }
  };
  int      proved = 0;
  CsvTable table({ "graph", "nodes", "edges", "embedding", "crossings", "sfdp", "crossings of sfdp" });
  for (const auto & [name, graph] : graphs)
  {
    EmbeddingCertificate certificate;
    const double         seconds = SecondsOf([&] { certificate = EmbedGraph(graph, FindEmbedding(graph).map); });
    const bool           isAccepted = VerifyEmbedding(certificate).refusal.empty();
    const peers::SfdpRun sfdp = peers::RunSfdp(graph);
    table.AddRow(Cells() << name << graph.nodes << graph.edges.size() << Measured(seconds)
                         << (isAccepted ? "0, proved" : "not proved")
                         << (sfdp.seconds < 0.0 ? "not installed" : Measured(sfdp.seconds))
                         << (sfdp.seconds < 0.0 ? "" : std::to_string(sfdp.crossings)));
    report.Check(isAccepted);
    proved += isAccepted ? 1 : 0;
  }
  report.AddText("Planar embedding and packing compared with the force layout of Graphviz's sfdp: times and crossings. "
                 "The verifier proves that embeddings have no crossings: " +
                 RatioOf(proved, static_cast<int>(graphs.size())) + '.');
  report.AddRows("sfdp", table);
}

void
CompareSpeed(bool isQuick, ValidationReport & report)
{
  const CombinatorialMap  sphere = peers::GridOnSphere(isQuick ? 20 : 55);
  const CirclesAtInfinity infinite = peers::CirclesThroughFirstEdge(sphere);
  CirclePacking           packing;
  const double            newton = SecondsOf([&] { packing = PackCircles(sphere, FlowGeometry::Euclidean, infinite); });
  const auto              run = [&](peers::Method method) { return peers::RunPeer(sphere, infinite, method); };
  const peers::PeerRun    sweep = run(peers::Method::ThurstonSweep);
  const peers::PeerRun    flow = run(peers::Method::GradientFlow);
  const auto              ratio = [&](const peers::PeerRun & peer) {
    return Rounded(peer.seconds / newton) + (peer.isExtrapolated ? " (extrapolated)" : "");
  };
  const auto isMet = [&](bool isReached) { return isQuick ? std::string() : report.Check(isReached); };
  CsvTable   table(
    Columns("nodes | Newton | Thurston sweeps / Newton | at least 100 | gradient flow / Newton | at least 1000"));
  table.AddRow(Cells() << sphere.Nodes() << Measured(newton) << ratio(sweep) << isMet(sweep.seconds >= 100.0 * newton)
                       << ratio(flow) << isMet(flow.seconds >= 1000.0 * newton));
  report.AddText("Circle packing of a triangulated sphere to a curvature of 1e-10 by three methods in one run:");
  report.AddTable(table);
}

// ---- stability ----

/** Displacement of nodes when a few edges change. Lengths are in radii of the sphere or of the layout (the root mean
 * square distance of its nodes from their center). */
struct GraphStability
{
  int    unchangedNodes{ 0 };
  double moebius{ 0.0 };  ///< mean displacement after the best Moebius transformation, as in DynamicGraph
  double rotation{ 0.0 }; ///< mean displacement after the best rotation
  double sfdp{ -1.0 };    ///< force layout, after the best similarity; negative if not installed
};

using Places = std::vector<std::complex<double>>;

/** Removes some edges from the graph. */
Graph
Without(const Graph & graph, std::vector<std::size_t> gone)
{
  Graph rest{ graph.nodes, {}, graph.names };
  for (std::size_t edge = 0; edge < graph.edges.size(); ++edge)
  {
    if (std::find(gone.begin(), gone.end(), edge) == gone.end())
    {
      rest.edges.push_back(graph.edges[edge]);
    }
  }
  return rest;
}

/** Centers the layout and scales it to size 1. */
Places
Normalized(const std::vector<std::array<double, 2>> & layout)
{
  Places               places;
  std::complex<double> center = 0.0;
  for (const std::array<double, 2> & place : layout)
  {
    places.emplace_back(place[0], place[1]);
    center += places.back() / static_cast<double>(layout.size());
  }
  double square = 0.0;
  for (std::complex<double> & place : places)
  {
    place -= center;
    square += std::norm(place) / static_cast<double>(layout.size());
  }
  for (std::complex<double> & place : places)
  {
    place /= std::sqrt(square);
  }
  return places;
}

/** Mean distance of the unchanged nodes after the least-squares similarity, with reflection allowed. */
double
MeanDistance(const Places & a, const Places & b, const std::vector<char> & isChanged)
{
  double best = 1e300;
  for (const bool isMirrored : { false, true })
  {
    const auto           imageOf = [&](std::size_t i) { return isMirrored ? std::conj(b[i]) : b[i]; };
    std::complex<double> factor = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
    {
      factor += a[i] * std::conj(imageOf(i)) / static_cast<double>(a.size());
    }
    double sum = 0.0;
    double number = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
    {
      sum += isChanged[i] ? 0.0 : std::abs(a[i] - factor * imageOf(i));
      number += isChanged[i] ? 0.0 : 1.0;
    }
    best = std::min(best, sum / number);
  }
  return best;
}

double
SfdpDisplacement(const Graph & before, const Graph & after, const std::vector<int> & changedNodes)
{
  const peers::SfdpRun a = peers::RunSfdp(before, false);
  const peers::SfdpRun b = peers::RunSfdp(after, false);
  if (a.seconds < 0.0 || b.seconds < 0.0)
  {
    return -1.0;
  }
  std::vector<char> isChanged(before.nodes, 0);
  for (const int node : changedNodes)
  {
    isChanged[node] = 1;
  }
  return MeanDistance(Normalized(a.places), Normalized(b.places), isChanged);
}

/** Moves the barycenter of the circles to the center of the sphere, as without a previous step. */
EmbeddingCertificate
NotMoved(const EmbeddingCertificate & certificate)
{
  return EmbedPackedGraph(certificate.graph,
                          MapOfRotation(certificate.graph, certificate.rotation),
                          PackedMapOf(certificate),
                          PointAtInfinity::Circle);
}
/** Two steps of a graph. Each lacks a different set of `edits` / 2 edges, evenly spaced in the edge list, so `edits` /
 * 2 edges disappear and the same number appear. */
GraphStability
MeasureStability(const Graph & graph, int edits, bool withSfdp)
{
  std::vector<std::size_t> gone[2];
  for (int k = 0; k < edits; ++k)
  {
    gone[k % 2].push_back((2 * k + 1) * graph.edges.size() / (2 * edits));
  }
  const Graph                before = Without(graph, gone[0]);
  const Graph                after = Without(graph, gone[1]);
  DynamicEmbedding           dynamic;
  const DynamicStep          first = dynamic.Add(before);
  const DynamicStep          second = dynamic.Add(after);
  const EmbeddingCertificate turned = NotMoved(second.certificate);
  GraphStability             stability;
  stability.unchangedNodes = second.changes.unchangedNodes;
  stability.moebius = second.changes.meanDisplacement;
  stability.rotation = ChangesBetween(first.certificate, turned).meanDisplacement;
  stability.sfdp = withSfdp ? SfdpDisplacement(before, after, second.changes.changedNodes) : -1.0;
  return stability;
}

/** Ten edits. The bounds apply to graphs of 3,000 to 5,000 nodes; the results of these graphs are also added to
 * `bounded`. */
void
AddStability(const std::string & name,
             const Graph &       graph,
             ValidationReport &  report,
             CsvTable &          table,
             CsvTable &          bounded)
{
  const GraphStability stability = MeasureStability(graph, 10, graph.nodes <= 5000);
  const bool           hasSfdp = stability.sfdp >= 0.0;
  const bool           hasBound = graph.nodes >= 3000 && graph.nodes <= 5000;
  table.AddRow(Cells() << name << graph.nodes << Rounded(stability.moebius, 2)
                       << (hasBound ? report.Check(stability.moebius <= 0.002) : "") << Rounded(stability.rotation, 2)
                       << (hasSfdp ? Rounded(stability.sfdp, 2) : "")
                       << (hasSfdp ? Rounded(stability.sfdp / stability.moebius) : "")
                       << (hasBound && hasSfdp ? report.Check(stability.sfdp >= 10.0 * stability.moebius) : ""));
  if (hasBound)
  {
    bounded.AddRow(table.GetRows().back());
  }
}

/** Sensor network with the same number of links per device, for any number of devices. */
Graph
GabrielGraph(int devices, std::uint64_t seed)
{
  SensorNetworkOptions options;
  options.nodes = devices;
  options.range = 2200.0 / std::sqrt(devices);
  options.seed = seed;
  return SensorNetwork(options).GetGraph();
}

void
MoveLittle(bool isQuick, ValidationReport & report)
{
  CsvTable table(
    Columns("graph | nodes | Moebius | at most 0.002 | rotation alone | sfdp | sfdp / Moebius | at least 10"));
  CsvTable bounded(table.GetColumns());
  for (const int side : isQuick ? std::vector<int>{ 20 } : std::vector<int>{ 32, 64, 128 })
  {
    AddStability("triangles on a sphere", peers::GridOnSphere(side).ToGraph(), report, table, bounded);
  }
  for (const int devices : isQuick ? std::vector<int>{ 400 } : std::vector<int>{ 1000, 4000, 16000 })
  {
    AddStability("sensor network, Gabriel graph", GabrielGraph(devices, 1), report, table, bounded);
  }
  report.AddText(
    "Five edges are removed and five added. Mean displacement of the nodes that keep their edges, in radii of the "
    "sphere, after the best Moebius transformation (as in DynamicGraph) or the best rotation. For sfdp: in root mean "
    "squares of its layout after the best similarity, up to 5,000 nodes.");
  if (!bounded.GetRows().empty())
  {
    report.AddTable(bounded);
  }
  report.AddRows("edits", table);
}

/** Stability on networks not used for tuning, because results differ between networks. */
void
MoveLittleOnNetworks(bool isQuick, ValidationReport & report)
{
  const int           devices = isQuick ? 400 : 4000;
  const int           networks = isQuick ? 3 : 16;
  std::vector<double> displacements;
  std::vector<double> ratios;
  for (int k = 0; k < networks; ++k)
  {
    const GraphStability stability = MeasureStability(GabrielGraph(devices, 201 + k), 10, true);
    displacements.push_back(stability.moebius);
    if (stability.sfdp >= 0.0)
    {
      ratios.push_back(stability.sfdp / stability.moebius);
    }
  }
  std::sort(displacements.begin(), displacements.end());
  std::sort(ratios.begin(), ratios.end());
  const auto small = std::upper_bound(displacements.begin(), displacements.end(), 0.002) - displacements.begin();
  const auto steady = ratios.end() - std::lower_bound(ratios.begin(), ratios.end(), 10.0);
  CsvTable   table({ "", "least", "median", "most", "within the bound" });
  table.AddRow(Cells() << "mean displacement, at most 0.002" << Rounded(displacements.front(), 2)
                       << Rounded(displacements[displacements.size() / 2], 2) << Rounded(displacements.back(), 2)
                       << RatioOf(static_cast<int>(small), networks));
  if (!ratios.empty())
  {
    table.AddRow(Cells() << "sfdp / Moebius, at least 10" << Rounded(ratios.front())
                         << Rounded(ratios[ratios.size() / 2]) << Rounded(ratios.back())
                         << RatioOf(static_cast<int>(steady), static_cast<int>(ratios.size())));
  }
  report.AddText("The same on " + std::to_string(networks) + " sensor networks of " + std::to_string(devices) +
                 " devices (seeds from 201) that were not used for tuning:");
  report.AddTable(table);
}
} // namespace

void
ValidateGraphEmbedding(const ValidationSettings & settings, ValidationReport & report)
{
  EmbedFiles(settings, report);
  FindGenera(settings.quick, report);
  CompareSpeed(settings.quick, report);
  CompareWithSfdp(settings.quick, report);
  MoveLittle(settings.quick, report);
  MoveLittleOnNetworks(settings.quick, report);
}
