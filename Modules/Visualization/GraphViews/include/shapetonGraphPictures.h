#ifndef shapetonGraphPictures_h
#define shapetonGraphPictures_h

#include "ShapetonGraphViewsExport.h"
#include "shapetonEmbeddingCertificate.h"
#include "shapetonProvenance.h"

#include <optional>
#include <string>
#include <vector>

namespace shapeton
{
/** Model of the hyperbolic plane: Poincare (conformal, circles stay circles) or Klein (straight edges).
 * \ingroup ShapetonGraphViews */
enum class DiskModel
{
  Poincare,
  Klein
};

/** Legend of the colors of a quantity, see DivergingColor(). \ingroup ShapetonGraphViews */
struct GraphColorBar
{
  /** Quantity and unit. */
  std::string title;
  /** Largest magnitude shown, > 0. */
  double most{ 1.0 };
};

/** An embedded graph and how to draw it.
 * \ingroup ShapetonGraphViews */
struct GraphView
{
  std::string                  title;
  const EmbeddingCertificate * certificate{ nullptr };
  /** Color of each node's circle, "#rrggbb"; empty for one color. */
  std::vector<std::string> nodeColors{};
  /** Whether nodes are labeled with their names. */
  bool hasLabels{ false };
  /** Pages only: key of each node, shared with the corresponding nodes of other graphs. If empty, nodes correspond by
   * name. */
  std::vector<int> nodeKeys{};
  /** Color of each edge, "#rrggbb"; empty for one color. With edge colors, outlines are gray, the tiles of the
   * universal cover are white, and the fundamental polygon is omitted. */
  std::vector<std::string> edgeColors{};
  /** Legend of node and edge colors, or none. */
  std::optional<GraphColorBar> colorBar{};
};

/** Model of the hyperbolic plane, size and arrangement of the panels for WriteGraphSvg().
 * \ingroup ShapetonGraphViews */
struct GraphPictureOptions
{
  DiskModel disk{ DiskModel::Poincare };
  /** Width and height of a panel, pixels. */
  int panelSize{ 600 };
  /** Number of panels per row. */
  int columns{ 2 };
  /** WriteGraphSvg() of a sphere only: project from the node of the first edge and its dual, as published. The circles
   * of its ends become vertical lines and those of its faces horizontal lines, up to a radius of thousands of pixels.
   */
  bool fromEdgeNode{ false };
  /** WriteGraphSheetSvg() only: names of nodes that a second panel of each graph enlarges, below the first, with their
   * neighbors; a blue box marks its area in the first. No second panel if it would show almost the same. */
  std::vector<std::string> enlarged{};
};

/** Writes a picture of one graph with a panel for each of
 * - the overlap graph: nodes red, edges black, the dual green, edge nodes where an edge crosses its dual;
 * - circles of nodes (red) and of faces (green).
 * The sphere is shown by stereographic projection from the largest face, and from two sides. The torus is shown with
 * the period parallelogram and its surrounding copies. The disk is shown with the colored tiles of the universal cover
 * around the fundamental domain, and the fundamental polygon. Dummies are hidden. Items smaller than a tenth of a pixel
 * are skipped; for graphs of more than 2,000 edges this limit grows up to a pixel, and the title states the number of
 * skipped lines. Equal certificates give equal bytes. Throws OutputError.
 * \ingroup ShapetonGraphViews */
ShapetonGraphViews_EXPORT void
WriteGraphSvg(const GraphView & view, const GraphPictureOptions & options, const std::string & path);

/** Writes small multiples: one panel per graph with its colored circles and its edges.
 * \ingroup ShapetonGraphViews */
ShapetonGraphViews_EXPORT void
WriteGraphSheetSvg(const std::vector<GraphView> & views, const GraphPictureOptions & options, const std::string & path);

/** Writes nodes (points), edges and circles (polylines) as VTP: on the unit sphere, in the plane, or in the Poincare
 * disk, z = 0. Cell arrays: kind (0 node, 1 edge, 2 circle of a node, 3 circle of a face), id of the node, edge or
 * face, radius. Dummies are omitted. Throws OutputError. \ingroup ShapetonGraphViews */
ShapetonGraphViews_EXPORT void
WriteGraphVtp(const EmbeddingCertificate & certificate, const Provenance & facts, const std::string & path);

/** `count` colors of different hues, for corresponding nodes.
 * \ingroup ShapetonGraphViews */
ShapetonGraphViews_EXPORT std::vector<std::string>
                          DistinctColors(int count);

/** Colors of a few tracked nodes, distinguishable for color-blind readers and from green, which marks changes.
 * \ingroup ShapetonGraphViews */
ShapetonGraphViews_EXPORT const std::vector<std::string> &
                                TrackColors();

/** Color of a value between -1 and 1: orange, gray at 0, blue; values outside are clamped. Orange and blue are
 * distinguishable for color-blind readers (Okabe and Ito). `lightness`, 0 to 1, is the amount of white mixed into the
 * color, for areas behind lines. \ingroup ShapetonGraphViews */
ShapetonGraphViews_EXPORT std::string
                          DivergingColor(double value, double lightness = 0.0);

/** SVG elements of a legend with its upper left corner at a position in pixels; 290 x 46 pixels.
 * \ingroup ShapetonGraphViews */
ShapetonGraphViews_EXPORT std::string
                          ColorBarMarkup(const GraphColorBar & bar, int left, int top);
} // namespace shapeton

#endif
