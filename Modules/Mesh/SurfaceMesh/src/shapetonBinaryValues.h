#ifndef shapetonBinaryValues_h
#define shapetonBinaryValues_h

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>

namespace shapeton
{
/** Reads the value at `offset`, little endian unless `isBigEndian`. \pre The value is within the bytes. */
template <typename TValue>
TValue
ValueAt(const std::string & bytes, std::size_t offset, bool isBigEndian = false)
{
  char raw[sizeof(TValue)];
  std::copy_n(bytes.data() + offset, sizeof(TValue), raw);
  const std::uint16_t one = 1;
  char                low = 0;
  std::memcpy(&low, &one, 1);
  if (isBigEndian == (low == 1))
  {
    std::reverse(raw, raw + sizeof(TValue));
  }
  TValue value;
  std::memcpy(&value, raw, sizeof(TValue));
  return value;
}

/** Appends a value in little endian order. */
template <typename TValue>
void
AppendValue(std::string & bytes, TValue value)
{
  const std::uint16_t one = 1;
  char                low = 0;
  std::memcpy(&low, &one, 1);
  char raw[sizeof(TValue)];
  std::memcpy(raw, &value, sizeof(TValue));
  if (low != 1)
  {
    std::reverse(raw, raw + sizeof(TValue));
  }
  bytes.append(raw, sizeof(TValue));
}
} // namespace shapeton

#endif
