#ifndef shapetonPolypCandidateReport_h
#define shapetonPolypCandidateReport_h

#include "ShapetonColonToolsExport.h"

#include "shapetonHtmlReport.h"
#include "shapetonPolypSearch.h"

#include <functional>

namespace shapeton
{
class CommandLine;

/** Picture file of the candidate with this number, or of the flat colon with all candidates for 0; empty if there is
 * none.
 * \ingroup ShapetonColonTools */
using PolypPictureFile = std::function<std::string(int number)>;

/** Candidates for a page on one position. \ingroup ShapetonColonTools */
struct PolypsOfPage
{
  std::vector<PolypCandidate> here;
  /** Those of the other position; may be empty. */
  std::vector<PolypCandidate> there;
  /** Whether the page is on the second position. */
  bool isSecond{ false };
};

/** Adds the section on candidates for a first page: how to read them, the resolution limit stored with the centerline,
 * a table, and a count by size in case they are confirmed. \ingroup ShapetonColonTools */
ShapetonColonTools_EXPORT void
AddPolypCandidateTable(HtmlReport & report, const CurveSet & centerline, const PolypsOfPage & polyps);

/** Adds a table of the possible polyps of the other position whose counterpart here is missing or recognized as
 * something else; nothing if there are none. \ingroup ShapetonColonTools */
ShapetonColonTools_EXPORT void
AddPolypsOfOtherPosition(HtmlReport & report, const PolypsOfPage & polyps);

/** Content of the cards of candidates. \ingroup ShapetonColonTools */
struct PolypCards
{
  PolypsOfPage polyps;
  /** The CT, for slice numbers; may be null. */
  const itk::ImageBase<3> * grid{ nullptr };
  /** Pages to which the cards link, relative to the report: the viewer, and the cards of the other position; may be
   * empty. */
  std::string      viewer;
  std::string      otherPage;
  PolypPictureFile pictureOf{};
};

/** Adds a card for each candidate that is a possible polyp in one of the positions, and a list of those recognized as
 * something else. \ingroup ShapetonColonTools */
ShapetonColonTools_EXPORT void
AddPolypCandidateCards(HtmlReport & report, const PolypCards & cards);

/** Writes index.html with these sections and the provenance, and its pictures, polyp-candidates-flat.png and
 * polyp-candidate-NUMBER.png, into an existing folder; does nothing if the folder name is empty. Without a flat map,
 * it writes no pictures. Throws OutputError, and the exceptions of PolypCandidatePictures.
 * \ingroup ShapetonColonTools */
ShapetonColonTools_EXPORT void
WritePolypCandidateReport(CommandLine &                       commandLine,
                          const PolypColon &                  colon,
                          const std::vector<PolypCandidate> & candidates,
                          const std::string &                 folder);
} // namespace shapeton

#endif
