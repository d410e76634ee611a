#include "MadeUpTree.h"
#include "ModuleLayers.h"

#include <iostream>

namespace
{
using rules::CheckModuleLayers;
using rules::ToText;

/** Two floors, Low and High, in order. */
class ModuleLayers : public rules::MadeUpTree
{
protected:
  void
  SetUp() override
  {
    MadeUpTree::SetUp();
    this->Write("CMake/Modules.cmake",
                "# names\nset(Shapeton_MODULES\n  Core/Low # the first\n  Filtering/Middle\n  Filtering/High\n)\n");
    this->Declare("Core/Low", "Low DEPENDS ITKCommon DESCRIPTION \"${DOCUMENTATION}\"");
    this->Declare("Filtering/Middle", "Middle DEPENDS Low");
    this->Declare("Filtering/High", "High\n  ENABLE_SHARED\n  DEPENDS Middle\n  TEST_DEPENDS ITKGoogleTest");
    this->Write("Modules/Core/Low/include/itkLow.h",
                "#include \"LowExport.h\"\n#include \"itkImage.h\"\n#include <vector>\n");
    this->Write("Modules/Filtering/Middle/include/itkMiddle.h", "#include \"itkLow.h\"\n");
    this->Write("Modules/Filtering/High/include/itkHigh.h", "  #  include <itkLow.h>\n#include \"itkMiddle.h\"\n");
    this->Write("Modules/Filtering/High/test/itkHighGTest.cxx", "#include <gtest/gtest.h>\n");
    this->Write("Modules/Filtering/High/src/itkHigh.cxx", "#include \"itkHigh.h\"\n#include \"MiddleExport.h\"\n");
  }

  void
  Declare(const std::string & folder, const std::string & arguments) const
  {
    this->Write("Modules/" + folder + "/itk-module.cmake",
                "set(DOCUMENTATION \"Shapes (of things).\")\nitk_module(" + arguments + "\n  EXCLUDE_FROM_DEFAULT)\n");
  }

