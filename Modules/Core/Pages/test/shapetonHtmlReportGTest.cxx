#include "shapetonHtmlReport.h"
#include "shapetonFileBytes.h"
#include "shapetonTestFolder.h"
#include "shapetonTestXml.h"

#include "gtest/gtest.h"

#include <algorithm>
#include <map>
#include <set>

namespace
{
using basetest::Folder;
using Page = basetest::XmlPage;
using Element = basetest::XmlElement;

const std::string pngSignature = "\x89PNG\r\n\x1A\n";

Page
Written(const shapeton::HtmlReport & report)
{
  const Folder folder;
  report.Write(folder / "index.html");
  return Page(shapeton::ReadFileBytes(folder / "index.html"));
}

shapeton::HtmlReport
FullReport(const Folder & folder)
{
  shapeton::WriteFileBytes(folder / "p.png", pngSignature + "pixels");
  shapeton::CsvTable table({ "class", "heat" });
  table.AddRow({ "bone", "1" });
  table.AddRow({ "skin", "2" });
  shapeton::HtmlReport report("Heat of the ankle");
  report.AddParagraph("First.");
  report.AddNote("Look here.");
  report.AddHeading("Pictures");
  report.AddPicture(folder / "p.png", "The histogram");
  report.AddTable(table, "Classes");
  report.AddFacts({ { "tool", "CumulativeHeatDiffusion" }, { "version", "0.1.0" } });
  return report;
}

TEST(HtmlReport, ShowsWhatWasAddedInItsOrder)
{
  const Folder folder;
  const Page   page = Written(FullReport(folder));
  EXPECT_EQ(page.bytes.find("<!DOCTYPE html>\n<html lang=\"en\">\n"), 0u);
  EXPECT_EQ(page.TextsOf("title"), page.TextsOf("h1"));
  using Texts = std::vector<std::string>;
  EXPECT_EQ(page.TextsOf("h1"), Texts({ "Heat of the ankle" }));
  EXPECT_EQ(page.TextsOf("h2"), Texts({ "Pictures" }));
  EXPECT_EQ(page.TextsOf("p"), Texts({ "First.", "Look here." }));
  EXPECT_EQ(page.TextsOf("figcaption"), Texts({ "The histogram" }));
  EXPECT_EQ(page.TextsOf("caption"), Texts({ "Classes" }));
  EXPECT_EQ(page.TextsOf("th"), Texts({ "class", "heat", "tool", "version" }));
  EXPECT_EQ(page.TextsOf("td"), Texts({ "bone", "1", "skin", "2", "CumulativeHeatDiffusion", "0.1.0" }));

  std::vector<std::string> order;
  for (const auto & element : page.elements)
  {
    if (std::set<std::string>{ "h1", "p", "h2", "figure", "table" }.count(element.tag))
    {
      order.push_back(element.tag);
    }
  }
  EXPECT_EQ(order, Texts({ "h1", "p", "p", "h2", "figure", "table", "table" }));
}

TEST(HtmlReport, RefersToNothingOutside)
{
  const Folder folder;
  const Page   page = Written(FullReport(folder));
  for (const auto & element : page.elements)
  {
    EXPECT_EQ(element.attributes.count("href"), 0u);
    EXPECT_FALSE(std::set<std::string>({ "link", "script", "iframe", "object", "embed", "base" }).count(element.tag))
      << element.tag;
    if (const auto source = element.attributes.find("src"); source != element.attributes.end())
    {
      EXPECT_EQ(source->second.find("data:"), 0u);
    }
  }
  for (const std::string reference : { "http:", "https:", "file:", "url(", "@import", "p.png" })
  {
    EXPECT_EQ(page.bytes.find(reference), std::string::npos) << reference;
  }
}

TEST(HtmlReport, IsTheSameBytesForTheSameContent)
{
  const Folder one;
  const Folder two; // pictures and report in different folders
  EXPECT_EQ(Written(FullReport(one)).bytes, Written(FullReport(two)).bytes);
}

TEST(HtmlReport, MayBeWrittenTwiceAndContinued)
{
  shapeton::HtmlReport report("T");
  const std::string    empty = Written(report).bytes;
  EXPECT_EQ(Written(report).bytes, empty);
  report.AddParagraph("more");
  EXPECT_EQ(Written(report).TextsOf("p"), std::vector<std::string>({ "more" }));
}

TEST(HtmlReport, TextIsNeverMarkup)
{
  const Folder      folder;
  const std::string text = "</td></style><script>alert('1' & \"2\")</script> &amp; ]]> \xC3\xA4 <!--";
  shapeton::WriteFileBytes(folder / "p.png", pngSignature);
  shapeton::CsvTable table({ text });
  table.AddRow({ text });
  shapeton::HtmlReport report(text);
  report.AddHeading(text);
  report.AddParagraph(text);
  report.AddLink(text, text);
  report.AddNote(text);
  report.AddPicture(folder / "p.png", text);
  report.AddTable(table, text);
  report.AddFacts({ { text, text } });
  const Page page = Written(report);
  for (const std::string tag : { "title", "h1", "h2", "a", "p", "figcaption", "caption", "th", "td" })
  {
    const auto texts = page.TextsOf(tag);
    EXPECT_FALSE(texts.empty());
    EXPECT_TRUE(std::all_of(texts.begin(), texts.end(), [&](const auto & found) { return found == text; })) << tag;
  }
  EXPECT_TRUE(page.TextsOf("script").empty());
  const auto picture =
    std::find_if(page.elements.begin(), page.elements.end(), [](const Element & e) { return e.tag == "img"; });
  ASSERT_NE(picture, page.elements.end());
  EXPECT_EQ(picture->attributes.at("alt"), text);
}

/** The style class of each element with this tag, by the text of the element. */
std::map<std::string, std::string>
StylesOf(const Page & page, const std::string & tag)
{
  std::map<std::string, std::string> styles;
  for (const auto & element : page.elements)
  {
    if (element.tag == tag)
    {
      const auto style = element.attributes.find("class");
      styles[element.text] = style == element.attributes.end() ? "" : style->second;
    }
  }
  return styles;
}

TEST(HtmlReport, NumbersStandAtTheRightUnderTheirUnit)
{
  shapeton::CsvTable table({ "segment", "length", "wall", "place", "voxels" });
  table.AddRow({ "rectum", "14 cm", "2.322e+04", "1, 2", "246 908" });
  table.AddRow({ "sigmoid", "9.5 cm", "", "not found", "1234" });
  shapeton::HtmlReport report("T");
  report.AddTable(table, "C");
  const Page page = Written(report);
  using Styles = std::map<std::string, std::string>;
  EXPECT_EQ(StylesOf(page, "th"),
            Styles({ { "segment", "" },
                     { "length, cm", "number" },
                     { "wall", "number" },
                     { "place", "" },
                     { "voxels", "number" } }));
  EXPECT_EQ(StylesOf(page, "td"),
            Styles({ { "rectum", "" },
                     { "sigmoid", "" },
                     { "14", "number" },
                     { "9.5", "number" },
                     { "23\u202F220", "number" },
                     { "", "number" },
                     { "1, 2", "" },
                     { "not found", "" },
                     { "246\u202F908", "number" },
                     { "1\u202F234", "number" } }));
}

TEST(HtmlReport, UnitsThatDifferStayWithTheirNumbers)
{
  shapeton::CsvTable table({ "length" });
  table.AddRow({ "14 cm" });
  table.AddRow({ "140 mm" });
  shapeton::HtmlReport report("T");
  report.AddTable(table, "C");
  const Page page = Written(report);
  EXPECT_EQ(page.TextsOf("th"), std::vector<std::string>({ "length" }));
  EXPECT_EQ(page.TextsOf("td"), std::vector<std::string>({ "14 cm", "140 mm" }));
}

TEST(HtmlReport, ColorsAreSeen)
{
  shapeton::CsvTable table({ "color" });
  table.AddRow({ "#23cbac" });
  table.AddRow({ "#23cbac; x" });
  shapeton::HtmlReport report("T");
  report.AddTable(table, "C");
  const Page page = Written(report);
  EXPECT_EQ(page.TextsOf("td"), std::vector<std::string>({ "", "#23cbac; x" }));
  const auto patch = std::find_if(
    page.elements.begin(), page.elements.end(), [](const Element & element) { return element.tag == "span"; });
  ASSERT_NE(patch, page.elements.end());
  EXPECT_EQ(patch->attributes.at("title"), "#23cbac");
  EXPECT_EQ(patch->attributes.at("style"), "background:#23cbac");
}

TEST(HtmlReport, FactsArePlainAndOptionsStay)
{
  shapeton::HtmlReport report("T");
  report.AddFacts({ { "Length", "2322 mm" }, { "Faces", "5.5e+04" }, { "option.faces", "5.5e+04" } });
  EXPECT_EQ(Written(report).TextsOf("td"), std::vector<std::string>({ "2\u202F322 mm", "55\u202F000", "5.5e+04" }));
}

TEST(HtmlReport, WordsAndNumbersAreNotBroken)
{
  shapeton::HtmlReport report("T");
  const Page           page = Written(report);
  for (const std::string breaking : { "overflow-wrap", "word-break", "word-wrap" })
  {
    EXPECT_EQ(page.bytes.find(breaking), std::string::npos) << breaking;
  }
  EXPECT_NE(page.bytes.find("overflow-x: auto"), std::string::npos) << "a wide table scrolls";
}

TEST(HtmlReport, ControlCharactersBecomeBlanks)
{
  shapeton::HtmlReport report("T");
  report.AddParagraph("a\x01"
                      "b\x1B"
                      "c" +
                      std::string(1, '\0') + "d\te\nf");
  EXPECT_EQ(Written(report).TextsOf("p"), std::vector<std::string>({ "a b c d\te\nf" }));
}

// ---- pictures ----

std::string
SourceOfPicture(const std::string & bytes)
{
  const Folder folder;
  shapeton::WriteFileBytes(folder / "p.png", bytes);
  shapeton::HtmlReport report("T");
  report.AddPicture(folder / "p.png", "C");
  const Page page = Written(report);
  for (const auto & element : page.elements)
  {
    if (element.tag == "img")
    {
      return element.attributes.at("src");
    }
  }
  return "no picture";
}

// With one more byte, the PNG signature ends on a base64 boundary and the following bytes are encoded separately.
TEST(HtmlReport, PicturesAreEncodedAsTheExamplesOfRFC4648)
{
  const std::pair<std::string, std::string> examples[] = { { "", "" },
                                                           { "f", "Zg==" },
                                                           { "fo", "Zm8=" },
                                                           { "foo", "Zm9v" },
                                                           { "foob", "Zm9vYg==" },
                                                           { "fooba", "Zm9vYmE=" },
                                                           { "foobar", "Zm9vYmFy" } };
  for (const auto & [bytes, encoded] : examples)
  {
    EXPECT_EQ(SourceOfPicture(pngSignature + "\n" + bytes), "data:image/png;base64,iVBORw0KGgoK" + encoded);
  }
  EXPECT_EQ(SourceOfPicture(pngSignature), "data:image/png;base64,iVBORw0KGgo=");
}

int
ValueOf(char c)
{
  static const std::string alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  return static_cast<int>(alphabet.find(c));
}

TEST(HtmlReport, PicturesOfAllBytesAreDecodedAsTheyWere)
{
  std::string bytes = pngSignature;
  for (unsigned int i = 0; i < 70000; ++i)
  {
    bytes += static_cast<char>(i * i / 7 + i);
  }
  const std::string source = SourceOfPicture(bytes).substr(std::string("data:image/png;base64,").size());
  std::string       decoded;
  unsigned int      bits = 0;
  int               number = 0;
  for (const char c : source.substr(0, source.find('=')))
  {
    bits = (bits << 6 | ValueOf(c)) & 0xFFFFFF;
    number += 6;
    if (number >= 8)
    {
      number -= 8;
      decoded += static_cast<char>(bits >> number & 0xFF);
    }
  }
  EXPECT_EQ(decoded, bytes);
  EXPECT_EQ(source.size() % 4, 0u);
}

TEST(HtmlReport, PicturesThatAreNone)
{
  const Folder         folder;
  shapeton::HtmlReport report("T");
  EXPECT_EQ(basetest::MessageOf([&] { report.AddPicture(folder / "no.png", "C"); }),
            "InputError: cannot read \"" + (folder / "no.png") +
              "\": No such file or directory; check the name and its permissions");
  for (const std::string & bytes : { std::string(), std::string("text"), pngSignature.substr(0, 7) })
  {
    shapeton::WriteFileBytes(folder / "p.png", bytes);
    EXPECT_EQ(basetest::MessageOf([&] { report.AddPicture(folder / "p.png", "C"); }),
              "InputError: the picture \"" + (folder / "p.png") + "\" is not a PNG file; convert it");
  }
  EXPECT_TRUE(Written(report).TextsOf("figcaption").empty());
}

TEST(HtmlReport, CannotBeWrittenEverywhere)
{
  EXPECT_EQ(
    basetest::MessageOf([] { shapeton::HtmlReport("T").Write("/dev/full"); }),
    "OutputError: cannot write \"/dev/full\": No space left on device; free some space or choose another folder");
}

TEST(HtmlReport, BeginsWithItsUseWhatWasFoundAndWhatIsDoubtful)
{
  shapeton::HtmlReport sure("Colon");
  sure.AddHead({ { "Length", "1.6 m" } }, {});
  shapeton::HtmlReport doubtful("Colon");
  doubtful.AddHead({ { "Length", "1.6 m" } }, { "a gap" });
  const Folder folder;
  sure.Write(folder / "sure.html");
  doubtful.Write(folder / "doubtful.html");
  const std::string pages[] = { shapeton::ReadFileBytes(folder / "sure.html"),
                                shapeton::ReadFileBytes(folder / "doubtful.html") };
  for (const std::string & page : pages)
  {
    const auto use = page.find("For research use. This is not a diagnosis");
    const auto found = page.find("1.6 m");
    EXPECT_LT(use, found);
    EXPECT_LT(found, page.find("Missing or doubtful results"));
  }
  EXPECT_NE(pages[0].find("No warnings of this step"), std::string::npos);
  EXPECT_NE(pages[1].find("<p class=\"note\">a gap</p>"), std::string::npos);
  EXPECT_EQ(pages[1].find("No warnings"), std::string::npos);
}

using Texts = std::vector<std::string>;

Page
PageWithWarnings(const Texts & warnings)
{
  shapeton::HtmlReport report("T");
  report.AddWarnings(warnings);
  return Written(report);
}

TEST(HtmlReport, WarningsOfOneKindAreCounted)
{
  const Texts warnings{ "the lumen is only 4.3 mm wide at (-29, 43, 7) mm: a collapsed place",
                        "\"a.vtp\" has 3 of 12 holes",
                        "the lumen is only 4.3 mm wide at (29, -1.5, 7) mm: a collapsed place",
                        "\"b.vtp\" has 3 of 12 holes" };
  const Page  page = PageWithWarnings(warnings);
  EXPECT_EQ(page.TextsOf("summary"),
            Texts({ "2 times: the lumen is only 4.3 mm wide at (\u2026, \u2026, 7) mm: a collapsed place",
                    "2 times: \u2026 has 3 of 12 holes" }));
  EXPECT_EQ(page.TextsOf("li"), Texts({ warnings[0], warnings[2], warnings[1], warnings[3] })) << "in full";
  EXPECT_TRUE(page.TextsOf("p").empty());
}

TEST(HtmlReport, WarningsThatAreAloneOrDifferStayOpen)
{
  const Texts warnings{ "part 1 of 2", "part 1 of two", "the \"x quote", "the \"y quote", "", "7", "7 mm" };
  const Page  page = PageWithWarnings(warnings);
  EXPECT_EQ(page.TextsOf("p"), warnings);
  EXPECT_TRUE(page.TextsOf("details").empty());
}

TEST(HtmlReport, EqualWarningsAreCountedToo)
{
  const Page page = PageWithWarnings({ "turned 3", "turned 3", "turned 3" });
  EXPECT_EQ(page.TextsOf("summary"), Texts({ "3 times: turned 3" }));
}

TEST(HtmlReport, TheWorstWarningsComeFirst)
{
  EXPECT_EQ(PageWithWarnings({ "the faces looked inwards; they were turned",
                               "the splenic flexure is uncertain (confidence 31 %): check it",
                               "the surface: 3 vertices were joined",
                               "landmarks: the hepatic flexure was not found: no bend there",
                               "the heat is not yet steady after 500 steps",
                               "No window of the wall holds enough fold ends" })
              .TextsOf("p"),
            Texts({ "landmarks: the hepatic flexure was not found: no bend there",
                    "No window of the wall holds enough fold ends",
                    "the splenic flexure is uncertain (confidence 31 %): check it",
                    "the heat is not yet steady after 500 steps",
                    "the faces looked inwards; they were turned",
                    "the surface: 3 vertices were joined" }));
}
} // namespace
