#include "shapetonGraphPainter.h"

#include "shapetonGraphTiles.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace shapeton
{
namespace
{
const char * const                 NodeColor = "#c62828";
const char * const                 FaceColor = "#2e7d32";
const char * const                 EdgeColor = "#212121";
const char * const                 EdgeNodeColor = "#1565c0";
const std::array<const char *, 12> TileColors{ "#fff3c4", "#cfe8ff", "#ffd9d4", "#d6f5d6", "#eadcff", "#ffe3c2",
                                               "#d2f4f0", "#ffd6ec", "#e8f0c8", "#dfe3ee", "#f5e0d3", "#d9ecd9" };

/** Widths of lines, pixels. */
constexpr double TileWidth = 0.6;
constexpr double DomainWidth = 1.6;
constexpr double PolygonWidth = 1.8;
/** Widths relative to edges. */
constexpr double DualWidth = 0.7;
constexpr double CircleWidth = 0.8;
constexpr double ColoredWidth = 2.0; // edges with colors need more area

/** Outlines and marks next to colors that show a quantity. */
const char * const OutlineColor = "#9e9e9e";
const char * const MarkColor = "#424242";

/** Space around the legend, pixels. */
constexpr int LegendMargin = 8;
constexpr int LegendHeight = 46;
} // namespace

std::string
GraphPainter::Paint(const PanelPlan & plan) const
{
  SvgPanel panel(m_Graph.space, plan.picture, plan.window, m_Size, LeastPixels());
  if (plan.hasTiles)
  {
    this->PaintTiles(plan, panel);
  }
  if (plan.hasRim)
  {
    panel.AddRim({ 0.0, 0.0 }, 1.0, { "#9e9e9e", plan.hasTiles ? "" : "#fafafa", 1.0, 1.0, false });
  }
  if (plan.hasCircles)
  {
    this->PaintCircles(plan, panel);
  }
  const double width = LineWidth();
  for (const auto & [color, segments] : this->EdgesByColor())
  {
    const double ofColor = m_View.edgeColors.empty() ? 1.0 : ColoredWidth;
    panel.AddSegments(segments, plan.tiles, { color, "", ofColor * width, 1.0, false });
  }
  if (plan.hasDual)
  {
    panel.AddSegments(m_Graph.dual, plan.tiles, { FaceColor, "", DualWidth * width, 1.0, false });
  }
  if (plan.hasTiles && m_View.edgeColors.empty())
  {
    panel.AddPolygon(PolygonCorners(m_Graph), {}, { "#8e24aa", "", PolygonWidth, 1.0, true });
  }
  this->PaintDots(plan, panel);
  int namesLeftOut = 0;
  for (int node = 0; node < m_Graph.certificate.graph.nodes && m_View.hasLabels; ++node)
  {
    const Place & rim = m_Graph.touch[m_Graph.map.FirstAround(node)];
    namesLeftOut += panel.AddLabel(m_Graph.nodes[node], rim, NameOfNode(m_Graph.certificate.graph, node)) ? 0 : 1;
  }
  const std::size_t        leftOut = panel.LeftOut(); // a few are just short ends of curves
  std::vector<std::string> title(1, plan.title);
  if (leftOut > m_Graph.halfEdges.size() / 100)
  {
    title.push_back(std::to_string(leftOut) + " lines are too short to show");
  }
  if (namesLeftOut > 0)
  {
    title.push_back(namesLeftOut == 1 ? "1 name does not fit its circle"
                                      : std::to_string(namesLeftOut) + " names do not fit their circles");
  }
  panel.AddTitle(title);
  return panel.Content() +
         (m_View.colorBar ? ColorBarMarkup(*m_View.colorBar, LegendMargin, m_Size - LegendHeight - LegendMargin) : "");
}

/** Segments of each color. Draws whole edges on the sphere if the arc between the ends passes through the tangency
 * point, else halves. */
std::map<std::string, std::vector<EmbeddedGraph::Segment>>
GraphPainter::EdgesByColor() const
{
  const bool isSphere = m_Graph.space.Geometry() == EmbeddingGeometry::Spherical;
  std::map<std::string, std::vector<EmbeddedGraph::Segment>> edges;
  for (int h = 0; h < m_Graph.map.HalfEdges(); h += isSphere ? 2 : 1)
  {
    const int edge = m_Graph.edgeOf[h / 2];
    if (edge >= 0)
    {
      const Place & start = m_Graph.nodes[m_Graph.map.Node(h)];
      const Place & end = isSphere ? m_Graph.nodes[m_Graph.map.Node(h + 1)] : m_Graph.touch[h];
      edges[m_View.edgeColors.empty() ? EdgeColor : m_View.edgeColors[edge]].push_back({ start, end });
    }
  }
  return edges;
}

/** Size limit of skipped items: a tenth of a pixel for small graphs, up to a pixel for very large ones. */
double
GraphPainter::LeastPixels() const
{
  constexpr double least = 0.1;
  constexpr double small = 4000.0; // half edges
  return std::clamp(least * std::sqrt(static_cast<double>(m_Graph.halfEdges.size()) / small), least, 1.0);
}

double
GraphPainter::LineWidth() const
{
  constexpr double ofOneEdge = 30.0, narrowest = 0.15, widest = 1.4; // pixels
  const double     edges = static_cast<double>(std::max<std::size_t>(m_Graph.halfEdges.size(), 1));
  return std::clamp(ofOneEdge / std::sqrt(edges), narrowest, widest);
}

void
GraphPainter::PaintTiles(const PanelPlan & plan, SvgPanel & panel) const
{
  const std::vector<Place> boundary = DomainBoundary(m_Graph);
  if (boundary.empty())
  {
    return;
  }
  for (std::size_t i = plan.tiles.size(); i-- > 0;)
  {
    const std::string fill = m_View.edgeColors.empty() ? TileColors[i % TileColors.size()] : "#ffffff";
    panel.AddPolygon(boundary, plan.tiles[i], { "#b0a890", fill, TileWidth, 1.0, false });
  }
  panel.AddPolygon(boundary, {}, { "#8d6e00", "", DomainWidth, 1.0, false });
}

void
GraphPainter::PaintCircles(const PanelPlan & plan, SvgPanel & panel) const
{
  const double       width = CircleWidth * LineWidth();
  const char * const outline = m_View.edgeColors.empty() ? NodeColor : OutlineColor;
  for (const Motion & tile : plan.tiles)
  {
    for (int node = 0; node < m_Graph.certificate.graph.nodes; ++node)
    {
      const std::string fill = m_View.nodeColors.empty() ? "#f8c9c4" : m_View.nodeColors[node];
      panel.AddCircle(
        m_Graph.nodes[node], m_Graph.certificate.nodeRadii[node], tile, { outline, fill, width, 1.0, false });
    }
    for (std::size_t face = 0; plan.hasDual && face < m_Graph.faces.size(); ++face)
    {
      if (m_Graph.isVisibleFace[face] != 0)
      {
        panel.AddCircle(
          m_Graph.faces[face], m_Graph.certificate.faceRadii[face], tile, { FaceColor, "", width, 1.0, false });
      }
    }
  }
}

void
GraphPainter::PaintDots(const PanelPlan & plan, SvgPanel & panel) const
{
  constexpr double   largest = 5.0, largestOfFace = 4.0, largestOfLine = 1.6; // pixels; the last relative to edges
  constexpr double   ofNode = 0.3, ofFace = 0.25, ofEdgeNode = 0.12;          // of the radius of the circle
  const char * const mark = m_View.edgeColors.empty() ? NodeColor : MarkColor;
  for (const Motion & tile : plan.tiles)
  {
    for (int node = 0; node < m_Graph.certificate.graph.nodes && !m_View.hasLabels; ++node)
    {
      const double pixels = panel.PixelsOf(m_Graph.nodes[node], m_Graph.certificate.nodeRadii[node], tile);
      panel.AddDot(m_Graph.nodes[node], tile, std::min(largest, ofNode * pixels), mark);
    }
    for (const int face : plan.hasDual ? m_Graph.representatives : std::vector<int>())
    {
      const double pixels = panel.PixelsOf(m_Graph.faces[face], m_Graph.certificate.faceRadii[face], tile);
      panel.AddDot(m_Graph.faces[face], tile, std::min(largestOfFace, ofFace * pixels), FaceColor);
    }
    for (const int h : plan.hasDual && !plan.hasCircles ? m_Graph.crossings : std::vector<int>())
    {
      const int    node = m_Graph.map.Node(h);
      const double pixels = panel.PixelsOf(m_Graph.nodes[node], m_Graph.certificate.nodeRadii[node], tile);
      panel.AddDot(m_Graph.touch[h], tile, std::min(largestOfLine * LineWidth(), ofEdgeNode * pixels), EdgeNodeColor);
    }
  }
}
} // namespace shapeton
