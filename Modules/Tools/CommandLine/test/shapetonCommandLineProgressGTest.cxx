#include "shapetonToolProcess.h"

#include "itkImage.h"
#include "itkImageSource.h"
#include "shapetonExceptions.h"
#include "shapetonTestXml.h"

#include "gtest/gtest.h"

#include <algorithm>
#include <chrono>
#include <iostream>
#include <limits>
#include <regex>
#include <sstream>
#include <thread>

namespace
{
using namespace tooltest;

/** The elements of the output of a tool. */
basetest::XmlPage
ReadXml(const std::string & fragment)
{
  return basetest::XmlPage("<all>" + fragment + "</all>");
}

std::vector<double>
NumbersOf(const basetest::XmlPage & page, const std::string & tag)
{
  std::vector<double> numbers;
  for (const auto & text : page.TextsOf(tag))
  {
    numbers.push_back(std::stod(text));
  }
  return numbers;
}

void
TwoStages(shapeton::CommandLine & commandLine)
{
  for (int i = 0; i <= 500; ++i)
  {
    commandLine.Progress("Diffusing <1> & \"more\"", 0.5 * i / 500);
  }
  for (int i = 0; i <= 500; ++i)
  {
    commandLine.Progress("Classifying", 0.5 + 0.5 * i / 500);
  }
}

TEST(CommandLineProgress, IsWellFormedMonotoneAndShort)
{
  const auto outcome = RunWithOptions({}, TwoStages);
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, "");
  const auto page = ReadXml(outcome.out);
  const auto progress = NumbersOf(page, "filter-progress");
  EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
  EXPECT_EQ(progress.front(), 0.0);
  EXPECT_EQ(progress.back(), 1.0);
  EXPECT_EQ(std::count(progress.begin(), progress.end(), 1.0), 1);
  EXPECT_GE(progress.size(), 50u);
  EXPECT_LE(progress.size(), 110u);
  const Words stages = { "Diffusing <1> & \"more\"", "Classifying" };
  EXPECT_EQ(page.TextsOf("filter-comment"), stages);
  EXPECT_EQ(page.TextsOf("filter-start").size(), 2u);
  EXPECT_EQ(page.TextsOf("filter-end").size(), 2u);
  EXPECT_EQ(page.TextsOf("filter-name"), Words({ stages[0], stages[0], stages[1], stages[1] })) << "start and end";
  for (const double seconds : NumbersOf(page, "filter-time"))
  {
    EXPECT_GE(seconds, 0.0);
    EXPECT_LT(seconds, 60.0);
  }
}

TEST(CommandLineProgress, IsForcedIntoItsRangeAndNeverGoesBack)
{
  const auto outcome = RunWithOptions({}, [](shapeton::CommandLine & commandLine) {
    for (const double fraction : { -1.0,
                                   0.5,
                                   0.2,
                                   std::numeric_limits<double>::quiet_NaN(),
                                   0.7,
                                   7.0,
                                   std::numeric_limits<double>::infinity(),
                                   0.1 })
    {
      commandLine.Progress("Work", fraction);
    }
  });
  EXPECT_EQ(NumbersOf(ReadXml(outcome.out), "filter-progress"), std::vector<double>({ 0.0, 0.5, 0.7, 1.0 }));
}

TEST(CommandLineProgress, OfAFailedRunIsWellFormedToo)
{
  const auto outcome = RunWithOptions({}, [](shapeton::CommandLine & commandLine) {
    commandLine.Progress("Work", 0.5);
    throw shapeton::InputError("no");
  });
  EXPECT_EQ(outcome.status, 3);
  EXPECT_EQ(outcome.err, "TestTool: no\n");
  EXPECT_EQ(ReadXml(outcome.out).TextsOf("filter-end").size(), 1u);
}

