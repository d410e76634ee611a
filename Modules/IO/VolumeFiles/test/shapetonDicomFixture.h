#ifndef shapetonDicomFixture_h
#define shapetonDicomFixture_h

#include "itkMatrix.h"
#include "itkPoint.h"

#include "dcmtk/config/osconfig.h"
#include "dcmtk/dcmdata/dctk.h"

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace shapeton
{
/** Valid and faulty series for tests, created with DCMTK. Intensities are a function of the position in space, so a
 * wrong geometry produces wrong intensities. */
class DicomFixture
{
public:
  using PointType = itk::Point<double, 3>;
  using File = std::unique_ptr<DcmFileFormat>;
  using Files = std::vector<File>;

  /** An affine function, which linear interpolation reproduces. */
  static double
  Ramp(const PointType & point)
  {
    return 100.0 + 7.0 * point[0] - 5.0 * point[1] + 9.0 * point[2];
  }

  unsigned int                             columns{ 7 };
  unsigned int                             rows{ 9 };
  unsigned int                             slices{ 6 };
  double                                   columnSpacing{ 0.75 };
  double                                   rowSpacing{ 1.25 };
  double                                   sliceSpacing{ 2.0 };
  itk::Matrix<double, 3, 3>                direction{ MakeIdentity() };
  PointType                                origin{ MakeOrigin() };
  std::function<double(const PointType &)> intensity{ Ramp };
  std::string                              seriesUID{ "1.2.826.0.1.3680043.10.1.1" };
  std::string                              description{ "FIXTURE" };
  std::string                              modality{ "CT" };
  int                                      seriesNumber{ 1 };
  double                                   slope{ 1.0 / 32 };
  double                                   intercept{ -50.0 };
  bool                                     isSigned{ true };
  unsigned int                             bitsStored{ 16 };

  static constexpr unsigned int bitsAllocated = 16;

  /** The first pixel of a slice, `distance` along the normal from the origin, displaced within the plane. */
  PointType
  SlicePosition(double distance, double alongRow = 0.0, double alongColumn = 0.0) const;

  /** A slice with its first pixel at `position`. */
  File
  MakeSlice(const PointType & position, int instanceNumber) const;

  /** All slices, ordered by position. */
  Files
  MakeSeries() const;

  /** An enhanced multi-frame image with a frame at each distance along the normal. */
  File
  MakeEnhanced(const std::vector<double> & distances) const;

  /** A Siemens mosaic of `slices` slices, the first at the origin, ascending or descending along the normal. */
  File
  MakeMosaic(bool isAscending) const;

  /** A label map segmentation (Supplement 243) of 8 or 16 bits with the given segments, frame positions and pixels
   * `labels`. */
  File
  MakeLabelMap(const std::vector<PointType> & frames,
               const std::vector<Uint16> &    labels,
               unsigned int                   bits,
               const std::vector<Uint16> &    segments) const;

  /** `count` slice positions: 0, spacing, 2 * spacing, ... */
  std::vector<double>
  RegularDistances() const;

  /** A rotation about an axis other than the coordinate axes. */
  static itk::Matrix<double, 3, 3>
  ObliqueDirection();

private:
  static itk::Matrix<double, 3, 3>
  MakeIdentity();
  static PointType
  MakeOrigin();
  void
  FillIdentity(DcmDataset & dataset, int instanceNumber) const;
  std::vector<Uint16>
  MakePixels(const PointType & position) const;
};

/** "a\b\c" with enough digits. */
std::string
DicomNumbers(const std::vector<double> & numbers);

/** Image Orientation (Patient) of a direction matrix. */
std::string
DicomOrientation(const itk::Matrix<double, 3, 3> & direction);

void
SetText(DcmFileFormat & file, const DcmTagKey & tag, const std::string & value);

/** The same value in each file, or a function of the number of the file. */
void
SetText(const DicomFixture::Files & files, const DcmTagKey & tag, const std::string & value);
void
SetText(const DicomFixture::Files &                     files,
        const DcmTagKey &                               tag,
        const std::function<std::string(std::size_t)> & value);

/** Stores attributes of an item with VR UN: their values become implicit VR little endian (PS3.5 6.2.2). */
void
StoreAsUnknown(DcmItem & item, const std::vector<DcmTagKey> & tags);

/** Applies StoreAsUnknown() to all attributes of an item. */
void
StoreAllAsUnknown(DcmItem & item);

/** A Siemens CSA header with the values of these elements. */
std::string
CsaHeader(const std::vector<std::pair<std::string, std::vector<std::string>>> & elements);

/** Adds a private attribute with VR UN, in the second block of its group. */
void
AddPrivate(DcmItem & item, Uint16 group, const std::string & creator, Uint16 element, const std::string & bytes);

/** Replaces the transfer syntax in a file, which must have 19 characters: explicit little endian, or RLE. */
void
StateTransferSyntax(const std::string & path, const std::string & uid);

/** Saves a file; throws std::runtime_error. */
void
SaveDicom(DcmFileFormat & file, const std::string & path, E_TransferSyntax syntax = EXS_LittleEndianExplicit);

/** Saves files as `stem`0001.dcm and so on. */
void
SaveDicom(const DicomFixture::Files & files,
          const std::string &         folder,
          E_TransferSyntax            syntax = EXS_LittleEndianExplicit,
          const std::string &         stem = "im");

/** Compresses a file in place with GDCM; `syntax` is a transfer syntax UID. */
void
CompressDicom(const std::string & path, const std::string & syntax);

/** The same for a segmentation, which GDCM does not consider an image. */
void
CompressSegmentation(const std::string & path, const std::string & syntax);

/** Replaces the pixels of a file with these compressed frames, which are encoded in this transfer syntax. */
void
ReplaceFrames(const std::string & path, std::vector<std::string> frames, const std::string & syntax);

/** Compresses the frames of an uncompressed file in place, as in Deflated Image Frame Compression. */
void
DeflateDicomFrames(const std::string & path);

/** Truncates a file after `bytes` bytes. */
void
Truncate(const std::string & path, std::size_t bytes);

/** Makes a new, empty folder. */
std::string
MakeFolder(const std::string & path);

void
WriteText(const std::string & path, const std::string & text);

/** Writes folders named after their single defect, and files that are not volumes; see the source for the list. */
void
WriteFaultyInputs(const std::string & folder);
} // namespace shapeton

#endif
