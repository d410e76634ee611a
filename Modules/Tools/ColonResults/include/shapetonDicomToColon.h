#ifndef shapetonDicomToColon_h
#define shapetonDicomToColon_h

#include "ColonResultsExport.h"
#include "shapetonCsvTable.h"
#include "shapetonDicomReportReader.h"
#include "shapetonDicomSegmentationReader.h"
#include "shapetonSlicerMarkups.h"

#include <vector>

namespace shapeton
{
/** \defgroup DicomToColon DICOM objects of any maker as inputs of the colon's tools
 * \ingroup ColonResults */
///@{

/** The segments that are the lumen of a colon: those of gas and of intraluminal fluid, else the only one; fluid
 * without gas is none. Throws InputError, with a list of all, where that cannot be told. */
ColonResults_EXPORT std::vector<int>
                    LumenSegmentsOf(const DicomSegmentationFile & file);

/** The numbers of all segments. */
ColonResults_EXPORT std::vector<int>
                    AllSegmentsOf(const DicomSegmentationFile & file);

/** A row for each of these segments: number, name, code, scheme, meaning, voxels, volume in ml. */
ColonResults_EXPORT CsvTable
TableOfSegments(const DicomSegmentationFile & file,
                const std::vector<int> &      numbers,
                const DicomSegmentVoxels &    voxels);

/** A list of points, named as the measurements that they belong to. */
ColonResults_EXPORT std::vector<Markup>
                    MarkupsOfReport(const std::vector<DicomReportPoints> & points);
///@}
} // namespace shapeton

#endif
