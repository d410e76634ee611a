#include "shapetonGraphPictures.h"
#include "shapetonEmbeddedGraph.h"
#include "shapetonCertificateFixtures.h"
#include "shapetonGraphEmbedding.h"
#include "shapetonGraphFamilies.h"
#include "shapetonGraphGenus.h"
#include "shapetonCurveSet.h"
#include "shapetonGraphInSpace.h"
#include "shapetonGrowthPlot.h"
#include "shapetonFileBytes.h"
#include "shapetonTestFolder.h"
#include "shapetonSurfaceQuality.h"
#include "shapetonSurfaceReader.h"
#include "shapetonTestXml.h"

#include "gtest/gtest.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <set>

using namespace certificatetest;
using basetest::Folder;
using basetest::XmlPage;

namespace
{
XmlPage
PictureOf(const EmbeddingCertificate &          certificate,
          const shapeton::GraphPictureOptions & options = {},
          bool                                  hasLabels = false)
{
  const Folder        folder;
  shapeton::GraphView view{ "a & b", &certificate, {}, hasLabels };
  shapeton::WriteGraphSvg(view, options, folder / "picture.svg");
  return XmlPage(shapeton::ReadFileBytes(folder / "picture.svg"));
}

void
ExpectBaseline(const EmbeddingCertificate & certificate, const std::string & name)
{
  const std::string text = PictureOf(certificate, {}, true).bytes;
  const std::string baseline = shapeton::ReadFileBytes(std::string(BASELINE_FOLDER) + '/' + name);
  EXPECT_TRUE(text == baseline) << name << " differs from its baseline; written to " << name
                                << " in the folder of tests";
  if (text != baseline)
  {
    shapeton::WriteFileBytes(std::string(SHAPETON_TEST_TEMPORARY_DIR) + '/' + name, text);
  }
}

const char * const Node = "#c62828";
const char * const Face = "#2e7d32";
} // namespace

TEST(GraphPictures, Baselines)
{
  ExpectBaseline(Cube(), "Cube.svg");
  ExpectBaseline(PathInTetrahedron(), "PathInTetrahedron.svg");
  ExpectBaseline(TorusGrid(3, 2), "TorusGrid.svg");
}

/** Small graphs on one side of the sphere are viewed from that side, graphs around the sphere from a fixed side. */
TEST(GraphPictures, TheFrontShowsTheGraph)
{
  const EmbeddingCertificate    path = PathInTetrahedron();
  const shapeton::EmbeddedGraph graph(path);
  for (int node = 0; node < path.graph.nodes; ++node)
  {
    const shapeton::Place & place = graph.nodes[node];
    EXPECT_GT(place.x * graph.front.x + place.y * graph.front.y + place.z * graph.front.z, 0.0) << node;
  }
  const EmbeddingCertificate cube = Cube();
  const shapeton::Place      front = shapeton::EmbeddedGraph(cube).front;
  EXPECT_NEAR(1.0, std::hypot(front.x, front.y, front.z), 1e-12);
  EXPECT_DOUBLE_EQ(0.48, front.x);
}

/** The stereographic picture of a cube shows 8 nodes and 6 circles of faces, one of which surrounds all others. */
TEST(GraphPictures, SphereShowsEachCircle)
{
  const XmlPage page = PictureOf(Cube());
  EXPECT_EQ(5u, page.TextsOf("svg").size()); // the outer svg element and four panels
  EXPECT_EQ(8u, page.Count("circle", "stroke", Node));
  EXPECT_EQ(6u, page.Count("circle", "stroke", Face));
  // Node marks: in both flat panels, and once on the front or the back of the sphere.
  EXPECT_EQ(8u * 3u, page.Count("circle", "fill", Node));
}

/** A path of three nodes: the other circles of the tetrahedron and its four faces are hidden. */
TEST(GraphPictures, DummiesAreHidden)
{
  const XmlPage page = PictureOf(PathInTetrahedron(), {}, true);
  EXPECT_EQ(3u, page.Count("circle", "stroke", Node));
  EXPECT_EQ(0u, page.Count("circle", "stroke", Face));
  EXPECT_NE(std::string::npos, page.bytes.find(">left<"));
}

