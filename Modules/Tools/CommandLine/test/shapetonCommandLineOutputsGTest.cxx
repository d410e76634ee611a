#include "shapetonFaultySystem.h"
#include "shapetonToolProcess.h"

#include "shapetonFileBytes.h"
#include "shapetonExceptions.h"

#include "gtest/gtest.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <fstream>
#include <iostream>
#include <thread>

#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace
{
using namespace tooltest;

const std::string oldText = "the old result, which took a week\n";
const std::string newText = "new\n";

/** Writes `newText` to all `paths`. */
Body
WriterOf(const Words & paths)
{
  return [paths](shapeton::CommandLine & commandLine) {
    Words temporaries;
    for (const auto & path : paths)
    {
      temporaries.push_back(commandLine.Output(path));
    }
    for (const auto & temporary : temporaries)
    {
      WriteText(temporary, newText);
    }
  };
}

Outcome
Write(const Words & paths)
{
  return RunWithOptions({}, WriterOf(paths));
}

/** Expects that a run that writes to `path` fails before the body continues, without changes. */
void
ExpectRefused(const std::string & path, int status, const std::string & message)
{
  const Words before = NamesIn();
  const auto  outcome = RunWithOptions({}, [&path](shapeton::CommandLine & commandLine) {
    commandLine.Output(path);
    std::cout << "hours of work";
  });
  EXPECT_EQ(outcome.status, status);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err, "TestTool: " + message + "\n");
  EXPECT_EQ(NamesIn(), before);
}

