#ifndef shapetonGraphPainter_h
#define shapetonGraphPainter_h

#include "shapetonPanelPlans.h"

namespace shapeton
{
/** Paints panels of one graph. */
class GraphPainter
{
public:
  GraphPainter(const GraphView & view, const EmbeddedGraph & graph, int size)
    : m_View(view), m_Graph(graph), m_Size(size)
  {}

  std::string
  Paint(const PanelPlan & plan) const;

private:
  std::vector<EmbeddedGraph::Segment>
  Edges() const;
  double
  LeastPixels() const;
  double
  LineWidth() const;
  void
  PaintTiles(const PanelPlan & plan, SvgPanel & panel) const;
  void
  PaintCircles(const PanelPlan & plan, SvgPanel & panel) const;
  void
  PaintDots(const PanelPlan & plan, SvgPanel & panel) const;

  const GraphView &     m_View;
  const EmbeddedGraph & m_Graph;
  int                   m_Size;
};
} // namespace shapeton

#endif