/** Tiles of the torus and of the octagon have no gaps: each tile color has its polygon. */
TEST(GraphPictures, TilesOfTheUniversalCover)
{
  for (const auto & certificate : { TorusGrid(3, 3), Octagon() })
  {
    const XmlPage page = PictureOf(certificate);
    EXPECT_EQ(3u, page.TextsOf("svg").size());
    EXPECT_EQ(2u, page.Count("path", "stroke", "#8d6e00")); // the domain, in both panels
    EXPECT_EQ(2u, page.Count("path", "stroke", "#8e24aa")); // the fundamental polygon
    EXPECT_GE(page.Count("path", "stroke", "#b0a890"), 2u * 9u);
  }
}

/** Names fit approximately into their circles; the title counts the names that would be too small to read. */
TEST(GraphPictures, NamesFitTheirCirclesOrAreLeftOut)
{
  EmbeddingCertificate cube = Cube();
  cube.graph.names = { "a", "b", "c", "d", "e", "f", "g", "h" };
  const XmlPage small = PictureOf(cube, {}, true);
  EXPECT_EQ(8u * 3u, small.Count("text", "text-anchor", "middle"));
  EXPECT_EQ(std::string::npos, small.bytes.find("not fit"));
  cube.graph.names[3] = std::string(2000, 'd');
  const XmlPage large = PictureOf(cube, {}, true);
  EXPECT_EQ(7u * 3u, large.Count("text", "text-anchor", "middle"));
  EXPECT_NE(std::string::npos, large.bytes.find("1 name does not fit its circle"));
}

TEST(GraphPictures, KleinDiskHasStraightEdges)
{
  shapeton::GraphPictureOptions options;
  options.disk = shapeton::DiskModel::Klein;
  const XmlPage klein = PictureOf(Octagon(), options);
  const XmlPage poincare = PictureOf(Octagon());
  EXPECT_EQ(0u, klein.Count("circle", "stroke", Node)); // ellipses
  EXPECT_LT(0u, poincare.Count("circle", "stroke", Node));
  EXPECT_NE(std::string::npos, klein.bytes.find("Klein disk"));
}

TEST(GraphPictures, SmallMultiplesHaveTheColorsOfTheirNodes)
{
  const Folder               folder;
  const EmbeddingCertificate cube = Cube();
  const auto                 colors = shapeton::DistinctColors(8);
  EXPECT_EQ(8u, std::set<std::string>(colors.begin(), colors.end()).size());
  shapeton::GraphPictureOptions options;
  options.columns = 3;
  shapeton::WriteGraphSheetSvg({ { "one", &cube, colors }, { "two", &cube, colors } }, options, folder / "sheet.svg");
  const XmlPage page(shapeton::ReadFileBytes(folder / "sheet.svg"));
  for (const std::string & color : colors)
  {
    EXPECT_EQ(2u, page.Count("circle", "fill", color));
  }
}

TEST(GraphPictures, SmallMultiplesEnlargeAPart)
{
  const Folder               folder;
  const shapeton::Graph      grid = shapeton::GridGraph(12, 10);
  const EmbeddingCertificate large = shapeton::EmbedGraph(grid, shapeton::FindEmbedding(grid).map);
  const EmbeddingCertificate cube = Cube();
  const auto                 panelsOf = [&](const EmbeddingCertificate & certificate, const std::string & name) {
    shapeton::GraphPictureOptions options;
    options.enlarged = { name };
    const shapeton::GraphView view{ "", &certificate, {} };
    shapeton::WriteGraphSheetSvg({ view, view, view }, options, folder / "sheet.svg");
    const XmlPage page(shapeton::ReadFileBytes(folder / "sheet.svg"));
    return std::array<std::size_t, 2>{ page.TextsOf("svg").size() - 1, page.Count("rect", "stroke", "#1e88e5") };
  };
  // Two columns: two rows of two, and two rows of one, with an empty panel between.
  EXPECT_EQ((std::array<std::size_t, 2>{ 7, 3 }), panelsOf(large, shapeton::NameOfNode(grid, 0)));
  EXPECT_EQ((std::array<std::size_t, 2>{ 3, 0 }), panelsOf(cube, shapeton::NameOfNode(cube.graph, 0)));
}

