#ifndef shapetonStoredVoxels_h
#define shapetonStoredVoxels_h

#include <cstdint>
#include <functional>
#include <string>

namespace shapeton
{
/** The image formats that are no DICOM. */
enum class ImageFormat
{
  none,
  nrrd,
  nifti,
  meta
};

/** The format by the extension of a name. */
ImageFormat
ImageFormatOf(const std::string & path);

/** "NRRD", "NIfTI" or "MetaImage". */
std::string
NameOf(ImageFormat format);

/** Where the voxels of an image file lie and how they are coded. */
struct StoredVoxels
{
  enum class Coding
  {
    raw,
    deflated,
    text
  };
  /** The file itself, or the data file that a header names. */
  std::string   file;
  std::uint64_t offset{ 0 };
  Coding        coding{ Coding::raw };
  /** TakeVoxels() gives them, so that no other reader is needed. */
  bool canBeTaken{ false };
  /** Bytes of the inflated stream before the voxels. */
  std::uint64_t inflatedOffset{ 0 };
};

/** Finds the voxels by the header of a file. Throws InputError. */
StoredVoxels
LocateVoxels(const std::string & path, ImageFormat format);

/** False where the header of NRRD or MetaImage names no spacing, or none for some axis: ITK then takes 1 mm. To be
 * called for a file that ITK has read. */
bool
StatesSpacing(const std::string & path, ImageFormat format);

/** True when the file is long enough for `bytes` bytes of voxels in the worst case of its coding. Cheap: a claim that
 * fails here is not worth an allocation. */
bool
CanHold(const StoredVoxels & voxels, double bytes, double values);

/** Reads the stored bytes to their end and compares them with the need and with their checksum: ITK's reader of
 * MetaImage takes truncated and damaged files for good ones. Runs in a contained process; throws std::runtime_error. */
void
VerifyVoxels(const StoredVoxels & voxels, std::uint64_t bytes);

/** Gets a piece of the stored bytes, and its place among them. */
using TakeBytes = std::function<void(std::uint64_t place, const char * piece, std::size_t size)>;

/** Hands over the first `bytes` bytes of voxels that can be taken, in their order and as they are stored, and verifies
 * them as VerifyVoxels() does. Throws std::runtime_error. */
void
TakeVoxels(const StoredVoxels & voxels, std::uint64_t bytes, const TakeBytes & take);
} // namespace shapeton

#endif
