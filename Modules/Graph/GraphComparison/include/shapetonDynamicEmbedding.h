#ifndef shapetonDynamicEmbedding_h
#define shapetonDynamicEmbedding_h

#include "GraphComparisonExport.h"
#include "shapetonEmbeddingCertificate.h"
#include "shapetonGraphEmbedding.h"
#include "shapetonGraphGenus.h"
#include "shapetonPackedMap.h"

#include <string>
#include <vector>

namespace shapeton
{
/** What differs between two steps of a dynamic graph, or two graphs whose nodes have names. Node and edge indices are
 * those of the step they belong to. \ingroup GraphComparison */
struct GraphChanges
{
  std::vector<int> removedNodes; /**< of the first step */
  std::vector<int> removedEdges; /**< of the first step */
  std::vector<int> addedNodes;   /**< of the second step */
  std::vector<int> addedEdges;   /**< of the second step */
  /** Of the second step, ascending: nodes that are new or have gained or lost an edge. The regions of change. */
  std::vector<int> changedNodes;
  /** Nodes that both steps have and that did not change, and how far they lie from each other when the second
   * sphere is turned to the first as a whole, in radians; not a number on other surfaces, or without such nodes. */
  int    unchangedNodes{ 0 };
  double meanDisplacement;
  double largestDisplacement;
};

/** Compares embeddings by the names of the nodes. With another correspondence, give for each node of `a` that of `b`,
 * or -1. \ingroup GraphComparison */
///@{
GraphComparison_EXPORT GraphChanges
ChangesBetween(const EmbeddingCertificate & a, const EmbeddingCertificate & b);
GraphComparison_EXPORT GraphChanges
ChangesBetween(const EmbeddingCertificate & a, const EmbeddingCertificate & b, const std::vector<int> & image);
///@}

/** The rotation that turns sphere `b` to sphere `a`, by the nodes that correspond; the identity on other surfaces.
 * \ingroup GraphComparison */
GraphComparison_EXPORT std::array<double, 9>
RotationTo(const EmbeddingCertificate & a, const EmbeddingCertificate & b, const std::vector<int> & image);

/** One step. \ingroup GraphComparison */
struct DynamicStep
{
  EmbeddingCertificate certificate;
  /** Against the step before; empty for the first one. */
  GraphChanges changes;
  /** The rotation system was sought anew, or blocks and dummies were arranged anew, which may move nodes far. */
  bool embeddedAnew{ false };
};

/** \class DynamicEmbedding
 * \brief Embeds the steps of a dynamic graph so that what does not change stays where it is.
 *
 * The first step has its blocks arranged, see EmbedGraph(); each other one takes over the rotation system of the
 * step before. Its sphere is turned so that nodes that did not change lie as near to their old places as can be. It is
 * packed with the dummies that can stay (see CarryPackedMap()), which is steadier after few changes, and where nodes
 * move then also with new ones, which is steadier after many; what moves less is taken. Where that leaves an illegible
 * circle, blocks and dummies are arranged anew if this makes the smallest one ten times larger.
 * \ingroup GraphComparison */
class GraphComparison_EXPORT DynamicEmbedding
{
public:
  explicit DynamicEmbedding(GenusOptions genus = {}, GraphEmbeddingOptions embedding = {});

  /** The next step. Throws InputError as FindEmbedding() and EmbedGraph() do. */
  DynamicStep
  Add(const Graph & graph);

private:
  EmbeddingCertificate
  EmbedAnew(const Graph & graph, const CombinatorialMap & map) const;
  DynamicStep
  StepTo(EmbeddingCertificate certificate) const;
  DynamicStep
  StepBy(const Graph & graph, const CombinatorialMap & map, const std::vector<PackedMap> & choices) const;
  DynamicStep
  NextStep(const Graph & graph) const;

  GenusOptions          m_Genus;
  GraphEmbeddingOptions m_Embedding;
  bool                  m_IsFirst{ true };
  EmbeddingCertificate  m_Last;
};
} // namespace shapeton

#endif
