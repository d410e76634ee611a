#ifndef shapetonDicomToColon_h
#define shapetonDicomToColon_h

#include "ShapetonColonToolsExport.h"
#include "shapetonCsvTable.h"
#include "shapetonDicomReportReader.h"
#include "shapetonDicomSegmentationReader.h"
#include "shapetonReaderVerdicts.h"
#include "shapetonRemarks.h"
#include "shapetonSlicerMarkups.h"

#include <vector>

namespace shapeton
{
/** \defgroup DicomToColon DICOM objects of any vendor as inputs of the colon tools
 * \ingroup ShapetonColonTools */
///@{

/** Numbers of the segments that form the colon lumen: gas and intraluminal fluid, or the only segment. Fluid without
 * gas does not count as a lumen. Throws InputError, listing all segments, if the choice is ambiguous. */
ShapetonColonTools_EXPORT std::vector<int>
                          LumenSegmentsOf(const DicomSegmentationFile & file);

/** The numbers of all segments. */
ShapetonColonTools_EXPORT std::vector<int>
                          AllSegmentsOf(const DicomSegmentationFile & file);

/** One row per given segment: number, name, code, scheme, meaning, voxels, volume in ml. */
ShapetonColonTools_EXPORT CsvTable
TableOfSegments(const DicomSegmentationFile & file,
                const std::vector<int> &      numbers,
                const DicomSegmentVoxels &    voxels);

/** Verdicts from a report that a reader saved in OHIF after loading the candidates of sr-ohif.dcm as measurements. A
 * label states a verdict if it begins with "polyp", "not a polyp" or "unsure" (case-insensitive), optionally after
 * "candidate 3:".
 *
 * A measurement of a candidate is recognized by the candidate's code as finding site, which OHIF keeps, or by its
 * label. It determines the verdict (unread without such a label) and, if the reader changed it by more than 0.05 mm,
 * the size. Any other measurement labeled as a polyp becomes a finding at its midpoint. The rest of the label becomes
 * the note.
 *
 * \param exam the examination; the report is on its position that was computed from `source`.
 * \param remarks receives the candidates that the report does not contain, and measurements without a verdict.
 * Throws InputError if no position was computed from the source, or a candidate is measured twice. */
ShapetonColonTools_EXPORT ReaderVerdicts
VerdictsOfReport(const std::vector<DicomReportPoints> & points,
                 const ColonExamination &               exam,
                 const DicomSource &                    source,
                 Remarks &                              remarks);

/** Point lists, named after their measurements. The labels of vertices of lines and of centers of circles say so;
 * `remarks` receives their numbers. */
ShapetonColonTools_EXPORT std::vector<Markup>
                          MarkupsOfReport(const std::vector<DicomReportPoints> & points, Remarks & remarks);
///@}
} // namespace shapeton

#endif
