#include "MadeUpTree.h"
#include "RepositoryRules.h"

namespace
{
using rules::ToText;

void
ExpectNone(const rules::Faults & faults)
{
  EXPECT_TRUE(faults.empty()) << ToText(faults);
}

class RepositoryRules : public rules::MadeUpTree
{};

TEST_F(RepositoryRules, FollowLinks)
{
  this->Write("Documentation/guide.md", "# A heading: with *marks*\ntext\n## Second_part 2 ##\n");
  this->Write("picture.png", "");
  this->Write("README.md",
              "[a](Documentation/guide.md) [b](https://example.org/x) [c](Documentation)\n"
              "![p](picture.png \"title\") <img src=\"picture.png\">\n"
              "[h](Documentation/guide.md#a-heading-with-marks) [i](Documentation/guide.md#second_part-2)\n"
              "`[code](nowhere)`\n```\n[code](nowhere)\n```\n[r]: picture.png\n");
  EXPECT_EQ(ToText(rules::CheckLinks(m_Root)), "");
}

TEST_F(RepositoryRules, NameBrokenLinks)
{
  this->Write("Documentation/guide.md", "# Heading\n[up](../../x.md)\n");
  this->Write("README.md",
              "[a](nowhere.md)\n[h](Documentation/guide.md#other)\n[s](#none)\n<img src=\"no.png\">\n[r]: no.md\n");
  EXPECT_EQ(ToText(rules::CheckLinks(m_Root)),
            "Documentation/guide.md:2: the link ../../x.md leaves the repository\n"
            "README.md:1: the link nowhere.md points to a missing file\n"
            "README.md:2: the link Documentation/guide.md#other points to a missing heading\n"
            "README.md:3: the link #none points to a missing heading\n"
            "README.md:4: the link no.png points to a missing file\n"
            "README.md:5: the link no.md points to a missing file\n");
}

TEST_F(RepositoryRules, AskForAPageOfEachModuleAndTool)
{
  this->Write("Modules/Core/Low/itk-module.cmake", "");
  this->Write("Modules/Core/Low/README.md", "");
  this->Write("Applications/Tool/CMakeLists.txt", "");
  this->Write("Applications/Tool/Testing/CMakeLists.txt", "");
  this->Write("Documentation/index.md", "[Low](../Modules/Core/Low/README.md)\n");
  EXPECT_EQ(ToText(rules::CheckPages(m_Root)),
            "Applications/Tool: has no README.md\n"
            "Documentation/index.md: has no link to Applications/Tool/README.md\n");
  this->Write("Applications/Tool/README.md", "");
  this->Write("Documentation/index.md",
              "[Low](../Modules/Core/Low/README.md) [Tool](../Applications/Tool/README.md)\n");
  EXPECT_EQ(ToText(rules::CheckPages(m_Root)), "");
}

TEST_F(RepositoryRules, AskForTheSourceOfData)
{
  this->Write("Data/small.nrrd", "");
  EXPECT_EQ(ToText(rules::CheckPages(m_Root)),
            "Data/small.nrrd: Data/README.md does not state its source and license\n");
  this->Write("Data/README.md", "small.nrrd: made by hand, CC0\n");
  EXPECT_EQ(ToText(rules::CheckPages(m_Root)), "");
}

TEST_F(RepositoryRules, LimitTheSizeOfFiles)
{
  this->Write("small", std::string(1000000, 'x'));
  this->Write("build/large", std::string(1000001, 'x'));
  EXPECT_EQ(ToText(rules::CheckSizes(m_Root)), "");
  this->Write("large", std::string(1000001, 'x'));
  EXPECT_EQ(ToText(rules::CheckSizes(m_Root)), "large: has 1000001 bytes, more than 1 MB\n");
}

TEST_F(RepositoryRules, RefuseFoldersOfOneMachine)
{
  this->Write("a.cmake",
              "set(x 1)\nset(y /home"
              "/somebody/data)\n");
  this->Write("picture.png",
              std::string("\0/home"
                          "/x",
                          8));
  EXPECT_EQ(ToText(rules::CheckTexts(m_Root)),
            "a.cmake:2: contains a machine-specific path: /home"
            "/\n");
}

TEST_F(RepositoryRules, RefuseForeignLicensesInSources)
{
  const std::string notice = "// Copy"
                             "right (C) 2001 Somebody\n";
  this->Write("LICENSE", notice);
  this->Write("a.cxx", notice);
  EXPECT_EQ(ToText(rules::CheckTexts(m_Root)),
            "a.cxx:1: contains a foreign license: Copy"
            "right (\n");
}

TEST_F(RepositoryRules, RefuseOtherParallelLoops)
{
  const std::string call = "MultiThreaderBase::New()"
                           "->Parallelize";
  this->Write("a.cxx", "itk::" + call + "Array(0, n, body, nullptr);\n");
  EXPECT_EQ(ToText(rules::CheckTexts(m_Root)),
            "a.cxx:1: has a loop that does not use shapetonParallelFor.h: " + call + "\n");
}

TEST_F(RepositoryRules, LimitTheLengthOfTools)
{
  std::string lines;
  for (int i = 0; i < 150; ++i)
  {
    lines += "x\n";
  }
  this->Write("Applications/Tool/Tool.cxx", lines);
  EXPECT_EQ(ToText(rules::CheckTools(m_Root)), "");
  this->Write("Applications/Tool/Tool.cxx", lines + "x\n");
  EXPECT_EQ(ToText(rules::CheckTools(m_Root)),
            "Applications/Tool/Tool.cxx: has 151 lines, more than 150; move code to a module\n");
}

TEST(ThisRepository, HasNoBrokenLink) { ExpectNone(rules::CheckLinks(SHAPETON_SOURCE_DIR)); }

TEST(ThisRepository, DocumentsItsParts) { ExpectNone(rules::CheckPages(SHAPETON_SOURCE_DIR)); }

TEST(ThisRepository, HasSmallFiles) { ExpectNone(rules::CheckSizes(SHAPETON_SOURCE_DIR)); }

TEST(ThisRepository, HasCleanTexts) { ExpectNone(rules::CheckTexts(SHAPETON_SOURCE_DIR)); }

TEST(ThisRepository, HasShortTools) { ExpectNone(rules::CheckTools(SHAPETON_SOURCE_DIR)); }
} // namespace
