#ifndef shapetonStoredVoxels_h
#define shapetonStoredVoxels_h

#include "shapetonDecoding.h"

#include <cstdint>
#include <string>
#include <vector>

namespace shapeton
{
/** Largest ratio of decoded to coded bytes that the deflate format allows. */
constexpr std::uint64_t MaximumDeflateRatio = 1032;
/** Largest ratio of bzip2: a block of 900,000 bytes, 5 of which stand for up to 259, takes at least 32. */
constexpr std::uint64_t MaximumBzip2Ratio = 1'500'000;

/** The supported image formats other than DICOM. */
enum class ImageFormat
{
  none,
  nrrd,
  nifti,
  meta
};

/** The format indicated by the extension of a name. */
ImageFormat
ImageFormatOf(const std::string & path);

/** "NRRD", "NIfTI" or "MetaImage". */
std::string
NameOf(ImageFormat format);

/** Location and coding of the voxels of an image file. */
struct StoredVoxels
{
  /** The file itself, or the data files referenced by a header, in order. */
  std::vector<std::string> files;
  /** Bytes before the voxels in each file. */
  std::uint64_t offset{ 0 };
  VoxelCoding   coding{ VoxelCoding::raw };
  /** Whether TakeVoxels() can read them. */
  bool canBeTaken{ false };
  /** For voxels that TakeVoxels() reads. */
  bool isBigEndian{ false };
  /** Bytes before the voxels in each inflated stream. */
  std::uint64_t inflatedOffset{ 0 };
  /** Whether they are the last ones of the file, regardless of `offset`: a negative byte skip of NRRD. */
  bool areLast{ false };
};

/** Locates the voxels from the header of a file. Throws InputError. */
StoredVoxels
LocateVoxels(const std::string & path, ImageFormat format);

/** False if a NRRD or MetaImage header lacks the spacing of an axis; ITK then assumes 1 mm. For files that ITK has
 * read. */
bool
StatesSpacing(const std::string & path, ImageFormat format);

/** Whether the file is long enough for `bytes` bytes of voxels at the highest possible compression. A cheap check
 * before any allocation. */
bool
CanHold(const StoredVoxels & voxels, double bytes, double values);

/** Reads all stored bytes and verifies their number and checksum, because ITK's MetaImage reader accepts truncated and
 * damaged files. Returns whether the files contain more than `bytes` bytes or, as text, `values` numbers. Runs in a
 * contained process; throws std::runtime_error. */
bool
VerifyVoxels(const StoredVoxels & voxels, std::uint64_t bytes, std::uint64_t values);

/** Passes on the first `bytes` bytes of voxels, in stored order and format, and verifies them as VerifyVoxels() does.
 * Returns whether there are more. Throws std::runtime_error. */
bool
TakeVoxels(const StoredVoxels & voxels, std::uint64_t bytes, const TakeBytes & take);
} // namespace shapeton

#endif
