#include "shapetonContainedProcess.h"

#include "shapetonByteStream.h"
#include "shapetonContainedMessages.h"
#include "shapetonFileParserPath.h"

#include <system_error>

namespace shapeton
{
namespace
{
using Transfer = MessageChannel::Transfer;

// A response is a header or an error message; pixels are in shared memory.
constexpr std::uint64_t MaximumMessageBytes = 256u << 20;

// Generous, for a program on a slow network drive.
constexpr std::chrono::seconds MaximumStartTime{ 120 };

std::string
InMegabytes(std::size_t bytes)
{
  return std::to_string(bytes >> 20) + " MB";
}
} // namespace

ContainedProcess::ContainedProcess(const std::string & service, std::size_t sharedBytes, const Limits & limits)
  : m_Service(service)
{
  this->Share(sharedBytes, limits);
  this->Start();
}

void
ContainedProcess::Share(std::size_t sharedBytes, const Limits & limits)
{
  m_Limits = limits;
  if (sharedBytes > 0)
  {
    m_Shared.Grow(sharedBytes);
  }
}

void
ContainedProcess::Start()
{
  const std::string program = FileParserPath();
  auto              ends = MessageChannel::MakePair();
  try
  {
    m_Child =
      ChildProcess::StartIsolated(program, { m_Service }, { ends.second.GetDescriptor(), m_Shared.GetDescriptor() });
  }
  catch (const std::system_error & error)
  {
    throw std::runtime_error("cannot start the program \"" + program + "\": " + error.code().message());
  }
  m_Channel = std::move(ends.first);
  ends.second = MessageChannel(); // only the child keeps its end open
  this->Greet(program);
}

/** Waits until the program is ready. */
void
ContainedProcess::Greet(const std::string & program)
{
  char        kind = 0;
  std::string text;
  const auto  deadline = MessageChannel::Clock::now() + MaximumStartTime;
  if (m_Channel.Receive(kind, text, deadline, MaximumMessageBytes) == Transfer::complete && kind == Ready &&
      text == SHAPETON_VERSION)
  {
    return;
  }
  this->Stop();
  if (kind == Failed)
  {
    throw std::runtime_error(text);
  }
  throw std::runtime_error("the program \"" + program + "\" " +
                           (kind == Ready ? "has version " + text : std::string("cannot be run")) +
                           "; install that of " + SHAPETON_VERSION);
}

void
ContainedProcess::Stop()
{
  m_Child.Stop();
  m_Channel = MessageChannel();
}

std::string
ContainedProcess::Call(const std::string & request)
{
  if (!m_Child.IsRunning())
  {
    this->Start();
  }
  const ContainedRequest whole{ m_Shared.GetSize(), m_Limits.memoryBytes, m_Limits.cpuSeconds, request };
  ByteWriter             writer;
  Transmit(writer, whole);
  if (!m_Channel.Send(Request, writer.GetBytes()))
  {
    this->ReportDeath();
  }
  const auto  deadline = MessageChannel::Clock::now() + std::chrono::seconds(m_Limits.wallSeconds);
  char        kind = 0;
  std::string text;
  switch (m_Channel.Receive(kind, text, deadline, MaximumMessageBytes))
  {
    case Transfer::ended:
      this->ReportDeath();
    case Transfer::outOfTime:
      this->Stop();
      throw Failure("reading it took longer than " + std::to_string(m_Limits.wallSeconds) + " s");
    case Transfer::tooLarge:
      this->Stop();
      throw Failure("the file's header is larger than " + InMegabytes(MaximumMessageBytes));
    case Transfer::complete:
      break;
  }
  switch (kind)
  {
    case Done:
      return text;
    case OutOfMemory:
      this->Stop();
      throw Failure("reading it requires more than " + InMegabytes(m_Limits.memoryBytes) +
                    " of memory; the file is malformed");
    default:
      throw Failure(text);
  }
}

void
ContainedProcess::ReportDeath()
{
  const ChildProcess::End end = m_Child.Wait();
  m_Channel = MessageChannel();
  if (WasKilled(end))
  {
    throw Failure("reading it took more than " + std::to_string(m_Limits.cpuSeconds) +
                  " s of CPU time; the file is malformed");
  }
  if (end.isSignal)
  {
    throw Failure("the decoder crashed on it (signal " + std::to_string(end.number) + "); the file is malformed");
  }
  throw Failure("the decoder failed on it; the file is malformed");
}
} // namespace shapeton
