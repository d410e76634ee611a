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
  /** At most 64 characters, as trackingID; any characters in UTF-8. */
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
  /** Whether a person guided the computation, as with seeds. */
  bool isSemiautomatic{ false };
};

/** The written segmentation. \ingroup ShapetonDicomResults */
struct DicomSegmentation
{
  DicomInstance instance;
  /** The number of each segment in the file, starting at 1; 0 for a segment without voxels, which is skipped. */
  std::vector<int> numbers;
  /** Number of voxels of each segment. */
  std::vector<std::size_t> voxels;
  /** For each segment, the center of the voxel nearest to its centroid (LPS, mm); undefined if it has no voxels. */
  std::vector<std::array<double, 3>> centers;
};

/** Formats of a segmentation. \ingroup ShapetonDicomResults */
enum class DicomSegmentationFormat
{
  /** Segmentation Storage, one bit per voxel; uncompressed. */
  Binary,
  /** The same in Deflated Explicit VR Little Endian. */
  DeflatedBinary,
  /** Label Map Segmentation Storage (Supplement 243), the segment number of each voxel; RLE Lossless. */
  LabelMap,
  /** The same in Deflated Explicit VR Little Endian. */
  DeflatedLabelMap
};

/** Writes a DICOM Segmentation. A binary file has one frame per segment and nonempty slice, and its segments may
 * overlap. A label map has a frame for each slice, with 8 bits per pixel if there are at most 255 segments, otherwise
 * 16. Its background, 0, is the Pixel Padding Value and not a segment, because some viewers would otherwise shift the
 * colors of the segments.
 *
 * Frames are in the planes of the slices that they reference. Output is deterministic.
 *
 * Throws InputError if the grids of labels and source differ or all segments are empty; std::invalid_argument for
 * several label images in a label map; OutputError. \ingroup ShapetonDicomResults */
ShapetonDicomResults_EXPORT DicomSegmentation
WriteDicomSegmentation(const DicomSource &               source,
                       const std::vector<DicomSegment> & segments,
                       const DicomResultHeader &         header,
                       const std::string &               path,
                       DicomSegmentationFormat           format = DicomSegmentationFormat::Binary);
} // namespace shapeton

#endif
