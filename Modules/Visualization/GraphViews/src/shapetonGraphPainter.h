#ifndef shapetonGraphPainter_h
#define shapetonGraphPainter_h

#include "shapetonPanelPlans.h"

#include <map>

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
  std::map<std::string, std::vector<EmbeddedGraph::Segment>>
  EdgesByColor() const;
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