TEST(CommandLineProgress, ReachesOneOnceAndWhenTheBodyHasReturned)
{
  const auto reported = [](const std::vector<double> & fractions, bool fails) {
    const auto outcome = RunWithOptions({}, [&](shapeton::CommandLine & commandLine) {
      for (std::size_t i = 0; i < fractions.size(); ++i)
      {
        commandLine.Progress("Stage " + std::to_string(i), fractions[i]);
      }
      shapeton::RequireParameter(!fails, "no");
    });
    return NumbersOf(ReadXml(outcome.out), "filter-progress");
  };
  EXPECT_EQ(reported({ 0.25 }, false), std::vector<double>({ 0.25, 1.0 }));
  EXPECT_EQ(reported({ 0.25, 1.0, 1.0, 1.0 }, false), std::vector<double>({ 0.25, 1.0 }));
  EXPECT_EQ(reported({ 1.0 }, false), std::vector<double>({ 1.0 }));
  EXPECT_EQ(reported({ 0.25, 1.0 }, true), std::vector<double>({ 0.25 }));
}

TEST(CommandLineProgress, WithoutAStageContinuesTheLastOne)
{
  const auto outcome = RunWithOptions({}, [](shapeton::CommandLine & commandLine) {
    commandLine.Progress("Work", 0.25);
    commandLine.Progress("", 0.5);
  });
  const auto page = ReadXml(outcome.out);
  EXPECT_EQ(NumbersOf(page, "filter-progress"), std::vector<double>({ 0.25, 0.5, 1.0 }));
  EXPECT_EQ(page.TextsOf("filter-name"), Words({ "Work", "Work" }));
}

TEST(CommandLineProgress, IsSilentWithQuietOrWithoutReports)
{
  const Body talkative = [](shapeton::CommandLine & commandLine) {
    TwoStages(commandLine);
    commandLine.Warn("a remark");
  };
  EXPECT_EQ(RunWithOptions({ "--quiet" }, talkative).out, "");
  EXPECT_EQ(RunWithOptions({ "--quiet=true" }, talkative).out, "");
  EXPECT_NE(RunWithOptions({ "--quiet=false" }, talkative).out, "");
  EXPECT_EQ(RunWithOptions({}, [](shapeton::CommandLine &) {}).out, "");
  EXPECT_EQ(RunWithOptions({ "--quiet=1" }, talkative).err, "TestTool: --quiet: \"1\" is neither true nor false\n");
}

TEST(CommandLineProgress, WarningsAreKeptAndToldAsWellFormedComments)
{
  const std::string remark = "slices 3 <and> 4 & \"5\"\nof \x01\x1B[31m\xFF\xEF\xBF\xBE\xED\xA0\x80 \xC3\xA4";
  const auto        outcome = RunWithOptions({}, [&](shapeton::CommandLine & commandLine) {
    commandLine.Warn(remark);
    commandLine.Warn("another");
    if (commandLine.GetWarnings() != Words({ remark, "another" }))
    {
      throw std::logic_error("warnings are not stored");
    }
  });
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(ReadXml(outcome.out).TextsOf("filter-comment"),
            Words({ "slices 3 <and> 4 & \"5\" of [31m????? \xC3\xA4", "another" }));
}

/** A source that reports progress step by step. */
class SlowSource : public itk::ImageSource<itk::Image<float, 3>>
{
public:
  using Self = SlowSource;
  using Pointer = itk::SmartPointer<Self>;
  itkFactorylessNewMacro(Self);

protected:
  void
  GenerateOutputInformation() override
  {}
  void
  GenerateData() override
  {
    for (const float progress : { 0.0f, 0.25f, 0.5f, 1.0f })
    {
      this->UpdateProgress(progress);
    }
  }
};

