#include "shapetonGraphGenus.h"

#include "shapetonBlockKernel.h"
#include "shapetonGenusAnnealing.h"
#include "shapetonGraphStructure.h"
#include "shapetonIncrementalMap.h"
#include "shapetonParallelFor.h"
#include "shapetonPlanarRotation.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <atomic>

namespace shapeton
{
namespace
{
constexpr std::uint32_t annealingPurpose = 0x6E05A1; // of the random numbers
// Exponents of successive searches. Sparse graphs of large genus need low exponents, complete graphs high ones: K15
// reaches its genus of 11 only with 16. With 0 (all corners equal) a quarter more handles remain.
constexpr int lastExponents[] = { 8, 16, 12, 6 };
// Moves of one search at effort 1. On the Rome graphs and K15, longer searches do not find better embeddings than more
// searches.
constexpr double movesOfAnEdge = 4000.0;
constexpr double mostMoves = 3.0e6;
constexpr double mostCorners = 4.0e8;
// This limit is needed because a node with many neighbors would otherwise be visited once for each of them.
constexpr double mostCornersOfBreadth = 2000.0;

/** An independently searched part of the graph. */
struct SearchPart
{
  const Graph *    graph;
  int              lowerBound;
  std::vector<int> nextAround;
};

/** Runs all searches of all parts on all threads. The best search of each part is used; ties go to the first. A search
 * is skipped if an earlier one has reached the lower bound, so the result is independent of threads. Searches poll
 * often: this reports progress, and stops all of them after an abort. */
template <typename TSearch>
void
SearchAll(std::vector<SearchPart> & parts, int restarts, const TSearch & search, const Progress & progress)
{
  struct Outcome
  {
    int              genus{ std::numeric_limits<int>::max() };
    std::vector<int> nextAround;
  };
  std::vector<Outcome>          outcomes(parts.size() * restarts);
  std::vector<std::atomic<int>> firstAtBound(parts.size());
  for (auto & first : firstAtBound)
  {
    first = restarts;
  }
  std::atomic<std::size_t> begun{ 0 };
  std::atomic<bool>        isAborted{ false };
  const ProgressOfWorkers  reporter(progress);
  const auto               report = [&] {
    try
    {
      reporter(static_cast<double>(begun) / static_cast<double>(outcomes.size() + 1));
    }
    catch (...)
    {
      isAborted = true;
      throw;
    }
  };
  const auto run = [&](std::size_t part, int restart) {
    ++begun;
    const std::size_t task = part * restarts + restart;
    if (restart > firstAtBound[part])
    {
      return;
    }
    Outcome &  outcome = outcomes[task];
    const auto isInVain = [&] {
      report();
      return isAborted || restart > firstAtBound[part];
    };
    outcome.nextAround = search(parts[part], restart, static_cast<std::uint32_t>(task), isInVain);
    outcome.genus = CombinatorialMap(parts[part].graph->nodes, parts[part].graph->edges, outcome.nextAround).Genus();
    int first = firstAtBound[part];
    while (outcome.genus <= parts[part].lowerBound && restart < first &&
           !firstAtBound[part].compare_exchange_weak(first, restart))
    {}
  };
  // The first search is often sufficient; for a large graph the others would only cost time and memory.
  ParallelFor(parts.size(), [&](std::size_t part) { run(part, 0); });
  const std::size_t others = restarts - 1;
  ParallelFor(parts.size() * others, [&](std::size_t i) { run(i / others, 1 + static_cast<int>(i % others)); });
  for (std::size_t part = 0; part < parts.size(); ++part)
  {
    const auto begin = outcomes.begin() + part * restarts;
    parts[part].nextAround = std::min_element(begin, begin + restarts, [](const Outcome & a, const Outcome & b) {
                               return a.genus < b.genus;
                             })->nextAround;
  }
}

/** Mean number of corners examined by a move, that is, at both ends of an edge. */
double
CornersOfAMove(const Graph & graph)
{
  const Incidence incidence(graph);
  double          sum = 0.0;
  for (int v = 0; v < graph.nodes; ++v)
  {
    sum += static_cast<double>(incidence.Degree(v)) * incidence.Degree(v);
  }
  return sum / graph.edges.size();
}

/** A block of the graph with its kernel. */
struct Block
{
  explicit Block(Subgraph subgraph) : part(std::move(subgraph)), kernel(part.graph) {}

