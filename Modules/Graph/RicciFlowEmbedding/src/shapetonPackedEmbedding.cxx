#include "shapetonPackedEmbedding.h"

#include "shapetonSurfaceLayout.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace shapeton
{
namespace
{
/** Tolerance of the verifier, relative to the largest matrix. */
constexpr double worstWordResidual = 1e-6;

/** Packed edges that form the edges of the graph. */
std::vector<int>
EdgesOfGraph(const PackedMap & packed)
{
  std::vector<int> edges(packed.graphEdges);
  std::iota(edges.begin(), edges.end(), 0);
  for (const std::vector<int> & path : packed.subdivided)
  {
    for (std::size_t i = 1; i < path.size(); ++i)
    {
      edges.push_back(path[i] / 2);
    }
  }
  return edges;
}

/** Called after the packing, to reduce peak memory. */
void
AddMaps(const Graph & graph, const PackedMap & packed, EmbeddingCertificate & certificate)
{
  certificate.graph = graph;
  certificate.packed = packed.map.ToGraph();
  certificate.packedRotation = FlatRotation(packed.map);
  certificate.subdivided = packed.subdivided;
}

void
AddSphere(const PackedMap &      packed,
          PointAtInfinity        infinity,
          std::vector<int>       rank,
          const Progress &       progress,
          EmbeddingCertificate & certificate)
{
  std::vector<char> isVisible(packed.map.Nodes(), 0);
  std::fill_n(isVisible.begin(), packed.graphNodes, 1);
  SphericalPacking sphere = PackOnSphere(packed.map, infinity, EdgesOfGraph(packed), isVisible, progress);
  rank.resize(packed.graphNodes); // dummies may be numbered differently in the mirror image
  TurnToCanonicalPosition(sphere, rank);
  certificate.geometry = EmbeddingGeometry::Spherical;
  const auto add =
    [](const std::vector<SphereCircle> & circles, std::vector<double> & radii, std::vector<double> & places) {
      for (const SphereCircle & circle : circles)
      {
        const std::array<double, 3> center = CenterOf(circle);
        radii.push_back(RadiusOf(circle));
        places.insert(places.end(), center.begin(), center.end());
      }
    };
  add(sphere.nodes, certificate.nodeRadii, certificate.nodePositions);
  add(sphere.faces, certificate.faceRadii, certificate.facePositions);
  certificate.statistics.emplace_back("residual", sphere.residual);
  certificate.statistics.emplace_back("newtonSteps", sphere.steps);
}

/** Appends a complex number to a list. */
void
Append(const PlaneMotion::Complex & z, std::vector<double> & list)
{
  list.push_back(z.real());
  list.push_back(z.imag());
}

void
AddLayout(const CombinatorialMap & map, const SurfaceLayout & layout, EmbeddingCertificate & certificate)
{
  for (const PlaneMotion & frame : layout.Frames())
  {
    Append(frame(0.0), certificate.nodePositions);
    certificate.nodeAngles.push_back(frame.Direction());
  }
  for (int face = 0; face < map.Faces(); ++face)
  {
    Append(layout.FaceCenter(face), certificate.facePositions);
  }
  certificate.tree = layout.Arrivals();
  certificate.word = layout.Word();
  certificate.canonicalWords = CanonicalWords(layout.Word());
}

std::vector<PlaneMotion>
GeneratorsOf(const SurfaceLayout & layout)
{
  std::vector<PlaneMotion> generators;
  for (const int h : layout.CutHalfEdges())
  {
    generators.push_back(layout.DeckTransformationOf(h));
  }
  return generators;
}

void
AddGenerators(const SurfaceLayout &            layout,
              const std::vector<PlaneMotion> & generators,
              EmbeddingCertificate &           certificate)
{
  for (std::size_t k = 0; k < generators.size(); ++k)
  {
    certificate.generators.push_back({ layout.CutHalfEdges()[k], generators[k].a, generators[k].b });
  }
}

void
AddTorus(const CombinatorialMap & map, const Progress & progress, EmbeddingCertificate & certificate)
{
  const CirclePacking packing =
    PackCircles(map, FlowGeometry::Euclidean, {}, PackingPrecision::Double, progress.Part("", 0.0, 0.7));
  progress(0.7);
  const SurfaceLayout      layout(map, packing);
  std::vector<PlaneMotion> generators = GeneratorsOf(layout);
  for (PlaneMotion & generator : generators)
  {
    generator.a = 1.0; // a translation up to rounding
  }
  certificate.geometry = EmbeddingGeometry::Euclidean;
  certificate.nodeRadii = packing.nodeRadii;
  certificate.faceRadii = packing.faceRadii;
  progress(0.8);
  AddLayout(map, layout, certificate);
  progress(0.9);
  AddGenerators(layout, generators, certificate);
  const auto lattice = ReducedLattice(generators[0].b, generators[1].b);
  Append(lattice[0], certificate.periods);
  Append(lattice[1], certificate.periods);
  certificate.statistics.emplace_back("residual", packing.residual);
  certificate.statistics.emplace_back("newtonSteps", packing.steps);
  certificate.statistics.emplace_back("wordResidual", WordResidual(generators, layout.Word()) / std::abs(lattice[0]));
}

/** With many handles, the outer part of a fundamental domain lies on the circle at infinity, to double precision. */
void
RequireFinite(const std::vector<PlaneMotion> & generators, int genus)
{
  for (const PlaneMotion & generator : generators)
  {
    if (!std::isfinite(std::abs(generator.a)) || !std::isfinite(std::abs(generator.b)))
    {
      throw InputError("the surface of genus " + std::to_string(genus) +
                       " cannot be laid out: its fundamental domain exceeds the range of double precision. "
                       "Remove edges, or embed parts of the graph");
    }
  }
}

/** Products of very many matrices overflow; then the value is omitted and a warning states that the relation fails. */
void
AddResidual(const std::string & name, double residual, EmbeddingCertificate & certificate)
{
  if (std::isfinite(residual))
  {
    certificate.statistics.emplace_back(name, residual);
  }
}

void
AddHyperbolicSurface(const CombinatorialMap & map, const Progress & progress, EmbeddingCertificate & certificate)
{
  const CirclePacking packing =
    PackCircles(map, FlowGeometry::Hyperbolic, {}, PackingPrecision::Double, progress.Part("", 0.0, 0.7));
  progress(0.7);
  const SurfaceLayout layout(map, packing);
  certificate.geometry = EmbeddingGeometry::Hyperbolic;
  certificate.nodeRadii = packing.nodeRadii;
  certificate.faceRadii = packing.faceRadii;
  progress(0.8);
  AddLayout(map, layout, certificate);
  progress(0.9);
  const std::vector<PlaneMotion> generators = GeneratorsOf(layout);
  certificate.word = CenteredWord(generators, layout.Word());
  certificate.canonicalWords = CanonicalWords(certificate.word);
  const DeckRelation relation = RefineDeckRelation(generators, certificate.word, certificate.canonicalWords);
  RequireFinite(relation.generators, certificate.genus);
  AddGenerators(layout, relation.generators, certificate);
  certificate.statistics.emplace_back("residual", packing.residual);
  certificate.statistics.emplace_back("newtonSteps", packing.steps);
  AddResidual("givenWordResidual", relation.givenResidual, certificate);
  AddResidual("wordResidual", relation.residual, certificate);
  if (!relation.canonical.empty())
  {
    AddResidual("canonicalResidual", relation.canonicalResidual, certificate);
  }
  double largest = 1.0;
  for (const PlaneMotion & generator : relation.generators)
  {
    largest = std::max(largest, std::abs(generator.a));
  }
  if (!(relation.residual <= worstWordResidual * largest))
  {
    certificate.warnings.emplace_back(
      "the relation of the deck transformations does not hold in double precision, because their "
      "matrices are large: the verifier rejects this certificate; the packing itself is "
      "not affected");
  }
}
} // namespace

void
AddPacking(const Graph &            graph,
           const PackedMap &        packed,
           PointAtInfinity          infinity,
           const std::vector<int> & rank,
           const Progress &         progress,
           EmbeddingCertificate &   certificate)
{
  if (certificate.genus == 0)
  {
    AddSphere(packed, infinity, rank, progress, certificate);
  }
  else
  {
    certificate.genus == 1 ? AddTorus(packed.map, progress, certificate)
                           : AddHyperbolicSurface(packed.map, progress, certificate);
  }
  AddMaps(graph, packed, certificate);
  certificate.statistics.emplace_back("rings", packed.rings);
}

void
AddSmallestCircle(EmbeddingCertificate & certificate)
{
  const double unit = UnitOfSurface(certificate);
  const auto   first = certificate.nodeRadii.begin();
  const auto   end = first + certificate.graph.nodes;
  const auto   smallest = std::min_element(first, end);
  certificate.statistics.emplace_back("smallestRadius", *smallest);
  const auto illegible = std::count_if(first, end, [unit](double r) { return r < smallestLegibleRadius * unit; });
  if (illegible > 0)
  {
    char text[320];
    std::snprintf(text,
                  sizeof(text),
                  "%ld of %d nodes have circles below %.0e of the surface (smallest: node %s, %.1e): they are not "
                  "legible in pictures, and the verifier rejects circles below 1e-12",
                  static_cast<long>(illegible),
                  certificate.graph.nodes,
                  smallestLegibleRadius,
                  NameOfNode(certificate.graph, static_cast<int>(smallest - first)).substr(0, LongestName).c_str(),
                  *smallest / unit);
    certificate.warnings.emplace_back(text);
  }
}
} // namespace shapeton
