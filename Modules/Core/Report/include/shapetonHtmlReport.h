#ifndef shapetonHtmlReport_h
#define shapetonHtmlReport_h

#include "ReportExport.h"
#include "shapetonCsvTable.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace shapeton
{
/** Maps the final path of a file to the path to write it to, for example to a temporary one.
 * \ingroup Report */
using OutputPath = std::function<std::string(const std::string &)>;

/** The text that shapeton_join_scripts() of CMake makes from the scripts or styles of a page: literals, ended by
 * nullptr. \ingroup Report */
Report_EXPORT std::string
              PageText(const char * const pieces[]);

/** The style sheet that all pages share; one with the class `dark` at its root is dark.
 * \ingroup Report */
Report_EXPORT std::string
              PageStyle();

/** \class HtmlReport
 * \brief One HTML file that opens without a network or other files: styles and pictures are inside it.
 *
 * Text is UTF-8, is escaped, and shows numbers as ReadableText() does. The page is HTML 5, and well-formed XML too. The
 * bytes depend on the content alone.
 *
 * \ingroup Report
 */
class Report_EXPORT HtmlReport
{
public:
  explicit HtmlReport(const std::string & title);
  ~HtmlReport();

  /** That it is for research use, and no diagnosis. */
  void
  AddResearchNote();
  /** How a report begins: that note, what was found, and what is missing or doubtful. */
  void
  AddHead(const std::vector<std::pair<std::string, std::string>> & summary, const std::vector<std::string> & warnings);
  /** A box for each kind of warning, the worst first: what failed or is missing, what is doubtful, notes. Warnings that
   * are the same but for numbers and quoted names share a box with their number, which unfolds to their full texts. */
  void
  AddWarnings(const std::vector<std::string> & warnings);
  void
  AddHeading(const std::string & text);
  void
  AddParagraph(const std::string & text);
  /** A paragraph that leads to another page, named relative to this one. */
  void
  AddLink(const std::string & path, const std::string & text);
  /** A box for what a reader must not miss, for example a warning. */
  void
  AddNote(const std::string & text);
  /** Embeds a PNG file. Throws InputError when it cannot be read or is none. The caption is its alternative text, too.
   */
  void
  AddPicture(const std::string & pngPath, const std::string & caption);
  /** Columns of numbers are aligned at the right, with the unit that all share in the head; a colour "#rrggbb" is a
   * patch that tells its name. A table that is too wide scrolls in a box of its own. */
  void
  AddTable(const CsvTable & table, const std::string & caption);
  /** Two columns: name and value. A name with a full stop is that of an option, whose value stays as it was given. */
  void
  AddFacts(const std::vector<std::pair<std::string, std::string>> & facts);
  /** Markup as it is, well-formed XML, for drawings and scripts that are part of the page. The caller has escaped it.
   */
  void
  AddMarkup(const std::string & markup);
  /** Rules of a style sheet after those that all pages share; without "<" and "&". */
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
