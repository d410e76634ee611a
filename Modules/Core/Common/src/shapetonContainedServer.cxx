#include "shapetonContainedMessages.h"
#include "shapetonByteStream.h"
#include "shapetonContainedProcess.h"

#include <cstdlib>
#include <iostream>
#include <limits>
#include <new>

namespace shapeton
{
namespace
{
constexpr auto Never =
  MessageChannel::Clock::time_point::max() - std::chrono::hours(1); // early enough for additions to a time point

/** The services of this program. */
ContainedServices &
AllServices()
{
  static ContainedServices services;
  return services;
}

struct ContainedResponse
{
  char        kind;
  std::string text;
};

template <typename TWork>
ContainedResponse
ResponseOf(const TWork & work)
{
  try
  {
    return work();
  }
  catch (const std::bad_alloc &)
  {
    return { OutOfMemory, "" };
  }
  catch (const std::exception & error)
  {
    return { Failed, error.what() };
  }
  catch (...)
  {
    return { Failed, "unknown error" };
  }
}

ContainedResponse
CreateService(const std::string & name, ContainedService & service)
{
  return ResponseOf([&]() -> ContainedResponse {
    const auto found = AllServices().find(name);
    if (found == AllServices().end())
    {
      throw std::runtime_error("the program that reads files lacks the service " + name + "; install all of Shapeton");
    }
    service = found->second();
    return { Ready, SHAPETON_VERSION };
  });
}

/** Answers requests until the channel is closed. */
void
AnswerRequests(const MessageChannel & channel, const ContainedService & service)
{
  const MemoryLimit limit;
  SharedMemory      shared{ FileDescriptor(FirstInheritedDescriptor + 1) };
  char              kind = 0;
  for (std::string bytes; channel.Receive(kind, bytes, Never, std::numeric_limits<std::size_t>::max()) ==
                          MessageChannel::Transfer::complete;)
  {
    const ContainedResponse response = ResponseOf([&]() -> ContainedResponse {
      ContainedRequest request;
      ByteReader       reader(bytes);
      Transmit(reader, request);
      limit.Set(request.memoryBytes, request.sharedBytes);
      LimitComputingTime(request.cpuSeconds);
      if (shared.GetSize() != request.sharedBytes)
      {
        shared.Map(request.sharedBytes);
      }
      return { Done, service(request.text, shared.GetData()) };
    });
    if (!channel.Send(response.kind, response.text))
    {
      return;
    }
  }
}
} // namespace

AddContainedServices::AddContainedServices(ContainedServices services) { AllServices().merge(services); }

int
ServeContained(int argc, char * argv[])
{
  const MessageChannel channel{ FileDescriptor(FirstInheritedDescriptor) };
  if (argc != 2 || !channel.IsConnected())
  {
    std::cerr << "This program parses untrusted files for the tools and libraries of Shapeton " << SHAPETON_VERSION
              << ", which start it.\n";
    return 2;
  }
  SilenceThisProcess();
  ContainedService        service;
  const ContainedResponse ready = CreateService(argv[1], service);
  if (channel.Send(ready.kind, ready.text) && service)
  {
    AnswerRequests(channel, service);
  }
  std::_Exit(0); // the libraries must not clean up after a malformed file
}
} // namespace shapeton