bool
EndsWith(const std::string & text, const std::string & end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

TEST(CommandLineOutputs, AppearUnderTheirFinalNamesOnly)
{
  const Scratch scratch;
  const auto    outcome = Write({ "a.nrrd", "b.nii.gz" });
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(NamesIn(), Words({ "a.nrrd", "b.nii.gz" }));
  EXPECT_EQ(ReadText("a.nrrd"), newText);
  EXPECT_EQ(ReadText("b.nii.gz"), newText);
}

TEST(CommandLineOutputs, TemporaryNamesHaveTheFolderAndTheExtensionOfTheFinalOnes)
{
  const Scratch scratch;
  fs::create_directory("sub");
  const std::vector<std::pair<std::string, std::string>> cases = {
    { "heat.nrrd", ".nrrd" },
    { "sub/heat.nii.gz", ".nii.gz" },
    { "sub/points.mrk.json", ".mrk.json" },
    { "sub/report.json", ".json" },
    { "heat.v1.NII.GZ", ".NII.GZ" },
    { "plain", ".part" },
    { ".hidden", ".part" },
    { ".hidden.csv", ".csv" },
    { "two words.vp", ".vp" },
    { "Gehirn \xC3\xA4.json", ".json" },
    { "dot.", ".part." },
    { ".nii.gz", ".nii.gz" },
    { "a.part", ".part.part" },
    { "-x.png", ".png" },
  };
  for (const auto & [path, end] : cases)
  {
    const auto outcome = RunWithOptions({}, [path = path](shapeton::CommandLine & commandLine) {
      const std::string temporary = commandLine.Output(path);
      std::cout << temporary;
      if (fs::exists(temporary))
      {
        throw std::logic_error("the output exists while the tool computes");
      }
      WriteText(temporary, newText);
    });
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const fs::path temporary = outcome.out;
    EXPECT_EQ(temporary.parent_path(), (scratch.Path() / path).parent_path()) << path;
    EXPECT_TRUE(EndsWith(outcome.out, end)) << path << " -> " << outcome.out;
    EXPECT_EQ(temporary.filename().string()[0], '.') << path;
    EXPECT_NE(temporary, scratch.Path() / path);
    EXPECT_EQ(ReadText(path), newText);
  }
  EXPECT_EQ(NamesIn().size(), cases.size() - 2) << "three outputs are in the folder, which is one more name";
  EXPECT_EQ(NamesIn("sub"), Words({ "heat.nii.gz", "points.mrk.json", "report.json" }));
}

TEST(CommandLineOutputs, TheLongestNameOfAFileSystemWorks)
{
  const Scratch     scratch;
  std::string       umlauts;
  const std::string stem(250, 'x');
  for (int i = 0; i < 125; ++i)
  {
    umlauts += "\xC3\xA4";
  }
  const auto outcome = Write({ stem + ".nrrd", stem + "y.csv", std::string(255, 'z'), umlauts + ".nrrd" });
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(NamesIn(), Words({ stem + ".nrrd", stem + "y.csv", std::string(255, 'z'), umlauts + ".nrrd" }));
}

TEST(CommandLineOutputs, ShorteningCutsNoCharacterInTwo)
{
  const Scratch scratch;
  for (const std::string start : { "a", "aa", "aaa" })
  {
    std::string name = start;
    while (name.size() < 248)
    {
      name += "\xE2\x82\xAC"; // the euro sign
    }
    const auto        outcome = RunWithOptions({}, [&name](shapeton::CommandLine & commandLine) {
      const std::string temporary = commandLine.Output(name + ".nrrd");
      WriteText(temporary, newText);
      std::cout << fs::path(temporary).filename().string();
    });
    const std::string kept = outcome.out.substr(1, outcome.out.rfind(".part") - 1); // stem and tag
    const std::string stem = kept.substr(0, kept.rfind('.'));
    EXPECT_GT(stem.size(), 200u);
    EXPECT_EQ(name.compare(0, stem.size(), stem), 0);
    EXPECT_EQ((stem.size() - start.size()) % 3, 0u) << "whole euro signs";
  }
}

TEST(CommandLineOutputs, NamesThatAreShortenedAlikeStayTwoFiles)
{
  const Scratch     scratch;
  const std::string stem(249, 'x');
  EXPECT_EQ(Write({ stem + "1.nrrd", stem + "2.nrrd" }).status, 0);
  EXPECT_EQ(NamesIn(), Words({ stem + "1.nrrd", stem + "2.nrrd" }));
}

TEST(CommandLineOutputs, OutputOfIsEmptyForAnOptionThatWasNotGiven)
{
  const Scratch scratch;
  const Body    body = [](shapeton::CommandLine & commandLine) {
    const std::string table = commandLine.OutputOf("table");
    std::cout << table.empty();
    if (!table.empty())
    {
      WriteText(table, newText);
    }
  };
  EXPECT_EQ(RunWithOptions({}, body).out, "1");
  EXPECT_EQ(RunWithOptions({ "--table", "t.csv" }, body).out, "0");
  EXPECT_EQ(NamesIn(), Words({ "t.csv" }));
}

TEST(CommandLineOutputs, AFailedRunKeepsTheOldResultAndLeavesNothingElse)
{
  const Scratch scratch;
  WriteText("a.nrrd", oldText);
  const auto outcome = RunWithOptions({}, [](shapeton::CommandLine & commandLine) {
    WriterOf({ "a.nrrd", "b.csv" })(commandLine);
    throw shapeton::InputError("the last slice is broken; copy the series again");
  });
  EXPECT_EQ(outcome.status, 3);
  EXPECT_EQ(NamesIn(), Words({ "a.nrrd" }));
  EXPECT_EQ(ReadText("a.nrrd"), oldText);
}

TEST(CommandLineOutputs, AMessageHasTheNamesThatTheUserGave)
{
  const auto outcome = RunWithOptions({}, [](shapeton::CommandLine & commandLine) {
    const std::string first = commandLine.Output("first.csv");
    throw shapeton::OutputError("cannot write \"" + first + "\" beside \"" + commandLine.Output("second.csv") +
                                "\", \"" + first + "\"");
  });
  EXPECT_NE(outcome.err.find("cannot write \"first.csv\" beside \"second.csv\", \"first.csv\""), std::string::npos)
    << outcome.err;
}

TEST(CommandLineOutputs, WhatTheBodyDidNotWriteIsAFailureOfAll)
{
  const Scratch scratch;
  WriteText("a.nrrd", oldText);
  const auto outcome = RunWithOptions({}, [](shapeton::CommandLine & commandLine) {
    WriteText(commandLine.Output("a.nrrd"), newText);
    commandLine.Output("b.csv");
  });
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.err, "TestTool: cannot write \"b.csv\": the program wrote nothing; report this as a bug\n");
  EXPECT_EQ(NamesIn(), Words({ "a.nrrd" }));
  EXPECT_EQ(ReadText("a.nrrd"), oldText);
}

