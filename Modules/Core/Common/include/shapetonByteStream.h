#ifndef shapetonByteStream_h
#define shapetonByteStream_h

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace shapeton
{
/** \class ByteWriter
 * \brief Serializes numbers, strings and lists of them for transfer between two processes of one program.
 * \ingroup ShapetonCommon */
class ByteWriter
{
public:
  template <typename TValue>
  ByteWriter &
  operator&(const TValue & value)
  {
    static_assert(std::is_arithmetic<TValue>::value || std::is_enum<TValue>::value, "write members one by one");
    m_Bytes.append(reinterpret_cast<const char *>(&value), sizeof(value));
    return *this;
  }

  ByteWriter &
  operator&(const std::string & text)
  {
    *this & static_cast<std::uint64_t>(text.size());
    m_Bytes += text;
    return *this;
  }

  template <typename TValue, std::size_t VSize>
  ByteWriter &
  operator&(const TValue (&values)[VSize])
  {
    for (const TValue & value : values)
    {
      *this & value;
    }
    return *this;
  }

  /** Writes the number of elements; the caller writes the elements. */
  template <typename TElement>
  ByteWriter &
  SizeOf(const std::vector<TElement> & list)
  {
    return *this & static_cast<std::uint64_t>(list.size());
  }

  const std::string &
  GetBytes() const
  {
    return m_Bytes;
  }

private:
  std::string m_Bytes;
};

/** \class ByteReader
 * \brief Reads the data written by ByteWriter. The sender parses untrusted data, so each length is checked; throws
 * std::runtime_error if bytes are missing. \ingroup ShapetonCommon */
class ByteReader
{
public:
  explicit ByteReader(const std::string & bytes) : m_Next(bytes.data()), m_Left(bytes.size()) {}

  template <typename TValue>
  ByteReader &
  operator&(TValue & value)
  {
    static_assert(std::is_arithmetic<TValue>::value || std::is_enum<TValue>::value, "read members one by one");
    std::memcpy(&value, this->Take(sizeof(value)), sizeof(value));
    return *this;
  }

  ByteReader &
  operator&(std::string & text)
  {
    std::uint64_t size = 0;
    *this &       size;
    if (size > m_Left)
    {
      throw std::runtime_error("incomplete message");
    }
    text.assign(this->Take(size), size);
    return *this;
  }

  template <typename TValue, std::size_t VSize>
  ByteReader &
  operator&(TValue (&values)[VSize])
  {
    for (TValue & value : values)
    {
      *this & value;
    }
    return *this;
  }

  /** Resizes a list to the number of elements stated by the sender; the caller reads the elements, at least one byte
   * each. */
  template <typename TElement>
  ByteReader &
  SizeOf(std::vector<TElement> & list)
  {
    std::uint64_t size = 0;
    *this &       size;
    if (size > m_Left)
    {
      throw std::runtime_error("incomplete message");
    }
    list.resize(size);
    return *this;
  }

private:
  const char *
  Take(std::size_t size)
  {
    if (size > m_Left)
    {
      throw std::runtime_error("incomplete message");
    }
    const char * const taken = m_Next;
    m_Next += size;
    m_Left -= size;
    return taken;
  }

  const char * m_Next;
  std::size_t  m_Left;
};
} // namespace shapeton

#endif
