#include "shapetonContainedProcess.h"

#include <algorithm>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <memory>
#include <unistd.h>
#include <vector>

// The program that the tests of ContainedProcess start. Its service misbehaves on request.

namespace
{
using shapeton::ContainedProcess;
using shapeton::MessageChannel;

[[noreturn]] void
Loop()
{
  for (volatile unsigned int i = 0;; ++i)
  {}
}

void
Grow()
{
  std::vector<std::unique_ptr<char[]>> blocks;
  for (int i = 0; i < 1024; ++i)
  {
    blocks.push_back(std::make_unique<char[]>(16u << 20));
    std::memset(blocks.back().get(), 1, 16u << 20);
  }
}

std::string
ListDescriptors()
{
  std::vector<std::string> names;
  for (const auto & entry : std::filesystem::directory_iterator("/proc/self/fd"))
  {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  std::string list;
  for (const std::string & name : names)
  {
    list += name + ' ';
  }
  return list;
}

std::string
Misbehave(const std::string & request, char * shared)
{
  if (request == "crash")
  {
    std::raise(SIGKILL);
  }
  if (request == "loop")
  {
    Loop();
  }
  if (request == "sleep")
  {
    sleep(600);
  }
  if (request == "grow")
  {
    Grow();
  }
  if (request == "throw")
  {
    throw std::runtime_error("a reason");
  }
  if (request == "leave")
  {
    _exit(7);
  }
  if (request == "interrupt")
  {
    kill(getpid(), SIGINT);
  }
  if (request == "number")
  {
    return std::to_string(getpid());
  }
  if (request == "descriptors")
  {
    return ListDescriptors();
  }
  if (shared)
  {
    std::copy(request.begin(), request.end(), shared);
  }
  return request + request;
}

shapeton::ContainedService
MakeFaultyService()
{
  throw std::runtime_error("the dictionary is missing");
}

const shapeton::AddContainedServices
  services({ { "Misbehave", [] { return Misbehave; } },
             { "Echo", [] { return [](const std::string & request, char *) { return request; }; } },
             { "Faulty", MakeFaultyService } });

/** Starts a process, sends its process ID, and lets it compute until it is killed. */
int
BeParent(const MessageChannel & channel)
{
  ContainedProcess child("Misbehave", 0, { 64u << 20, 600, 600 });
  channel.Send('N', child.Call("number"));
  child.Call("loop");
  return 0;
}
} // namespace

int
main(int argc, char * argv[])
{
  const std::string service = argc > 1 ? argv[1] : "";
  if (service == "OtherVersion" || service == "Parent")
  {
    const MessageChannel channel{ shapeton::FileDescriptor(shapeton::FirstInheritedDescriptor) };
    return service == "Parent" ? BeParent(channel) : channel.Send('V', "0.1.0") ? 0 : 1;
  }
  return shapeton::ServeContained(argc, argv);
}
