#ifndef shapetonDicomFramePlaces_h
#define shapetonDicomFramePlaces_h

#include "shapetonDicomSegmentationReader.h"

#include "itkIndex.h"
#include "itkOffset.h"

#include <vector>

namespace shapeton
{
/** The voxels of the source grid that the pixels of a frame cover. */
struct DicomFramePlace
{
  itk::Index<3>  first;       ///< of the first pixel
  itk::Offset<3> alongRow;    ///< to the next column
  itk::Offset<3> alongColumn; ///< to the next row
};

/** The place of each frame. Frames may be smaller than the slices, mirrored, transposed, or cross the slices of a
 * regular series, but each pixel must be a voxel. Throws InputError with the difference from the slices, or if two
 * frames of a segment are in one plane. */
std::vector<DicomFramePlace>
PlacesOfFrames(const DicomSegmentationFile & file, const DicomSource & source);
} // namespace shapeton

#endif
