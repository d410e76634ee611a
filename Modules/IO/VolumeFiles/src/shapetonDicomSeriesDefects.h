#ifndef shapetonDicomSeriesDefects_h
#define shapetonDicomSeriesDefects_h

#include "shapetonDicomSeriesGeometry.h"
#include "shapetonDicomSeriesScan.h"

#include <cstddef>
#include <string>
#include <vector>

namespace shapeton
{
/** "1 slice", "2 slices". */
std::string
Count(std::size_t count, const std::string & noun);

/** "slice 3 (im0003.dcm)" for an `index` counted from 0. */
std::string
NameOfSlice(const DicomSeries & series, unsigned int index);

std::vector<unsigned int>
AllIndices(const DicomSeries & series);

/** A defect or remark that concerns the slices with these indices, counted from 0. */
DicomDefect
DefectOfSlices(const DicomSeries &               series,
               DicomDefectKind                   kind,
               const std::string &               message,
               const std::vector<unsigned int> & indices);

/** Adds the defect to the series. */
void
AddDefect(DicomSeries &                     series,
          DicomDefectKind                   kind,
          const std::string &               message,
          const std::vector<unsigned int> & indices);

/** The number of consecutive series, starting with `first`, that are single slices with one Series Instance UID and
 * share a line in the list; 1 for other series. */
std::size_t
LengthOfSingles(const std::vector<const DicomSeries *> & list, std::size_t first);

/** Adds the duplicates, gaps, spacing changes and shear found in the slices. Reads the pixels of duplicates. */
void
AddGeometryDefects(DicomSeries & series, const SlicesGeometry & geometry);
} // namespace shapeton

#endif
