#include "MadeUpTree.h"
#include "ReferenceRules.h"

namespace
{
using rules::ToText;

class ReferenceRules : public rules::MadeUpTree
{};

TEST_F(ReferenceRules, AskForMarksOfEquations)
{
  this->Write(
    "Modules/A/B/include/b.h",
    "/** Text. \\equation{2.4} as a product. */\nint a();\n\n/** \\equation{3.10}\n *\n * \\equation{5.5} */\n");
  this->Write("Modules/A/B/src/b.cxx", "/** \\equation{6.7} */\nint b;\n/**/ int c;\n/** \\equation{8.5} */\n");
  this->Write("Applications/Tool/Tool.cxx", "/** \\equation{2.4} */\n");
  EXPECT_EQ(ToText(rules::CheckEquations(m_Root)), "");
}

TEST_F(ReferenceRules, RefuseSecondMarksOfAnEquation)
{
  this->Write("Modules/A/B/include/b.h", "/** \\equation{2.4}\n *\n * \\equation{3.10} */\n");
  this->Write("Modules/A/B/src/b.cxx", "int a;\n/** \\equation{3.1} \\equation{5.5} \\equation{6.7} */\n");
  this->Write("Modules/A/B/src/c.cxx", "int a;\n\n/** \\equation{2.4} */\nint b;\n// \\equation{8.5}\n");
  EXPECT_EQ(ToText(rules::CheckEquations(m_Root)),
            "Modules/A/B/src/c.cxx:3: marks equation (2.4), which Modules/A/B/include/b.h marks\n"
            "Modules: no comment marks equation (8.5)\n");
}

TEST_F(ReferenceRules, RefuseCommentsThatSayNothing)
{
  this->Write(
    "Modules/A/B/include/b.h",
    "/** A class. \\ingroup B */\nclass A;\n/** \\ingroup B */\nclass B;\n/** \\class C\n * \\ingroup B\n */\n"
    "class C;\n///@{\n/***/\n/** Text. */\n");
  this->Write("Modules/A/B/src/c.h", "/** \\ingroup B */\n");
  EXPECT_EQ(ToText(rules::CheckComments(m_Root)),
            "Modules/A/B/include/b.h:3: a comment contains only a group\n"
            "Modules/A/B/include/b.h:5: a comment contains only a group\n");
}

TEST_F(ReferenceRules, RefuseGroupsOfOtherModules)
{
  this->Write("Modules/A/B/include/b.h", "/** \\defgroup Part A part of B\n * \\ingroup B */\n");
  this->Write("Modules/A/B/src/b.cxx",
              "int a;\n/** Text. \\ingroup Part */\nint b;\n/** Text. \\ingroup C */\nint c;\n");
  this->Write("Modules/A/C/include/c.h", "/** Text.\n * \\ingroup Part */\nint a;\n/** Text. \\ingroup C */\n");
  EXPECT_EQ(ToText(rules::CheckGroups(m_Root)),
            "Modules/A/B/src/b.cxx:4: names the group C, which is not a group of its module\n"
            "Modules/A/C/include/c.h:1: names the group Part, which is not a group of its module\n");
}

TEST(ThisRepository, MarksEachEquationOnce)
{
  const rules::Faults faults = rules::CheckEquations(SHAPETON_SOURCE_DIR);
  EXPECT_TRUE(faults.empty()) << ToText(faults);
}

TEST(ThisRepository, HasCommentsThatSaySomething)
{
  const rules::Faults faults = rules::CheckComments(SHAPETON_SOURCE_DIR);
  EXPECT_TRUE(faults.empty()) << ToText(faults);
}

TEST(ThisRepository, HasCommentsInGroupsOfTheirModules)
{
  const rules::Faults faults = rules::CheckGroups(SHAPETON_SOURCE_DIR);
  EXPECT_TRUE(faults.empty()) << ToText(faults);
}
} // namespace
