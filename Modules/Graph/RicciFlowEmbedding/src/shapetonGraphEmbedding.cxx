#include "shapetonGraphEmbedding.h"

#include "shapetonBlockArrangement.h"
#include "shapetonCanonicalMapOrder.h"
#include "shapetonPackedEmbedding.h"
#include "shapetonSplitArrangement.h"
#include "shapetonExceptions.h"
#include "shapetonOpenEndedProgress.h"

#include <algorithm>
#include <exception>

namespace shapeton
{
namespace
{
/** For larger graphs only one packing is computed instead of several candidates. */
constexpr int mostEdgesForChoice = 4000;
/** If a node circle is smaller, split components are rearranged. The time is quadratic, so larger graphs are excluded.
 * Units of the surface. */
constexpr double smallCircle = 1e-4;
constexpr int    mostEdgesForSplits = 10000;

EmbeddingCertificate
EmbedMap(const Graph &                  graph,
         const CombinatorialMap &       map,
         const AugmentationOptions &    augmentation,
         const GraphEmbeddingSettings & options,
         const Progress &               progress)
{
  progress(0.0);
  PackedMap packed = MakePackedMap(map, augmentation);
  progress(0.1);
  EmbeddingCertificate certificate;
  certificate.genus = map.Genus();
  std::vector<int> rank;
  if (certificate.genus == 0)
  {
    CanonicalMapOrder order(packed.map, options.isRotationFree && options.isSideFree);
    if (order.isMirrored)
    {
      const CombinatorialMap mirrored = map.Mirrored();
      packed = MakePackedMap(mirrored, augmentation);
      certificate.rotation = FlatRotation(mirrored);
    }
    rank = std::move(order.rank);
  }
  AddPacking(graph, packed, options.infinity, rank, progress.Part("", 0.2, 1.0), certificate);
  if (certificate.rotation.empty())
  {
    certificate.rotation = FlatRotation(map);
  }
  return certificate;
}

bool
IsSameMap(const CombinatorialMap & one, const CombinatorialMap & other)
{
  for (int h = 0; h < one.HalfEdges(); ++h)
  {
    if (one.NextAround(h) != other.NextAround(h))
    {
      return false;
    }
  }
  return true;
}

/** A candidate embedding: an arrangement of blocks and a ring width. */
struct Candidate
{
  const CombinatorialMap * map;
  int                      halfEdgesOfDummy;
};

/** All candidates: the maps, in this order, with several ring widths if there are rings and the graph is small. */
std::vector<Candidate>
CandidatesOf(const std::vector<const CombinatorialMap *> & maps, const GraphEmbeddingSettings & options)
{
  const bool isChoice = maps.front()->Edges() <= mostEdgesForChoice && options.isRotationFree;
  const bool hasRings =
    isChoice && options.augmentation == Augmentation::Ring && MakePackedMap(*maps.front()).rings > 0;
  std::vector<Candidate> candidates;
  for (const int halfEdges : hasRings ? std::vector<int>{ 2, 4, 1 } : std::vector<int>{ 2 })
  {
    for (const CombinatorialMap * map : maps)
    {
      candidates.push_back({ map, halfEdges });
    }
  }
  return candidates;
}

/** The embedding whose smallest circle is the largest. */
class BestEmbedding
{
public:
  BestEmbedding(const Graph & graph, const GraphEmbeddingSettings & options)
    : m_Graph(graph), m_Options(options), m_Candidates(options.progress, 1.0)
  {}

  void
  Try(const std::vector<Candidate> & candidates)
  {
    for (const Candidate & candidate : candidates)
    {
      AugmentationOptions augmentation(m_Options.augmentation);
      augmentation.names = m_Graph.names;
      augmentation.halfEdgesOfDummy = candidate.halfEdgesOfDummy;
      augmentation.longestFace = m_Options.longestFace;
      try
      {
        EmbeddingCertificate certificate =
          EmbedMap(m_Graph, *candidate.map, augmentation, m_Options, m_Candidates.NextStep());
        const double smallest = SmallestCircle(certificate);
        if (smallest > m_Smallest)
        {
          m_Smallest = smallest;
          m_Best = std::move(certificate);
        }
      }
      catch (const InputError &)
      {
        m_Failure = m_Failure ? m_Failure : std::current_exception();
      }
    }
  }
  /** Radius of the smallest circle; 0 if there are no circles. */
  double
  Smallest() const
  {
    return m_Smallest;
  }
  /** If no candidate has a packing, rethrows the error of the first one. */
  EmbeddingCertificate
  Take()
  {
    if (m_Smallest == 0.0)
    {
      std::rethrow_exception(m_Failure);
    }
    AddSmallestCircle(m_Best);
    m_Options.progress(1.0);
    return std::move(m_Best);
  }

private:
  const Graph &                  m_Graph;
  const GraphEmbeddingSettings & m_Options;
  OpenEndedProgress              m_Candidates;
  EmbeddingCertificate           m_Best;
  std::exception_ptr             m_Failure;
  double                         m_Smallest{ 0.0 };
};

/** Rearranges blocks and, if circles are small, also split components. */
EmbeddingCertificate
EmbedArranged(const Graph & graph, const CombinatorialMap & map, const GraphEmbeddingSettings & options)
{
  BestEmbedding    best(graph, options);
  CombinatorialMap other = ArrangeBlocks(map);
  const bool       isSame = IsSameMap(map, other);
  if (isSame)
  {
    other = CombinatorialMap(); // avoids a second copy of a large map
  }
  const CombinatorialMap & blocks = isSame ? map : other;
  const bool               isChoice = !isSame && map.Edges() <= mostEdgesForChoice && map.Genus() == blocks.Genus();
  best.Try(isChoice ? CandidatesOf({ &blocks, &map }, options) : CandidatesOf({ &blocks }, options));
  if (best.Smallest() < smallCircle && map.Edges() <= mostEdgesForSplits)
  {
    const CombinatorialMap splits = ArrangeBlocks(ArrangeSplitComponents(map));
    if (!IsSameMap(blocks, splits))
    {
      best.Try(CandidatesOf({ &splits }, options));
    }
  }
  return best.Take();
}
} // namespace

EmbeddingCertificate
EmbedPackedGraph(const Graph & graph, const CombinatorialMap & map, const PackedMap & packed, PointAtInfinity infinity)
{
  EmbeddingCertificate certificate;
  certificate.genus = map.Genus();
  AddPacking(graph,
             packed,
             infinity,
             certificate.genus == 0 ? CanonicalMapOrder(packed.map, false).rank : std::vector<int>(),
             {},
             certificate);
  certificate.rotation = FlatRotation(map);
  AddSmallestCircle(certificate);
  return certificate;
}

PackedMap
PackedMapOf(const EmbeddingCertificate & certificate)
{
  PackedMap packed;
  packed.map = MapOfRotation(certificate.packed, certificate.packedRotation);
  packed.graphNodes = certificate.graph.nodes;
  packed.graphEdges = static_cast<int>(certificate.graph.edges.size());
  packed.subdivided = certificate.subdivided;
  return packed;
}

EmbeddingCertificate
EmbedGraph(const Graph & graph, const CombinatorialMap & map, const GraphEmbeddingSettings & options)
{
  if (graph.nodes == 0)
  {
    throw InputError("a graph without nodes cannot be embedded");
  }
  if (options.isRotationFree)
  {
    return EmbedArranged(graph, map, options);
  }
  BestEmbedding best(graph, options);
  best.Try({ { &map, 2 } });
  return best.Take();
}
} // namespace shapeton
