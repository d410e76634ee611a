#ifndef shapetonDicomToColon_h
#define shapetonDicomToColon_h

#include "ShapetonColonToolsExport.h"
#include "shapetonCsvTable.h"
#include "shapetonDicomReportReader.h"
#include "shapetonDicomSegmentationReader.h"
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

/** Point lists, named after their measurements. */
ShapetonColonTools_EXPORT std::vector<Markup>
                          MarkupsOfReport(const std::vector<DicomReportPoints> & points);
///@}
} // namespace shapeton

#endif
