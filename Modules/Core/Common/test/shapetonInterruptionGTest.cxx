#include "shapetonInterruption.h"
#include "shapetonParallelFor.h"

#include "itkMultiThreaderBase.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

namespace
{
using shapeton::Interruption;

struct Stop : std::runtime_error
{
  Stop() : std::runtime_error("stop") {}
};

class InterruptionWithThreads : public testing::TestWithParam<unsigned int>
{
protected:
  void
  SetUp() override
  {
    itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(GetParam());
  }
};

/** Stops at the hundredth check, and counts the checks of another thread. */
class HundredQuestions
{
public:
  void
  operator()()
  {
    m_FromOthers += std::this_thread::get_id() != m_Owner;
    if (++m_Asked == 100)
    {
      throw Stop();
    }
  }

  int
  FromOthers() const
  {
    return m_FromOthers;
  }

private:
  std::thread::id m_Owner{ std::this_thread::get_id() };
  int             m_Asked{ 0 };
  int             m_FromOthers{ 0 };
};

TEST_P(InterruptionWithThreads, EndsALoopThatReportsNothing)
{
  HundredQuestions         check;
  const Interruption       interruption(std::ref(check));
  std::atomic<std::size_t> done{ 0 };
  constexpr std::size_t    number = 1000000;
  EXPECT_THROW(shapeton::ParallelFor(number,
                                     [&](std::size_t) {
                                       ++done;
                                       std::this_thread::yield();
                                     }),
               Stop);
  EXPECT_GT(done, 0);
  EXPECT_LT(done, number);
  EXPECT_EQ(check.FromOthers(), 0);
}

TEST_P(InterruptionWithThreads, EndsLoopsWithinLoops)
{
  HundredQuestions   check;
  const Interruption interruption(std::ref(check));
  std::atomic<int>   begun{ 0 };
  EXPECT_THROW(shapeton::ParallelFor(1000,
                                     [&](std::size_t) {
                                       ++begun;
                                       shapeton::ParallelFor(1000, [](std::size_t) { std::this_thread::yield(); });
                                     }),
               Stop);
  EXPECT_LT(begun, 1000);
  EXPECT_EQ(check.FromOthers(), 0);
}

TEST_P(InterruptionWithThreads, EndsWhatOtherThreadsDoMeanwhile)
{
  HundredQuestions   check;
  const Interruption interruption(std::ref(check));
  const auto         forEver = [] {
    for (;;)
    {
      Interruption::Check();
    }
  };
  EXPECT_THROW(shapeton::ParallelInvoke(forEver, forEver), Stop);
  EXPECT_EQ(check.FromOthers(), 0);
  EXPECT_THROW(shapeton::ParallelFor(100, [](std::size_t) {}), Stop) << "an interruption is permanent";
}

TEST_P(InterruptionWithThreads, EndsWhatIsDoneBeside)
{
  HundredQuestions   check;
  const Interruption interruption(std::ref(check));
  auto               beside = shapeton::StartBeside([] {
    for (;;)
    {
      Interruption::Check();
    }
  });
  EXPECT_THROW(
    for (;;) { shapeton::ParallelFor(1000, [](std::size_t) {}); }, Stop);
  EXPECT_THROW(beside.Get(), Stop);
}

INSTANTIATE_TEST_SUITE_P(Threads, InterruptionWithThreads, testing::Values(1, 2, 5));

TEST(Interruption, IsAskedNowAndThenByShortSteps)
{
  HundredQuestions           check;
  const Interruption         interruption(std::ref(check));
  shapeton::RareInterruption rare;
  std::size_t                steps = 0;
  EXPECT_THROW(
    for (;; ++steps) { rare.Check(); }, Stop);
  EXPECT_GT(steps, 10000U);
  EXPECT_LT(steps, 1000000U);
}

TEST(Interruption, IsAskedByReports)
{
  int asked = 0;
  {
    const Interruption interruption([&] { ++asked; });
    const auto         outer = Interruption::OfThread();
    shapeton::Progress()("stage", 0.5);
    EXPECT_EQ(asked, 1);
    const Interruption inner([&] { throw Stop(); });
    EXPECT_NE(Interruption::OfThread(), outer);
    EXPECT_THROW(shapeton::Progress()(0.5), Stop);
    EXPECT_EQ(asked, 2) << "the outer check is called, too";
  }
  EXPECT_EQ(Interruption::OfThread(), nullptr);
  EXPECT_NO_THROW(Interruption::Check());
  EXPECT_EQ(asked, 2);
}
} // namespace
