#ifndef shapetonPolypCandidateReport_h
#define shapetonPolypCandidateReport_h

#include "ShapetonColonToolsExport.h"

#include "shapetonHtmlReport.h"
#include "shapetonPolypSearch.h"

namespace shapeton
{
class CommandLine;

/** Begins a section on candidates: a note on how to read them, the limit of the resolution stored with the centerline,
 * a table, and the category implied by their sizes. \ingroup ShapetonColonTools */
ShapetonColonTools_EXPORT void
AddPolypCandidateTable(HtmlReport &                        report,
                       const CurveSet &                    centerline,
                       const std::vector<PolypCandidate> & candidates);

/** Caption of a picture in the section. Number 0 is the picture of all candidates, any other number that candidate.
 * \ingroup ShapetonColonTools */
ShapetonColonTools_EXPORT std::string
                          CaptionOfPolypPicture(int candidate);

/** Adds a section on candidates to a report: AddPolypCandidateTable(), the flat colon with all candidates, and a
 * close-up of each. Pictures are written to the existing `folder` under names that begin with "polyp-candidate".
 * Without a flat map there are no pictures. Throws OutputError and the exceptions of PolypCandidatePictures.
 * \ingroup ShapetonColonTools */
ShapetonColonTools_EXPORT void
AddPolypCandidateSection(HtmlReport &                        report,
                         const PolypColon &                  colon,
                         const std::vector<PolypCandidate> & candidates,
                         const std::string &                 folder,
                         const OutputPath &                  outputPath);

/** Writes index.html with this section and the provenance into a folder; does nothing if the folder name is empty.
 * \ingroup ShapetonColonTools */
ShapetonColonTools_EXPORT void
WritePolypCandidateReport(CommandLine &                       commandLine,
                          const PolypColon &                  colon,
                          const std::vector<PolypCandidate> & candidates,
                          const std::string &                 folder);
} // namespace shapeton

#endif
