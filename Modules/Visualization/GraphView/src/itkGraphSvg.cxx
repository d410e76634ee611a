#include "itkFileBytes.h"
#include "itkGraphPictures.h"
#include "itkGraphTiles.h"
#include "itkSvgPanel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <list>

namespace itk
{
namespace
{
const char * const                 NodeColor = "#c62828";
const char * const                 FaceColor = "#2e7d32";
const char * const                 EdgeColor = "#212121";
const char * const                 EdgeNodeColor = "#1565c0";
const std::array<const char *, 12> TileColors{ "#fff3c4", "#cfe8ff", "#ffd9d4", "#d6f5d6", "#eadcff", "#ffe3c2",
                                               "#d2f4f0", "#ffd6ec", "#e8f0c8", "#dfe3ee", "#f5e0d3", "#d9ecd9" };

/** An orthonormal frame; z looks at the reader. */
struct Frame
{
  Place x;
  Place y;
  Place z;
};

double
Dot(const Place & p, const Place & q)
{
  return p.x * q.x + p.y * q.y + p.z * q.z;
}

Frame
FrameOf(const Place & z)
{
  const Place  up = std::abs(z.z) < 0.9 ? Place{ 0.0, 0.0, 1.0 } : Place{ 0.0, 1.0, 0.0 };
  const double along = Dot(up, z);
  Place        y{ up.x - along * z.x, up.y - along * z.y, up.z - along * z.z };
  const double length = std::sqrt(Dot(y, y));
  y = { y.x / length, y.y / length, y.z / length };
  return { { y.y * z.z - y.z * z.y, y.z * z.x - y.x * z.z, y.x * z.y - y.y * z.x }, y, z };
}

PictureMap
Orthographic(const Frame & frame)
{
  PictureMap picture = { [frame](const Place & p) {
                          return Pixel{ Dot(p, frame.x), -Dot(p, frame.y) };
                        },
                         [frame](const Place & p) { return Dot(p, frame.z) >= 0.0; },
                         false,
                         false,
                         {} };
  constexpr int number = 360;
  for (int i = 0; i < number; ++i)
  {
    const double c = std::cos(2.0 * std::acos(-1.0) * i / number);
    const double s = std::sin(2.0 * std::acos(-1.0) * i / number);
    picture.rim.push_back(
      { c * frame.x.x + s * frame.y.x, c * frame.x.y + s * frame.y.y, c * frame.x.z + s * frame.y.z });
  }
  return picture;
}

/** From the pole -z of the frame; seen as from outside the sphere. */
PictureMap
Stereographic(const Frame & frame)
{
  return { [frame](const Place & p) {
            const double share = 1.0 / std::max(1e-12, 1.0 + Dot(p, frame.z));
            return Pixel{ share * Dot(p, frame.x), -share * Dot(p, frame.y) };
          },
           [frame](const Place & p) { return Dot(p, frame.z) > -0.9999; }, // the pole is out of any picture
           true,
           false,
           {} };
}

PictureMap
Flat(bool isStraight)
{
  return { [](const Place & p) {
            return Pixel{ p.x, -p.y };
          },
           [](const Place &) { return true; },
           true,
           isStraight,
           {} };
}

PictureMap
Klein()
{
  return { [](const Place & p) {
            const double scale = 2.0 / (1.0 + p.x * p.x + p.y * p.y);
            return Pixel{ scale * p.x, -scale * p.y };
          },
           [](const Place &) { return true; },
           false,
           true,
           {} };
}

/** What a panel shows. */
struct PanelPlan
{
  std::string         title;
  PictureMap          picture;
  PictureWindow       window;
  std::vector<Motion> tiles{ Motion{} };
  bool                hasCircles{ false };
  bool                hasDual{ true };
  bool                hasTiles{ false };
  bool                hasRim{ false };
};

class GraphPainter
{
public:
  GraphPainter(const GraphView & view, const EmbeddedGraph & graph, int size)
    : m_View(view), m_Graph(graph), m_Size(size)
  {}

