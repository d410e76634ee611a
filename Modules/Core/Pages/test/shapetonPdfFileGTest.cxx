#include "shapetonPdfFile.h"

#include "shapetonExceptions.h"
#include "shapetonFileBytes.h"
#include "shapetonHtmlReport.h"
#include "shapetonTestFolder.h"

#include "gtest/gtest.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>

using namespace shapeton;

namespace
{
/** A page with a table, written to a new folder. */
class PdfFile : public testing::Test
{
protected:
  void
  SetUp() override
  {
    HtmlReport report("Title");
    report.AddHead({ { "Length", "231.4 cm" } }, { "a warning" });
    report.Write(m_Folder / "page.html");
  }

  basetest::Folder m_Folder;
};
} // namespace

TEST_F(PdfFile, IsTheSameForTheSamePage)
{
  ASSERT_TRUE(HasPdfWriter()) << "install WeasyPrint by Utilities/install-dependencies";
  WritePdf(m_Folder / "page.html", m_Folder / "first.pdf");
  WritePdf(m_Folder / "page.html", m_Folder / "second.pdf");
  const std::string bytes = ReadFileBytes(m_Folder / "first.pdf");
  EXPECT_EQ(bytes.rfind("%PDF-", 0), 0u);
  EXPECT_EQ(bytes, ReadFileBytes(m_Folder / "second.pdf"));
}

TEST_F(PdfFile, NamesThePackageThatIsMissing)
{
  const std::string path = std::getenv("PATH");
  setenv("PATH", (m_Folder / "").c_str(), 1);
  EXPECT_FALSE(HasPdfWriter());
  try
  {
    WritePdf(m_Folder / "page.html", m_Folder / "page.pdf");
    ADD_FAILURE() << "no exception";
  }
  catch (const OutputError & error)
  {
    EXPECT_NE(std::string(error.what()).find("install the package weasyprint"), std::string::npos);
  }
  std::ofstream(m_Folder / "page.pdf") << "old";
  const auto same = [](const std::string & file) { return file; };
  EXPECT_EQ(PrintPage(m_Folder / "page.html", m_Folder / "page.pdf", same).at(0).rfind("page.pdf was not written", 0),
            0u);
  EXPECT_FALSE(std::filesystem::exists(m_Folder / "page.pdf"));
  setenv("PATH", path.c_str(), 1);
}

TEST_F(PdfFile, SaysWhyItCannotBeWritten)
{
  EXPECT_THROW(WritePdf(m_Folder / "missing.html", m_Folder / "page.pdf"), OutputError);
  EXPECT_THROW(WritePdf(m_Folder / "page.html", m_Folder / "missing/page.pdf"), OutputError);
}
