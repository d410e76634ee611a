#ifndef itkPolypCandidateReport_h
#define itkPolypCandidateReport_h

#include "PolypCandidateViewExport.h"

#include "itkHtmlReport.h"
#include "itkPolypSearch.h"

namespace itk
{
class CommandLine;

/** The heading of a section on candidates, and what they are and are not. \ingroup PolypCandidateView */
PolypCandidateView_EXPORT void
AddPolypCandidateHeading(HtmlReport & report);

/** Adds a section on candidates to a report: what they are and are not, the category that their sizes imply, a table,
 * the flat colon with all of them, each close by. Pictures go to `folder`, which exists, under names that begin with
 * "polyp-candidate". Without a flat map there are no pictures. Throws OutputError, and as PolypCandidatePictures does.
 * \ingroup PolypCandidateView */
PolypCandidateView_EXPORT void
AddPolypCandidateSection(HtmlReport &                        report,
                         const PolypColon &                  colon,
                         const std::vector<PolypCandidate> & candidates,
                         const std::string &                 folder,
                         const OutputPath &                  outputPath);

/** Writes index.html with that section and the provenance into a folder; none where its name is empty.
 * \ingroup PolypCandidateView */
PolypCandidateView_EXPORT void
WritePolypCandidateReport(CommandLine &                       commandLine,
                          const PolypColon &                  colon,
                          const std::vector<PolypCandidate> & candidates,
                          const std::string &                 folder);
} // namespace itk

#endif