  std::string
  Paint(const PanelPlan & plan) const
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
    panel.AddSegments(this->Edges(), plan.tiles, { EdgeColor, "", width, 1.0, false });
    if (plan.hasDual)
    {
      panel.AddSegments(m_Graph.dual, plan.tiles, { FaceColor, "", 0.7 * width, 1.0, false });
    }
    if (plan.hasTiles)
    {
      panel.AddPolygon(PolygonCorners(m_Graph), {}, { "#8e24aa", "", 1.8, 1.0, true });
    }
    this->PaintDots(plan, panel);
    if (m_View.hasLabels)
    {
      for (int node = 0; node < m_Graph.certificate.graph.nodes; ++node)
      {
        panel.AddLabel(m_Graph.nodes[node], NameOfNode(m_Graph.certificate.graph, node));
      }
    }
    const std::size_t        leftOut = panel.LeftOut(); // a few are but the short ends of curves
    std::vector<std::string> title(1, plan.title);
    if (leftOut > m_Graph.halfEdges.size() / 100)
    {
      title.push_back(std::to_string(leftOut) + " lines are too short to show");
    }
    panel.AddTitle(title);
    return panel.Content();
  }

private:
  /** Whole edges on the sphere, where the arc between the ends runs through the touching point; else halves. */
  std::vector<EmbeddedGraph::Segment>
  Edges() const
  {
    if (m_Graph.space.Geometry() != EmbeddingGeometry::Spherical)
    {
      return m_Graph.halfEdges;
    }
    std::vector<EmbeddedGraph::Segment> edges;
    for (int h = 0; h < m_Graph.map.HalfEdges(); h += 2)
    {
      if (m_Graph.isVisibleEdge[h / 2] != 0)
      {
        edges.push_back({ m_Graph.nodes[m_Graph.map.Node(h)], m_Graph.nodes[m_Graph.map.Node(h + 1)] });
      }
    }
    return edges;
  }

  /** From a tenth of a pixel for small graphs to a pixel for those that fill the panel with points. */
  double
  LeastPixels() const
  {
    return std::clamp(0.1 * std::sqrt(static_cast<double>(m_Graph.halfEdges.size()) / 4000.0), 0.1, 1.0);
  }

  double
  LineWidth() const
  {
    const double edges = static_cast<double>(std::max<std::size_t>(m_Graph.halfEdges.size(), 1));
    return std::clamp(30.0 / std::sqrt(edges), 0.15, 1.4);
  }

  void
  PaintTiles(const PanelPlan & plan, SvgPanel & panel) const
  {
    const std::vector<Place> boundary = DomainBoundary(m_Graph);
    if (boundary.empty())
    {
      return;
    }
    for (std::size_t i = plan.tiles.size(); i-- > 0;)
    {
      panel.AddPolygon(boundary, plan.tiles[i], { "#b0a890", TileColors[i % TileColors.size()], 0.6, 1.0, false });
    }
    panel.AddPolygon(boundary, {}, { "#8d6e00", "", 1.6, 1.0, false });
  }

