#include "shapetonSessionFrames.h"

namespace shapeton
{
std::string
TextOfJson(const Json & json)
{
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string
SessionFrame::GetBytes() const
{
  constexpr unsigned int bitsOfByte = 8;
  const std::string      text = TextOfJson(header);
  std::string            bytes;
  bytes.reserve(sizeof(std::uint32_t) + text.size() + m_Arrays.size());
  for (std::size_t i = 0; i < sizeof(std::uint32_t); ++i)
  {
    bytes += static_cast<char>(text.size() >> (bitsOfByte * i));
  }
  return bytes + text + m_Arrays;
}
} // namespace shapeton
