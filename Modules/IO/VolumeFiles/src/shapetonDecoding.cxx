#include "shapetonDecoding.h"

#include "itk_zlib.h"

#include <bzlib.h>

#include <fstream>
#include <memory>
#include <new>
#include <stdexcept>
#include <vector>

namespace shapeton
{
namespace
{
/** A library that decodes one member of a stream after the other. */
struct Decoder
{
  enum class Status
  {
    goesOn,
    hasEnded,
    isCorrupt
  };
  Decoder() = default;
  virtual ~Decoder() = default;
  Decoder(const Decoder &) = delete;
  Decoder &
  operator=(const Decoder &) = delete;

  /** The first byte of each further member. */
  virtual char
  Magic() const = 0;
  virtual void
  Restart() = 0;
  /** Decodes into `out` and advances all arguments. */
  virtual Status
  Decode(char *& in, unsigned int & inBytes, char *& out, unsigned int & outBytes) = 0;
};

class ZlibDecoder final : public Decoder
{
public:
  ZlibDecoder()
  {
    constexpr int detectsZlibOrGzip = 32;
    if (inflateInit2(&m_State, MAX_WBITS + detectsZlibOrGzip) != Z_OK)
    {
      throw std::bad_alloc();
    }
  }
  ~ZlibDecoder() override { inflateEnd(&m_State); }

  char
  Magic() const override
  {
    return '\x1F'; // of gzip; a zlib stream has one member
  }
  void
  Restart() override
  {
    inflateReset(&m_State);
  }
  Status
  Decode(char *& in, unsigned int & inBytes, char *& out, unsigned int & outBytes) override
  {
    m_State.next_in = reinterpret_cast<Bytef *>(in);
    m_State.avail_in = inBytes;
    m_State.next_out = reinterpret_cast<Bytef *>(out);
    m_State.avail_out = outBytes;
    const int status = inflate(&m_State, Z_NO_FLUSH);
    in = reinterpret_cast<char *>(m_State.next_in);
    inBytes = m_State.avail_in;
    out = reinterpret_cast<char *>(m_State.next_out);
    outBytes = m_State.avail_out;
    return status == Z_STREAM_END                    ? Status::hasEnded
           : status == Z_OK || status == Z_BUF_ERROR ? Status::goesOn
                                                     : Status::isCorrupt;
  }

private:
  z_stream m_State{};
};

class Bzip2Decoder final : public Decoder
{
public:
  Bzip2Decoder() { this->Start(); }
  ~Bzip2Decoder() override { BZ2_bzDecompressEnd(&m_State); }

  char
  Magic() const override
  {
    return 'B';
  }
  void
  Restart() override
  {
    BZ2_bzDecompressEnd(&m_State);
    m_State = {};
    this->Start();
  }
  Status
  Decode(char *& in, unsigned int & inBytes, char *& out, unsigned int & outBytes) override
  {
    m_State.next_in = in;
    m_State.avail_in = inBytes;
    m_State.next_out = out;
    m_State.avail_out = outBytes;
    const int status = BZ2_bzDecompress(&m_State);
    in = m_State.next_in;
    inBytes = m_State.avail_in;
    out = m_State.next_out;
    outBytes = m_State.avail_out;
    return status == BZ_STREAM_END ? Status::hasEnded : status == BZ_OK ? Status::goesOn : Status::isCorrupt;
  }

private:
  void
  Start()
  {
    if (BZ2_bzDecompressInit(&m_State, 0, 0) != BZ_OK)
    {
      throw std::bad_alloc();
    }
  }

  bz_stream m_State{};
};

/** Feeds a decoder and passes on what it returns. */
class Stream
{
public:
  Stream(VoxelCoding coding, const TakeBytes & take) : m_Take(take)
  {
    if (coding == VoxelCoding::bzip2)
    {
      m_Decoder = std::make_unique<Bzip2Decoder>();
    }
    else
    {
      m_Decoder = std::make_unique<ZlibDecoder>();
    }
  }

  void
  Take(char * in, unsigned int inBytes)
  {
    while (inBytes > 0 && m_Decoded.trailing == 0)
    {
      if (m_HasEnded && *in != m_Decoder->Magic())
      {
        break;
      }
      if (m_HasEnded)
      {
        m_Decoder->Restart();
      }
      this->Step(in, inBytes);
    }
    m_Decoded.trailing += inBytes;
  }

  DecodedBytes
  Finish() const
  {
    if (!m_HasEnded)
    {
      throw std::runtime_error("truncated: its compressed voxels end after " + std::to_string(m_Decoded.bytes) +
                               " bytes");
    }
    return m_Decoded;
  }

private:
  void
  Step(char *& in, unsigned int & inBytes)
  {
    char         buffer[1u << 16];
    char *       out = buffer;
    unsigned int outBytes = sizeof(buffer);
    const auto   status = m_Decoder->Decode(in, inBytes, out, outBytes);
    if (status == Decoder::Status::isCorrupt)
    {
      throw std::runtime_error("damaged: its compressed voxels are corrupt after " + std::to_string(m_Decoded.bytes) +
                               " bytes");
    }
    const std::size_t produced = sizeof(buffer) - outBytes;
    if (m_Take)
    {
      m_Take(m_Decoded.bytes, buffer, produced);
    }
    m_Decoded.bytes += produced;
    m_HasEnded = status == Decoder::Status::hasEnded;
  }

  std::unique_ptr<Decoder> m_Decoder;
  const TakeBytes &        m_Take;
  DecodedBytes             m_Decoded;
  bool                     m_HasEnded{ false };
};
} // namespace

DecodedBytes
DecodeFile(const std::string & path, std::uint64_t offset, VoxelCoding coding, const TakeBytes & take)
{
  std::ifstream file(path, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(offset));
  Stream            stream(coding, take);
  std::vector<char> buffer(1u << 18);
  while (file)
  {
    file.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    stream.Take(buffer.data(), static_cast<unsigned int>(file.gcount()));
  }
  return stream.Finish();
}
} // namespace shapeton