TEST(CommandLineProgress, OfAFilterIsItsShareOfTheRun)
{
  const auto   outcome = RunWithOptions({}, [](shapeton::CommandLine & commandLine) {
    auto source = SlowSource::New();
    commandLine.Watch(source, "Diffusing", 0.2, 0.4);
    source->Update();
    commandLine.Progress("Writing", 0.8);
  });
  const auto   page = ReadXml(outcome.out);
  const auto   progress = NumbersOf(page, "filter-progress");
  const auto   ofStage = NumbersOf(page, "filter-stage-progress");
  const double expected[] = { 0.2, 0.3, 0.4, 0.6, 0.8, 1.0 };
  const double expectedOfStage[] = { 0.0, 0.25, 0.5, 1.0 };
  ASSERT_EQ(progress.size(), 6u) << outcome.out;
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_NEAR(progress[i], expected[i], 1e-6);
  }
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_NEAR(ofStage[i], expectedOfStage[i], 1e-6);
  }
}

TEST(CommandLineProgress, ByDefaultAFilterIsTheWholeRun)
{
  const auto outcome = RunWithOptions({}, [](shapeton::CommandLine & commandLine) {
    auto source = SlowSource::New();
    commandLine.Watch(source, "Diffusing");
    source->Update();
    source->Modified();
    source->Update(); // again: the progress does not decrease
  });
  EXPECT_EQ(NumbersOf(ReadXml(outcome.out), "filter-progress"), std::vector<double>({ 0.0, 0.25, 0.5, 1.0 }));
}

TEST(CommandLineProgress, MayComeFromManyThreads)
{
  const auto outcome = RunWithOptions({}, [](shapeton::CommandLine & commandLine) {
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t)
    {
      threads.emplace_back([&commandLine, t] {
        for (int i = 0; i <= 1000; ++i)
        {
          commandLine.Progress(t % 2 ? "Odd" : "Even", i / 1000.0);
        }
      });
    }
    for (auto & thread : threads)
    {
      thread.join();
    }
  });
  const auto progress = NumbersOf(ReadXml(outcome.out), "filter-progress");
  EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
  EXPECT_EQ(progress.back(), 1.0);
}

TEST(CommandLineProgress, HasAFullStopInEveryLocale)
{
  const auto outcome = InProcess([] {
    std::locale::global(std::locale(std::locale::classic(), new Comma));
    return RunHere({ "in", "out" }, [](shapeton::CommandLine & commandLine) { commandLine.Progress("Work", 0.5); });
  });
  EXPECT_NE(outcome.out.find("<filter-progress>0.500000</filter-progress>"), std::string::npos) << outcome.out;
}

// ---- on a terminal ----

/** Lines shown by a terminal after `text`. Supports only carriage returns, line feeds and printable characters. */
Words
LinesShown(const std::string & text)
{
  Words       lines{ "" };
  std::size_t column = 0;
  for (const char c : text)
  {
    if (c == '\r')
    {
      column = 0;
      continue;
    }
    if (c == '\n')
    {
      lines.emplace_back();
      continue;
    }
    EXPECT_GE(c, ' ') << "an escape code that is not supported by all terminals";
    std::string & line = lines.back();
    line.resize(std::max(line.size(), column + 1), ' ');
    line[column++] = c;
  }
  for (auto & line : lines)
  {
    line.erase(line.find_last_not_of(' ') + 1);
  }
  return lines;
}

std::function<int()>
Tool(const Words & options, const Body & body)
{
  Words arguments = { "in", "out" };
  arguments.insert(arguments.end(), options.begin(), options.end());
  return [=] { return RunHere(arguments, body); };
}

