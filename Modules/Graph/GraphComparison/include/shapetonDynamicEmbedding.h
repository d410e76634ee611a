#ifndef shapetonDynamicEmbedding_h
#define shapetonDynamicEmbedding_h

#include "ShapetonGraphComparisonExport.h"
#include "shapetonEmbeddingCertificate.h"
#include "shapetonGraphEmbedding.h"
#include "shapetonGraphGenus.h"
#include "shapetonPackedMap.h"

#include <vector>

namespace shapeton
{
/** Differences between two steps of a dynamic graph, or two graphs with named nodes. Node and edge indices refer to the
 * step they belong to. \ingroup ShapetonGraphComparison */
struct GraphChanges
{
  std::vector<int> removedNodes; /**< of the first step */
  std::vector<int> removedEdges; /**< of the first step */
  std::vector<int> addedNodes;   /**< of the second step */
  std::vector<int> addedEdges;   /**< of the second step */
  /** Changed nodes of the second step, ascending: new nodes and those that gained or lost an edge. */
  std::vector<int> changedNodes;
  /** Unchanged nodes of both steps, and their displacement in radians after a rotation of the second sphere onto the
   * first. NaN on other surfaces, or if there are no unchanged nodes. */
  int    unchangedNodes{ 0 };
  double meanDisplacement;
  double largestDisplacement;
};

/** Compares embeddings by node names. To use another correspondence, pass the corresponding node of `b`, or -1, for
 * each node of `a`.
 * \ingroup ShapetonGraphComparison */
///@{
ShapetonGraphComparison_EXPORT GraphChanges
ChangesBetween(const EmbeddingCertificate & a, const EmbeddingCertificate & b);
ShapetonGraphComparison_EXPORT GraphChanges
ChangesBetween(const EmbeddingCertificate & a, const EmbeddingCertificate & b, const std::vector<int> & image);
///@}

/** Rotation that aligns sphere `b` with sphere `a`, based on corresponding nodes; the identity on other surfaces.
 * \ingroup ShapetonGraphComparison */
ShapetonGraphComparison_EXPORT std::array<double, 9>
RotationTo(const EmbeddingCertificate & a, const EmbeddingCertificate & b, const std::vector<int> & image);

/** One step. \ingroup ShapetonGraphComparison */
struct DynamicStep
{
  EmbeddingCertificate certificate;
  /** Changes since the previous step; empty for the first one. */
  GraphChanges changes;
  /** Whether the rotation system was recomputed, or blocks and dummies were rearranged, which may move nodes far. */
  bool embeddedAnew{ false };
};

/** \class DynamicEmbedding
 * \brief Embeds the steps of a dynamic graph so that unchanged parts stay in place.
 *
 * The blocks of the first step are arranged (see EmbedGraph()); later steps reuse the rotation system of the previous
 * step. Each sphere is rotated to bring unchanged nodes as close as possible to their previous positions. The graph is
 * packed with the reusable dummies (see CarryPackedMap()), which is more stable if there are few changes. If nodes
 * move, it is also packed with new dummies, which is more stable if there are many changes; the more stable result is
 * used. If a circle is then too small to be legible, blocks and dummies are rearranged, provided that the smallest
 * circle becomes ten times larger.
 * \ingroup ShapetonGraphComparison */
class ShapetonGraphComparison_EXPORT DynamicEmbedding
{
public:
  explicit DynamicEmbedding(GenusSettings genus = {}, GraphEmbeddingSettings embedding = {});

  /** Embeds the next step. Throws InputError as FindEmbedding() and EmbedGraph() do. */
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

  GenusSettings          m_Genus;
  GraphEmbeddingSettings m_Embedding;
  bool                   m_IsFirst{ true };
  EmbeddingCertificate   m_Last;
};
} // namespace shapeton

#endif
