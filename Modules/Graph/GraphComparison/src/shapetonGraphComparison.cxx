#include "shapetonGraphComparison.h"

#include "shapetonCarriedRotation.h"
#include "shapetonGraphStructure.h"
#include "shapetonJson.h"
#include "shapetonSphereAlignment.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>

namespace shapeton
{
namespace
{
int
CountTriangles(const std::vector<std::vector<int>> & greaterNeighbors)
{
  int               triangles = 0;
  std::vector<bool> isNeighbor(greaterNeighbors.size(), false);
  for (const auto & neighbors : greaterNeighbors)
  {
    for (const int w : neighbors)
    {
      isNeighbor[w] = true;
    }
    for (const int w : neighbors)
    {
      triangles += static_cast<int>(
        std::count_if(greaterNeighbors[w].begin(), greaterNeighbors[w].end(), [&](int x) { return isNeighbor[x]; }));
    }
    for (const int w : neighbors)
    {
      isNeighbor[w] = false;
    }
  }
  return triangles;
}
} // namespace

GraphFigures
FiguresOf(const Graph & graph)
{
  const Incidence               incidence(graph);
  GraphFigures                  figures;
  std::set<std::array<int, 2>>  ends;
  std::vector<std::vector<int>> greaterNeighbors(graph.nodes);
  figures.nodes = graph.nodes;
  figures.edges = static_cast<int>(graph.edges.size());
  for (const auto & edge : graph.edges)
  {
    const std::array<int, 2> sorted{ std::min(edge[0], edge[1]), std::max(edge[0], edge[1]) };
    if (edge[0] == edge[1])
    {
      ++figures.loops;
    }
    else if (ends.insert(sorted).second)
    {
      greaterNeighbors[sorted[0]].push_back(sorted[1]);
    }
    else
    {
      ++figures.parallelEdges;
    }
  }
  figures.components = static_cast<int>(ConnectedComponents(graph).size());
  figures.blocks = static_cast<int>(BlocksOf(graph).size());
  figures.triangles = CountTriangles(greaterNeighbors);
  for (int v = 0; v < graph.nodes; ++v)
  {
    const std::size_t degree = incidence.Degree(v);
    figures.nodesOfDegree.resize(std::max(figures.nodesOfDegree.size(), degree + 1), 0);
    ++figures.nodesOfDegree[degree];
  }
  return figures;
}

std::vector<std::string>
DifferencesBetween(const GraphFigures & a, const GraphFigures & b)
{
  std::vector<std::string> differences;
  const auto               compare = [&differences](const std::string & what, int ofA, int ofB) {
    if (ofA != ofB)
    {
      differences.push_back(what + ": " + std::to_string(ofA) + " and " + std::to_string(ofB));
    }
  };
  compare("nodes", a.nodes, b.nodes);
  compare("edges", a.edges, b.edges);
  compare("loops", a.loops, b.loops);
  compare("parallel edges", a.parallelEdges, b.parallelEdges);
  compare("components", a.components, b.components);
  compare("blocks", a.blocks, b.blocks);
  compare("triangles", a.triangles, b.triangles);
  for (std::size_t d = 0; d < std::max(a.nodesOfDegree.size(), b.nodesOfDegree.size()); ++d)
  {
    compare("nodes of degree " + std::to_string(d),
            d < a.nodesOfDegree.size() ? a.nodesOfDegree[d] : 0,
            d < b.nodesOfDegree.size() ? b.nodesOfDegree[d] : 0);
  }
  return differences;
}

namespace
{
constexpr int roundsOfRefinement = 4; // chosen; bounds the time

/** Refines node colors of both graphs by their neighborhoods; equal colors mean equal neighborhoods. */
class Refinement
{
public:
  Refinement(const Graph & a, const Graph & b)
    : m_Shift(a.nodes), m_Neighbors(a.nodes + b.nodes), m_Color(a.nodes + b.nodes, 0)
  {
    AddEdges(a, 0);
    AddEdges(b, a.nodes);
  }

  void
  Refine()
  {
    std::map<std::vector<int>, int> colorOf;
    std::vector<int>                refined(m_Color.size());
    for (std::size_t v = 0; v < m_Color.size(); ++v)
    {
      std::vector<int> signature;
      for (const int w : m_Neighbors[v])
      {
        signature.push_back(m_Color[w]);
      }
      std::sort(signature.begin(), signature.end());
      signature.push_back(m_Color[v]);
      refined[v] = colorOf.try_emplace(signature, static_cast<int>(colorOf.size())).first->second;
    }
    m_Color.swap(refined);
  }

