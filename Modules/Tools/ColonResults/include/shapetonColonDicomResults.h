#ifndef shapetonColonDicomResults_h
#define shapetonColonDicomResults_h

#include "ColonResultsExport.h"
#include "shapetonHtmlReport.h"
#include "shapetonProgress.h"
#include "shapetonRemarks.h"

#include <string>

namespace shapeton
{
/** How the results of an examination are written. \ingroup ColonResults */
struct ColonDicomOptions
{
  /** The segmentation is written in Deflated Explicit VR Little Endian. */
  bool isDeflated{ false };
  /** Its stages are "Reading" and the names of the files. */
  Progress progress;
};

/** Writes what VirtualColonoscopy has found in one series as DICOM objects beside this series: seg.dcm (lumen, folds,
 * heads of candidates, segments of the colon), sr.dcm (TID 1500), cad.dcm (Colon CAD SR), sc.dcm (the flat colon),
 * stl.dcm (the wall).
 *
 * \param exam the folder of the run, or its folder `second`.
 * \param source the folder with the series that the run has read: checked by its UID, its grid, and its digest in the
 * record of the segmentation.
 * \param outputPath maps final names in `folder`, which is there, to those to write to.
 * Returns what is missing in the examination and therefore in the results. Equal input gives equal bytes.
 *
 * Throws InputError for a run that is not finished, did not read DICOM, or read another series; OutputError.
 * \ingroup ColonResults */
ColonResults_EXPORT Remarks
WriteColonDicomResults(const std::string &       exam,
                       const std::string &       source,
                       const std::string &       folder,
                       const ColonDicomOptions & options,
                       const OutputPath &        outputPath);
} // namespace shapeton

#endif
