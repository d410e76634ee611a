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
  DicomCode   category;
  DicomCode   type;
  std::string trackingUID;
};

/** A frame of a file: one segment in one plane. \ingroup DicomResults */
struct DicomSegmentFrame
{
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
  /** Of a fractional one, the value of a voxel that is wholly inside; 0 of a binary one. */
  unsigned int                    wholeValue{ 0 };
  std::vector<DicomSegmentInFile> segments;
  std::vector<DicomSegmentFrame>  frames;
};

/** Reads the header of a DICOM Segmentation of any maker: binary or fractional, not compressed or deflated; all frames
 * in parallel planes. Throws InputError that names the file and the fault. \ingroup DicomResults */
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

/** The voxels of segments on a grid, as a rule that of the source series. A voxel of a fractional segment belongs to it
 * from a half on.
 *
 * Throws InputError where a frame does not lie in a slice of the grid with the same pixels, two of a segment lie in
 * one, and for a file that is not whole; ParameterError for a number that is not there, or twice. \ingroup DicomResults
 */
DicomResults_EXPORT DicomSegmentVoxels
ReadDicomSegments(const DicomSegmentationFile & file, const std::vector<int> & numbers, const itk::ImageBase<3> * grid);
} // namespace shapeton

#endif
