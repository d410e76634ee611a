#include "shapetonFileBytes.h"
#include "shapetonGraphPainter.h"
#include "shapetonGraphPictures.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
/** Panels in rows, each clipped and with separate coordinates. */
void
WriteSheet(const std::vector<std::string> & panels, const GraphPictureOptions & options, const std::string & path)
{
  const int         columns = std::max(1, std::min<int>(options.columns, static_cast<int>(panels.size())));
  const int         rows = (static_cast<int>(panels.size()) + columns - 1) / columns;
  const std::string size = std::to_string(options.panelSize);
  std::string       text;
  for (std::size_t i = 0; i < panels.size(); ++i)
  {
    const int column = static_cast<int>(i) % columns;
    const int row = static_cast<int>(i) / columns;
    text += "<svg x=\"" + std::to_string(column * options.panelSize) + "\" y=\"" +
            std::to_string(row * options.panelSize) + "\" width=\"" + size + "\" height=\"" + size +
            "\" viewBox=\"0 0 " + size + ' ' + size + "\">\n" + panels[i] + "</svg>\n";
  }
  WriteFileBytes(path, SvgDocument(columns * options.panelSize, rows * options.panelSize, text));
}

std::vector<std::string>
PanelsOf(const std::vector<GraphView> &   views,
         const std::list<EmbeddedGraph> & graphs,
         const std::vector<PanelPlan> &   plans,
         int                              size)
{
  std::vector<std::string> panels;
  for (const EmbeddedGraph & graph : graphs)
  {
    const std::size_t i = panels.size();
    panels.push_back(GraphPainter(views[i], graph, size).Paint(plans[i]));
  }
  return panels;
}

/** Markup of a blue box around the area of another window. */
std::string
BoxOf(const PictureWindow & area, const PictureWindow & window, int size)
{
  const double      scale = 0.5 * size / window.halfWidth;
  const auto        pixel = [&](double at, double center) { return SvgNumber(0.5 * size + scale * (at - center)); };
  const std::string width = SvgNumber(2.0 * scale * area.halfWidth);
  return "<rect x=\"" + pixel(area.center.x - area.halfWidth, window.center.x) + "\" y=\"" +
         pixel(area.center.y - area.halfWidth, window.center.y) + "\" width=\"" + width + "\" height=\"" + width +
         "\" fill=\"none\" stroke=\"#1e88e5\" stroke-width=\"2\"/>\n";
}

/** Whether a part is shown much larger than before. */
bool
AreLarger(const std::vector<PanelPlan> & enlarged, const std::vector<PanelPlan> & plans)
{
  constexpr double muchLarger = 2.0;
  bool             areLarger = false;
  for (std::size_t i = 0; i < enlarged.size(); ++i)
  {
    areLarger |= plans[i].window.halfWidth > muchLarger * enlarged[i].window.halfWidth;
  }
  return areLarger;
}

/** A row of the first panels, a row of the second ones below, and so on. */
std::vector<std::string>
InAlternateRows(const std::vector<std::string> & first, const std::vector<std::string> & second, int columns)
{
  std::vector<std::string> panels;
  for (std::size_t start = 0; start < first.size(); start += columns)
  {
    const std::size_t end = std::min(start + columns, first.size());
    panels.insert(panels.end(), first.begin() + start, first.begin() + end);
    panels.resize(panels.size() + (first.size() > static_cast<std::size_t>(columns) ? start + columns - end : 0));
    panels.insert(panels.end(), second.begin() + start, second.begin() + end);
  }
  return panels;
}
} // namespace

void
WriteGraphSvg(const GraphView & view, const GraphPictureOptions & options, const std::string & path)
{
  const EmbeddedGraph      graph(*view.certificate);
  const GraphPainter       painter(view, graph, options.panelSize);
  std::vector<std::string> panels;
  for (const PanelPlan & plan : PlansOf(graph, options))
  {
    panels.push_back(painter.Paint(plan));
  }
  WriteSheet(panels, options, path);
}

void
WriteGraphSheetSvg(const std::vector<GraphView> & views, const GraphPictureOptions & options, const std::string & path)
{
  std::list<EmbeddedGraph> graphs;
  std::vector<PanelPlan>   plans;
  const Place *            pole = nullptr; // shared by all spheres, so unchanged nodes keep their position
  for (const GraphView & view : views)
  {
    const EmbeddedGraph & graph = graphs.emplace_back(*view.certificate);
    const bool            isSphere = graph.space.Geometry() == EmbeddingGeometry::Spherical;
    pole = isSphere && pole == nullptr ? &graph.pole : pole;
    plans.push_back((isSphere ? PlansOfSphere(graph, *pole) : PlansOf(graph, options))[1]);
    plans.back().title = view.title;
    plans.back().hasDual = false;
  }
  UniteWindows(graphs, plans);
  std::vector<std::string>     panels = PanelsOf(views, graphs, plans, options.panelSize);
  const std::vector<PanelPlan> enlarged = EnlargedPlans(graphs, plans, options.enlarged);
  if (AreLarger(enlarged, plans))
  {
    for (std::size_t i = 0; i < panels.size(); ++i)
    {
      panels[i] += BoxOf(enlarged[i].window, plans[i].window, options.panelSize);
    }
    panels = InAlternateRows(panels, PanelsOf(views, graphs, enlarged, options.panelSize), options.columns);
  }
  WriteSheet(panels, options, path);
}
} // namespace shapeton
