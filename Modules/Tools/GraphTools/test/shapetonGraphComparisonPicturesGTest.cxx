#include "shapetonGraphComparisonPictures.h"
#include "shapetonGraphPictures.h"
#include "shapetonFileBytes.h"
#include "shapetonGraphFamilies.h"
#include "shapetonTestFolder.h"
#include "shapetonTestReports.h"

#include "gtest/gtest.h"

using basetest::CountOf;
using basetest::Folder;

namespace
{
std::string
Same(const std::string & path)
{
  return path;
}

shapeton::Graph
NamedWheel(int spokes)
{
  shapeton::Graph wheel = shapeton::WheelGraph(spokes);
  for (int node = 0; node < wheel.nodes; ++node)
  {
    wheel.names.push_back("n" + std::to_string(node));
  }
  return wheel;
}
} // namespace

/** Corresponding nodes of both pictures have the same color. */
TEST(GraphComparisonPictures, PartnersHaveOneColor)
{
  const Folder                    folder;
  const shapeton::Graph           wheel = shapeton::WheelGraph(6);
  const shapeton::Graph           turned = shapeton::RelabeledGraph(wheel, { 3, 1, 4, 6, 5, 2, 0 });
  const shapeton::GraphComparison comparison = shapeton::CompareGraphs(wheel, turned);
  ASSERT_TRUE(comparison.isomorphic);
  shapeton::WriteComparisonPictures(comparison, { folder / "", false, {}, {} }, Same);
  const std::string picture = shapeton::ReadFileBytes(folder / "comparison.svg");
  const auto        colors = shapeton::ColorsOfNodes(comparison);
  for (const std::string & color : colors[0])
  {
    EXPECT_EQ(2U, CountOf(picture, "fill=\"" + color + "\" stroke")) << color;
  }
  EXPECT_NE(std::string::npos,
            shapeton::ReadFileBytes(folder / "index.html").find("The graphs are isomorphic. 7 nodes have a partner"));
}

/** An edge is added between two steps: its ends are green in the second panel. */
TEST(GraphComparisonPictures, ChangedNodesAreHighlighted)
{
  const Folder               folder;
  shapeton::DynamicEmbedding dynamic;
  shapeton::DynamicSequence  sequence;
  shapeton::Graph            graph = NamedWheel(6);
  for (int step = 0; step < 3; ++step)
  {
    sequence.files.push_back("file" + std::to_string(step));
    sequence.steps.push_back(dynamic.Add(graph));
    graph.edges.push_back({ 0, 2 + step });
  }
  shapeton::WriteSequencePictures(sequence, { 0, 2 }, { "n6" }, { folder / "", false, {}, {} }, Same);
  const std::string steps = shapeton::ReadFileBytes(folder / "steps.svg");
  EXPECT_EQ(3U, CountOf(steps, shapeton::TrackColors()[0])); // the tracked node in each step
  EXPECT_EQ(2U * 2, CountOf(steps, "#43a047"));              // two ends in each of two steps
  EXPECT_EQ(3U, CountOf(shapeton::ReadFileBytes(folder / "compare.svg"), "#43a047"));
  EXPECT_EQ(3U, CountOf(shapeton::ReadFileBytes(folder / "index.html"), "<figure data-graph"));
  EXPECT_EQ(4U, CountOf(shapeton::ReadFileBytes(folder / "correspondence.svg"), "<svg"));
}
