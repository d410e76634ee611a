#ifndef shapetonDicomSegmentationReader_h
#define shapetonDicomSegmentationReader_h

#include "shapetonDicomSegmentation.h"
#include "shapetonDicomSource.h"

namespace shapeton
{
/** A segment of a file. \ingroup ShapetonDicomResults */
struct DicomSegmentInFile
{
  int         number{ 0 };
  std::string name;
  /** Whether the name is valid in its character set. */
  bool        isNameDecoded{ true };
  DicomCode   category;
  DicomCode   type;
  std::string trackingUID;
};

/** A frame of a file: one segment in one plane, or all segments in a label map. \ingroup ShapetonDicomResults */
struct DicomSegmentFrame
{
  /** 0 in a label map. */
  int                   segment{ 0 };
  itk::Point<double, 3> position{};
};

/** The header of a DICOM Segmentation. \ingroup ShapetonDicomResults */
struct DicomSegmentationFile
{
  std::string path;
  std::string frameOfReferenceUID;
  /** The referenced series; empty if not stated. */
  std::string  seriesUID;
  unsigned int columns{ 0 };
  unsigned int rows{ 0 };
  /** Column and row spacing, mm. */
  double spacing[2]{ 0.0, 0.0 };
  /** Direction along a row, then along a column. */
  double orientation[6]{};
  /** Value of a voxel completely inside a fractional segment; 0 if the segmentation is not fractional. */
  unsigned int wholeValue{ 0 };
  /** Bytes of a pixel of a label map, 1 or 2; 0 if the segmentation is not a label map. */
  unsigned int bytesPerLabel{ 0 };
  /** Excludes segments that a label map declares as background. */
  std::vector<DicomSegmentInFile> segments;
  std::vector<DicomSegmentFrame>  frames;
  /** Pixel values of a label map outside all segments: 0 unless declared, the Pixel Padding Value, and the numbers of
   * segments of the type Background (125040, DCM). */
  std::vector<int> background;
  /** Remarks for the user, one line each. */
  std::vector<std::string> notes;
};

/** Reads the header of a DICOM Segmentation from any vendor: binary, fractional or a label map (Supplement 243, 8 or
 * 16 bits, with any colors), uncompressed or deflated. All frames must be in parallel planes; slices without a
 * segment may be missing. Throws InputError with the file name and the error. \ingroup ShapetonDicomResults */
ShapetonDicomResults_EXPORT DicomSegmentationFile
ReadDicomSegmentation(const std::string & path);

/** Throws InputError unless the segmentation references only the series of the source, or at least its frame of
 * reference. Equal grids may be a coincidence. \ingroup ShapetonDicomResults */
ShapetonDicomResults_EXPORT void
RequireMadeOn(const DicomSegmentationFile & file, const DicomSource & source);

/** Voxels of the segments read from a file. \ingroup ShapetonDicomResults */
struct DicomSegmentVoxels
{
  /** The segment number of each voxel, 0 for none; where segments overlap, the last requested one. */
  DicomLabelImage::Pointer labels;
  /** Voxels of each requested segment, including those covered by other segments. */
  std::vector<std::size_t> voxels;
};

/** The voxels of segments on the grid of the source series. A voxel belongs to a fractional segment if its fraction is
 * at least one half. On the grid of a tilted series (DicomSourceOptions::deshear) slices are shifted by whole pixels,
 * without losing or duplicating voxels.
 *
 * Throws InputError if a frame does not match the pixels of a slice of the series, two frames of a segment are in
 * one slice, or the file is truncated. Throws ParameterError for a segment number that does not exist, is repeated, or
 * is 0 (background). \ingroup ShapetonDicomResults */
ShapetonDicomResults_EXPORT DicomSegmentVoxels
ReadDicomSegments(const DicomSegmentationFile & file, const std::vector<int> & numbers, const DicomSource & source);
} // namespace shapeton

#endif
