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
/** Label of each voxel; 0 for none. \ingroup ShapetonDicomResults */
using DicomLabelImage = itk::Image<unsigned short, 3>;

/** A segment to write. \ingroup ShapetonDicomResults */
struct DicomSegment
{
  /** At most 64 characters, as trackingID. */
  std::string name;
  std::string description;
  DicomCode   category;
  DicomCode   type;
  /** Body region. */
  std::optional<DicomCode> region;
  /** Identifies the same object across DICOM instances; trackingUID is a UID. */
  std::string                  trackingID;
  std::string                  trackingUID;
  std::array<unsigned char, 3> color{ { 255, 255, 255 } };
  /** Its voxels have the value `label` in `labels`, on the grid of the source. */
  const DicomLabelImage * labels{ nullptr };
  unsigned short          label{ 1 };
};

/** The written segmentation. \ingroup ShapetonDicomResults */
struct DicomSegmentation
{
  DicomInstance instance;
  /** The number of each segment in the file, from 1; 0 for a segment without voxels, which is skipped. */
  std::vector<int> numbers;
  /** Number of voxels of each segment. */
  std::vector<std::size_t> voxels;
};

/** Writes a binary DICOM Segmentation: one frame per segment and nonempty slice. Segments may overlap.
 *
 * Frames are in the planes of the slices that they reference. With `isDeflated` the transfer syntax is Deflated
 * Explicit VR Little Endian. Output is deterministic.
 *
 * Throws InputError if the grids of labels and source differ or all segments are empty, and OutputError.
 * \ingroup ShapetonDicomResults */
ShapetonDicomResults_EXPORT DicomSegmentation
WriteDicomSegmentation(const DicomSource &               source,
                       const std::vector<DicomSegment> & segments,
                       const DicomResultHeader &         header,
                       const std::string &               path,
                       bool                              isDeflated = false);
} // namespace shapeton

#endif
