#include "shapetonPanelPlans.h"

#include "shapetonGraphTiles.h"
#include "shapetonPictureMaps.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace shapeton
{
namespace
{
/** Bounding square of these points, slightly enlarged. */
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

std::vector<Pixel>
PixelsOfCircles(const EmbeddedGraph & graph, const PictureMap & picture, const std::vector<int> & nodes)
{
  constexpr int      points = 16;
  std::vector<Pixel> pixels;
  for (const int node : nodes)
  {
    for (const Place & place : graph.space.Circle(graph.nodes[node], graph.certificate.nodeRadii[node], points))
    {
      pixels.push_back(picture.map(place));
    }
  }
  return pixels;
}

/** All nodes and edges of the graph, and its circles if they are not much larger. */
PictureWindow
WindowOfSphere(const EmbeddedGraph & graph, const PictureMap & picture)
{
  std::vector<Pixel> pixels;
  for (int node = 0; node < graph.certificate.graph.nodes; ++node)
  {
    pixels.push_back(picture.map(graph.nodes[node]));
  }
  for (const EmbeddedGraph::Segment & half : graph.halfEdges)
  {
    pixels.push_back(picture.map(half[0]));
    pixels.push_back(picture.map(half[1]));
  }
  constexpr double    muchLarger = 2.5;
  const PictureWindow near = WindowAround(pixels, 1.15);
  std::vector<int>    all(graph.certificate.graph.nodes);
  std::iota(all.begin(), all.end(), 0);
  const std::vector<Pixel> circles = PixelsOfCircles(graph, picture, all);
  pixels.insert(pixels.end(), circles.begin(), circles.end());
  const PictureWindow whole = WindowAround(pixels, 1.05);
  const bool          isSingle = graph.certificate.graph.nodes == 1;
  return isSingle || whole.halfWidth < muchLarger * near.halfWidth ? whole : near;
}

/** The nodes with these names and their neighbors, ascending. */
std::vector<int>
WithNeighbors(const Graph & graph, const std::vector<std::string> & names)
{
  const auto isNamed = [&](int node) {
    return std::find(names.begin(), names.end(), NameOfNode(graph, node)) != names.end();
  };
  std::set<int> nodes;
  for (int node = 0; node < graph.nodes; ++node)
  {
    if (isNamed(node))
    {
      nodes.insert(node);
    }
  }
  for (const auto & [a, b] : graph.edges)
  {
    if (isNamed(a) || isNamed(b))
    {
      nodes.insert({ a, b });
    }
  }
  return { nodes.begin(), nodes.end() };
}

std::vector<PanelPlan>
PlansOfTorus(const EmbeddedGraph & graph)
{
  constexpr double   enlargement = 1.4;
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
  PanelPlan overlap{ "Universal cover: overlap graph and fundamental domain", flat, WindowAround(pixels, enlargement) };
  overlap.hasTiles = true;
  // A large graph is shown with fewer copies, because each takes as long to paint as the original.
  constexpr std::size_t large = 20000, huge = 200000; // segments
  constexpr int         tilesOfHuge = 1, tilesOfLarge = 9, tiles = 25;
  const std::size_t     segments = graph.halfEdges.size() + graph.dual.size();
  overlap.tiles = TilesAround(graph, segments > huge ? tilesOfHuge : segments > large ? tilesOfLarge : tiles);
  PanelPlan circles = overlap;
  circles.title = "Circles of nodes and faces";
  circles.hasCircles = true;
  return { overlap, circles };
}

/** Tiles shrink towards the rim, so large graphs require fewer tiles. */
int
NumberOfTiles(const EmbeddedGraph & graph)
{
  constexpr double mostSegments = 150000.0;
  constexpr double mostTiles = 240.0;
  const double     segments = static_cast<double>(graph.halfEdges.size() + graph.dual.size() + 1);
  const int        least = 4 * graph.certificate.genus + 1;
  return static_cast<int>(std::clamp(mostSegments / segments, static_cast<double>(least), mostTiles));
}

/** Tiles that are large enough to be visible in a picture of the disk. */
std::vector<Motion>
VisibleTiles(const EmbeddedGraph & graph, const PictureMap & picture)
{
  constexpr double         least = 1e-4; // area in the disk's plane, about 9 pixels of a panel
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
  constexpr double  halfWidth = 1.02; // the disk with its rim
  const bool        isKlein = model == DiskModel::Klein;
  const std::string name = isKlein ? "Klein disk" : "Poincare disk";
  PanelPlan         overlap{ name + ": overlap graph, tiles of the universal cover",
                     isKlein ? Klein() : Flat(false),
                     { { 0.0, 0.0 }, halfWidth } };
  overlap.hasTiles = overlap.hasRim = true;
  overlap.tiles = VisibleTiles(graph, overlap.picture);
  PanelPlan circles = overlap;
  circles.title = name + ": circles of nodes and faces";
  circles.hasCircles = true;
  return { overlap, circles };
}

/** Projected from a point so close to the first edge node that the four circles through it are almost straight. The
 * circles of its ends are vertical. */
std::vector<PanelPlan>
PlansFromEdgeNode(const EmbeddedGraph & graph)
{
  constexpr double distance = 0.005;
  constexpr double enlargement = 1.3;
  const Place &    at = graph.touch.front();
  const Place &    end = graph.nodes[graph.map.Node(0)];
  const Frame      about = FrameOf(at);
  const double     angle = std::atan2(Dot(end, about.y), Dot(end, about.x)); // of the edge, seen from the edge node
  const double     x = distance * std::cos(angle + 0.7);                     // towards neither a node nor a face
  const double     y = distance * std::sin(angle + 0.7);
  Place            pole{ at.x + x * about.x.x + y * about.y.x,
              at.y + x * about.x.y + y * about.y.y,
              at.z + x * about.x.z + y * about.y.z };
  const double     length = std::sqrt(Dot(pole, pole));
  pole = { pole.x / length, pole.y / length, pole.z / length };
  std::vector<PanelPlan> plans = PlansOfSphere(graph, pole);
  const Frame            frame = FrameOf({ -pole.x, -pole.y, -pole.z });
  const double           turn = std::atan2(Dot(end, frame.y), Dot(end, frame.x));
  const auto             flat = Stereographic(Turned(frame, turn));
  std::vector<Pixel>     pixels;
  for (std::size_t h = 2; h < graph.touch.size(); ++h)
  {
    pixels.push_back(flat.map(graph.touch[h]));
  }
  for (const int i : { 0, 1 })
  {
    plans[i].picture = flat;
    plans[i].window = WindowAround(pixels, enlargement);
  }
  return plans;
}
} // namespace

std::vector<PanelPlan>
PlansOfSphere(const EmbeddedGraph & graph, const Place & outer)
{
  const auto             flat = Stereographic(FrameOf({ -outer.x, -outer.y, -outer.z }));
  const Place &          front = graph.front;
  const PictureWindow    ball{ { 0.0, 0.0 }, 1.06 };
  const PictureWindow    window = WindowOfSphere(graph, flat);
  std::vector<PanelPlan> plans(4);
  plans[0] = { "Overlap graph: graph and dual (stereographic)", flat, window };
  plans[1] = { "Circles of nodes and faces (stereographic)", flat, window };
  plans[1].hasCircles = true;
  plans[2] = { "Sphere, front", Orthographic(FrameOf(front)), ball };
  plans[3] = { "Sphere, back", Orthographic(FrameOf({ -front.x, -front.y, -front.z })), ball };
  for (const int i : { 2, 3 })
  {
    plans[i].hasCircles = plans[i].hasRim = true;
  }
  return plans;
}

std::vector<PanelPlan>
PlansOf(const EmbeddedGraph & graph, const GraphPictureOptions & options)
{
  switch (graph.space.Geometry())
  {
    case EmbeddingGeometry::Spherical:
      return options.fromEdgeNode && graph.touch.size() > 2 ? PlansFromEdgeNode(graph)
                                                            : PlansOfSphere(graph, graph.pole);
    case EmbeddingGeometry::Euclidean:
      return PlansOfTorus(graph);
    default:
      return PlansOfDisk(graph, options.disk);
  }
}

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
      corners.push_back({ plan.window.center.x - half, plan.window.center.y - half });
      corners.push_back({ plan.window.center.x + half, plan.window.center.y + half });
      ofSpheres.push_back(&plan);
    }
  }
  for (PanelPlan * const plan : ofSpheres)
  {
    plan->window = WindowAround(corners, 1.0);
  }
}

std::vector<PanelPlan>
EnlargedPlans(const std::list<EmbeddedGraph> & graphs,
              const std::vector<PanelPlan> &   plans,
              const std::vector<std::string> & names)
{
  constexpr double       withMargin = 1.05;
  std::vector<PanelPlan> enlarged;
  auto                   whole = plans.begin();
  for (const EmbeddedGraph & graph : graphs)
  {
    PanelPlan plan = *whole++;
    plan.title.clear();
    const auto pixels = PixelsOfCircles(graph, plan.picture, WithNeighbors(graph.certificate.graph, names));
    plan.window = pixels.empty() ? plan.window : WindowAround(pixels, withMargin);
    enlarged.push_back(plan);
  }
  UniteWindows(graphs, enlarged);
  return enlarged;
}
} // namespace shapeton
