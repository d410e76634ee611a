#include "shapetonReadOptions.h"

#include "shapetonToolProcess.h"

#include "gtest/gtest.h"

#include <cmath>
#include <iostream>

namespace
{
using namespace tooltest;

enum class Solver
{
  Chebyshev,
  Explicit
};

/** Like a generated struct; the tool does not declare `tolerance`. */
struct TestOptions
{
  double                               gamma{ 1.0 };
  int                                  steps{ 1 };
  bool                                 untilSteady{ false };
  Solver                               solver{ Solver::Chebyshev };
  std::string                          seriesUID;
  std::optional<std::array<double, 2>> window;
  double                               tolerance{ 0.5 };

  template <typename TOptions, typename TVisitor>
  static void
  VisitOptions(TOptions & options, const TVisitor & visit)
  {
    using shapeton::OptionInfo;
    visit(OptionInfo("gamma").AtLeast(0.0, "0").Below(10.0, "10"), options.gamma);
    visit(OptionInfo("steps").AtLeast(1.0, "1"), options.steps);
    visit(OptionInfo("untilSteady"), options.untilSteady);
    visit(OptionInfo("solver").Words({ "chebyshev", "explicit" }), options.solver);
    visit(OptionInfo("seriesUID"), options.seriesUID);
    visit(OptionInfo("window"), options.window);
    visit(OptionInfo("tolerance").Above(0.0, "0"), options.tolerance);
  }
};

/** The options as in PrintSelf, one after another, or the message of the failure. */
std::string
Read(const Words & words)
{
  const auto outcome = RunWithOptions(words, [](shapeton::CommandLine & commandLine) {
    TestOptions options;
    shapeton::ReadOptions(commandLine, options);
    TestOptions::VisitOptions(options, [](const shapeton::OptionInfo & info, const auto & option) {
      shapeton::PrintOption(std::cout << info.GetName() << ' ', info, option);
      std::cout << "; ";
    });
  });
  return outcome.status == 0 ? outcome.out : outcome.err;
}

TEST(ReadOptions, ReadsWhatTheToolDeclares)
{
  EXPECT_EQ(
    Read(
      { "--gamma", "2.5", "--steps=7", "-u", "--solver", "explicit", "--seriesUID", "1.2.3", "--window", "-160,240" }),
    "gamma 2.5; steps 7; untilSteady 1; solver explicit; seriesUID 1.2.3; window -160, 240; tolerance 0.5; ");
}

TEST(ReadOptions, TakesTheDefaultsOfTheTool)
{
  EXPECT_EQ(Read({}),
            "gamma 1.5; steps 100000; untilSteady 0; solver chebyshev; seriesUID ; window -1, 2.5; tolerance 0.5; ");
}

TEST(ReadOptions, RejectsAWindowWithoutItsLowerEndFirst)
{
  EXPECT_EQ(Read({ "--window", "3,2" }),
            "TestTool: --window requires two numbers, the lower one first, for example -160,240\n");
}

TEST(ReadOptions, CheckOptionsRejectsNumbersOutOfRange)
{
  const auto message = [](double gamma, double tolerance) -> std::string {
    TestOptions options;
    options.gamma = gamma;
    options.tolerance = tolerance;
    try
    {
      shapeton::CheckOptions(options);
    }
    catch (const itk::ExceptionObject & error)
    {
      return error.GetDescription();
    }
    return {};
  };
  EXPECT_EQ(message(0.0, 1e-9), "");
  EXPECT_EQ(message(-0.5, 0.5), "the parameter \"gamma\": -0.5 is less than the minimum 0");
  EXPECT_EQ(message(10.0, 0.5), "the parameter \"gamma\": 10 is not less than 10");
  EXPECT_EQ(message(1.0, 0.0), "the parameter \"tolerance\": 0 is not more than 0");
  EXPECT_NE(message(std::nan(""), 0.5).find("not a finite number"), std::string::npos);
}
} // namespace