TEST(CommandLineOutputs, PublishedOnesAreThereWhileTheRunGoesOnAndAfterItFails)
{
  const Scratch scratch;
  WriteText("preview.png", oldText);
  const auto outcome = RunWithOptions({}, [](shapeton::CommandLine & commandLine) {
    for (const char * const text : { "one", "two", "three" })
    {
      const std::string temporary = commandLine.Output("preview.png");
      WriteText(temporary, text);
      EXPECT_NE(ReadText("preview.png"), text);
      commandLine.Publish("preview.png");
      EXPECT_EQ(ReadText("preview.png"), text);
      EXPECT_EQ(NamesIn(), Words({ "preview.png" }));
    }
    commandLine.Output("preview.png"); // and the run fails before it is written
    throw std::runtime_error("enough");
  });
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(ReadText("preview.png"), "three");
  EXPECT_EQ(NamesIn(), Words({ "preview.png" }));
}

TEST(CommandLineOutputs, MayReplaceAnInputThatWasReleasedOnly)
{
  const Scratch scratch;
  WriteText("run.state", oldText);
  const Words options = { "--shape", "run.state" };
  const auto  refused =
    RunWithOptions(options, [](shapeton::CommandLine & commandLine) { commandLine.Output("run.state"); });
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("is an input of this run"), std::string::npos) << refused.err;
  const auto allowed = RunWithOptions(options, [](shapeton::CommandLine & commandLine) {
    commandLine.AllowReplacing("shape");
    WriteText(commandLine.Output("run.state"), newText);
  });
  EXPECT_EQ(allowed.status, 0) << allowed.err;
  EXPECT_EQ(ReadText("run.state"), newText);
}

TEST(CommandLineOutputs, OnlyWhatWasWrittenCanBePublished)
{
  const Scratch scratch;
  const auto    unwritten = RunWithOptions({}, [](shapeton::CommandLine & commandLine) {
    commandLine.Output("a.png");
    commandLine.Publish("a.png");
  });
  EXPECT_EQ(unwritten.status, 1);
  EXPECT_NE(unwritten.err.find("wrote nothing"), std::string::npos) << unwritten.err;
  const auto unknown = RunWithOptions({}, [](shapeton::CommandLine & commandLine) { commandLine.Publish("b.png"); });
  EXPECT_EQ(unknown.status, 1);
  EXPECT_EQ(NamesIn(), Words());
}

TEST(CommandLineOutputs, TheBodyMayChangeTheFolder)
{
  const Scratch scratch;
  fs::create_directory("sub");
  const auto outcome = RunWithOptions({}, [](shapeton::CommandLine & commandLine) {
    const std::string temporary = commandLine.Output("a.nrrd");
    fs::current_path("sub");
    WriteText(temporary, newText);
  });
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(NamesIn(), Words({ "a.nrrd", "sub" }));
  EXPECT_TRUE(NamesIn("sub").empty());
}

// ---- termination ----

class CommandLineKilled : public testing::TestWithParam<int>
{};

/** Begins two files, one of them half written and open, then calls `die`. */
Body
HalfWayThen(const std::function<void()> & die)
{
  return [die](shapeton::CommandLine & commandLine) {
    const std::string first = commandLine.Output("a.nrrd");
    const std::string second = commandLine.OutputOf("table");
    commandLine.MakeFolder("new/deep");
    const std::string third = commandLine.Output("new/deep/c.csv");
    WriteText(first, newText);
    WriteText(third, newText);
    std::ofstream os(second);
    os << "the first half" << std::flush;
    die();
    os << "and the second";
  };
}

TEST_P(CommandLineKilled, LeavesTheOldResultAndNoPartialFile)
{
  const Scratch scratch;
  WriteText("a.nrrd", oldText);
  WriteText("b.csv", oldText);
  const auto outcome = RunWithOptions({ "--table", "b.csv" }, HalfWayThen([] { raise(GetParam()); }));
  EXPECT_EQ(outcome.status, -GetParam());
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(NamesIn(), Words({ "a.nrrd", "b.csv" }));
  EXPECT_EQ(ReadText("a.nrrd"), oldText);
  EXPECT_EQ(ReadText("b.csv"), oldText);
}

