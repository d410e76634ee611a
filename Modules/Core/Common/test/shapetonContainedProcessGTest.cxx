#include "shapetonContainedProcess.h"
#include "shapetonParallelFor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <thread>
#include <unistd.h>
#include <vector>

namespace
{
using shapeton::ContainedProcess;

constexpr ContainedProcess::Limits Limits{ 64u << 20, 1, 60 }; // generous, because the machine may be busy

std::string
Misbehave(const std::string & request, char * shared)
{
  if (request == "crash")
  {
    std::raise(SIGKILL);
  }
  if (request == "loop")
  {
    for (volatile unsigned int i = 0;; ++i)
    {}
  }
  if (request == "sleep")
  {
    sleep(600);
  }
  if (request == "grow")
  {
    std::vector<std::unique_ptr<char[]>> blocks;
    for (int i = 0; i < 1024; ++i)
    {
      blocks.push_back(std::make_unique<char[]>(16u << 20));
      std::memset(blocks.back().get(), 1, 16u << 20);
    }
  }
  if (request == "throw")
  {
    throw std::runtime_error("a reason");
  }
  if (request == "leave")
  {
    _exit(7);
  }
  if (shared)
  {
    std::copy(request.begin(), request.end(), shared);
  }
  return request + request;
}

std::string
FailureOf(ContainedProcess & process, const std::string & request)
{
  try
  {
    process.Call(request);
  }
  catch (const ContainedProcess::Failure & failure)
  {
    return failure.what();
  }
  return "no failure";
}
} // namespace

TEST(ContainedProcess, AnswersAndSharesMemory)
{
  ContainedProcess process(Misbehave, 16, Limits);
  EXPECT_EQ(process.Call("abc"), "abcabc");
  EXPECT_EQ(std::string(process.GetShared(), 3), "abc");
  const std::string large(1u << 20, 'x');
  ContainedProcess  echo([](const std::string & request, char *) { return request; }, 0, Limits);
  EXPECT_EQ(echo.Call(large), large);
}

TEST(ContainedProcess, DeathIsAFailureAndTheNextCallWorks)
{
  ContainedProcess process(Misbehave, 16, Limits);
  for (const std::string request : { "crash", "leave" })
  {
    EXPECT_THROW(process.Call(request), ContainedProcess::Failure) << request;
    EXPECT_EQ(process.Call("ok"), "okok") << request;
  }
}

TEST(ContainedProcess, AnExceptionArrivesWithItsMessage)
{
  ContainedProcess process(Misbehave, 16, Limits);
  EXPECT_EQ(FailureOf(process, "throw"), "a reason");
  EXPECT_EQ(process.Call("ok"), "okok");
}

TEST(ContainedProcess, ComputingTimeIsLimited)
{
  ContainedProcess process(Misbehave, 16, Limits);
  EXPECT_NE(FailureOf(process, "loop").find("of CPU time"), std::string::npos);
}

TEST(ContainedProcess, ElapsedTimeIsLimited)
{
  ContainedProcess process(Misbehave, 16, { 64u << 20, 1, 1 });
  EXPECT_EQ(FailureOf(process, "sleep"), "reading it took longer than 1 s");
}

TEST(ContainedProcess, MemoryIsLimited)
{
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the address sanitizer ends the process itself, with its own report";
#endif
  ContainedProcess process(Misbehave, 16, Limits);
  EXPECT_NE(FailureOf(process, "grow").find("64 MB of memory"), std::string::npos);
  EXPECT_EQ(process.Call("ok"), "okok");
}

/** ITK's threader stops its pool before each fork: two concurrent forks crash or hang. */
TEST(ContainedProcess, ThreadsStartProcessesBesideEachOther)
{
  const auto startSome = [] {
    for (int i = 0; i < 40; ++i)
    {
      ContainedProcess process(Misbehave, 0, Limits);
      EXPECT_EQ(process.Call("ok"), "okok");
    }
  };
  std::atomic<int> done{ 0 };
  shapeton::ParallelFor(64, [&](std::size_t) { ++done; }); // creates the pool
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
  {
    threads.emplace_back(startSome);
  }
  for (std::thread & thread : threads)
  {
    thread.join();
  }
  shapeton::ParallelFor(64, [&](std::size_t) { ++done; });
  EXPECT_EQ(done, 128);
}
