#include "shapetonToolProcess.h"

#include "itkMultiThreaderBase.h"

#include "gtest/gtest.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <ctime>
#include <iostream>
#include <regex>

#include <unistd.h>

namespace
{
using namespace tooltest;

std::string
ProvenanceWith(
  const Words & options,
  const Body &  before = [](shapeton::CommandLine &) {})
{
  const auto outcome = RunWithOptions(options, [&before](shapeton::CommandLine & commandLine) {
    before(commandLine);
    for (const auto & fact : commandLine.GetProvenance())
    {
      std::cout << fact.first << " = " << fact.second << '\n';
    }
  });
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return outcome.out;
}

TEST(CommandLineProvenance, HoldsToolFactsAndOptionsInThisOrder)
{
  const std::string provenance = ProvenanceWith({ "--untilSteady", "--size", "3,4,5", "--tag", "b", "--tag", "a" },
                                                [](shapeton::CommandLine & commandLine) {
                                                  commandLine.AddInput("inputVolume", "seriesInstanceUID:1.2.3");
                                                  commandLine.AddProvenance("repair.resampleGaps", "slices 7, 8");
                                                });
  EXPECT_EQ(provenance,
            "tool = TestTool\n"
            "version = 1.2.3\n"
            "input.inputVolume = seriesInstanceUID:1.2.3\n"
            "repair.resampleGaps = slices 7, 8\n"
            "option.gamma = 1.5\n"
            "option.steps = 100000\n"
            "option.window = -1,2.5\n"
            "option.size = 3,4,5\n"
            "option.tag = b,a\n"
            "option.solver = chebyshev\n"
            "option.untilSteady = true\n");
}

TEST(CommandLineProvenance, IsTheSameHoweverTheSameOptionsAreWritten)
{
  const std::string provenance = ProvenanceWith({});
  EXPECT_EQ(ProvenanceWith({ "-g",
                             "+1.500",
                             "--steps=1e5",
                             "--window=-1.0,25e-1",
                             "--solver",
                             "chebyshev",
                             "--untilSteady=false",
                             "--ignoreSpacing=false" }),
            provenance);
  EXPECT_EQ(ProvenanceWith({ "--offset", "-0" }), ProvenanceWith({ "--offset", "0.0" }));
  EXPECT_NE(ProvenanceWith({ "-g", "1.25" }), provenance);
  EXPECT_NE(ProvenanceWith({ "--seriesUID", "false" }), provenance) << "a string, not a boolean";
}

TEST(CommandLineProvenance, HasNoThreadsPathsOrReturnValues)
{
  const Scratch     scratch;
  const std::string provenance = ProvenanceWith({});
  EXPECT_EQ(ProvenanceWith(
              { "--threads", "3", "--table", "t.csv", "--shape", "s.json", "--quiet", "--returnparameterfile", "r" },
              [](shapeton::CommandLine & commandLine) {
                WriteText(commandLine.OutputOf("table"), "");
                commandLine.Return("meanHeat", "2");
                commandLine.Warn("a remark");
              }),
            provenance);
}

TEST(CommandLineProvenance, HasNoOptionThatChangesNoResult)
{
  const auto leaveOut = [](shapeton::CommandLine & commandLine) { commandLine.LeaveOutOfProvenance("steps"); };
  const auto provenance = ProvenanceWith({ "--steps", "7" }, leaveOut);
  EXPECT_EQ(provenance.find("steps"), std::string::npos) << provenance;
  EXPECT_EQ(provenance, ProvenanceWith({}, leaveOut));
}

TEST(CommandLineProvenance, AnInputStatedByItsIdentityIsNotStatedByItsNameToo)
{
  const std::string provenance =
    ProvenanceWith({ "--source", "/data/me/shape.json" },
                   [](shapeton::CommandLine & commandLine) { commandLine.AddInput("source", "sha256:00ff"); });
  EXPECT_NE(provenance.find("input.source = sha256:00ff\n"), std::string::npos);
  EXPECT_EQ(provenance.find("/data/me"), std::string::npos) << provenance;
  EXPECT_NE(ProvenanceWith({ "--source", "figure2.4" }).find("option.source = figure2.4\n"), std::string::npos);
}

// ---- threads ----

TEST(CommandLineThreads, SetTheGlobalNumberOfITKBeforeTheBodyRuns)
{
  const auto threadsWith = [](const Words & options) {
    return std::stoi(RunWithOptions(options, [](shapeton::CommandLine &) {
                       std::cout << itk::MultiThreaderBase::GetGlobalDefaultNumberOfThreads();
                     }).out);
  };
  const int all = threadsWith({});
  EXPECT_EQ(all, static_cast<int>(itk::MultiThreaderBase::GetGlobalDefaultNumberOfThreads()));
  EXPECT_EQ(threadsWith({ "--threads", "0" }), all);
  EXPECT_EQ(threadsWith({ "--threads", "1" }), 1);
  EXPECT_EQ(threadsWith({ "--threads", "1e1" }), 10);
}

// ---- run record ----

TEST(CommandLineRunRecord, SaysHowTheRunWent)
{
  const Scratch     scratch;
  const std::time_t before = std::time(nullptr);
  const auto        outcome =
    RunWithOptions({ "--threads", "2", "--seriesUID", "\xFF" }, [](shapeton::CommandLine & commandLine) {
      WriteText(commandLine.Output("a.nrrd"), "");
      commandLine.RecordRun("a.nrrd.run.json");
      commandLine.Warn("a \"remark\"");
      commandLine.Progress("First", 0.1);
      usleep(20000);
      commandLine.Progress("Second", 0.6);
    });
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(NamesIn(), Words({ "a.nrrd", "a.nrrd.run.json" }));
  const auto record = nlohmann::json::parse(ReadText("a.nrrd.run.json"));
  EXPECT_EQ(record.at("tool"), "TestTool");
  EXPECT_EQ(record.at("version"), "1.2.3");
  EXPECT_EQ(record.at("arguments"),
            nlohmann::json({ "in.nrrd", "out.nrrd", "--threads", "2", "--seriesUID", "\xEF\xBF\xBD" }));
  EXPECT_EQ(record.at("threads"), 2);
  EXPECT_EQ(record.at("warnings"), nlohmann::json({ "a \"remark\"" }));
  EXPECT_GE(record.at("seconds").get<double>(), 0.02);
  EXPECT_LT(record.at("seconds").get<double>(), 60.0);
  char host[256] = {};
  gethostname(host, sizeof(host) - 1);
  EXPECT_EQ(record.at("host"), host);
  EXPECT_GE(record.at("stages").at("First").get<double>(), 0.02);
  EXPECT_LT(record.at("stages").at("Second").get<double>(), record.at("seconds").get<double>());
  EXPECT_EQ(record.at("stages").size(), 2u);
  EXPECT_EQ(record.size(), 9u);

  const std::string start = record.at("start");
  std::tm           parts{};
  ASSERT_NE(strptime(start.c_str(), "%Y-%m-%dT%H:%M:%SZ", &parts), nullptr) << start;
  EXPECT_GE(timegm(&parts), before - 1);
  EXPECT_LE(timegm(&parts), std::time(nullptr));
}

TEST(CommandLineRunRecord, IsAnOutputLikeAnyOther)
{
  const Scratch scratch;
  const auto    outcome = RunWithOptions({}, [](shapeton::CommandLine & commandLine) {
    commandLine.RecordRun("a.run.json");
    throw std::runtime_error("no");
  });
  EXPECT_EQ(outcome.status, 1);
  EXPECT_TRUE(NamesIn().empty());
}

// ---- return values ----

TEST(CommandLineReturn, ValuesAreLines)
{
  const Scratch scratch;
  WriteText("r.txt", "old");
  for (const Words & options : { Words{ "--returnparameterfile", "r.txt" }, Words{ "--returnparameterfile=r.txt" } })
  {
    const auto outcome = RunWithOptions(options, [](shapeton::CommandLine & commandLine) {
      commandLine.Return("remark", "two\nlines");
      commandLine.Return("meanHeat", "1");
      commandLine.Return("meanHeat", "0.25");
    });
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(ReadText("r.txt"), "meanHeat = 0.25\nremark = two lines\n");
  }
}

TEST(CommandLineReturn, WithoutAFileNothingIsWritten)
{
  const Scratch scratch;
  const auto    outcome =
    RunWithOptions({}, [](shapeton::CommandLine & commandLine) { commandLine.Return("meanHeat", "1"); });
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out + outcome.err, "");
  EXPECT_TRUE(NamesIn().empty());
}

TEST(CommandLineReturn, AFileThatCannotBeWrittenIsRefusedBeforeTheWork)
{
  const Scratch scratch;
  const auto    outcome = RunWithOptions({ "--returnparameterfile", "/proc/no/r.txt" },
                                      [](shapeton::CommandLine &) { std::cout << "hours of work"; });
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err, "TestTool: cannot write \"/proc/no\": No such file or directory; choose a writable folder\n");
}

TEST(CommandLineReturn, OnlySimpleOutputParametersReturnValues)
{
  for (const std::string name : { "gamma", "outputVolume", "table" })
  {
    const auto outcome =
      RunWithOptions({}, [&name](shapeton::CommandLine & commandLine) { commandLine.Return(name, "1"); });
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.err, "TestTool: \"" + name + "\" is not an output parameter of a simple type\n");
  }
}
} // namespace