  void
  ExpectFault(const std::string & message) const
  {
    const std::string faults = ToText(CheckModuleLayers(m_Root));
    EXPECT_NE(faults.find(message), std::string::npos) << "[" << faults << "]";
  }
};

TEST_F(ModuleLayers, AcceptGoodOrder) { EXPECT_EQ(ToText(CheckModuleLayers(m_Root)), ""); }

TEST_F(ModuleLayers, RefuseAnIncludeOfALaterModule)
{
  this->Write("Modules/Core/Low/src/itkLow.cxx", "#include \"itkLow.h\"\n#include \"itkHigh.h\"\n");
  this->ExpectFault("Modules/Core/Low/src/itkLow.cxx:2: includes itkHigh.h of High, a later module");
}

TEST_F(ModuleLayers, RefuseAnIncludeOfAnUndeclaredModule)
{
  this->Declare("Filtering/Middle", "Middle DEPENDS ITKCommon");
  this->ExpectFault("Modules/Filtering/Middle/include/itkMiddle.h:1: includes itkLow.h of Low, which its");
}

TEST_F(ModuleLayers, DistinguishPublicPrivateAndTestDependencies)
{
  this->Declare("Filtering/Middle", "Middle PRIVATE_DEPENDS Low");
  this->ExpectFault("Modules/Filtering/Middle/include/itkMiddle.h:1: includes itkLow.h of Low");
  this->ExpectFault("Modules/Filtering/High/include/itkHigh.h:1: includes itkLow.h of Low");

  this->Declare("Filtering/Middle", "Middle TEST_DEPENDS Low");
  this->Write("Modules/Filtering/Middle/include/itkMiddle.h", "");
  this->Write("Modules/Filtering/High/include/itkHigh.h", "#include \"itkMiddle.h\"\n");
  this->Write("Modules/Filtering/Middle/test/itkMiddleGTest.cxx", "#include \"itkLow.h\"\n");
  EXPECT_EQ(ToText(CheckModuleLayers(m_Root)), "");
  this->Write("Modules/Filtering/Middle/src/itkMiddle.cxx", "#include \"itkLow.h\"\n");
  this->ExpectFault("Modules/Filtering/Middle/src/itkMiddle.cxx:1: includes itkLow.h of Low");
}

TEST_F(ModuleLayers, RefuseADependencyOnALaterModule)
{
  this->Declare("Core/Low", "Low PRIVATE_DEPENDS ITKCommon High");
  this->ExpectFault("Modules/Core/Low/itk-module.cmake: PRIVATE_DEPENDS names High, which is not an earlier module");
}

TEST_F(ModuleLayers, RefuseADependencyOnItself)
{
  this->Declare("Core/Low", "Low DEPENDS Low");
  this->ExpectFault("DEPENDS names Low, which is not an earlier module");
}

TEST_F(ModuleLayers, RefuseAnUnknownDependency)
{
  this->Declare("Core/Low", "Low DEPENDS Lower");
  this->ExpectFault("DEPENDS names Lower, which is not a module");
}

TEST_F(ModuleLayers, RefuseAnotherName)
{
  this->Declare("Core/Low", "Lo DEPENDS ITKCommon");
  this->ExpectFault("must declare itk_module(Low)");
}

TEST_F(ModuleLayers, RefuseWhatItkTakesForSomethingElse)
{
  this->Write("Modules/Core/Low/itk-module.cmake", "itk_module(Low DEPENDS ITKCommon)\n");
  this->ExpectFault("Modules/Core/Low/itk-module.cmake: must set EXCLUDE_FROM_DEFAULT");
  this->Declare("Core/Low", "Low DEPENDS ITKCommon DESCRIPTION \"Boxes; spheres\"");
  this->ExpectFault("Modules/Core/Low/itk-module.cmake: contains a semicolon");
}

TEST_F(ModuleLayers, RefuseAModuleThatTheListLacks)
{
  this->Declare("Mesh/New", "New DEPENDS ITKCommon");
  this->ExpectFault("Modules/Mesh/New/itk-module.cmake: is not listed in CMake/Modules.cmake");
}

TEST_F(ModuleLayers, RefuseAListedModuleWithoutFolder)
{
  this->Write("CMake/Modules.cmake", "set(Shapeton_MODULES Core/Low Filtering/Middle Filtering/High Mesh/New)\n");
  this->ExpectFault("names the module Mesh/New, which has no itk-module.cmake");
}

TEST_F(ModuleLayers, RefuseAnEmptyList)
{
  this->Write("CMake/Modules.cmake", "");
  this->ExpectFault("CMake/Modules.cmake: does not list any module");
}

TEST_F(ModuleLayers, RefuseAPathThatLeavesItsFolder)
{
  this->Write("Modules/Core/Low/src/itkLow.cxx", "#include \"../include/itkLow.h\"\n");
  this->ExpectFault("includes ../include/itkLow.h, which leaves its folder");
}

TEST_F(ModuleLayers, RefuseAHeaderNameTwice)
{
  this->Write("Modules/Filtering/High/include/itkLow.h", "");
  this->ExpectFault("the header name itkLow.h is taken by the module");
}

TEST_F(ModuleLayers, RefuseADependencyThatNothingUses)
{
  this->Write("Modules/Filtering/High/include/itkHigh.h", "#include <vector>\n");
  this->Write("Modules/Filtering/High/src/itkHigh.cxx", "#include \"itkHigh.h\"\n");
  this->ExpectFault("Modules/Filtering/High/itk-module.cmake: DEPENDS names Middle, which no file in include uses");

  this->Declare("Filtering/Middle", "Middle DEPENDS Low ITKIONRRD");
  this->ExpectFault(
    "Modules/Filtering/Middle/itk-module.cmake: DEPENDS names ITKIONRRD, which no file in include uses");
}

TEST_F(ModuleLayers, RefuseAGroupBelowAnEarlierOne)
{
  this->Write("CMake/Modules.cmake", "set(Shapeton_MODULES Filtering/Middle Core/Low Filtering/High)\n");
  this->ExpectFault("names the module Low of Core after a module of Filtering");
  this->Write("CMake/Modules.cmake", "set(Shapeton_MODULES Core/Low Shapes/Middle Filtering/High)\n");
  this->ExpectFault("names the module Middle in the unknown group Shapes");
}

TEST_F(ModuleLayers, AreDescribed)
{
  const std::string text = rules::DescribeModuleGraph(m_Root);
  EXPECT_NE(text.find("Core/Low:\nFiltering/Middle: Low\nFiltering/High: Middle\n"), std::string::npos) << text;
  EXPECT_NE(text.find("3 modules, 2 arrows, 3 public headers, 2 used outside their module"), std::string::npos) << text;
}

TEST_F(ModuleLayers, RefuseADeclarationInTheNamespaceOfItk)
{
  EXPECT_EQ(ToText(rules::CheckLibraryTexts(m_Root)), "");
  this->Write("Modules/Filtering/High/src/itkHigh.cxx", "#include \"itkHigh.h\"\nnamespace itk\n{\n}\n");
  EXPECT_NE(ToText(rules::CheckLibraryTexts(m_Root)).find("High/src/itkHigh.cxx:2: opens the namespace itk"),
            std::string::npos);
}

TEST_F(ModuleLayers, RefuseAnOptionInTheTextOfALibrary)
{
  const std::string text = "const char * text = \"use --"
                           "option 3\";\n"; // joined: this file has no such text either
  this->Write("Modules/Filtering/High/src/itkHigh.cxx", text);
  EXPECT_NE(ToText(rules::CheckLibraryTexts(m_Root)).find("High/src/itkHigh.cxx:1: names an option"),
            std::string::npos);
  this->Write("Modules/Filtering/High/src/itkHigh.cxx", "int i; // \"a -- b\"\n");
  this->Write("Modules/Tools/Line/src/itkLine.cxx", text);
  EXPECT_EQ(ToText(rules::CheckLibraryTexts(m_Root)), "");
}

TEST(ModuleLayersOfThisRepository, AreKept)
{
  const rules::Faults faults = CheckModuleLayers(SHAPETON_SOURCE_DIR);
  EXPECT_TRUE(faults.empty()) << ToText(faults);
}

TEST(ModuleLayersOfThisRepository, HaveTextsForLibraries)
{
  const rules::Faults faults = rules::CheckLibraryTexts(SHAPETON_SOURCE_DIR);
  EXPECT_TRUE(faults.empty()) << ToText(faults);
}

TEST(ModuleLayersOfThisRepository, ArePrinted)
{
  const std::string text = rules::DescribeModuleGraph(SHAPETON_SOURCE_DIR);
  std::cout << text;
  EXPECT_NE(text.find(" modules, "), std::string::npos);
}
} // namespace
