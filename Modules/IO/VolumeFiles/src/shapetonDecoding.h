#ifndef shapetonDecoding_h
#define shapetonDecoding_h

#include <cstdint>
#include <functional>
#include <string>

namespace shapeton
{
/** Coding of the voxels in a file. */
enum class VoxelCoding
{
  raw,
  deflated, ///< zlib or gzip
  bzip2,
  text, ///< decimal numbers
  hex
};

/** Receives a chunk of bytes and its offset. */
using TakeBytes = std::function<void(std::uint64_t place, const char * piece, std::size_t size)>;

struct DecodedBytes
{
  std::uint64_t bytes{ 0 };
  /** Bytes of the file after the end of the compressed stream. */
  std::uint64_t trailing{ 0 };
};

/** Decodes a file from byte `offset` on, and verifies the checksums of all members of the stream. `take`, if set,
 * receives the decoded bytes. Throws std::runtime_error. */
DecodedBytes
DecodeFile(const std::string & path, std::uint64_t offset, VoxelCoding coding, const TakeBytes & take = {});
} // namespace shapeton

#endif
