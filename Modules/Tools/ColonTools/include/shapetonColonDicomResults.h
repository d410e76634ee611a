#ifndef shapetonColonDicomResults_h
#define shapetonColonDicomResults_h

#include "ShapetonColonToolsExport.h"
#include "shapetonColonDicomObjectOptions.h"
#include "shapetonOutputPath.h"
#include "shapetonProgress.h"
#include "shapetonRemarks.h"

#include <string>

namespace shapeton
{
/** The reader of an examination. \ingroup ShapetonColonTools */
struct ColonDicomReader
{
  /** Path of a verdicts.json saved by the viewer page of `exam`; if empty, no reader's report is written. */
  std::string verdicts;
  /** Folder of the run with all positions. */
  std::string exam;
  /** Position of the series: 0, or 1 for the folder `second` of the run. */
  std::size_t position{ 0 };
  /** DICOM person name, see RequireDicomPersonName(). */
  std::string observer{ "anonymous" };
};

/** Options for writing the results of an examination. \ingroup ShapetonColonTools */
struct ColonDicomOptions : public ColonDicomObjectOptions
{
  ColonDicomReader reader;
  /** Progress receiver; its stages are "Reading" and the file names. */
  Progress progress;
};

/** Writes the results of VirtualColonoscopy for one series as DICOM objects: seg.dcm (lumen, heads of
 * candidates), seg-anatomy.dcm (segments of the colon, terminal ileum, folds), sr.dcm (TID 1500), cad.dcm (Colon CAD
 * SR), sc.dcm (the flat colon), stl.dcm (the wall); with a reader, also sr-reader.dcm (TID 1500: accepted polyps, and
 * the category that the reader entered). With `fhir`, fhir.json describes them as a FHIR R4 bundle.
 *
 * \param exam the folder of the run, or its folder `second`.
 * \param source the folder with the series that the run read. Its UID, its grid, and its digest in the record of the
 * segmentation are checked.
 * \param outputPath maps final names in the existing `folder` to the names to write to. Returns a list of the results
 * that are missing from the examination, and thus from the objects. Equal input gives equal bytes.
 *
 * Throws InputError if the run is unfinished, did not read DICOM, or read another series, and the InputError of
 * ReadReaderVerdicts(); ParameterError for an invalid observer; OutputError. \ingroup ShapetonColonTools */
ShapetonColonTools_EXPORT Remarks
WriteColonDicomResults(const std::string &       exam,
                       const std::string &       source,
                       const std::string &       folder,
                       const ColonDicomOptions & options,
                       const OutputPath &        outputPath);
} // namespace shapeton

#endif
