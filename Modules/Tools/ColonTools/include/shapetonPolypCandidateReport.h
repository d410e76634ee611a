#ifndef shapetonPolypCandidateReport_h
#define shapetonPolypCandidateReport_h

#include "ShapetonColonToolsExport.h"

#include "shapetonHtmlReport.h"
#include "shapetonPolypSearch.h"

#include <functional>

namespace shapeton
{
class CommandLine;

/** Picture file of a candidate by its number, 0 for the flat colon with all candidates; empty if there is none.
 * \ingroup ShapetonColonTools */
using PolypPictureFile = std::function<std::string(int number)>;

/** Adds the section on candidates: how to read them, the limit of the resolution stored with the centerline, a table,
 * their sizes if confirmed, a card for each possible polyp, and a list of those recognized as something else.
 * \ingroup ShapetonColonTools */
ShapetonColonTools_EXPORT void
AddPolypCandidates(HtmlReport &                        report,
                   const CurveSet &                    centerline,
                   const std::vector<PolypCandidate> & candidates,
                   const PolypPictureFile &            pictureOf);

/** Writes index.html with this section and the provenance, and its pictures, polyp-candidates-flat.png and
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
