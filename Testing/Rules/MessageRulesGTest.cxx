#include "MadeUpTree.h"
#include "MessageRules.h"

namespace
{
using rules::CheckMessages;
using rules::ToText;

/** Two tools: Cutter, linked with Sheets through Knives, and Painter, linked with nothing. */
class MessageRules : public rules::MadeUpTree
{
protected:
  void
  SetUp() override
  {
    MadeUpTree::SetUp();
    this->Write("Modules/Core/Sheets/itk-module.cmake", "itk_module(Sheets DEPENDS ITKCommon)\n");
    this->Write("Modules/Core/Knives/itk-module.cmake", "itk_module(Knives\n  DEPENDS Sheets)\n");
    this->Write("Applications/Cutter/CMakeLists.txt", "shapeton_add_tool(Cutter MODULES Knives)\n");
    this->Write("Applications/Painter/CMakeLists.txt", "shapeton_add_tool(Painter)\n");
    this->Write(
      "Applications/Cutter/Cutter.xml",
      "<executable><parameters><integer><name>sheet</name><constraints><minimum>0</minimum><maximum>9</maximum>"
      "</constraints></integer><string-enumeration><name>shape</name><element>round</element>"
      "<element>square</element></string-enumeration></parameters></executable>");
    this->Write("Applications/Painter/Painter.xml",
                "<executable><parameters><string><name>color</name></string></parameters></executable>");
  }

  /** The faults of a text in the sources of a folder. */
  std::string
  FaultsOf(const std::string & folder, const std::string & text) const
  {
    this->Write(folder + "/a.cxx", "// --none\nconst char * text =\n  " + text + "; /* --none */ char c = '\"';\n");
    const std::string faults = ToText(CheckMessages(m_Root));
    std::filesystem::remove(m_Root / folder / "a.cxx");
    return faults;
  }
};

TEST_F(MessageRules, AcceptAdviceThatIsTaken)
{
  EXPECT_EQ(FaultsOf("Applications/Cutter", "\"--sheet 3 or --shape\" \" round; --sheet takes one, --help more\""), "");
  EXPECT_EQ(FaultsOf("Applications/Cutter", "\"use Painter (--color red), or \\\"--shape=square\\\"\""), "");
  EXPECT_EQ(
    FaultsOf("Modules/Core/Sheets/src", "\"the parameter \\\"sheet\\\" = N or the parameter \\\"shape\\\" = round\""),
    "");
  EXPECT_EQ(FaultsOf("Modules/Core/Sheets/src", "\"a -- b --color of a page\""), ""); // libraries name parameters
  EXPECT_EQ(FaultsOf("Modules/Core/Sheets/test", "\"the parameter \\\"length\\\"\""), "");
}

TEST_F(MessageRules, RefuseOptionsThatNobodyDeclares)
{
  EXPECT_EQ(FaultsOf("Applications/Cutter", "\"a\"\n  \"b --color\""),
            "Applications/Cutter/a.cxx:3: names the option --color, which no tool that may print it declares\n");
  EXPECT_EQ(FaultsOf("Applications/Cutter", "\"Painter (--sheet 3)\""),
            "Applications/Cutter/a.cxx:3: names the option --sheet, which Painter does not declare\n");
}

TEST_F(MessageRules, RefuseParametersOfOtherTools)
{
  EXPECT_EQ(FaultsOf("Modules/Core/Sheets/src", "\"the parameter \\\"color\\\"\""),
            "Modules/Core/Sheets/src/a.cxx:3: names the option --color, which no tool that may print it declares\n");
}

TEST_F(MessageRules, RefuseValuesThatAreRefused)
{
  EXPECT_EQ(FaultsOf("Modules/Core/Sheets/src", "\"the parameter \\\"sheet\\\" = -1\""),
            "Modules/Core/Sheets/src/a.cxx:3: names --sheet -1, which Cutter rejects\n");
  EXPECT_EQ(FaultsOf("Applications/Cutter", "\"give --shape oval or --sheet 10\""),
            "Applications/Cutter/a.cxx:3: names --shape oval, which Cutter rejects\n"
            "Applications/Cutter/a.cxx:3: names --sheet 10, which Cutter rejects\n");
}

TEST_F(MessageRules, RefuseWordingThatReadsAsTranslated)
{
  const auto faultsOf = [this](const std::string & text) {
    this->Write("a.cxx", text);
    return ToText(rules::CheckWording(m_Root));
  };
  EXPECT_EQ(faultsOf("/** Radius of the piece (mm). */\nthrow Error(\"there is no piece\"); // none is left\n"), "");
  EXPECT_EQ(faultsOf("int r; ///< Of the piece\n"), "a.cxx:1: begins a comment with a bare genitive: ///< Of t\n");
  EXPECT_EQ(faultsOf("f(\"x is \"\n  \"no number\");\n"), "a.cxx:1: says what is not by: is no\n");
  EXPECT_EQ(faultsOf("// Failures are told.\n"), "a.cxx:1: is not plain English: told\n");
  EXPECT_EQ(faultsOf("int nextColour; // analyses of centers\n"), "a.cxx:1: is not American spelling: Colour\n");
}

TEST(ThisRepository, IsWrittenInPlainEnglish)
{
  const rules::Faults faults = rules::CheckWording(SHAPETON_SOURCE_DIR);
  EXPECT_TRUE(faults.empty()) << ToText(faults);
}

TEST(ThisRepository, GivesNoAdviceThatIsRefused)
{
  const rules::Faults faults = CheckMessages(SHAPETON_SOURCE_DIR);
  EXPECT_TRUE(faults.empty()) << ToText(faults);
}
} // namespace
