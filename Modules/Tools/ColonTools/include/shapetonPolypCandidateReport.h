#ifndef shapetonPolypCandidateReport_h
#define shapetonPolypCandidateReport_h

#include "ColonToolsExport.h"

#include "shapetonHtmlReport.h"
#include "shapetonPolypSearch.h"

namespace shapeton
{
class CommandLine;

/** Begins a section on candidates: what they are and are not, a table, the category that their sizes imply.
 * \ingroup ColonTools */
ColonTools_EXPORT void
AddPolypCandidateTable(HtmlReport & report, const std::vector<PolypCandidate> & candidates);

/** What the pictures of a section show: all candidates for 0, or the one of this number.
 * \ingroup ColonTools */
ColonTools_EXPORT std::string
                  CaptionOfPolypPicture(int candidate);

/** Adds a section on candidates to a report: AddPolypCandidateTable(), the flat colon with all of them, each close by.
 * Pictures go to `folder`, which exists, under names that begin with "polyp-candidate". Without a flat map there are no
 * pictures. Throws OutputError, and as PolypCandidatePictures does. \ingroup ColonTools */
ColonTools_EXPORT void
AddPolypCandidateSection(HtmlReport &                        report,
                         const PolypColon &                  colon,
                         const std::vector<PolypCandidate> & candidates,
                         const std::string &                 folder,
                         const OutputPath &                  outputPath);

/** Writes index.html with that section and the provenance into a folder; none where its name is empty.
 * \ingroup ColonTools */
ColonTools_EXPORT void
WritePolypCandidateReport(CommandLine &                       commandLine,
                          const PolypColon &                  colon,
                          const std::vector<PolypCandidate> & candidates,
                          const std::string &                 folder);
} // namespace shapeton

#endif
