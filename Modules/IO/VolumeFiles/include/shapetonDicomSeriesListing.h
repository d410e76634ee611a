#ifndef shapetonDicomSeriesListing_h
#define shapetonDicomSeriesListing_h

#include "ShapetonVolumeFilesExport.h"
#include "shapetonDicomSeriesScan.h"

#include <functional>
#include <string>

namespace shapeton
{
/** Adapts the wording of advice for a program with options instead of parameters. \ingroup ShapetonVolumeFiles */
using AdviceInWords = std::function<std::string(const std::string & advice)>;

/** Lists a folder as text: a table with one line per series (one line for all single slices of one UID); UID, encoding
 * and defects with advice for each series; and the files outside any series.
 * \ingroup ShapetonVolumeFiles */
ShapetonVolumeFiles_EXPORT std::string
                           FormatDicomScan(const DicomScan & scan, const AdviceInWords & inWords = {});

/** Writes the listing of a folder as JSON for programs. Names are stable, and file names are relative to the folder.
 * Lengths are in mm, positions in LPS. Throws OutputError.
 * \code
 * {
 *   "schema": "shapeton.dicomSeries.1",
 *   "files": 40,
 *   "series": [{
 *     "selector": "1.2.3",              VolumeReadOptions::seriesUID: UID, with "#part" for a part of a mixed series
 *     "seriesInstanceUID": "1.2.3",
 *     "part": 1,
 *     "parts": 1,
 *     "seriesNumber": 2,
 *     "description": "SUPINE",
 *     "modality": "CT",
 *     "patientPosition": "HFS",
 *     "transferSyntax": "Little Endian Explicit",
 *     "lossy": false,
 *     "plane": "axial",                 axial, coronal, sagittal or oblique; empty without a position in space
 *     "size": [96, 96, 38],             columns, rows, slices
 *     "spacing": [0.8, 0.8, 1.25],      of columns, rows, slices; 0 if unknown
 *     "origin": [-38.4, -38.4, 0],      first pixel of the first slice
 *     "direction": [1, 0, 0, 0, 1, 0, 0, 0, 1],   matrix row by row; its columns are the axes
 *     "usable": false,                  true: a volume can be read without a repair
 *     "refusal": "",                    why it is not a volume, if no defect explains it
 *     "defects": [{ "name": "gap", "message": "...", "advice": "...", "files": ["..."], "slices": [17, 18] }],
 *     "remarks": [],                    like the defects, but do not prevent reading the volume
 *     "slices": [{ "file": "im0001.dcm", "frame": 1, "instanceNumber": 1, "position": 0 }]
 *   }],
 *   "otherFiles": [{ "name": "notAnImage", "message": "...", "files": ["README"] }]
 * }
 * \endcode
 * The names of defects are those of DicomDefectKind; slices and frames count from 1.
 * \ingroup ShapetonVolumeFiles */
ShapetonVolumeFiles_EXPORT void
WriteDicomScan(const DicomScan & scan, const std::string & path, const AdviceInWords & inWords = {});
} // namespace shapeton

#endif