  Subgraph    part;
  BlockKernel kernel;
};

/** Inserts the orders of a block into those of the graph, each in one existing corner. */
void
AddOrders(const Graph &            graph,
          const std::vector<int> & edges,
          const std::vector<int> & blockNext,
          std::vector<int> &       next,
          std::vector<int> &       any)
{
  const auto ofGraph = [&edges](int halfEdge) { return 2 * edges[halfEdge / 2] + halfEdge % 2; };
  for (std::size_t h = 0; h < blockNext.size(); ++h)
  {
    next[ofGraph(static_cast<int>(h))] = ofGraph(blockNext[h]);
  }
  std::vector<int> corners; // nodes first met in this block
  for (std::size_t h = 0; h < blockNext.size(); ++h)
  {
    const int halfEdge = ofGraph(static_cast<int>(h));
    int &     corner = any[graph.edges[halfEdge / 2][halfEdge % 2]];
    if (corner == -1 || corner >= 0)
    {
      if (corner >= 0)
      {
        SpliceOrders(next, corner, halfEdge);
      }
      corner = -2 - halfEdge; // already inserted for this block
      corners.push_back(graph.edges[halfEdge / 2][halfEdge % 2]);
    }
  }
  for (const int node : corners)
  {
    any[node] = -2 - any[node];
  }
}

/** Embeds a nonplanar graph; at least one of its blocks is nonplanar. */
class AnnealedEmbedding
{
public:
  AnnealedEmbedding(const Graph & graph, const GenusSettings & options)
    : m_Graph(graph), m_Options(options), m_Next(2 * graph.edges.size(), -1), m_Any(graph.nodes, -1)
  {}

  SurfaceEmbedding
  Find()
  {
    AddPlanarBlocks();
    SearchOthers();
    SurfaceEmbedding result;
    result.map = CombinatorialMap(m_Graph.nodes, m_Graph.edges, std::move(m_Next));
    result.lowerBound = m_LowerBound;
    return result;
  }

private:
  void
  AddPlanarBlocks()
  {
    const std::vector<std::vector<int>> blocks = BlocksOf(m_Graph);
    for (const auto & edges : blocks)
    {
      Subgraph               part = SubgraphOfEdges(m_Graph, edges);
      const std::vector<int> planar = blocks.size() > 1 ? PlanarNextAround(part.graph) : std::vector<int>();
      if (!planar.empty())
      {
        AddOrders(m_Graph, edges, planar, m_Next, m_Any);
      }
      else
      {
        m_Blocks.emplace_back(std::move(part));
      }
    }
  }

  void
  SearchOthers()
  {
    std::vector<SearchPart> parts;
    for (const Block & block : m_Blocks)
    {
      const Graph & kernel = block.kernel.GetGraph();
      parts.push_back({ &kernel, std::max(1, GenusLowerBound(kernel)), {} });
      m_LowerBound += parts.back().lowerBound;
    }
    SearchAll(
      parts,
      m_Options.restarts,
      [this](const SearchPart & part, int restart, std::uint32_t stream, const auto & isInVain) {
        const double   cornersOfAMove = CornersOfAMove(*part.graph);
        GenusAnnealing annealing(*part.graph,
                                 PhiloxStream(m_Options.seed, stream, annealingPurpose),
                                 restart % 3 == 0 && cornersOfAMove < mostCornersOfBreadth
                                   ? GenusAnnealing::Growth::Breadth
                                   : GenusAnnealing::Growth::Tree);
        const double   moves =
          std::min({ movesOfAnEdge * part.graph->edges.size(), mostMoves, mostCorners / cornersOfAMove }) *
          m_Options.effort;
        annealing.Anneal(static_cast<std::int64_t>(moves), lastExponents[restart % 4], part.lowerBound, isInVain);
        return annealing.BestNextAround();
      },
      m_Options.progress);
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      AddOrders(m_Graph, m_Blocks[i].part.edges, m_Blocks[i].kernel.Expand(parts[i].nextAround), m_Next, m_Any);
    }
  }