  /** Pairs unmatched nodes whose color is unique in both graphs. */
  void
  PairUnique(std::vector<int> & image, std::vector<bool> & taken) const
  {
    std::map<int, std::array<std::vector<int>, 2>> nodesOfColor;
    for (int v = 0; v < static_cast<int>(m_Color.size()); ++v)
    {
      const bool ofB = v >= m_Shift;
      nodesOfColor[m_Color[v]][ofB ? 1 : 0].push_back(ofB ? v - m_Shift : v);
    }
    for (const auto & [color, nodes] : nodesOfColor)
    {
      if (nodes[0].size() == 1 && nodes[1].size() == 1 && image[nodes[0][0]] < 0 && !taken[nodes[1][0]])
      {
        image[nodes[0][0]] = nodes[1][0];
        taken[nodes[1][0]] = true;
      }
    }
  }

private:
  void
  AddEdges(const Graph & graph, int shift)
  {
    for (const auto & edge : graph.edges)
    {
      m_Neighbors[edge[0] + shift].push_back(edge[1] + shift);
      m_Neighbors[edge[1] + shift].push_back(edge[0] + shift);
    }
  }

  int                           m_Shift;
  std::vector<std::vector<int>> m_Neighbors;
  std::vector<int>              m_Color;
};

NodeCorrespondence
ByNeighborhoods(const Graph & a, const Graph & b)
{
  NodeCorrespondence result{ "none", std::vector<int>(a.nodes, -1) };
  std::vector<bool>  taken(b.nodes, false);
  Refinement         refinement(a, b);
  for (int round = 0; round < roundsOfRefinement; ++round)
  {
    refinement.Refine();
    refinement.PairUnique(result.image, taken);
  }
  if (std::any_of(result.image.begin(), result.image.end(), [](int v) { return v >= 0; }))
  {
    result.by = "neighborhoods";
  }
  return result;
}
} // namespace

NodeCorrespondence
CorrespondingNodes(const CanonicalForm & a, const CanonicalForm & b)
{
  NodeCorrespondence result{ "isomorphism", {} };
  if (!Isomorphism(a, b).empty())
  {
    for (int v = 0; v < a.graph.nodes; ++v)
    {
      result.image.push_back(v);
    }
    return result;
  }
  if (!a.graph.names.empty() && !b.graph.names.empty())
  {
    result = { "names", NodesOfSameName(a.graph, b.graph) };
    const auto found = std::count_if(result.image.begin(), result.image.end(), [](int v) { return v >= 0; });
    if (2 * found >= std::min(a.graph.nodes, b.graph.nodes))
    {
      return result;
    }
  }
  return ByNeighborhoods(a.graph, b.graph);
}

GraphComparison
CompareGraphs(const Graph &                  a,
              const Graph &                  b,
              const GenusSettings &          genus,
              const GraphEmbeddingSettings & embedding,
              const Progress &               progress)
{
  const auto genusWithProgress = [&](double begin, double end) {
    GenusSettings part = genus;
    part.progress = progress.Part("Finding the genus", begin, end);
    return part;
  };
  const auto embeddingWithProgress = [&](double begin, double end) {
    GraphEmbeddingSettings part = embedding;
    part.progress = progress.Part("Packing circles", begin, end);
    return part;
  };
  progress("Labeling", 0.0);
  const CanonicalForm formA(a);
  const CanonicalForm formB(b);
  GraphComparison     result;
  result.correspondence = CorrespondingNodes(formA, formB);
  result.isomorphic = result.correspondence.by == "isomorphism";
  const CombinatorialMap mapA = FindEmbedding(formA.graph, genusWithProgress(0.1, 0.3)).map;
  result.a = EmbedGraph(formA.graph, mapA, embeddingWithProgress(0.3, 0.5));
  const bool             carries = result.correspondence.by == "names";
  const CombinatorialMap mapB = carries ? CarryRotation(formA.graph, mapA, formB.graph, genusWithProgress(0.5, 0.7)).map
                                        : FindEmbedding(formB.graph, genusWithProgress(0.5, 0.7)).map;
  result.b = EmbedGraph(formB.graph, mapB, embeddingWithProgress(0.7, 0.9));
  if (!result.isomorphic)
  {
    result.differences = DifferencesBetween(FiguresOf(a), FiguresOf(b));
    if (result.differences.empty())
    {
      result.differences.push_back("the counts agree, but the canonical forms differ");
    }
    if (result.a.geometry == EmbeddingGeometry::Spherical && result.b.geometry == EmbeddingGeometry::Spherical)
    {
      MoveEmbedding(result.b, BestMotion(result.a, result.b, result.correspondence.image));
    }
  }
  result.changes = ChangesBetween(result.a, result.b, result.correspondence.image);
  progress("Comparing", 1.0);
  return result;
}

namespace
{
/** Hues by the golden angle, cycling through three lightness values. */
std::string
ColorOf(int index)
{
  const double     hue = std::fmod(index * 0.6180339887498949, 1.0) * 6.0;
  const double     value = 0.95 - 0.15 * (index % 3);
  constexpr double saturation = 0.7, red = 5.0, green = 3.0, blue = 1.0; // conversion of HSV
  const auto       channel = [&](double shift) {
    const double k = std::fmod(shift + hue, 6.0);
    return static_cast<int>(255.0 * (value - saturation * value * std::max(0.0, std::min({ k, 4.0 - k, 1.0 }))));
  };
  char text[8];
  std::snprintf(text, sizeof(text), "#%02x%02x%02x", channel(red), channel(green), channel(blue));
  return text;
}

Json
NamesOf(const std::vector<int> & nodes, const Graph & graph)
{
  Json names = Json::array();
  for (const int v : nodes)
  {
    names.push_back(NameOfNode(graph, v));
  }
  return names;
}

Json
EdgeNamesOf(const std::vector<int> & edges, const Graph & graph)
{
  Json names = Json::array();
  for (const int e : edges)
  {
    names.push_back({ NameOfNode(graph, graph.edges[e][0]), NameOfNode(graph, graph.edges[e][1]) });
  }
  return names;
}

Json
FiguresToJson(const EmbeddingCertificate & certificate)
{
  const GraphFigures figures = FiguresOf(certificate.graph);
  return { { "nodes", figures.nodes },           { "edges", figures.edges },
           { "loops", figures.loops },           { "parallelEdges", figures.parallelEdges },
           { "components", figures.components }, { "blocks", figures.blocks },
           { "triangles", figures.triangles },   { "nodesOfDegree", figures.nodesOfDegree },
           { "genus", certificate.genus } };
}
} // namespace

std::array<std::vector<std::string>, 2>
ColorsOfNodes(const GraphComparison & comparison)
{
  const std::string                       gray = "#9a9a9a";
  std::array<std::vector<std::string>, 2> colors{ std::vector<std::string>(comparison.a.graph.nodes, gray),
                                                  std::vector<std::string>(comparison.b.graph.nodes, gray) };
  for (int v = 0; v < comparison.a.graph.nodes; ++v)
  {
    if (const int partner = comparison.correspondence.image[v]; partner >= 0)
    {
      colors[0][v] = colors[1][partner] = ColorOf(v);
    }
  }
  return colors;
}

Json
ChangesToJson(const GraphChanges & changes, const Graph & a, const Graph & b)
{
  return {
    { "removedNodes", NamesOf(changes.removedNodes, a) },     { "addedNodes", NamesOf(changes.addedNodes, b) },
    { "removedEdges", EdgeNamesOf(changes.removedEdges, a) }, { "addedEdges", EdgeNamesOf(changes.addedEdges, b) },
    { "changedNodes", NamesOf(changes.changedNodes, b) },     { "unchangedNodes", changes.unchangedNodes },
    { "meanDisplacement", changes.meanDisplacement },         { "largestDisplacement", changes.largestDisplacement }
  };
}

Json
ComparisonToJson(const GraphComparison & comparison)
{
  Json pairs = Json::array();
  for (int v = 0; v < comparison.a.graph.nodes; ++v)
  {
    if (const int partner = comparison.correspondence.image[v]; partner >= 0)
    {
      pairs.push_back({ NameOfNode(comparison.a.graph, v), NameOfNode(comparison.b.graph, partner) });
    }
  }
  return { { "isomorphic", comparison.isomorphic },
           { "differences", comparison.differences },
           { "a", FiguresToJson(comparison.a) },
           { "b", FiguresToJson(comparison.b) },
           { "correspondence", { { "by", comparison.correspondence.by }, { "nodes", pairs } } },
           { "changes", ChangesToJson(comparison.changes, comparison.a.graph, comparison.b.graph) } };
}
} // namespace shapeton
