#ifndef MedianReporter_h
#define MedianReporter_h

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

/** \class MedianReporter
 * \brief Prints the usual output and stores the medians (ms), or the times of single runs, by name and arguments. */
class MedianReporter : public benchmark::ConsoleReporter
{
public:
  void
  ReportRuns(const std::vector<Run> & runs) override
  {
    ConsoleReporter::ReportRuns(runs);
    for (const Run & run : runs)
    {
      if (run.aggregate_name == "median" || (run.aggregate_name.empty() && run.repetitions <= 1))
      {
        milliseconds[run.run_name.function_name + (run.run_name.args.empty() ? "" : "/" + run.run_name.args)] =
          run.GetAdjustedRealTime();
      }
    }
  }

  std::map<std::string, double> milliseconds;
};

/** Reads the options of the library. Speed fluctuates on shared machines, so peers run in random order and medians are
 * compared. */
inline void
InitializeBenchmarks(int argc, char * argv[])
{
  std::vector<char *> arguments(argv, argv + argc);
  std::string         interleaving = "--benchmark_enable_random_interleaving=true";
  std::string         medians = "--benchmark_report_aggregates_only=true";
  arguments.insert(arguments.begin() + 1, { interleaving.data(), medians.data() });
  int number = static_cast<int>(arguments.size());
  benchmark::Initialize(&number, arguments.data());
}

/** Prints whether a ratio meets its lower or upper bound; nothing if --benchmark_filter excluded it. */
inline void
PrintRatio(const char * text, double ratio, double asked, bool isAtMost = false)
{
  if (std::isfinite(ratio) && ratio > 0.0)
  {
    const bool isMet = isAtMost ? ratio <= asked : ratio >= asked;
    std::printf(
      "%-66s %8.2f   asked %s%g   %s\n", text, ratio, isAtMost ? "<= " : "", asked, isMet ? "met" : "NOT MET");
  }
}

#endif
