#include "shapetonGraphReader.h"

#include "gtest/gtest.h"

#include <cstdlib>
#include <filesystem>

namespace
{
namespace fs = std::filesystem;

fs::path
GraphFolder()
{
  const char * const folder = std::getenv("SHAPETON_TEST_DATA_DIR");
  return folder != nullptr && *folder != '\0' ? fs::path(folder) / "graphs" : fs::path();
}
} // namespace

TEST(GraphRealData, AllFilesAreRead)
{
  if (GraphFolder().empty())
  {
    GTEST_SKIP() << "SHAPETON_TEST_DATA_DIR is not set";
  }
  int files = 0;
  for (const auto & entry : fs::recursive_directory_iterator(GraphFolder()))
  {
    const bool isText = entry.path().extension() == ".md" || entry.path().filename() == "LICENSE.matpower";
    if (!entry.is_regular_file() || isText)
    {
      continue;
    }
    const shapeton::GraphFile file = shapeton::ReadGraph(entry.path().string());
    EXPECT_GT(file.graph.nodes, 0) << entry.path();
    EXPECT_EQ(static_cast<std::size_t>(file.graph.nodes), file.graph.names.size()) << entry.path();
    ++files;
  }
  EXPECT_GE(files, 187); // the folder may grow
}

/** Numbers stated in the files or known for these graphs. */
TEST(GraphRealData, KnownSizes)
{
  if (GraphFolder().empty())
  {
    GTEST_SKIP() << "SHAPETON_TEST_DATA_DIR is not set";
  }
  const auto sizeOf = [](const char * name) {
    const shapeton::Graph graph = shapeton::ReadGraph((GraphFolder() / name).string()).graph;
    return std::to_string(graph.nodes) + " " + std::to_string(graph.edges.size());
  };
  EXPECT_EQ("4720 13722", sizeOf("3elt.graph"));
  EXPECT_EQ("34 78", sizeOf("karate.gml"));
  EXPECT_EQ("118 186", sizeOf("power/case118.m"));
  EXPECT_EQ("300 411", sizeOf("power/case300.m"));
  EXPECT_EQ("15 105", sizeOf("named/gr/CompleteGraph_15.gr"));
  EXPECT_EQ("10 15", sizeOf("named/gr/PetersenGraph.gr"));
}