/** Seen from an edge node of a planar graph, the circles of its ends and faces are almost straight and form a
 * rectangle. */
TEST(GraphPictures, CirclesAroundAnEdgeNodeBecomeARectangle)
{
  shapeton::GraphPictureOptions options;
  options.fromEdgeNode = true;
  const std::string text = PictureOf(Cube(), options).bytes;
  int               large = 0;
  for (std::size_t at = text.find("A"); at != std::string::npos; at = text.find('A', at + 1))
  {
    large += std::atof(text.c_str() + at + 1) > 1e4 ? 1 : 0;
  }
  EXPECT_LE(2, large); // one node and one face contain the center of the projection; the others are <circle>
}

/** Edges have their colors, and neither outlines nor tiles compete with them. */
TEST(GraphPictures, EdgesHaveTheirColorsAndALegend)
{
  const Folder               folder;
  const EmbeddingCertificate cube = Cube();
  const EmbeddingCertificate torus = TorusGrid(3, 2);
  for (const EmbeddingCertificate * certificate : { &cube, &torus })
  {
    const auto          edges = static_cast<int>(certificate->graph.edges.size());
    shapeton::GraphView view{ "colored", certificate, shapeton::DistinctColors(certificate->graph.nodes) };
    view.edgeColors = shapeton::DistinctColors(edges);
    view.colorBar = shapeton::GraphColorBar{ "curvature <no unit>", 1.25 };
    shapeton::WriteGraphSheetSvg({ view }, {}, folder / "colored.svg");
    const XmlPage page(shapeton::ReadFileBytes(folder / "colored.svg"));
    for (const std::string & color : view.edgeColors)
    {
      EXPECT_EQ(1u, page.Count("path", "stroke", color));
    }
    EXPECT_EQ(0u, page.Count("path", "stroke", "#212121"));
    EXPECT_EQ(0u, page.Count("circle", "stroke", Node));
    EXPECT_EQ(0u, page.Count("path", "fill", "#fff3c4"));
    EXPECT_NE(std::string::npos, page.bytes.find("curvature &lt;no unit&gt;"));
    EXPECT_NE(std::string::npos, page.bytes.find(">-1.25<"));
    EXPECT_EQ(1u, page.Count("g", "class", "colorBar"));
  }
}

TEST(GraphPictures, DivergingColors)
{
  EXPECT_EQ("#d55e00", shapeton::DivergingColor(-1.0));
  EXPECT_EQ("#0072b2", shapeton::DivergingColor(7.0));
  EXPECT_EQ("#b0b0b0", shapeton::DivergingColor(0.0));
  EXPECT_EQ("#ffffff", shapeton::DivergingColor(0.3, 1.0));
}

/** A point per radius, and none where the quantity is undefined. */
TEST(GraphPictures, GrowthPlot)
{
  const Folder folder;
  const double undefined = std::nan("");
  shapeton::WriteGrowthSvg(
    { { "a", { 1, 2, 8, 20 }, { 0.1, 0.2, 0.4, 0.5 } }, { "b", { 1, 2 }, { undefined, 3.0 } }, { "c", {}, {} } },
    folder / "growth.svg");
  const XmlPage page(shapeton::ReadFileBytes(folder / "growth.svg"));
  EXPECT_EQ(5u, page.Count("circle", "fill", "#0072b2"));
  EXPECT_NE(std::string::npos, page.bytes.find(">10<"));
}

/** Circles of the VTP file of a cube touch where expected: the nearest points of two tangent circles are equal, except
 * for the error of the polygons. */
