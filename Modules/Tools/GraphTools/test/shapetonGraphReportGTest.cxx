#include "shapetonGraphReport.h"
#include "shapetonCertificateFixtures.h"
#include "shapetonFileBytes.h"
#include "shapetonTestFolder.h"
#include "shapetonTestXml.h"

#include "gtest/gtest.h"

using namespace certificatetest;
using basetest::Folder;
using basetest::XmlPage;

namespace
{
XmlPage
PageOf(const shapeton::GraphReport & report)
{
  const Folder folder;
  shapeton::WriteGraphReport(report, folder / "index.html");
  return XmlPage(shapeton::ReadFileBytes(folder / "index.html"));
}
} // namespace

TEST(GraphReport, IsWholeAndWellFormed)
{
  EmbeddingCertificate cube = Cube();
  cube.graph.names = { "<a>", "b&\"", "c\n", "d", "e", "</script>", "g", "h" };
  cube.statistics = { { "residual", 1.25e-13 } };
  shapeton::GraphReport report{ "A <title>", { { "one", &cube, shapeton::DistinctColors(8), true } } };
  report.warnings = { "a warning" };
  report.facts = shapeton::FactsOf(cube);
  const XmlPage page = PageOf(report);
  EXPECT_EQ(1u, page.TextsOf("figure").size());
  EXPECT_EQ(3u, page.TextsOf("script").size());
  EXPECT_NE(std::string::npos, page.bytes.find("a warning"));
  EXPECT_NE(std::string::npos, page.bytes.find("residual"));
  EXPECT_EQ(std::string::npos, page.bytes.find("</script>\",")); // names are escaped
}

TEST(GraphReport, NeedsNoNetwork)
{
  const EmbeddingCertificate cube = Cube();
  const XmlPage              page = PageOf({ "title", { { "one", &cube } } });
  EXPECT_EQ(std::string::npos, page.bytes.find("http"));
  EXPECT_EQ(std::string::npos, page.bytes.find("src="));
  EXPECT_EQ(std::string::npos, page.bytes.find("import"));
}

/** Graphs of one geometry move together; other geometries have separate switches. */
TEST(GraphReport, GroupsOfGeometries)
{
  const EmbeddingCertificate cube = Cube();
  const EmbeddingCertificate torus = TorusGrid(3, 3);
  const EmbeddingCertificate octagon = Octagon();
  const XmlPage page = PageOf({ "title", { { "1", &cube }, { "2", &torus }, { "3", &cube }, { "4", &octagon } } });
  EXPECT_EQ(4u, page.TextsOf("figure").size());
  EXPECT_EQ(3u, page.Count("div", "class", "graph-group"));
  EXPECT_EQ(2u, page.TextsOf("select").size()); // the torus has only one view
}