  const Graph &         m_Graph;
  const GenusSettings & m_Options;
  std::vector<int>      m_Next;
  std::vector<int>      m_Any; // a half-edge of each placed node
  std::vector<Block>    m_Blocks;
  int                   m_LowerBound{ 0 };
};

SurfaceEmbedding
FindAnnealed(const Graph & graph, const GenusSettings & options)
{
  SurfaceEmbedding result;
  if (FindPlanarEmbedding(graph, result.map))
  {
    return result;
  }
  return AnnealedEmbedding(graph, options).Find();
}

/** Finds a pair of corners of the edge's nodes in two faces; returns false if there is none. */
bool
FindCornersOfTwoFaces(const IncrementalMap & map, int edge, int & a, int & b)
{
  const int first0 = map.Any(map.Node(2 * edge));
  const int first1 = map.Any(map.Node(2 * edge + 1));
  a = first0;
  do
  {
    b = first1;
    do
    {
      if (map.Face(a) != map.Face(b))
      {
        return true;
      }
      b = map.NextAround(b);
    } while (b != first1);
    a = map.NextAround(a);
  } while (a != first0);
  return false;
}

/** Adds handles until the map has the requested genus: removes an edge between two faces, which merges them, and
 * reinserts it between two faces. */
CombinatorialMap
RaiseGenus(const Graph & graph, const CombinatorialMap & map, int genus)
{
  IncrementalMap changed(map);
  int            missing = genus - map.Genus();
  bool           progress = true;
  while (missing > 0 && progress)
  {
    progress = false;
    for (int e = 0; e < changed.Edges() && missing > 0; ++e)
    {
      const bool isLoop = graph.edges[e][0] == graph.edges[e][1];
      if (isLoop || changed.Face(2 * e) == changed.Face(2 * e + 1))
      {
        continue;
      }
      const int oldA = changed.PreviousAround(2 * e);
      const int oldB = changed.PreviousAround(2 * e + 1);
      changed.Remove(e);
      int        a = oldA;
      int        b = oldB;
      const bool found = FindCornersOfTwoFaces(changed, e, a, b);
      changed.Insert(e, found ? a : oldA, found ? b : oldB);
      missing -= found ? 1 : 0;
      progress = progress || found;
    }
  }
  return CombinatorialMap(graph.nodes, graph.edges, changed.GetNextAround());
}

void
RequireGenus(int genus, const SurfaceEmbedding & least, const CombinatorialMap & greatest)
{
  if (greatest.Genus() == genus)
  {
    return;
  }
  const std::string bound = "the lower bound is " + std::to_string(least.lowerBound);
  const std::string found = std::to_string(least.map.Genus());
  const std::string wanted = "no embedding of genus " + std::to_string(genus);
  if (genus < least.lowerBound)
  {
    throw InputError(wanted + " exists: " + bound + ", and the smallest genus found is " + found + "; choose that one");
  }
  throw InputError(wanted + " was found: the search found " +
                   (genus < least.map.Genus()
                      ? found + " or more; " + bound +
                          ", so a smaller genus is not excluded; try another parameter "
                          "\"seed\", or choose " +
                          found
                      : "genus " + found + " to " + std::to_string(greatest.Genus()) + "; choose one of these"));
}
} // namespace

SurfaceEmbedding
FindEmbedding(const Graph & graph, const GenusSettings & options)
{
  CheckOptions(options);
  RequireSound(graph, "embedding");
  options.progress(0.0);
  SurfaceEmbedding result = FindAnnealed(graph, options);
  if (options.genus)
  {
    const CombinatorialMap raised = RaiseGenus(graph, result.map, *options.genus);
    RequireGenus(*options.genus, result, raised);
    result.map = raised;
  }
  result.minimal = result.map.Genus() == result.lowerBound;
  options.progress(1.0);
  return result;
}
} // namespace shapeton
