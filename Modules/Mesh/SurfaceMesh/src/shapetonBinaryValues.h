#ifndef shapetonBinaryValues_h
#define shapetonBinaryValues_h

#include <vtkBase64Utilities.h>
#include <vtkByteSwap.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <string>
#include <type_traits>

namespace shapeton
{
/** Reads the value at `offset`, little endian unless `isBigEndian`. \pre The value is within the bytes. */
template <typename TValue>
TValue
ValueAt(const std::string & bytes, std::size_t offset, bool isBigEndian = false)
{
  TValue value;
  std::memcpy(&value, bytes.data() + offset, sizeof(TValue));
  if (isBigEndian)
  {
    vtkByteSwap::SwapBE(&value);
  }
  else
  {
    vtkByteSwap::SwapLE(&value);
  }
  return value;
}

/** A type of numbers in a file. */
struct BinaryType
{
  std::size_t size;
  bool        isInteger;
  bool        isUnsigned;                                                             ///< false for float and double
  double (*valueAt)(const std::string & bytes, std::size_t offset, bool isBigEndian); ///< see ValueAt()
};

template <typename TValue>
constexpr BinaryType
BinaryTypeOf()
{
  return { sizeof(TValue),
           std::is_integral_v<TValue>,
           std::is_unsigned_v<TValue>,
           [](const std::string & bytes, std::size_t offset, bool isBigEndian) {
             return static_cast<double>(ValueAt<TValue>(bytes, offset, isBigEndian));
           } };
}

/** Appends a value in little endian order. */
template <typename TValue>
void
AppendValue(std::string & bytes, TValue value)
{
  vtkByteSwap::SwapLE(&value);
  bytes.append(reinterpret_cast<const char *>(&value), sizeof(TValue));
}

/** Decodes `length` base64 characters, padding included; fewer bytes if one of them is invalid. */
inline std::string
DecodeBase64(const std::string & text, std::size_t begin, std::size_t length)
{
  const auto  first = text.begin() + static_cast<std::ptrdiff_t>(begin);
  const auto  last = first + static_cast<std::ptrdiff_t>(length);
  std::string bytes(length / 4 * 3, '\0');
  if (bytes.empty() || last - std::find(first, last, '=') > 2) // VTK would take more padding for zeros
  {
    return {};
  }
  bytes.resize(vtkBase64Utilities::DecodeSafely(reinterpret_cast<const unsigned char *>(text.data()) + begin,
                                                length,
                                                reinterpret_cast<unsigned char *>(bytes.data()),
                                                bytes.size()));
  return bytes;
}
} // namespace shapeton

#endif