TEST(CommandLineTerminal, ShowsABarWithTheRemainingTimeAndClearsIt)
{
  const auto outcome =
    OnTerminal(Tool({},
                    [](shapeton::CommandLine & commandLine) {
                      commandLine.Progress("Diffusing", 0.0);
                      std::this_thread::sleep_for(std::chrono::milliseconds(60));
                      commandLine.Progress("Diffusing", 0.05); // the remaining time is 19 times as long
                      commandLine.Progress("Writing", 1.0);
                    }),
               120);
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, "");
  const std::string bar(40, '=');
  const std::string blank(40, ' ');
  EXPECT_NE(outcome.out.find("[" + blank + "]   0 %  Diffusing"), std::string::npos) << outcome.out;
  std::smatch match;
  ASSERT_TRUE(std::regex_search(outcome.out, match, std::regex("\\[== {38}\\]   5 %  Diffusing  0:(\\d\\d) left")))
    << outcome.out;
  EXPECT_GE(std::stoi(match[1]), 2) << "19 times 60 ms, rounded up";
  EXPECT_NE(outcome.out.find("[" + bar + "] 100 %  Writing"), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("Writing  0:"), std::string::npos) << "no remaining time";
  EXPECT_EQ(outcome.out.find('<'), std::string::npos) << "no XML";
  EXPECT_EQ(LinesShown(outcome.out), Words({ "" }));
}

TEST(CommandLineTerminal, StaysOnOneLineHoweverNarrow)
{
  for (const unsigned short columns : { 120, 80, 47, 20, 2, 1, 0 })
  {
    const auto outcome = OnTerminal(Tool({}, TwoStages), columns);
    EXPECT_EQ(outcome.status, 0);
    std::istringstream pieces(outcome.out);
    for (std::string piece; std::getline(pieces, piece, '\r');)
    {
      EXPECT_LT(piece.size(), columns ? columns : 80u);
    }
    EXPECT_EQ(LinesShown(outcome.out), Words({ "" }));
  }
}

TEST(CommandLineTerminal, ShowsWarningsOnLinesOfTheirOwn)
{
  const auto outcome = OnTerminal(Tool({},
                                       [](shapeton::CommandLine & commandLine) {
                                         commandLine.Progress("Diffusing", 0.5);
                                         commandLine.Warn("the bed is\nin the \x1B[5mpicture");
                                         commandLine.Progress("Diffusing", 0.9);
                                       }),
                                  80);
  EXPECT_EQ(LinesShown(outcome.out), Words({ "Note: the bed is in the [5mpicture", "" }));
}

TEST(CommandLineTerminal, AFailureBeginsOnALineOfItsOwn)
{
  const auto outcome = OnTerminal(Tool({},
                                       [](shapeton::CommandLine & commandLine) {
                                         commandLine.Progress("Diffusing", 0.5);
                                         throw shapeton::InputError("no");
                                       }),
                                  80);
  EXPECT_EQ(outcome.status, 3);
  EXPECT_EQ(LinesShown(outcome.out), Words({ "" }));
  EXPECT_EQ(outcome.err, "TestTool: no\n");
}

TEST(CommandLineTerminal, EndsWithTheNamesOfWrittenPages)
{
  const Scratch scratch;
  const auto    writePage = [](shapeton::CommandLine & commandLine) {
    commandLine.Progress("Writing", 0.5);
    for (const std::string page : { "report/index.html", "report/index.html", "other.txt" })
    {
      WriteText(commandLine.Output(page), "a page");
      commandLine.Publish(page);
    }
  };
  EXPECT_EQ(LinesShown(OnTerminal(Tool({}, writePage), 80).out), Words({ "Page: report/index.html", "" }));
  EXPECT_EQ(OnTerminal(Tool({ "--quiet" }, writePage), 80).out, "");
}

TEST(CommandLineTerminal, HelpHasItsWidth)
{
  const auto help = [] { return RunHere({ "--help" }, [](shapeton::CommandLine &) {}); };
  const auto linesOn = [&help](unsigned short columns) { return LinesShown(OnTerminal(help, columns).out); };
  for (const unsigned short columns : { 60, 80 })
  {
    for (const auto & line : linesOn(columns))
    {
      EXPECT_LE(line.size(), columns);
    }
  }
  EXPECT_GT(linesOn(60).size(), linesOn(80).size());
  EXPECT_GT(linesOn(80).size(), linesOn(100).size());
}

TEST(CommandLineTerminal, IsSilentWithQuiet) { EXPECT_EQ(OnTerminal(Tool({ "--quiet" }, TwoStages), 80).out, ""); }
} // namespace