TEST(GraphPictures, CurvesOfTheSphere)
{
  const Folder folder;
  shapeton::WriteGraphVtp(Cube(), { { "tool", "test" } }, folder / "cube.vtp");
  const shapeton::CurveSet curves = shapeton::ReadCurves(folder / "cube.vtp");
  ASSERT_EQ(8u + 24u + 8u + 6u, curves.curves.size()); // nodes, halves of edges, circles of nodes and faces
  EXPECT_EQ(1u, curves.curves[0].size());
  EXPECT_NEAR(1.0, curves.V.rowwise().norm().minCoeff(), 1e-12);
  EXPECT_NEAR(1.0, curves.V.rowwise().norm().maxCoeff(), 1e-12);
  const auto kinds = curves.cellArrays[0].values;
  EXPECT_EQ(0.0, kinds(0));
  EXPECT_EQ(1.0, kinds(8));
  EXPECT_EQ(2.0, kinds(32));
  EXPECT_EQ(3.0, kinds(40));
}

/** The corners of a polygon are on its circle, and the midpoints of its sides at most 1e-4 of a period inside; such
 * small circles need fewer than the 32 corners of large circles. */
TEST(GraphPictures, PolygonsAreAsFineAsTheirCirclesNeed)
{
  const Folder               folder;
  const EmbeddingCertificate torus = TorusGrid(30, 30);
  shapeton::WriteGraphVtp(torus, {}, folder / "torus.vtp");
  const shapeton::CurveSet curves = shapeton::ReadCurves(folder / "torus.vtp");
  const auto               kinds = curves.cellArrays[0].values;
  const auto               ids = curves.cellArrays[1].values;
  int                      circles = 0;
  for (std::size_t c = 0; c < curves.curves.size(); ++c)
  {
    if (kinds(static_cast<Eigen::Index>(c)) != 2.0)
    {
      continue;
    }
    ++circles;
    const std::vector<int> & polygon = curves.curves[c];
    const auto               node = static_cast<int>(ids(static_cast<Eigen::Index>(c)));
    const double             radius = torus.nodeRadii[node];
    EXPECT_GT(32u, polygon.size());
    EXPECT_EQ(polygon.front(), polygon.back());
    for (std::size_t i = 0; i + 1 < polygon.size(); ++i)
    {
      const Eigen::RowVector3d corner = curves.V.row(polygon[i]) - curves.V.row(node);
      const Eigen::RowVector3d next = curves.V.row(polygon[i + 1]) - curves.V.row(node);
      EXPECT_NEAR(radius, corner.norm(), 1e-12);
      EXPECT_LE(radius - (0.5 * (corner + next)).norm(), 1e-4 * shapeton::UnitOfSurface(torus));
    }
  }
  EXPECT_EQ(900, circles);
}

/** Genus 2 in space: nodes and edges are vertices of the surface in the same file. */
TEST(GraphPictures, SurfaceInSpace)
{
  const Folder               folder;
  const EmbeddingCertificate octagon = Octagon();
  shapeton::WriteGraphInSpace(octagon, { { "tool", "test" } }, folder / "octagon.vtp");
  const shapeton::CurveSet    curves = shapeton::ReadCurves(folder / "octagon.vtp");
  const shapeton::SurfaceMesh surface = shapeton::ReadSurfaceFile(folder / "octagon.vtp").mesh;
  const shapeton::CurveSet    torus = [&] {
    shapeton::WriteGraphInSpace(TorusGrid(3, 4), {}, folder / "torus.vtp");
    return shapeton::ReadCurves(folder / "torus.vtp");
  }();
  EXPECT_EQ(2, shapeton::InspectSurface(surface).genus);
  EXPECT_EQ(surface.V, curves.V);
  ASSERT_EQ(octagon.graph.nodes + octagon.graph.edges.size(), curves.curves.size());
  EXPECT_EQ(std::vector<int>{ 0 }, curves.curves[0]);
  EXPECT_EQ(2.0, surface.cellArrays.at(0).values(0, 0)); // kind
  EXPECT_EQ(0.0, surface.cellArrays.at(1).values(0, 0)); // id
  EXPECT_EQ(12u + 24u, torus.curves.size());
  EXPECT_EQ(1.0, torus.cellArrays.at(0).values(12, 0));
}
