#include "shapetonParallelFor.h"

#include "itkMultiThreaderBase.h"

#include "gtest/gtest.h"

#include <algorithm>
#include <atomic>
#include <cfenv>
#include <chrono>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

namespace
{
class WithThreads : public testing::TestWithParam<unsigned int>
{
protected:
  void
  SetUp() override
  {
    itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(GetParam());
  }
};

TEST_P(WithThreads, EachIndexIsTakenOnce)
{
  for (const std::size_t number : { 0, 1, 7, 4096, 4097, 20000 })
  {
    std::vector<int> single(number, 0);
    std::vector<int> blocks(number, 0);
    shapeton::ParallelFor(number, [&](std::size_t i) { ++single[i]; });
    shapeton::ParallelForBlocks(number, [&](std::size_t i) { ++blocks[i]; });
    EXPECT_EQ(single, std::vector<int>(number, 1));
    EXPECT_EQ(blocks, std::vector<int>(number, 1));
  }
}

TEST_P(WithThreads, WorkersHaveTheirOwnNumbers)
{
  std::vector<int> counts(GetParam(), 0);
  shapeton::ParallelForWorkers(1000, [&](std::size_t, unsigned int worker) { ++counts.at(worker); });
  int sum = 0;
  for (const int count : counts)
  {
    sum += count;
  }
  EXPECT_EQ(sum, 1000);
}

TEST_P(WithThreads, AnExceptionComesBack)
{
  const auto loop = [] {
    shapeton::ParallelFor(100, [](std::size_t i) {
      if (i == 37)
      {
        throw std::runtime_error("thirty-seven");
      }
    });
  };
  EXPECT_THROW(loop(), std::runtime_error);
}

TEST_P(WithThreads, InvokesTheFirstHereAndLoopsInBoth)
{
  std::thread::id  first;
  std::vector<int> counts(2000, 0);
  const auto       loop = [&counts](std::size_t begin) {
    shapeton::ParallelFor(1000, [&](std::size_t i) { ++counts[begin + i]; });
  };
  shapeton::ParallelInvoke(
    [&] {
      first = std::this_thread::get_id();
      loop(0);
    },
    [&] { loop(1000); });
  EXPECT_EQ(first, std::this_thread::get_id());
  EXPECT_EQ(counts, std::vector<int>(2000, 1));
}

TEST_P(WithThreads, OfTwoExceptionsTheFirstComesBack)
{
  const auto fail = [] { throw std::runtime_error("the first"); };
  const auto failToo = [] { throw std::logic_error("the second"); };
  EXPECT_THROW(shapeton::ParallelInvoke(fail, failToo), std::runtime_error);
  EXPECT_THROW(shapeton::ParallelInvoke([] {}, failToo), std::logic_error);
}

TEST_P(WithThreads, LoopsInLoopsInLoopsEnd)
{
  constexpr int    number = 12;
  std::atomic<int> count{ 0 };
  const auto       loops = [&count] {
    shapeton::ParallelFor(number, [&](std::size_t) {
      shapeton::ParallelFor(number, [&](std::size_t) {
        shapeton::ParallelFor(number, [&](std::size_t) {
          std::this_thread::yield();
          ++count;
        });
      });
    });
  };
  shapeton::WorkBeside beside = shapeton::StartBeside(loops);
  shapeton::ParallelInvoke(loops, loops);
  beside.Get();
  EXPECT_EQ(count, 3 * number * number * number);
}

TEST_P(WithThreads, LoopsInLoopsOfSeveralCallersEnd)
{
  constexpr int            callers = 6; // more than ITK's pool has threads
  std::atomic<int>         count{ 0 };
  std::vector<std::thread> threads;
  for (int caller = 0; caller < callers; ++caller)
  {
    threads.emplace_back([&count] {
      shapeton::ParallelFor(40, [&](std::size_t) { shapeton::ParallelFor(10, [&](std::size_t) { ++count; }); });
    });
  }
  for (std::thread & thread : threads)
  {
    thread.join();
  }
  EXPECT_EQ(count, callers * 400);
}

TEST_P(WithThreads, WorkBesideIsDoneWhenItIsWaitedFor)
{
  int  done = 0;
  auto work = shapeton::StartBeside([&done] { done = 1; });
  work.Get();
  EXPECT_EQ(done, 1);
  auto failing = shapeton::StartBeside([] { throw std::runtime_error("beside"); });
  EXPECT_THROW(failing.Get(), std::runtime_error);
}

TEST_P(WithThreads, ProgressComesFromTheCallerAndAscends)
{
  const auto          caller = std::this_thread::get_id();
  std::vector<double> shares;
  shapeton::ParallelFor(
    1000,
    [](std::size_t) { std::this_thread::yield(); },
    [&](double share) {
      EXPECT_EQ(std::this_thread::get_id(), caller);
      shares.push_back(share);
    });
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  ASSERT_FALSE(shares.empty());
  EXPECT_GT(shares.front(), 0.0);
  EXPECT_LE(shares.back(), 1.0);
}

TEST_P(WithThreads, NothingIsBegunAfterAnAbort)
{
  constexpr std::size_t    number = 100000;
  std::atomic<std::size_t> begun{ 0 };
  const auto               loop = [&] {
    shapeton::ParallelFor(
      number,
      [&](std::size_t) {
        ++begun;
        std::this_thread::sleep_for(std::chrono::microseconds(10));
      },
      [](double share) {
        if (share > 0.001)
        {
          throw std::runtime_error("stop");
        }
      });
  };
  EXPECT_THROW(loop(), std::runtime_error);
  EXPECT_LT(begun, number / 2);
}

/** Counts the threads that are inside one or more loop bodies. */
class BusyThreads
{
public:
  class Body
  {
  public:
    explicit Body(BusyThreads & busy) : m_Busy(busy)
    {
      if (s_Depth++ == 0)
      {
        const unsigned int now = ++m_Busy.m_Now;
        for (unsigned int most = m_Busy.m_Most; most < now && !m_Busy.m_Most.compare_exchange_weak(most, now);)
        {}
      }
    }
    ~Body() { m_Busy.m_Now -= --s_Depth == 0; }

