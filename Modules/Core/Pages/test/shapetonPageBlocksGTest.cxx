#include "shapetonScriptPage.h"

#include "shapetonExceptions.h"
#include "shapetonFileBytes.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace
{
using shapeton::PageBlocks;
using shapeton::ScriptPage;

std::string
AsItIs(const std::string & path)
{
  return path;
}
} // namespace

TEST(PageBlocks, TextOfDataNeverEndsAScript)
{
  const std::string text = shapeton::ScriptText("</script><!--");
  EXPECT_EQ(text.find('<'), std::string::npos);
  EXPECT_EQ(shapeton::Json::parse(text), "</script><!--");
}

TEST(PageBlocks, HeadersTellTheRangeOfColumns)
{
  PageBlocks                blocks("", true, AsItIs);
  const std::vector<double> rows{ 1.0, NAN, 3.0, 5.0 };
  blocks.PutReals("r", rows, 2);
  EXPECT_NE(blocks.Inline().find(R"({"offset":[1.0,5.0],"step":[)"), std::string::npos) << blocks.Inline();
  blocks.PutReals<std::uint32_t>("fine", rows, 2);
  EXPECT_NE(blocks.Inline().find(R"("type":"u32")"), std::string::npos) << blocks.Inline();
}

TEST(PageBlocks, EqualInputGivesEqualBytesInThePageAndBesideIt)
{
  const std::vector<std::uint32_t> values{ 7, 70000, 3 };
  PageBlocks                       inside("", true, AsItIs);
  PageBlocks                       beside(testing::TempDir(), false, AsItIs);
  inside.Put("a/b", values, 1);
  beside.Put("a/b", values, 1);
  EXPECT_EQ("<script>" + shapeton::ReadFileBytes(testing::TempDir() + "/a-b.js") + "</script>\n", inside.Inline());
  EXPECT_EQ(shapeton::ReadFileBytes(testing::TempDir() + "/a-b.js"), inside.Script());
  EXPECT_TRUE(beside.Inline().empty());
}

TEST(PageBlocks, ALongBlockIsSplitIntoParts)
{
  constexpr std::size_t           partSize = std::size_t{ 8 } << 20;
  const std::vector<std::uint8_t> values(2 * partSize + 1, 3);
  PageBlocks                      blocks("", true, AsItIs);
  blocks.Put("long", values);
  const std::string text = blocks.Script();
  EXPECT_NE(text.find(R"("delta":0,"parts":3},""))"), std::string::npos) << text.substr(0, 200);
  EXPECT_NE(text.find(R"(block("long.1",null,")"), std::string::npos);
  EXPECT_NE(text.find(R"(block("long.3",null,")"), std::string::npos);
  EXPECT_EQ(text.find(R"(block("long.4")"), std::string::npos);
}

TEST(PageBlocks, AFileThatCannotBeWrittenIsAnError)
{
  PageBlocks blocks(testing::TempDir() + "/no/such/folder", false, AsItIs);
  EXPECT_THROW(blocks.PutJson("info", 1), shapeton::OutputError);
}

TEST(ScriptPage, ForbidsRequestsAndStartsWhenItsBlocksAreThere)
{
  PageBlocks blocks("", true, AsItIs);
  blocks.PutJson("info", 1);
  const std::string text = TextOf(ScriptPage{ "T", ".own {}", "function f() {}", "f();" }, blocks);
  EXPECT_NE(text.find("default-src 'none'"), std::string::npos);
  EXPECT_LT(text.find(":root"), text.find(".own {}"));
  EXPECT_LT(text.find("function f"), text.find("block(\"info\""));
  EXPECT_LT(text.find("block(\"info\""), text.find("<script>f();"));
}
