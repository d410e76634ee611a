#ifndef shapetonGraphComparison_h
#define shapetonGraphComparison_h

#include "shapetonCanonicalForm.h"
#include "shapetonDynamicEmbedding.h"
#include "shapetonJsonForward.h"
#include "shapetonProgress.h"

#include <string>
#include <vector>

namespace shapeton
{
/** Graph invariants, equal for isomorphic graphs. \ingroup ShapetonGraphComparison */
struct GraphFigures
{
  int nodes{ 0 };
  int edges{ 0 };
  int loops{ 0 };
  int parallelEdges{ 0 }; /**< parallel edges, not counting the first */
  int components{ 0 };
  int blocks{ 0 };
  int triangles{ 0 };
  /** Number of nodes of each degree, starting at 0. */
  std::vector<int> nodesOfDegree;
};

ShapetonGraphComparison_EXPORT GraphFigures
FiguresOf(const Graph & graph);

/** Describes the differences between the invariants of two graphs, one sentence each. \ingroup ShapetonGraphComparison
 */
ShapetonGraphComparison_EXPORT std::vector<std::string>
                               DifferencesBetween(const GraphFigures & a, const GraphFigures & b);

/** Node correspondence and its method. \ingroup ShapetonGraphComparison */
struct NodeCorrespondence
{
  /** "isomorphism", "names", "neighborhoods" (nodes with a neighborhood of up to four edges that is unique in both
   * graphs), or "none". */
  std::string by;
  /** For each node of the first graph, the corresponding node of the second, or -1. */
  std::vector<int> image;
};

/** Matches nodes by an isomorphism if one exists; else by names, if both graphs have names and at least half of the
 * nodes of the smaller graph match; else by neighborhoods. Indices refer to the graphs of the canonical forms.
 * \ingroup ShapetonGraphComparison */
ShapetonGraphComparison_EXPORT NodeCorrespondence
CorrespondingNodes(const CanonicalForm & a, const CanonicalForm & b);

/** Result of comparing two graphs. \ingroup ShapetonGraphComparison */
struct GraphComparison
{
  bool isomorphic{ false };
  /** Embeddings of the graphs in canonical order: node k of the certificate has canonical number k. Isomorphic graphs
   * have the same certificates except for their names. */
  EmbeddingCertificate a;
  EmbeddingCertificate b;
  NodeCorrespondence   correspondence;
  /** Differences and displacements of corresponding nodes. */
  GraphChanges changes;
  /** Differences, one sentence each; empty for isomorphic graphs. */
  std::vector<std::string> differences;
};

/** Labels both graphs canonically and embeds them. If the graphs are not isomorphic, the second embedding reuses the
 * rotation system of the first where nodes correspond by names, and its sphere is aligned with the first by a Moebius
 * transformation. Reports overall progress; the progress function in the options is ignored.
 * \ingroup ShapetonGraphComparison
 */
ShapetonGraphComparison_EXPORT GraphComparison
CompareGraphs(const Graph &                  a,
              const Graph &                  b,
              const GenusSettings &          genus = {},
              const GraphEmbeddingSettings & embedding = {},
              const Progress &               progress = {});

/** "#rrggbb" for each node of both graphs. Corresponding nodes share a color; nodes that are adjacent in canonical
 * order have very different colors; unmatched nodes are gray. \ingroup ShapetonGraphComparison */
ShapetonGraphComparison_EXPORT std::array<std::vector<std::string>, 2>
                               ColorsOfNodes(const GraphComparison & comparison);

/** Comparison as JSON with node names, excluding the embeddings. \ingroup ShapetonGraphComparison */
ShapetonGraphComparison_EXPORT Json
ComparisonToJson(const GraphComparison & comparison);

/** Changes as JSON with node names. \ingroup ShapetonGraphComparison */
ShapetonGraphComparison_EXPORT Json
ChangesToJson(const GraphChanges & changes, const Graph & a, const Graph & b);
} // namespace shapeton

#endif