std::string
NameOfSignal(const testing::TestParamInfo<int> & info)
{
  return std::string("SIG") + sigabbrev_np(info.param);
}

INSTANTIATE_TEST_SUITE_P(Requests,
                         CommandLineKilled,
                         testing::Values(SIGTERM, SIGINT, SIGHUP, SIGQUIT, SIGPIPE, SIGXCPU, SIGALRM),
                         NameOfSignal);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) // sanitizers report crashes themselves
INSTANTIATE_TEST_SUITE_P(Crashes, CommandLineKilled, testing::Values(SIGABRT, SIGSEGV, SIGBUS, SIGFPE), NameOfSignal);
#endif

TEST(CommandLineOutputs, AnotherThreadMayReceiveTheSignal)
{
  const Scratch scratch;
  WriteText("a.nrrd", oldText);
  const auto dieInThread = [] { std::thread([] { raise(SIGTERM); }).join(); };
  const auto outcome = RunWithOptions({ "--table", "b.csv" }, HalfWayThen(dieInThread));
  EXPECT_EQ(outcome.status, -SIGTERM);
  EXPECT_EQ(NamesIn(), Words({ "a.nrrd" }));
  EXPECT_EQ(ReadText("a.nrrd"), oldText);
}

TEST(CommandLineOutputs, ASignalThatWasIgnoredStaysIgnored)
{
  const Scratch scratch;
  const auto    outcome = InProcess([] {
    signal(SIGHUP, SIG_IGN); // as with nohup
    return RunHere({ "in", "out" }, [](shapeton::CommandLine & commandLine) {
      raise(SIGHUP);
      WriterOf({ "a.nrrd" })(commandLine);
    });
  });
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(NamesIn(), Words({ "a.nrrd" }));
}

TEST(CommandLineOutputs, AChildProcessThatDiesDoesNotRemoveTheFilesOfItsParent)
{
  const Scratch scratch;
  const auto    outcome = RunWithOptions({}, [](shapeton::CommandLine & commandLine) {
    WriterOf({ "a.nrrd" })(commandLine);
    const pid_t child = fork();
    if (child == 0)
    {
      raise(SIGTERM);
      _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    std::cout << (WIFSIGNALED(status) && WTERMSIG(status) == SIGTERM);
  });
  EXPECT_EQ(outcome.out, "1");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(ReadText("a.nrrd"), newText);
}

TEST(CommandLineOutputs, LeftoversOfSIGKILLAreRemovedByTheNextRun)
{
  const Scratch scratch;
  WriteText("a.nrrd", oldText);
  const Words ownedByOthers = { ".a.00000000-1-0.part.nrrd", ".hidden", "a.part.nrrd" };
  for (const auto & name : ownedByOthers)
  {
    WriteText(name, "not ours");
  }
  const auto killed = RunWithOptions({ "--table", "b.csv" }, HalfWayThen([] { raise(SIGKILL); }));
  EXPECT_EQ(killed.status, -SIGKILL);
  EXPECT_EQ(ReadText("a.nrrd"), oldText);
  EXPECT_EQ(NamesIn().size(), 7u) << "two temporary files and a folder remain";

  EXPECT_EQ(Write({ "another.png" }).status, 0);
  Words expected = ownedByOthers;
  expected.insert(expected.end(), { "a.nrrd", "another.png", "new" });
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(NamesIn(), expected);
}

TEST(CommandLineOutputs, TheFilesOfARunThatLivesAreNoLeftovers)
{
  const Scratch scratch;
  const auto    outcome = RunWithOptions({}, [](shapeton::CommandLine & commandLine) {
    WriterOf({ "a.nrrd" })(commandLine);
    std::cout << Write({ "a.nrrd", "b.nrrd" }).status; // another run, meanwhile
  });
  EXPECT_EQ(outcome.out, "0");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(NamesIn(), Words({ "a.nrrd", "b.nrrd" }));
}

// ---- renaming ----

TEST(CommandLineOutputs, AreAllRenamedOrNoneWhenASignalComesBetween)
{
  const Scratch scratch;
  WriteText("a.nrrd", oldText);
  WriteText("b.csv", oldText);
  const auto outcome = InProcess([] {
    faultySystem.signalAtRename = SIGTERM;
    faultySystem.callOfRename = 2;
    return RunHere({ "in", "out" }, WriterOf({ "a.nrrd", "b.csv", "c.vp" }));
  });
  EXPECT_EQ(outcome.status, -SIGTERM);
  EXPECT_EQ(NamesIn(), Words({ "a.nrrd", "b.csv", "c.vp" }));
  for (const auto & name : NamesIn())
  {
    EXPECT_EQ(ReadText(name), newText);
  }
}

TEST(CommandLineOutputs, ARenameThatFailsIsToldAndLeavesNoTemporaryFile)
{
  const Scratch scratch;
  WriteText("a.nrrd", oldText);
  const auto outcome = InProcess([] {
    faultySystem.renameError = EROFS;
    return RunHere({ "in", "out" }, WriterOf({ "a.nrrd", "b.csv" }));
  });
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.err, "TestTool: cannot write \"a.nrrd\": Read-only file system; choose another name\n");
  EXPECT_EQ(NamesIn(), Words({ "a.nrrd" }));
  EXPECT_EQ(ReadText("a.nrrd"), oldText);
}