  void
  PaintCircles(const PanelPlan & plan, SvgPanel & panel) const
  {
    const double width = 0.8 * LineWidth();
    for (const Motion & tile : plan.tiles)
    {
      for (int node = 0; node < m_Graph.certificate.graph.nodes; ++node)
      {
        const std::string fill = m_View.nodeColors.empty() ? "#f8c9c4" : m_View.nodeColors[node];
        panel.AddCircle(
          m_Graph.nodes[node], m_Graph.certificate.nodeRadii[node], tile, { NodeColor, fill, width, 1.0, false });
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
  PaintDots(const PanelPlan & plan, SvgPanel & panel) const
  {
    constexpr double largest = 5.0;
    for (const Motion & tile : plan.tiles)
    {
      for (int node = 0; node < m_Graph.certificate.graph.nodes && !m_View.hasLabels; ++node)
      {
        const double pixels = panel.PixelsOf(m_Graph.nodes[node], m_Graph.certificate.nodeRadii[node], tile);
        panel.AddDot(m_Graph.nodes[node], tile, std::min(largest, 0.3 * pixels), NodeColor);
      }
      for (const int face : plan.hasDual ? m_Graph.representatives : std::vector<int>())
      {
        const double pixels = panel.PixelsOf(m_Graph.faces[face], m_Graph.certificate.faceRadii[face], tile);
        panel.AddDot(m_Graph.faces[face], tile, std::min(0.8 * largest, 0.25 * pixels), FaceColor);
      }
      for (const int h : plan.hasDual && !plan.hasCircles ? m_Graph.crossings : std::vector<int>())
      {
        const int    node = m_Graph.map.Node(h);
        const double pixels = panel.PixelsOf(m_Graph.nodes[node], m_Graph.certificate.nodeRadii[node], tile);
        panel.AddDot(m_Graph.touch[h], tile, std::min(1.6 * LineWidth(), 0.12 * pixels), EdgeNodeColor);
      }
    }
  }

  const GraphView &     m_View;
  const EmbeddedGraph & m_Graph;
  int                   m_Size;
};

/** The square around these points, a little larger. */
PictureWindow
WindowAround(const std::vector<Pixel> & pixels, double enlargement)
{
  Pixel least{ 1e300, 1e300 };
  Pixel most{ -1e300, -1e300 };
  for (const Pixel & pixel : pixels)
  {
    least = { std::min(least.x, pixel.x), std::min(least.y, pixel.y) };
    most = { std::max(most.x, pixel.x), std::max(most.y, pixel.y) };
  }
  const double half = 0.5 * std::max({ most.x - least.x, most.y - least.y, 1e-9 });
  return { { 0.5 * (least.x + most.x), 0.5 * (least.y + most.y) }, enlargement * half };
}

/** All nodes and touching points of the graph, and its circles where they are not much larger than that. */
PictureWindow
WindowOfSphere(const EmbeddedGraph & graph, const PictureMap & picture)
{
  std::vector<Pixel> pixels;
  for (int node = 0; node < graph.certificate.graph.nodes; ++node)
  {
    pixels.push_back(picture.map(graph.nodes[node]));
  }
  for (const int h : graph.crossings)
  {
    pixels.push_back(picture.map(graph.touch[h]));
  }
  const PictureWindow near = WindowAround(pixels, 1.15);
  for (int node = 0; node < graph.certificate.graph.nodes; ++node)
  {
    for (const Place & place : graph.space.Circle(graph.nodes[node], graph.certificate.nodeRadii[node], 16))
    {
      pixels.push_back(picture.map(place));
    }
  }
  const PictureWindow whole = WindowAround(pixels, 1.05);
  const bool          isSingle = graph.certificate.graph.nodes == 1;
  return isSingle || whole.halfWidth < 2.5 * near.halfWidth ? whole : near;
}

std::vector<PanelPlan>
PlansOfSphere(const EmbeddedGraph & graph, const Place & outer)
{
  const auto             flat = Stereographic(FrameOf({ -outer.x, -outer.y, -outer.z }));
  const Place            side{ 0.48, -0.6, 0.64 };
  const PictureWindow    ball{ { 0.0, 0.0 }, 1.06 };
  const PictureWindow    window = WindowOfSphere(graph, flat);
  std::vector<PanelPlan> plans(4);
  plans[0] = { "Overlap graph: graph and dual (stereographic)", flat, window };
  plans[1] = { "Circles of nodes and faces (stereographic)", flat, window };
  plans[1].hasCircles = true;
  plans[2] = { "Sphere, front", Orthographic(FrameOf(side)), ball };
  plans[3] = { "Sphere, back", Orthographic(FrameOf({ -side.x, -side.y, -side.z })), ball };
  for (const int i : { 2, 3 })
  {
    plans[i].hasCircles = plans[i].hasRim = true;
  }
  return plans;
}

std::vector<PanelPlan>
PlansOfTorus(const EmbeddedGraph & graph)
{
  std::vector<Pixel> pixels;
  const auto         flat = Flat(true);
  for (const Place & place : graph.nodes)
  {
    pixels.push_back(flat.map(place));
  }
  for (const Place & place : DomainBoundary(graph))
  {
    pixels.push_back(flat.map(place));
  }
  PanelPlan overlap{ "Universal cover: overlap graph and fundamental domain", flat, WindowAround(pixels, 1.4) };
  overlap.hasTiles = true;
  // Copies of a large graph are grey; painting them takes as long as the original each.
  const std::size_t segments = graph.halfEdges.size() + graph.dual.size();
  overlap.tiles = TilesAround(graph, segments > 1000000 ? 1 : segments > 100000 ? 9 : 25);
  PanelPlan circles = overlap;
  circles.title = "Circles of nodes and faces";
  circles.hasCircles = true;
  return { overlap, circles };
}

/** Tiles shrink towards the rim, so large graphs need no more of them. */
int
NumberOfTiles(const EmbeddedGraph & graph)
{
  constexpr double mostSegments = 150000.0;
  const double     segments = static_cast<double>(graph.halfEdges.size() + graph.dual.size() + 1);
  const int        least = 4 * graph.certificate.genus + 1;
  return static_cast<int>(std::clamp(mostSegments / segments, static_cast<double>(least), 240.0));
}

/** The tiles that a picture of the disk shows as more than a speck. */
std::vector<Motion>
VisibleTiles(const EmbeddedGraph & graph, const PictureMap & picture)
{
  constexpr double         least = 1e-4; // of an area of the disk's plane, about 9 pixels of a panel
  const std::vector<Place> boundary = DomainBoundary(graph);
  std::vector<Motion>      tiles;
  for (const Motion & tile : TilesAround(graph, NumberOfTiles(graph)))
  {
    double twice = 0.0;
    for (std::size_t i = 0; i < boundary.size(); ++i)
    {
      const Pixel p = picture.map(graph.space.Moved(tile, boundary[i]));
      const Pixel q = picture.map(graph.space.Moved(tile, boundary[(i + 1) % boundary.size()]));
      twice += p.x * q.y - p.y * q.x;
    }
    if (tiles.empty() || std::abs(twice) > 2.0 * least)
    {
      tiles.push_back(tile);
    }
  }
  return tiles;
}

std::vector<PanelPlan>
PlansOfDisk(const EmbeddedGraph & graph, DiskModel model)
{
  const bool        isKlein = model == DiskModel::Klein;
  const std::string name = isKlein ? "Klein disk" : "Poincare disk";
  PanelPlan         overlap{ name + ": overlap graph, tiles of the universal cover",
                     isKlein ? Klein() : Flat(false),
                     { { 0.0, 0.0 }, 1.02 } };
  overlap.hasTiles = overlap.hasRim = true;
  overlap.tiles = VisibleTiles(graph, overlap.picture);
  PanelPlan circles = overlap;
  circles.title = name + ": circles of nodes and faces";
  circles.hasCircles = true;
  return { overlap, circles };
}

std::vector<PanelPlan>
PlansOf(const EmbeddedGraph & graph, DiskModel model)
{
  switch (graph.space.Geometry())
  {
    case EmbeddingGeometry::Spherical:
      return PlansOfSphere(graph, graph.faces[graph.outerFace]);
    case EmbeddingGeometry::Euclidean:
      return PlansOfTorus(graph);
    default:
      return PlansOfDisk(graph, model);
  }
}

/** One window for all spheres: the square around theirs. */
void
UniteWindows(const std::list<EmbeddedGraph> & graphs, std::vector<PanelPlan> & plans)
{
  std::vector<Pixel>       corners;
  std::vector<PanelPlan *> ofSpheres;
  std::size_t              i = 0;
  for (const EmbeddedGraph & graph : graphs)
  {
    PanelPlan & plan = plans[i++];
    if (graph.space.Geometry() == EmbeddingGeometry::Spherical)
    {
      const double half = plan.window.halfWidth;
      corners.push_back({ plan.window.centre.x - half, plan.window.centre.y - half });
      corners.push_back({ plan.window.centre.x + half, plan.window.centre.y + half });
      ofSpheres.push_back(&plan);
    }
  }
  for (PanelPlan * const plan : ofSpheres)
  {
    plan->window = WindowAround(corners, 1.0);
  }
}

/** Panels in rows, with their own coordinates and clipped. */
void
WriteSheet(const std::vector<std::string> & panels, const GraphPictureOptions & options, const std::string & path)
{
  const int         columns = std::max(1, std::min<int>(options.columns, static_cast<int>(panels.size())));
  const int         rows = (static_cast<int>(panels.size()) + columns - 1) / columns;
  const std::string width = std::to_string(columns * options.panelSize);
  const std::string height = std::to_string(rows * options.panelSize);
  const std::string size = std::to_string(options.panelSize);
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" +
                     width + "\" height=\"" + height + "\" viewBox=\"0 0 " + width + ' ' + height +
                     "\">\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
  for (std::size_t i = 0; i < panels.size(); ++i)
  {
    const int column = static_cast<int>(i) % columns;
    const int row = static_cast<int>(i) / columns;
    text += "<svg x=\"" + std::to_string(column * options.panelSize) + "\" y=\"" +
            std::to_string(row * options.panelSize) + "\" width=\"" + size + "\" height=\"" + size +
            "\" viewBox=\"0 0 " + size + ' ' + size + "\">\n" + panels[i] + "</svg>\n";
  }
  WriteFileBytes(path, text + "</svg>\n");
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
  const Place *            pole = nullptr; // one for all spheres, so that what stays in place does so in the pictures
  for (const GraphView & view : views)
  {
    const EmbeddedGraph & graph = graphs.emplace_back(*view.certificate);
    const bool            isSphere = graph.space.Geometry() == EmbeddingGeometry::Spherical;
    pole = isSphere && pole == nullptr ? &graph.faces[graph.outerFace] : pole;
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

std::vector<std::string>
DistinctColors(int count)
{
  constexpr double         golden = 0.61803398874989485; // neighbours in number differ most in hue
  std::vector<std::string> colors;
  for (int i = 0; i < count; ++i)
  {
    const double hue = 6.0 * std::fmod(i * golden, 1.0);
    std::string  color = "#";
    for (const double shift : { 5.0, 3.0, 1.0 })
    {
      const double      k = std::fmod(shift + hue, 6.0);
      const double      value = 0.95 - 0.55 * std::clamp(std::min(k, 4.0 - k), 0.0, 1.0);
      const int         byte = static_cast<int>(std::lround(255.0 * value));
      static const char digits[] = "0123456789abcdef";
      color += digits[byte / 16];
      color += digits[byte % 16];
    }
    colors.push_back(color);
  }
  return colors;
}
} // namespace itk
