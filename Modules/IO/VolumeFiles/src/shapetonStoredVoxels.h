#ifndef shapetonStoredVoxels_h
#define shapetonStoredVoxels_h

#include <cstdint>
#include <functional>
#include <string>

namespace shapeton
{
/** Largest ratio of decoded to coded bytes that the deflate format allows. */
constexpr std::uint64_t MaximumDeflateRatio = 1032;

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
  enum class Coding
  {
    raw,
    deflated,
    text
  };
  /** The file itself, or the data file referenced by a header. */
  std::string   file;
  std::uint64_t offset{ 0 };
  Coding        coding{ Coding::raw };
  /** Whether TakeVoxels() can read them. */
  bool canBeTaken{ false };
  /** Bytes before the voxels in the inflated stream. */
  std::uint64_t inflatedOffset{ 0 };
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
 * damaged files. Runs in a contained process; throws std::runtime_error. */
void
VerifyVoxels(const StoredVoxels & voxels, std::uint64_t bytes);

/** Receives a chunk of the stored bytes and its offset. */
using TakeBytes = std::function<void(std::uint64_t place, const char * piece, std::size_t size)>;

/** Passes on the first `bytes` bytes of voxels, in stored order and format, and verifies them as VerifyVoxels() does.
 * Throws std::runtime_error. */
void
TakeVoxels(const StoredVoxels & voxels, std::uint64_t bytes, const TakeBytes & take);
} // namespace shapeton

#endif