TEST(CommandLineOutputs, ADiskThatFailsWhenTheFileIsMadeDurable)
{
  const Scratch scratch;
  WriteText("a.nrrd", oldText);
  const auto writeWith = [](int error) {
    return InProcess([error] {
      faultySystem.fsyncError = error;
      return RunHere({ "in", "out" }, WriterOf({ "b.csv", "a.nrrd" }));
    });
  };
  const auto full = writeWith(ENOSPC);
  EXPECT_EQ(full.status, 1);
  EXPECT_EQ(full.err,
            "TestTool: cannot write \"b.csv\": No space left on device; free some space or choose another folder\n");
  EXPECT_EQ(NamesIn(), Words({ "a.nrrd" }));
  EXPECT_EQ(ReadText("a.nrrd"), oldText);

  EXPECT_EQ(writeWith(EINVAL).status, 0) << "a file system without this call";
  EXPECT_EQ(ReadText("a.nrrd"), newText);
}

// ---- unwritable paths ----

TEST(CommandLineOutputs, BadNamesAreRefusedAtOnce)
{
  const Scratch scratch;
  fs::create_directory("folder");
  WriteText("file", oldText);
  const std::string advice = "use an existing, writable folder";
  ExpectRefused("", 2, "the name of an output is empty");
  ExpectRefused("folder", 1, "cannot write \"folder\": it is a folder; use a file name");
  ExpectRefused("folder/", 1, "cannot write \"folder/\": it is a folder; use a file name");
  ExpectRefused("new/", 1, "cannot write \"new/\": it is a folder; use a file name");
  ExpectRefused(".", 1, "cannot write \".\": it is a folder; use a file name");
  ExpectRefused("folder/..", 1, "cannot write \"folder/..\": it is a folder; use a file name");
  ExpectRefused("file/a.nrrd", 1, "cannot write \"file\": it exists and is not a folder; use another name");
  ExpectRefused("/proc/no/a.nrrd", 1, "cannot write \"/proc/no\": No such file or directory; choose a writable folder");
  ExpectRefused("/proc/a.nrrd", 1, "cannot write \"/proc/a.nrrd\": No such file or directory; " + advice);
  const std::string tooLong(256, 'x');
  ExpectRefused(tooLong, 1, "cannot write \"" + tooLong + "\": File name too long; choose a shorter name");
}

TEST(CommandLineOutputs, DevicesAndPipesAreNeverReplaced)
{
  const Scratch scratch;
  ASSERT_EQ(mkfifo("pipe", 0600), 0);
  for (const std::string path : { "/dev/full", "/dev/null", "pipe" })
  {
    ExpectRefused(path, 1, "cannot write \"" + path + "\": it is not a regular file; use the name of a regular file");
  }
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST(CommandLineOutputs, AFolderWithoutPermissionIsRefusedAtOnce)
{
  const Scratch scratch;
  fs::create_directory("locked");
  fs::permissions("locked", fs::perms(0555));
  const auto outcome = InProcess([] {
    BecomeNobody();
    return RunHere({ "in", "out" }, [](shapeton::CommandLine & commandLine) {
      commandLine.Output("locked/a.nrrd");
      std::cout << "hours of work";
    });
  });
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err,
            "TestTool: cannot write \"locked/a.nrrd\": Permission denied; use an existing, writable folder\n");
}

