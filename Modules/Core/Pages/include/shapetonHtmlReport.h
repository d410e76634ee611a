#ifndef shapetonHtmlReport_h
#define shapetonHtmlReport_h

#include "ShapetonPagesExport.h"
#include "shapetonCsvTable.h"
#include "shapetonOutputPath.h"

#include <string>
#include <utility>
#include <vector>

namespace shapeton
{
/** Scripts or styles of a page, joined by shapeton_join_scripts() in CMake: string literals, terminated by nullptr.
 * \ingroup ShapetonPages */
ShapetonPages_EXPORT std::string
                     PageText(const char * const pieces[]);

/** The style sheet shared by all pages; a root element of class `dark` selects dark colors.
 * \ingroup ShapetonPages */
ShapetonPages_EXPORT std::string
                     PageStyle();

/** \class HtmlReport
 * \brief A self-contained HTML file with embedded styles and pictures; it opens without a network or other files.
 *
 * Text is UTF-8 and escaped; numbers are formatted by ReadableText(). The page is HTML 5 and well-formed XML, and is
 * deterministic.
 *
 * \ingroup ShapetonPages */
class ShapetonPages_EXPORT HtmlReport
{
public:
  explicit HtmlReport(const std::string & title);
  ~HtmlReport();

  /** Adds the note that the report is for research use only, not for diagnosis. */
  void
  AddResearchNote();
  /** Adds the head of a report: the research note, the findings, and missing or doubtful results. */
  void
  AddHead(const std::vector<std::pair<std::string, std::string>> & summary, const std::vector<std::string> & warnings);
  /** Adds a box for each kind of warning, the most severe first: failures and missing results, doubtful results,
   * notes. Warnings that differ only in numbers and quoted names share one box with a count, which expands to the full
   * warnings. */
  void
  AddWarnings(const std::vector<std::string> & warnings);
  void
  AddHeading(const std::string & text);
  /** Adds a heading within a section. */
  void
  AddSubheading(const std::string & text);
  /** Begins content that is hidden until its title is clicked, and not printed, up to EndDetails(). */
  void
  BeginDetails(const std::string & title);
  void
  EndDetails();
  void
  AddParagraph(const std::string & text);
  /** Adds a paragraph with a link to another page, relative to this one. */
  void
  AddLink(const std::string & path, const std::string & text);
  /** An item of a list, with a link to another page or to a place on it, relative to this page; no link if `path` is
   * empty. */
  struct LinkedItem
  {
    std::string text;
    std::string path;
    std::string linkText;
  };
  /** Adds a numbered list. */
  void
  AddNumberedList(const std::vector<LinkedItem> & items);
  /** Begins a part that is printed on separate pages, up to EndPage(). */
  void
  BeginPage();
  void
  EndPage();
  /** Adds a highlighted box, for example for a warning. */
  void
  AddNote(const std::string & text);
  /** Embeds a PNG file. Throws InputError if it cannot be read or is not a PNG file. The caption is also the
   * alternative text. */
  void
  AddPicture(const std::string & pngPath, const std::string & caption);
  /** Embeds the bytes of a PNG file. Throws std::invalid_argument unless IsPng(). */
  void
  AddPictureBytes(const std::string & png, const std::string & caption);
  /** Adds a table. Columns of numbers are right-aligned, with their common unit in the header; a color "#rrggbb" is
   * shown as a swatch with its value as a tooltip. A table that is too wide scrolls within its box. */
  void
  AddTable(const CsvTable & table, const std::string & caption);
  /** Adds a table of names and values. The value of an option (a name with a period) is shown unchanged. */
  void
  AddFacts(const std::vector<std::pair<std::string, std::string>> & facts);
  /** Adds markup unchanged: well-formed XML for drawings and scripts of the page, escaped by the caller. */
  void
  AddMarkup(const std::string & markup);
  /** Adds style sheet rules after the shared ones; without "<" and "&". */
  void
  AddStyle(const std::string & rules);

  /** Throws OutputError. */
  void
  Write(const std::string & path) const;

private:
  std::string m_Title;
  std::string m_Style;
  std::string m_Body;
};
} // namespace shapeton

#endif
