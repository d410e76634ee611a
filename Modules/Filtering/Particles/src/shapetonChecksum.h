#ifndef shapetonChecksum_h
#define shapetonChecksum_h

#include <cstdint>
#include <cstring>

namespace shapeton
{
/** A 64-bit checksum that detects damage and differences, not forgery. The result depends on how the bytes are divided
 * among calls.
 */
class Checksum
{
public:
  void
  Add(const void * bytes, std::size_t number)
  {
    const auto * next = static_cast<const unsigned char *>(bytes);
    for (; number >= 8; number -= 8, next += 8)
    {
      std::uint64_t word;
      std::memcpy(&word, next, 8);
      this->Mix(word);
    }
    std::uint64_t rest = number;
    if (number > 0) // the pointer may be null
    {
      std::memcpy(reinterpret_cast<unsigned char *>(&rest) + 1, next, number);
    }
    this->Mix(rest);
  }

  std::uint64_t
  Get() const
  {
    return m_Sum;
  }

private:
  void
  Mix(std::uint64_t word)
  {
    constexpr std::uint64_t goldenRatio = 0x9E3779B97F4A7C15U; // times 2^64
    m_Sum = (m_Sum ^ word) * goldenRatio;
    m_Sum ^= m_Sum >> 32;
  }

  std::uint64_t m_Sum{ 0x243F6A8885A308D3U };
};
} // namespace shapeton

#endif