TEST(CommandLineOutputs, AWriteProtectedFileIsNotReplaced)
{
  const Scratch scratch;
  fs::permissions(".", fs::perms(0777));
  WriteText("a.nrrd", oldText);
  fs::permissions("a.nrrd", fs::perms(0444));
  const auto outcome = InProcess([] {
    BecomeNobody();
    return RunHere({ "in", "out" }, WriterOf({ "a.nrrd" }));
  });
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.err,
            "TestTool: cannot write \"a.nrrd\": Permission denied; use another name or allow writing to the file\n");
  EXPECT_EQ(ReadText("a.nrrd"), oldText);
}

TEST(CommandLineOutputs, TwoOutputsWithOneNameAreRefused)
{
  const Scratch scratch;
  fs::create_directory("sub");
  fs::create_directory_symlink("sub", "link");
  fs::create_symlink("a.nrrd", "alias.nrrd");
  const std::vector<Words> pairs = { { "a.nrrd", "a.nrrd" },
                                     { "a.nrrd", "./sub/../a.nrrd" },
                                     { "a.nrrd", (scratch.Path() / "a.nrrd").string() },
                                     { "sub/a.nrrd", "link/a.nrrd" },
                                     { "a.nrrd", "alias.nrrd" } };
  for (const auto & pair : pairs)
  {
    const auto outcome = Write(pair);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.err, "TestTool: two outputs have the same name \"" + pair[1] + "\"; use different names\n");
  }
  EXPECT_EQ(NamesIn(), Words({ "alias.nrrd", "link", "sub" }));
  EXPECT_TRUE(NamesIn("sub").empty());
}

/** Overwrites an old result with 1 MB and prints the remaining contents. */
int
WriteOneMegabyte()
{
  WriteText("a.nrrd", oldText);
  const int status = RunHere({ "in", "out" }, [](shapeton::CommandLine & commandLine) {
    shapeton::WriteFileBytes(commandLine.Output("a.nrrd"), std::string(1 << 20, 'x'));
  });
  for (const auto & name : NamesIn())
  {
    std::cout << name << ' ' << ReadText(name);
  }
  return status;
}

TEST(CommandLineOutputs, AFullDisk)
{
  const Scratch scratch;
  const int     noMount = 77;
  const auto    outcome = InProcess([&] {
    if (unshare(CLONE_NEWNS) != 0 || mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
        mount("tmpfs", scratch.Path().c_str(), "tmpfs", 0, "size=512k") != 0)
    {
      return noMount;
    }
    fs::current_path(scratch.Path());
    return WriteOneMegabyte();
  });
  if (outcome.status == noMount)
  {
    GTEST_SKIP() << "may not mount a small disk; AFileSizeLimit tests the same path";
  }
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.out, "a.nrrd " + oldText);
  EXPECT_TRUE(EndsWith(
    outcome.err, ": cannot write \"a.nrrd\": No space left on device; free some space or choose another folder\n"))
    << outcome.err;
}

TEST(CommandLineOutputs, AFileSizeLimit)
{
  const Scratch scratch;
  const auto    outcome = InProcess([] {
    const rlimit limit{ 1 << 18, 1 << 18 };
    setrlimit(RLIMIT_FSIZE, &limit);
    return WriteOneMegabyte();
  });
  EXPECT_EQ(outcome.status, 1) << "not SIGXFSZ";
  EXPECT_EQ(outcome.out, "a.nrrd " + oldText);
  EXPECT_TRUE(
    EndsWith(outcome.err, ": cannot write \"a.nrrd\": File too large; free some space or choose another folder\n"))
    << outcome.err;
}

// ---- links and permissions ----

