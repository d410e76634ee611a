#ifndef itkDynamicEmbedding_h
#define itkDynamicEmbedding_h

#include "GraphComparisonExport.h"
#include "itkEmbeddingCertificate.h"
#include "itkGraphEmbedding.h"
#include "itkGraphGenus.h"
#include "itkPackedMap.h"

#include <string>
#include <vector>

namespace itk
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
  /** The rotation system was sought anew, which may move nodes far. */
  bool embeddedAnew{ false };
};

/** \class DynamicEmbedding
 * \brief Embeds the steps of a dynamic graph so that what does not change stays where it is.
 *
 * The first step has its blocks arranged, see ArrangeBlocks(); each other one takes over the rotation system of the
 * step before, and the dummies that can stay (see CarryPackedMap()). Its sphere is turned so that nodes that did not
 * change lie as near to their old places as can be. \ingroup GraphComparison */
class GraphComparison_EXPORT DynamicEmbedding
{
public:
  explicit DynamicEmbedding(GenusOptions genus = {}, GraphEmbeddingOptions embedding = {});

  /** The next step. Throws InputError as FindEmbedding() and EmbedGraph() do. */
  DynamicStep
  Add(const Graph & graph);

private:
  PackedMap
  PackAnew(const Graph & graph) const;

  GenusOptions          m_Genus;
  GraphEmbeddingOptions m_Embedding;
  bool                  m_IsFirst{ true };
  CombinatorialMap      m_Map;
  PackedMap             m_Packed;
  EmbeddingCertificate  m_Last;
};
} // namespace itk

#endif
