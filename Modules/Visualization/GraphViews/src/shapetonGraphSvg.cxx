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
} // namespace

void
WriteGraphSvg(const GraphView & view, const GraphPictureOptions & options, const std::string & path)
{
  const EmbeddedGraph      graph(*view.certificate);
  const GraphPainter       painter(view, graph, options.panelSize);
  std::vector<std::string> panels;
  for (const PanelPlan & plan : PlansOf(graph, options.disk))
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
    plans.push_back((isSphere ? PlansOfSphere(graph, *pole) : PlansOf(graph, options.disk))[1]);
    plans.back().title = view.title;
    plans.back().hasDual = false;
  }
  UniteWindows(graphs, plans);
  std::vector<std::string> panels;
  auto                     graph = graphs.begin();
  for (std::size_t i = 0; i < views.size(); ++i, ++graph)
  {
    panels.push_back(GraphPainter(views[i], *graph, options.panelSize).Paint(plans[i]));
  }
  WriteSheet(panels, options, path);
}
} // namespace shapeton
