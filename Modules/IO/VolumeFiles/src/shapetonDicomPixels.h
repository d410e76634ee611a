#ifndef shapetonDicomPixels_h
#define shapetonDicomPixels_h

#include "shapetonDicomSeriesScan.h"

#include <cstddef>
#include <vector>

namespace shapeton
{
/** Converts stored pixels to intensities; padding becomes NaN. */
void
ConvertDicomPixels(const char * stored, const DicomPixelFormat & format, std::size_t count, float * intensities);

/** Reads slices of equal size into consecutive blocks of `columns` x `rows` intensities; padding becomes NaN.
 *
 * Native encodings (implicit and explicit, little and big endian, deflated) are read by DCMTK, which supports random
 * access to frames; compressed frames are decoded by GDCM, which supports all codecs. Both run in several contained
 * processes. Progress is reported for each slice processed by the calling thread. Throws InputError with the file name.
 */
void
ReadDicomSlices(const std::vector<const DicomSlice *> & slices,
                unsigned int                            columns,
                unsigned int                            rows,
                float *                                 intensities,
                const Progress &                        progress = {});
} // namespace shapeton

#endif
