#include "shapetonGraphReport.h"
#include "shapetonCertificateFixtures.h"
#include "shapetonTestFolder.h"
#include "shapetonXmlPage.h"

#include "gtest/gtest.h"

using namespace certificatetest;
using basetest::Folder;

namespace
{
XmlPage
PageOf(const shapeton::GraphReport & report)
{
  const Folder folder;
  shapeton::WriteGraphReport(report, folder / "index.html");
  return XmlPage(folder / "index.html");
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
  ASSERT_TRUE(page.isWellFormed) << page.text.substr(0, 300);
  EXPECT_EQ(1u, page.elements.at("figure").size());
  EXPECT_EQ(2u, page.elements.at("script").size());
  EXPECT_NE(std::string::npos, page.text.find("a warning"));
  EXPECT_NE(std::string::npos, page.text.find("residual"));
  EXPECT_EQ(std::string::npos, page.text.find("</script>\",")); // names are escaped
}

TEST(GraphReport, NeedsNoNetwork)
{
  const EmbeddingCertificate cube = Cube();
  const XmlPage              page = PageOf({ "title", { { "one", &cube } } });
  EXPECT_EQ(std::string::npos, page.text.find("http"));
  EXPECT_EQ(std::string::npos, page.text.find("src="));
  EXPECT_EQ(std::string::npos, page.text.find("import"));
}

/** Graphs of one geometry move together; other geometries have separate switches. */
TEST(GraphReport, GroupsOfGeometries)
{
  const EmbeddingCertificate cube = Cube();
  const EmbeddingCertificate torus = TorusGrid(3, 3);
  const EmbeddingCertificate octagon = Octagon();
  const XmlPage page = PageOf({ "title", { { "1", &cube }, { "2", &torus }, { "3", &cube }, { "4", &octagon } } });
  ASSERT_TRUE(page.isWellFormed);
  EXPECT_EQ(4u, page.elements.at("figure").size());
  EXPECT_EQ(3u, page.Count("div", "class", "graph-group"));
  EXPECT_EQ(2u, page.elements.at("select").size()); // the torus has only one view
}
