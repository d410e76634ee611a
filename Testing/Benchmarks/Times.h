#ifndef Times_h
#define Times_h

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <vector>

/** Times and bounds of benchmarks and of the validation. */

/** \class Stopwatch
 * \brief Seconds since its construction. */
class Stopwatch
{
public:
  double
  Seconds() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_Start).count();
  }
  /** Processor time of all threads, which, unlike elapsed time, hardly depends on other load. */
  double
  ProcessorSeconds() const
  {
    return static_cast<double>(std::clock() - m_ProcessorStart) / CLOCKS_PER_SEC;
  }

private:
  std::chrono::steady_clock::time_point m_Start{ std::chrono::steady_clock::now() };
  std::clock_t                          m_ProcessorStart{ std::clock() };
};

/** Elapsed and processor time of the calls of a function. */
struct Times
{
  std::vector<double> elapsed, processor;

  template <typename TFunction>
  void
  Measure(const TFunction & function)
  {
    const Stopwatch watch;
    function();
    processor.push_back(watch.ProcessorSeconds());
    elapsed.push_back(watch.Seconds());
  }
};

/** Duration of a call in seconds; the shortest if there are several. */
template <typename TBody>
double
SecondsOf(const TBody & body, int calls = 1)
{
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < calls; ++i)
  {
    const Stopwatch watch;
    body();
    least = std::min(least, watch.Seconds());
  }
  return least;
}

template <typename TBody>
double
ProcessorSecondsOf(const TBody & body)
{
  const Stopwatch watch;
  body();
  return watch.ProcessorSeconds();
}

/** Peak memory of this process. */
inline double
PeakMegabytes()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

/** Prints whether a value meets its upper or lower bound. */
inline void
PrintBound(const char * text, double value, double asked, bool isAtLeast = false)
{
  const bool isMet = isAtLeast ? value >= asked : value <= asked;
  std::printf(
    "  %-66s %10.4g   asked %s %g   %s\n", text, value, isAtLeast ? ">=" : "<=", asked, isMet ? "met" : "NOT MET");
}

/** Numbers of faces from the command line, at least 2000 each; ends the program if any is invalid. */
inline std::vector<int>
NumbersOfFaces(int argc, char * argv[], const std::vector<int> & defaults)
{
  std::vector<int> numbers;
  for (int i = 1; i < argc; ++i)
  {
    numbers.push_back(std::atoi(argv[i]));
    if (numbers.back() < 2000)
    {
      std::fprintf(stderr, "usage: %s [NUMBER OF FACES >= 2000]...\n", argv[0]);
      std::exit(2);
    }
  }
  return numbers.empty() ? defaults : numbers;
}

#endif