TEST(CommandLineOutputs, ASymbolicLinkStaysAndItsTargetIsReplaced)
{
  const Scratch scratch;
  fs::create_directory("disk");
  WriteText("disk/real.nrrd", oldText);
  fs::create_symlink("disk/real.nrrd", "first.nrrd");
  fs::create_symlink("first.nrrd", "second.nrrd");
  fs::create_symlink("disk/not yet.nrrd", "dangling.nrrd");
  EXPECT_EQ(Write({ "second.nrrd", "dangling.nrrd" }).status, 0);
  EXPECT_TRUE(fs::is_symlink("first.nrrd"));
  EXPECT_TRUE(fs::is_symlink("second.nrrd"));
  EXPECT_TRUE(fs::is_symlink("dangling.nrrd"));
  EXPECT_EQ(ReadText("disk/real.nrrd"), newText);
  EXPECT_EQ(ReadText("disk/not yet.nrrd"), newText);
  EXPECT_EQ(NamesIn("disk"), Words({ "not yet.nrrd", "real.nrrd" }));

  fs::create_symlink("loop.nrrd", "loop.nrrd");
  ExpectRefused(
    "loop.nrrd", 1, "cannot write \"loop.nrrd\": Too many levels of symbolic links; use an existing, writable folder");
}

TEST(CommandLineOutputs, TheParentOfALinkedFolderIsThatOfItsTarget)
{
  const Scratch scratch;
  fs::create_directories("far/away");
  fs::create_directory_symlink("far/away", "link");
  EXPECT_EQ(Write({ "link/../a.nrrd" }).status, 0);
  EXPECT_EQ(NamesIn("far"), Words({ "a.nrrd", "away" }));
}

TEST(CommandLineOutputs, AHardLinkKeepsTheOldResultUnderItsOtherName)
{
  const Scratch scratch;
  WriteText("a.nrrd", oldText);
  fs::create_hard_link("a.nrrd", "kept.nrrd");
  EXPECT_EQ(Write({ "a.nrrd" }).status, 0);
  EXPECT_EQ(ReadText("a.nrrd"), newText);
  EXPECT_EQ(ReadText("kept.nrrd"), oldText);
}

TEST(CommandLineOutputs, PermissionsAreThoseOfTheOldFileOrOfTheUmask)
{
  const Scratch scratch;
  WriteText("private.nrrd", oldText);
  fs::permissions("private.nrrd", fs::perms(0600));
  const auto outcome = InProcess([] {
    umask(027);
    return RunHere({ "in", "out" }, WriterOf({ "private.nrrd", "new.nrrd" }));
  });
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(fs::status("private.nrrd").permissions(), fs::perms(0600));
  EXPECT_EQ(fs::status("new.nrrd").permissions(), fs::perms(0640));
}

TEST(CommandLineOutputs, ALinkInPlaceOfTheTemporaryFileIsNotFollowed)
{
  const Scratch scratch;
  WriteText("victim", oldText);
  const auto outcome = RunWithOptions({}, [](shapeton::CommandLine & commandLine) {
    std::string link = commandLine.Output("a.nrrd");
    WriteText(link, newText);
    link.replace(link.rfind("-0.part"), 2, "-1").replace(link.rfind("/.a."), 3, "/.b"); // default permissions of b.nrrd
    fs::create_symlink("victim", link);
    const std::string temporary = commandLine.Output("b.nrrd");
    std::cout << (temporary == link) << fs::exists(temporary);
    WriteText(temporary, newText);
  });
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "10");
  EXPECT_EQ(ReadText("victim"), oldText);
}

// ---- folders ----

TEST(CommandLineOutputs, FoldersAreMadeWithTheirParents)
{
  const Scratch scratch;
  const auto    outcome = RunWithOptions({}, [](shapeton::CommandLine & commandLine) {
    commandLine.MakeFolder("report/deep/");
    commandLine.MakeFolder("report"); // exists already
    WriteText(commandLine.Output("report/deep/index.html"), newText);
  });
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(ReadText("report/deep/index.html"), newText);
  EXPECT_EQ(NamesIn("report"), Words({ "deep" }));
}

