#ifndef shapetonSessionFrames_h
#define shapetonSessionFrames_h

#include "shapetonJson.h"

#include <string>

namespace shapeton
{
/** \class SessionFrame
 * \brief A binary message: the length of the header (4 bytes, little-endian), the header (JSON), arrays. */
class SessionFrame
{
public:
  Json header;

  template <typename TValue>
  void
  Add(const TValue * values, std::size_t number)
  {
    m_Arrays.append(reinterpret_cast<const char *>(values), number * sizeof(TValue));
  }

  std::string
  GetBytes() const;

private:
  std::string m_Arrays;
};

/** JSON as text; malformed UTF-8 is replaced. */
std::string
TextOfJson(const Json & json);
} // namespace shapeton

#endif
