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

/** "slice 3 (im0003.dcm)"; `index` counts from 0. */
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

/** Adds it to the defects. */
void
AddDefect(DicomSeries &                     series,
          DicomDefectKind                   kind,
          const std::string &               message,
          const std::vector<unsigned int> & indices);

/** How many elements of a list of series from `first` on are single slices of one Series Instance UID: what a person
 * wants to read in one line. 1 for any other series. */
std::size_t
LengthOfSingles(const std::vector<const DicomSeries *> & list, std::size_t first);

/** Adds the duplicates, gaps, changes of spacing and shear that an examination of the slices has found. Reads the
 * pixels of duplicates. */
void
AddGeometryDefects(DicomSeries & series, const SlicesGeometry & geometry);
} // namespace shapeton

#endif
