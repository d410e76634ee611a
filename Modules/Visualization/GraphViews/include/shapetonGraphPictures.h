#ifndef shapetonGraphPictures_h
#define shapetonGraphPictures_h

#include "GraphViewsExport.h"
#include "shapetonEmbeddingCertificate.h"

#include <string>
#include <utility>
#include <vector>

namespace shapeton
{
/** How the hyperbolic plane is shown: with circles and angles as they are, or with straight edges.
 * \ingroup GraphViews */
enum class DiskModel
{
  Poincare,
  Klein
};

/** An embedded graph as it is to be shown.
 * \ingroup GraphViews */
struct GraphView
{
  std::string                  title;
  const EmbeddingCertificate * certificate{ nullptr };
  /** Of the circle of each node of the graph, "#rrggbb"; empty for one colour. */
  std::vector<std::string> nodeColors{};
  /** Names of nodes beside them. */
  bool hasLabels{ false };
  /** For pages: a number of each node that it shares with those of other graphs that correspond to it; empty where
   * names say so. */
  std::vector<int> nodeKeys{};
};

/** Model of the hyperbolic plane, size and arrangement of the panels for WriteGraphSvg(). \ingroup GraphViews */
struct GraphPictureOptions
{
  DiskModel disk{ DiskModel::Poincare };
  /** Width and height of a panel, pixels. */
  int panelSize{ 600 };
  /** Panels in a row. */
  int columns{ 2 };
};

/** Writes a picture of one graph with a panel for each of
 * - the overlap graph: nodes red, edges black, the dual green, edge nodes where an edge and its dual cross;
 * - circles of nodes (red) and of faces (green),
 * on the sphere both by stereographic projection from the largest face, and the sphere itself from two sides; on the
 * torus with the period parallelogram and the copies around it; on the disk with the tiles of the universal cover
 * around the fundamental domain, each in its colour, and the fundamental polygon. Dummies are hidden. Nothing smaller
 * than a tenth of a pixel is drawn; of graphs of more than 2,000 edges nothing below a limit that grows to a pixel, and
 * the title says how many lines are left out. Equal certificates give equal bytes. Throws OutputError.
 * \ingroup GraphViews */
GraphViews_EXPORT void
WriteGraphSvg(const GraphView & view, const GraphPictureOptions & options, const std::string & path);

/** Writes small multiples: one panel for each graph, its circles in their colours and its edges.
 * \ingroup GraphViews */
GraphViews_EXPORT void
WriteGraphSheetSvg(const std::vector<GraphView> & views, const GraphPictureOptions & options, const std::string & path);

/** Writes nodes (points), edges and circles (polylines) as VTP: on the unit sphere, in the plane, or in the Poincare
 * disk, z = 0. Cell arrays: kind (0 node, 1 edge, 2 circle of a node, 3 circle of a face), id of the node, edge or
 * face, radius. Dummies are left out. Throws OutputError. \ingroup GraphViews */
GraphViews_EXPORT void
WriteGraphVtp(const EmbeddingCertificate &                             certificate,
              const std::vector<std::pair<std::string, std::string>> & facts,
              const std::string &                                      path);

/** `count` colours that differ in hue, for nodes that correspond to each other.
 * \ingroup GraphViews */
GraphViews_EXPORT std::vector<std::string>
                  DistinctColors(int count);
} // namespace shapeton

#endif
