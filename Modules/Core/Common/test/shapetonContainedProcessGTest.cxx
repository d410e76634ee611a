#include "shapetonContainedProcess.h"
#include "shapetonParallelFor.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <unistd.h>
#include <vector>

namespace
{
using shapeton::ContainedProcess;

constexpr ContainedProcess::Limits Limits{ 64u << 20, 1, 60 }; // generous, because the machine may be busy

[[maybe_unused]] const int isProgramSet = setenv("SHAPETON_FILE_PARSER", SHAPETON_TEST_PROGRAM, 1);

/** The message of the constructor's error for this service and program. */
std::string
StartErrorOf(const std::string & service, const std::string & program = SHAPETON_TEST_PROGRAM)
{
  setenv("SHAPETON_FILE_PARSER", program.c_str(), 1);
  std::string message = "no error";
  try
  {
    const ContainedProcess process(service, 0, Limits);
  }
  catch (const std::runtime_error & error)
  {
    message = error.what();
  }
  setenv("SHAPETON_FILE_PARSER", SHAPETON_TEST_PROGRAM, 1);
  return message;
}

std::size_t
CountFiles(const std::string & folder)
{
  const std::filesystem::directory_iterator files(folder);
  return static_cast<std::size_t>(std::distance(begin(files), end(files)));
}

std::size_t
CountMappingsOfSharedMemory()
{
  std::ifstream maps("/proc/self/maps");
  std::size_t   count = 0;
  for (std::string line; std::getline(maps, line);)
  {
    count += line.find("memfd:shapeton") != std::string::npos ? 1 : 0;
  }
  return count;
}

/** Whether a process exists and has not ended. */
bool
IsAlive(const std::string & number)
{
  std::ifstream stat("/proc/" + number + "/stat");
  std::string   text;
  std::getline(stat, text);
  return !text.empty() && text.compare(text.rfind(')') + 2, 1, "Z") != 0;
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
  ContainedProcess process("Misbehave", 16, Limits);
  EXPECT_EQ(process.Call("abc"), "abcabc");
  EXPECT_EQ(std::string(process.GetShared(), 3), "abc");
  const std::string large(1u << 20, 'x');
  ContainedProcess  echo("Echo", 0, Limits);
  EXPECT_EQ(echo.Call(large), large);
}

TEST(ContainedProcess, DeathIsAFailureAndTheNextCallWorks)
{
  ContainedProcess process("Misbehave", 16, Limits);
  for (const std::string request : { "crash", "leave" })
  {
    EXPECT_THROW(process.Call(request), ContainedProcess::Failure) << request;
    EXPECT_EQ(process.Call("ok"), "okok") << request;
  }
}

TEST(ContainedProcess, AnExceptionArrivesWithItsMessage)
{
  ContainedProcess process("Misbehave", 16, Limits);
  EXPECT_EQ(FailureOf(process, "throw"), "a reason");
  EXPECT_EQ(process.Call("ok"), "okok");
}

TEST(ContainedProcess, ComputingTimeIsLimited)
{
  ContainedProcess process("Misbehave", 16, Limits);
  EXPECT_NE(FailureOf(process, "loop").find("of CPU time"), std::string::npos);
}

TEST(ContainedProcess, ElapsedTimeIsLimited)
{
  ContainedProcess process("Misbehave", 16, { 64u << 20, 1, 1 });
  EXPECT_EQ(FailureOf(process, "sleep"), "reading it took longer than 1 s");
}

TEST(ContainedProcess, MemoryIsLimited)
{
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the address sanitizer ends the process itself, with its own report";
#endif
  ContainedProcess process("Misbehave", 16, Limits);
  EXPECT_NE(FailureOf(process, "grow").find("64 MB of memory"), std::string::npos);
  EXPECT_EQ(process.Call("ok"), "okok");
}

TEST(ContainedProcess, SharedMemoryGrowsWithoutARestart)
{
  ContainedProcess  process("Misbehave", 0, Limits);
  const std::string number = process.Call("number");
  EXPECT_EQ(process.GetShared(), nullptr);
  process.Share(128u << 20, Limits); // more than the limit of private memory
  EXPECT_EQ(process.Call("abc"), "abcabc");
  EXPECT_EQ(std::string(process.GetShared(), 3), "abc");
  EXPECT_EQ(process.Call("number"), number);
  EXPECT_THROW(process.Call("crash"), ContainedProcess::Failure);
  EXPECT_EQ(process.Call("xyz"), "xyzxyz");
  EXPECT_EQ(std::string(process.GetShared(), 3), "xyz");
}

TEST(ContainedProcess, AnInterruptFromTheKeyboardDoesNotEndIt)
{
  ContainedProcess process("Misbehave", 0, Limits);
  EXPECT_EQ(process.Call("interrupt"), "interruptinterrupt");
}

TEST(ContainedProcess, AnUnsuitableProgramIsAClearError)
{
  EXPECT_NE(StartErrorOf("Misbehave", "/nowhere/parser").find("SHAPETON_FILE_PARSER names \"/nowhere/parser\""),
            std::string::npos);
  EXPECT_NE(StartErrorOf("Misbehave", __FILE__).find("cannot start the program"), std::string::npos);
  EXPECT_NE(StartErrorOf("Misbehave", "/bin/true").find("\"/bin/true\" cannot be run; install"), std::string::npos);
  EXPECT_NE(StartErrorOf("OtherVersion").find("has version 0.1.0; install"), std::string::npos);
  EXPECT_NE(StartErrorOf("Unknown").find("lacks the service Unknown"), std::string::npos);
  EXPECT_EQ(StartErrorOf("Faulty"), "the dictionary is missing");
}

TEST(ContainedProcess, NeitherProcessKeepsDescriptorsOrSharedMemory)
{
  const int         inherited = dup(STDERR_FILENO); // without FD_CLOEXEC
  const std::size_t descriptors = CountFiles("/proc/self/fd");
  const std::size_t names = CountFiles("/dev/shm");
  for (int i = 0; i < 3; ++i)
  {
    ContainedProcess process("Misbehave", 16, Limits);
    // The standard streams, the channel, the shared memory, and the folder being listed.
    EXPECT_EQ(process.Call("descriptors"), "0 1 2 3 4 5 ");
    EXPECT_THROW(process.Call("crash"), ContainedProcess::Failure);
    EXPECT_EQ(process.Call("ok"), "okok");
    EXPECT_EQ(CountMappingsOfSharedMemory(), 1u);
    StartErrorOf("OtherVersion");
  }
  EXPECT_EQ(CountFiles("/proc/self/fd"), descriptors);
  EXPECT_EQ(CountFiles("/dev/shm"), names);
  EXPECT_EQ(CountMappingsOfSharedMemory(), 0u);
  close(inherited);
}

TEST(ContainedProcess, EndsWithItsParentEvenWhileItComputes)
{
  auto ends = shapeton::MessageChannel::MakePair();
  auto parent =
    shapeton::ChildProcess::StartIsolated(SHAPETON_TEST_PROGRAM, { "Parent" }, { ends.second.GetDescriptor() });
  char        kind = 0;
  std::string number;
  const auto  soon = shapeton::MessageChannel::Clock::now() + std::chrono::seconds(60);
  ASSERT_EQ(ends.first.Receive(kind, number, soon, 100), shapeton::MessageChannel::Transfer::complete);
  ASSERT_TRUE(IsAlive(number));
  parent.Stop();
  while (IsAlive(number) && shapeton::MessageChannel::Clock::now() < soon)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_FALSE(IsAlive(number));
}

TEST(ContainedProcess, ThreadsStartProcessesWhileLoopsRun)
{
  std::atomic<bool> isDone{ false };
  std::atomic<int>  loops{ 0 };
  std::thread       looping([&] {
    while (!isDone)
    {
      std::atomic<int> done{ 0 };
      shapeton::ParallelFor(1000, [&](std::size_t) { ++done; });
      EXPECT_EQ(done, 1000);
      ++loops;
    }
  });
  const auto        startSome = [] {
    for (int i = 0; i < 20; ++i)
    {
      ContainedProcess process("Misbehave", 0, Limits);
      EXPECT_EQ(process.Call("ok"), "okok");
    }
  };
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
  {
    threads.emplace_back(startSome);
  }
  for (std::thread & thread : threads)
  {
    thread.join();
  }
  isDone = true;
  looping.join();
  EXPECT_GT(loops, 0);
}

TEST(ContainedProcess, WorkersOfALoopStartProcesses)
{
  std::vector<std::string> answers(40);
  shapeton::ParallelFor(answers.size(), [&](std::size_t i) {
    ContainedProcess process("Misbehave", 16, Limits);
    answers[i] = process.Call(std::to_string(i)) + ' ';
    answers[i] += process.GetShared()[0];
  });
  for (std::size_t i = 0; i < answers.size(); ++i)
  {
    const std::string text = std::to_string(i);
    EXPECT_EQ(answers[i], text + text + ' ' + text.substr(0, 1));
  }
}
