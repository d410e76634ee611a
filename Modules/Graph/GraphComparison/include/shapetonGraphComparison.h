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
/** Numbers that isomorphic graphs have in common. \ingroup GraphComparison */
struct GraphFigures
{
  int nodes{ 0 };
  int edges{ 0 };
  int loops{ 0 };
  int parallelEdges{ 0 }; /**< beyond the first of each pair of ends */
  int components{ 0 };
  int blocks{ 0 };
  int triangles{ 0 };
  /** How many nodes have each degree, from 0. */
  std::vector<int> nodesOfDegree;
};

GraphComparison_EXPORT GraphFigures
FiguresOf(const Graph & graph);

/** Sentences: what differs between the figures of two graphs. \ingroup GraphComparison */
GraphComparison_EXPORT std::vector<std::string>
                       DifferencesBetween(const GraphFigures & a, const GraphFigures & b);

/** Which nodes correspond, and by what. \ingroup GraphComparison */
struct NodeCorrespondence
{
  /** "isomorphism", "names", "neighbourhoods": nodes that are the only ones of both graphs whose surroundings, up to
   * four edges away, look as they do; or "none". */
  std::string by;
  /** For each node of the first graph that of the second one, or -1. */
  std::vector<int> image;
};

/** By an isomorphism where there is one, else by names where both graphs have names and at least half of the nodes of
 * the smaller one find theirs, else by neighbourhoods. Indices are those of the graphs of the canonical forms.
 * \ingroup GraphComparison */
GraphComparison_EXPORT NodeCorrespondence
CorrespondingNodes(const CanonicalForm & a, const CanonicalForm & b);

/** Two graphs side by side. \ingroup GraphComparison */
struct GraphComparison
{
  bool isomorphic{ false };
  /** Of the graphs in canonical order: node k of the certificate is that with canonical number k. Isomorphic graphs
   * have the same certificates but for their names. */
  EmbeddingCertificate a;
  EmbeddingCertificate b;
  NodeCorrespondence   correspondence;
  /** What differs where nodes correspond, and how far they lie apart. */
  GraphChanges changes;
  /** Sentences; empty for isomorphic graphs. */
  std::vector<std::string> differences;
};

/** Labels both graphs canonically and embeds them. An embedding of a graph that is not isomorphic to the first one
 * takes over its rotation system where nodes correspond by names, and its sphere is moved to the first one by a
 * Moebius transformation. Progress is that of the whole; that of the options is not told.
 * \ingroup GraphComparison */
GraphComparison_EXPORT GraphComparison
CompareGraphs(const Graph &                 a,
              const Graph &                 b,
              const GenusOptions &          genus = {},
              const GraphEmbeddingOptions & embedding = {},
              const Progress &              progress = {});

/** "#rrggbb" for each node of both graphs: corresponding nodes have one colour, neighbours in canonical order far ones;
 * nodes without a partner are grey. \ingroup GraphComparison */
GraphComparison_EXPORT std::array<std::vector<std::string>, 2>
                       ColoursOfNodes(const GraphComparison & comparison);

/** All of a comparison but the embeddings, by the names of the nodes. \ingroup GraphComparison */
GraphComparison_EXPORT Json
ComparisonToJson(const GraphComparison & comparison);

/** Changes by the names of the nodes. \ingroup GraphComparison */
GraphComparison_EXPORT Json
ChangesToJson(const GraphChanges & changes, const Graph & a, const Graph & b);
} // namespace shapeton

#endif
