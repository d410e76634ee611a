#ifndef shapetonContainedMessages_h
#define shapetonContainedMessages_h

#include <cstdint>
#include <string>

namespace shapeton
{
/** \name Kinds of messages between ContainedProcess and its program */
///@{
/** The first message of the program: its version. */
constexpr char Ready = 'V';
constexpr char Request = 'R';
constexpr char Done = 'D';
constexpr char Failed = 'F';
constexpr char OutOfMemory = 'M';
///@}

/** A request and its limits. */
struct ContainedRequest
{
  std::uint64_t sharedBytes{ 0 };
  std::uint64_t memoryBytes{ 0 };
  unsigned int  cpuSeconds{ 0 };
  std::string   text;
};

template <typename TStream, typename TRequest>
void
Transmit(TStream & stream, TRequest & request)
{
  stream & request.sharedBytes & request.memoryBytes & request.cpuSeconds & request.text;
}
} // namespace shapeton

#endif