  private:
    BusyThreads & m_Busy;
  };

  unsigned int
  Most() const
  {
    return m_Most;
  }

  /** Waits until `number` threads have been busy at the same time; returns whether that happened within 20 s. */
  bool
  WaitFor(unsigned int number) const
  {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (m_Most < number && std::chrono::steady_clock::now() < end)
    {
      std::this_thread::yield();
    }
    return m_Most >= number;
  }

private:
  static thread_local int   s_Depth;
  std::atomic<unsigned int> m_Now{ 0 };
  std::atomic<unsigned int> m_Most{ 0 };
};

thread_local int BusyThreads::s_Depth = 0;

TEST_P(WithThreads, AllAllowedThreadsWorkAndNoOthers)
{
  const unsigned int allowed = shapeton::NumberOfThreads();
  BusyThreads        busy;
  shapeton::ParallelFor(allowed, [&](std::size_t) {
    const BusyThreads::Body body(busy);
    EXPECT_TRUE(busy.WaitFor(allowed)) << "a loop";
  });
  EXPECT_EQ(busy.Most(), allowed);
}

TEST_P(WithThreads, NestedLoopsShareTheThreads)
{
  const unsigned int allowed = shapeton::NumberOfThreads();
  BusyThreads        busy;
  const auto         loops = [&] {
    shapeton::ParallelFor(3, [&](std::size_t) {
      const BusyThreads::Body body(busy);
      shapeton::ParallelFor(10, [&](std::size_t) {
        const BusyThreads::Body inner(busy);
        EXPECT_TRUE(busy.WaitFor(allowed)) << "nested loops";
        shapeton::ParallelFor(10, [&](std::size_t) { const BusyThreads::Body innermost(busy); });
      });
    });
  };
  shapeton::WorkBeside beside = shapeton::StartBeside(loops);
  shapeton::ParallelInvoke(loops, loops);
  beside.Get();
  EXPECT_EQ(busy.Most(), allowed);
}

TEST_P(WithThreads, AllCalculateLikeTheCaller)
{
  std::fesetround(FE_UPWARD);
  std::vector<int> modes(50, -1);
  shapeton::ParallelFor(modes.size(), [&](std::size_t i) {
    modes[i] = std::fegetround();
    std::this_thread::yield();
  });
  std::fesetround(FE_TONEAREST);
  EXPECT_EQ(modes, std::vector<int>(50, FE_UPWARD));
  shapeton::ParallelFor(modes.size(), [&](std::size_t i) { modes[i] = std::fegetround(); });
  EXPECT_EQ(modes, std::vector<int>(50, FE_TONEAREST));
}

TEST_P(WithThreads, WorkBesideThatNobodyWaitsForLeavesNoTrace)
{
  std::atomic<int> begun{ 0 };
  std::atomic<int> ended{ 0 };
  for (int i = 0; i < 100; ++i)
  {
    const shapeton::WorkBeside work = shapeton::StartBeside([&] {
      ++begun;
      std::this_thread::yield();
      ++ended;
    });
  }
  EXPECT_EQ(begun, ended);
}

TEST_P(WithThreads, AForkedProcessLoopsToo)
{
  shapeton::SourceOfThreads(); // prepares the threads of this process
  shapeton::ParallelFor(100, [](std::size_t) {});
  const pid_t child = fork();
  if (child == 0)
  {
    std::atomic<int> count{ 0 };
    shapeton::ParallelFor(100, [&](std::size_t) { ++count; });
    _exit(count == 100 && shapeton::SourceOfThreads() == std::string("ITK") ? 0 : 1);
  }
  int status = -1;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
}

TEST(ParallelFor, TellsTheSourceOfItsThreads)
{
  const char * const wanted = std::getenv("SHAPETON_THREADS_FROM");
  const bool         isItk = wanted && wanted == std::string("itk");
  EXPECT_STREQ(shapeton::SourceOfThreads(), isItk ? "ITK" : SHAPETON_TEST_THREADS);
}

INSTANTIATE_TEST_SUITE_P(Threads, WithThreads, testing::Values(1U, 2U, 3U, 8U));
} // namespace