TEST(CommandLineOutputs, AFailedRunRemovesTheFoldersItMadeWhenTheyAreEmpty)
{
  const Scratch scratch;
  fs::create_directory("old");
  const auto outcome = RunWithOptions({}, [](shapeton::CommandLine & commandLine) {
    commandLine.MakeFolder("old/report");
    commandLine.MakeFolder("a/b/c");
    commandLine.MakeFolder("used/by/others");
    WriteText("used/notes.txt", "written by someone else meanwhile");
    WriteText(commandLine.Output("a/b/c/index.html"), newText);
    throw shapeton::InputError("no");
  });
  EXPECT_EQ(outcome.status, 3);
  EXPECT_EQ(NamesIn(), Words({ "old", "used" }));
  EXPECT_TRUE(NamesIn("old").empty());
  EXPECT_EQ(NamesIn("used"), Words({ "notes.txt" }));
}

TEST(CommandLineOutputs, AFolderStaysAfterARunThatSucceeds)
{
  const Scratch scratch;
  const auto    outcome = InProcess([] {
    const int status =
      RunHere({ "in", "out" }, [](shapeton::CommandLine & commandLine) { commandLine.MakeFolder("a/empty one"); });
    raise(SIGTERM); // signals after the run do not remove it either
    return status;
  });
  EXPECT_EQ(outcome.status, -SIGTERM);
  EXPECT_EQ(NamesIn("a"), Words({ "empty one" }));
}

TEST(CommandLineOutputs, AFolderThatAnotherRunMakesMeanwhileIsNotRemoved)
{
  const Scratch scratch;
  const auto    outcome = InProcess([] {
    faultySystem.losesRaceForFolder = true;
    return RunHere({ "in", "out" }, [](shapeton::CommandLine & commandLine) {
      commandLine.MakeFolder("a/b");
      throw shapeton::InputError("no");
    });
  });
  EXPECT_EQ(outcome.status, 3) << outcome.err;
  EXPECT_EQ(NamesIn("a"), Words({ "b" }));
}

TEST(CommandLineOutputs, FoldersOfFilesAreMadeAndRemovedAfterAFailure)
{
  const Scratch scratch;
  const auto    run = [](bool fails) {
    return RunTool({ "in", "a/b/out.nrrd" }, [fails](shapeton::CommandLine & commandLine) {
      WriteText(commandLine.OutputOf("outputVolume"), newText);
      if (fails)
      {
        throw shapeton::InputError("no");
      }
    });
  };
  EXPECT_EQ(run(true).status, 3);
  EXPECT_EQ(NamesIn(), Words());
  EXPECT_EQ(run(false).status, 0);
  EXPECT_EQ(ReadText("a/b/out.nrrd"), newText);
}

TEST(CommandLineOutputs, FoldersThatCannotBeMade)
{
  const Scratch scratch;
  WriteText("file", oldText);
  const auto messageOf = [](const std::string & path) {
    const auto outcome =
      RunWithOptions({}, [&path](shapeton::CommandLine & commandLine) { commandLine.MakeFolder(path); });
    return std::to_string(outcome.status) + ' ' + outcome.err;
  };
  EXPECT_EQ(messageOf(""), "2 TestTool: the name of a folder for outputs is empty\n");
  EXPECT_EQ(messageOf("file"), "1 TestTool: cannot write \"file\": it exists and is not a folder; use another name\n");
  EXPECT_EQ(messageOf("file/sub"),
            "1 TestTool: cannot write \"file/sub\": Not a directory; choose a writable folder\n");
  EXPECT_EQ(messageOf("/proc/sub"),
            "1 TestTool: cannot write \"/proc/sub\": No such file or directory; choose a writable folder\n");
}

TEST(CommandLineOutputs, OfferedAtTheSameTimeByManyRunsAreOfOneOfThem)
{
  const Scratch            scratch;
  std::vector<std::thread> threads;
  const auto               whole = [](char c) { return std::string(200000, c); };
  for (const char c : { 'a', 'b', 'c', 'd' })
  {
    threads.emplace_back([&, c] {
      RunWithOptions({},
                     [&](shapeton::CommandLine & commandLine) { WriteText(commandLine.Output("x.txt"), whole(c)); });
    });
  }
  for (auto & thread : threads)
  {
    thread.join();
  }
  const std::string text = ReadText("x.txt");
  EXPECT_EQ(text, whole(text[0]));
  EXPECT_EQ(NamesIn(), Words({ "x.txt" }));
}
} // namespace
