#ifndef shapetonDicomSegmentation_h
#define shapetonDicomSegmentation_h

#include "shapetonDicomCode.h"
#include "shapetonDicomSource.h"

#include "itkImage.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace shapeton
{
/** Labels of voxels; 0 is nothing. \ingroup DicomResults */
using DicomLabelImage = itk::Image<unsigned short, 3>;

/** A segment to be written. \ingroup DicomResults */
struct DicomSegment
{
  /** At most 64 characters, as trackingID. */
  std::string name;
  std::string description;
  DicomCode   category;
  DicomCode   type;
  /** Where in the body. */
  std::optional<DicomCode> region;
  /** By which the segment is the same thing in other objects; trackingUID is a UID. */
  std::string                  trackingID;
  std::string                  trackingUID;
  std::array<unsigned char, 3> color{ { 255, 255, 255 } };
  /** Its voxels: those of `labels` that are `label`, on the grid of the source. */
  const DicomLabelImage * labels{ nullptr };
  unsigned short          label{ 1 };
};

/** What was written. \ingroup DicomResults */
struct DicomSegmentation
{
  DicomInstance instance;
  /** The number of each segment in the file, from 1; 0 of one that has no voxel and was left out. */
  std::vector<int> numbers;
  /** Voxels of each segment. */
  std::vector<std::size_t> voxels;
};

/** Writes a binary DICOM Segmentation: a frame for each segment and slice where it has voxels. Segments may overlap.
 *
 * Frames lie in the planes of the slices that they refer to. With `isDeflated` the file is in the transfer syntax
 * Deflated Explicit VR Little Endian. Equal input gives equal bytes.
 *
 * Throws InputError where labels lie on another grid than the source, and where no segment has a voxel; OutputError.
 * \ingroup DicomResults */
DicomResults_EXPORT DicomSegmentation
WriteDicomSegmentation(const DicomSource &               source,
                       const std::vector<DicomSegment> & segments,
                       const DicomResultHeader &         header,
                       const std::string &               path,
                       bool                              isDeflated = false);
} // namespace shapeton

#endif
