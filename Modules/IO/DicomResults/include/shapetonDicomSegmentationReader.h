#ifndef shapetonDicomSegmentationReader_h
#define shapetonDicomSegmentationReader_h

#include "shapetonDicomSegmentation.h"
#include "shapetonDicomSource.h"

namespace shapeton
{
/** A segment of a file. \ingroup DicomResults */
struct DicomSegmentInFile
{
  int         number{ 0 };
  std::string name;
  /** The name is what its bytes mean in their character set. */
  bool        isNameDecoded{ true };
  DicomCode   category;
  DicomCode   type;
  std::string trackingUID;
};

/** A frame of a file: one segment in one plane, all of them in a label map. \ingroup DicomResults */
struct DicomSegmentFrame
{
  /** 0 in a label map. */
  int                   segment{ 0 };
  itk::Point<double, 3> position{};
};

/** What the header of a DICOM Segmentation says. \ingroup DicomResults */
struct DicomSegmentationFile
{
  std::string path;
  std::string frameOfReferenceUID;
  /** Of the series that it refers to; empty where it names none. */
  std::string  seriesUID;
  unsigned int columns{ 0 };
  unsigned int rows{ 0 };
  /** Distance of columns, of rows, mm. */
  double spacing[2]{ 0.0, 0.0 };
  /** Along a row, then along a column. */
  double orientation[6]{};
  /** Value of a voxel that is wholly inside a fractional segment; 0 if the segmentation is not fractional. */
  unsigned int wholeValue{ 0 };
  /** Bytes of a pixel of a label map, 1 or 2; 0 if the segmentation is not a label map. */
  unsigned int bytesPerLabel{ 0 };
  /** Without those that a label map declares as background. */
  std::vector<DicomSegmentInFile> segments;
  std::vector<DicomSegmentFrame>  frames;
  /** Values of pixels of a label map that belong to no segment: 0 unless it is declared, Pixel Padding Value, and the
   * numbers of segments of the type Background (125040, DCM). */
  std::vector<int> background;
  /** What a user should know, one line each. */
  std::vector<std::string> notes;
};

/** Reads the header of a DICOM Segmentation of any maker: binary, fractional or a label map (Supplement 243, 8 or 16
 * bits, whatever its colors), not compressed or deflated; all frames in parallel planes; slices without a segment may
 * be missing. Throws InputError that names the file and the fault. \ingroup DicomResults */
DicomResults_EXPORT DicomSegmentationFile
ReadDicomSegmentation(const std::string & path);

/** Throws InputError unless a segmentation names the series of the source, or at least its frame of reference, as the
 * one that it was made on, and no other. Grids may be equal by chance. \ingroup DicomResults */
DicomResults_EXPORT void
RequireMadeOn(const DicomSegmentationFile & file, const DicomSource & source);

/** Segments as they were read. \ingroup DicomResults */
struct DicomSegmentVoxels
{
  /** The number of the segment of each voxel, 0 for none; of several the one that was asked for last. */
  DicomLabelImage::Pointer labels;
  /** Voxels of each segment that was asked for, whatever others lie over it. */
  std::vector<std::size_t> voxels;
};

/** The voxels of segments on the grid of the source series. A voxel of a fractional segment belongs to it from a half
 * on. On the grid of a tilted series (DicomSourceOptions::deshear) each slice is moved by whole pixels, so that no
 * voxel is lost or doubled.
 *
 * Throws InputError where a frame does not lie in a slice of the series with the same pixels, two of a segment lie in
 * one, and for a file that is not whole; ParameterError for a number that is not there, or twice, or 0, which means no
 * segment here. \ingroup DicomResults */
DicomResults_EXPORT DicomSegmentVoxels
ReadDicomSegments(const DicomSegmentationFile & file, const std::vector<int> & numbers, const DicomSource & source);
} // namespace shapeton

#endif
