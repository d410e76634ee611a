#include "shapetonOperatingSystem.h"

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <stdexcept>
#include <sys/socket.h>
#include <unistd.h>

namespace shapeton
{
namespace
{
#ifdef MSG_NOSIGNAL
constexpr int SendFlags = MSG_NOSIGNAL;
#else
constexpr int SendFlags = 0;
#endif

#ifdef SOCK_CLOEXEC
constexpr int SocketFlags = SOCK_CLOEXEC;
#else
constexpr int SocketFlags = 0;
#endif

bool
SendAll(int channel, const char * data, std::size_t size)
{
  while (size > 0)
  {
    const ssize_t sent = send(channel, data, size, SendFlags);
    if (sent < 0 && errno == EINTR)
    {
      continue;
    }
    if (sent <= 0)
    {
      return false;
    }
    data += sent;
    size -= static_cast<std::size_t>(sent);
  }
  return true;
}
} // namespace

FileDescriptor::~FileDescriptor()
{
  if (m_Number >= 0)
  {
    close(m_Number);
  }
}

std::pair<MessageChannel, MessageChannel>
MessageChannel::MakePair()
{
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SocketFlags, 0, ends) != 0)
  {
    throw std::runtime_error(std::string("cannot start the process that reads files: ") + std::strerror(errno));
  }
  for (const int end : ends)
  {
    fcntl(end, F_SETFD, FD_CLOEXEC); // for systems without SOCK_CLOEXEC
  }
  return { MessageChannel(FileDescriptor(ends[0])), MessageChannel(FileDescriptor(ends[1])) };
}

bool
MessageChannel::IsConnected() const
{
  sockaddr_storage other{};
  socklen_t        size = sizeof(other);
  return getpeername(m_End.Get(), reinterpret_cast<sockaddr *>(&other), &size) == 0 && other.ss_family == AF_UNIX;
}

bool
MessageChannel::Send(char kind, const std::string & text) const
{
  const std::uint64_t size = text.size();
  char                head[1 + sizeof(size)];
  head[0] = kind;
  std::memcpy(head + 1, &size, sizeof(size));
  return SendAll(m_End.Get(), head, sizeof(head)) && SendAll(m_End.Get(), text.data(), text.size());
}

MessageChannel::Transfer
MessageChannel::Receive(char & kind, std::string & text, Clock::time_point deadline, std::size_t maximumBytes) const
{
  std::uint64_t size = 0;
  char          head[1 + sizeof(size)];
  const auto    transfer = this->ReceiveAll(head, sizeof(head), deadline);
  if (transfer != Transfer::complete)
  {
    return transfer;
  }
  kind = head[0];
  std::memcpy(&size, head + 1, sizeof(size));
  if (size > maximumBytes)
  {
    return Transfer::tooLarge;
  }
  text.resize(size);
  return this->ReceiveAll(&text[0], text.size(), deadline);
}

MessageChannel::Transfer
MessageChannel::ReceiveAll(char * data, std::size_t size, Clock::time_point deadline) const
{
  while (size > 0)
  {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0)
    {
      return Transfer::outOfTime;
    }
    pollfd    wanted{ m_End.Get(), POLLIN, 0 };
    const int ready = poll(&wanted, 1, static_cast<int>(left < 1000 ? left : 1000));
    if (ready == 0 || (ready < 0 && errno == EINTR))
    {
      continue;
    }
    const ssize_t got = recv(m_End.Get(), data, size, 0);
    if (got < 0 && errno == EINTR)
    {
      continue;
    }
    if (got <= 0)
    {
      return Transfer::ended;
    }
    data += got;
    size -= static_cast<std::size_t>(got);
  }
  return Transfer::complete;
}
} // namespace shapeton
