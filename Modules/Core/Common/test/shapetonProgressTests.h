#ifndef shapetonProgressTests_h
#define shapetonProgressTests_h

#include "shapetonProgress.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <exception>
#include <thread>
#include <vector>

namespace shapeton::test
{
/** Thrown by a progress function to abort. */
struct Abort : std::exception
{};

/** Runs `work(progress)` to its end: reports must be made on the calling thread, ascend from 0 to `last`, and be
 * frequent enough. Then repeats it with aborts, each of which must propagate unchanged without a later report. */
template <typename TWork>
void
ExpectProgress(const TWork & work, std::size_t leastReports, double last = 1.0)
{
  const auto          caller = std::this_thread::get_id();
  std::vector<double> shares;
  work(Progress([&](double share) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    shares.push_back(share);
  }));
  ASSERT_GE(shares.size(), leastReports);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_GE(shares.front(), 0.0);
  EXPECT_NEAR(shares.back(), last, 1e-12);
  for (const double place : { 0.0, 0.25, 0.5, 0.75 })
  {
    const double limit = shares[static_cast<std::size_t>(place * static_cast<double>(shares.size()))];
    bool         isAborted = false;
    const auto   abort = [&](double share) {
      EXPECT_FALSE(isAborted) << "a report after an abort";
      isAborted = share >= limit;
      if (isAborted)
      {
        throw Abort();
      }
    };
    EXPECT_THROW(work(Progress(abort)), Abort) << "at " << limit;
  }
}
} // namespace shapeton::test

#endif
