#include "shapetonStagedRun.h"

#include "shapetonExceptions.h"
#include "shapetonFileBytes.h"
#include "shapetonRunRecords.h"
#include "shapetonTestFolder.h"
#include "shapetonSha256.h"

#include "gtest/gtest.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <map>
#include <thread>

#include <sys/wait.h>
#include <unistd.h>

namespace
{
namespace fs = std::filesystem;
using basetest::Folder;
using basetest::MessageOf;
using shapeton::Stage;
using shapeton::StagedRun;
using shapeton::StageResult;

/** A folder of tools (shell scripts), a folder for a run, and a file that counts tool calls. */
class Bench
{
public:
  Bench()
  {
    fs::create_directories(m_Folder / "tools");
    fs::create_directories(m_Folder / "run");
    shapeton::WriteFileBytes(m_Folder / "input", "input");
    // copies its input: Copy --suffix=TEXT --mood=TEXT --wait=S -- INPUT FOLDER
    this->MakeTool("Copy",
                   R"(for word; do
  case $word in
    --suffix=*) suffix=${word#--suffix=} ;;
    --fail=*) fail=${word#--fail=} ;;
    --wait=*) wait=${word#--wait=} ;;
    --) ;;
    --*) ;;
    *) if [ -z "$from" ]; then from=$word; else to=$word; fi ;;
  esac
done
echo "$suffix" >> LOG
printf '<filter-start>\n<filter-name>Copying</filter-name>\n<filter-comment>Copying</filter-comment>\n</filter-start>\n'
printf '<filter-progress>0.5</filter-progress>\n<filter-comment>a &lt;remark&gt; &amp;amp;</filter-comment>\n'
trap 'kill $!; echo ended >> LOG; exit 1' TERM
[ -z "$wait" ] || { sleep "$wait" & wait $!; }
mkdir -p "$to/sub"
{ cat "$from"; echo "$suffix"; } > "$to/copy"
[ -z "$suffix" ] || echo "$suffix" > "$to/sub/extra-$suffix"
echo "$$" > "$to/copy.run.json"
[ "$fail" != partial ] || { echo 'Copy: only a part' >&2; exit 3; }
)");
    this->MakeTool("Fail", "echo 'noise' >&2; echo 'Fail: no colon; look at it' >&2; exit 3\n");
    this->MakeTool("Crash", "kill -SEGV $$\n");
    this->MakeTool("Forget", "exit 0\n");
  }

  std::string
  operator/(const std::string & name) const
  {
    return m_Folder / name;
  }

  std::string
  Log() const
  {
    return fs::exists(m_Folder / "log") ? shapeton::ReadFileBytes(m_Folder / "log") : "";
  }

  /** Files of the run with their bytes, except records of single runs. */
  std::map<std::string, std::string>
  Files() const
  {
    std::map<std::string, std::string> files;
    for (const auto & entry : fs::recursive_directory_iterator(m_Folder / "run"))
    {
      const std::string name = entry.path().lexically_relative(m_Folder / "run").string();
      if (entry.is_regular_file() && name.find("run.json") == std::string::npos)
      {
        files[name] = shapeton::ReadFileBytes(entry.path().string());
      }
    }
    return files;
  }

private:
  void
  MakeTool(const std::string & name, std::string script)
  {
    for (auto at = script.find("LOG"); at != std::string::npos; at = script.find("LOG"))
    {
      script.replace(at, 3, m_Folder / "log");
    }
    const std::string path = m_Folder / "tools/" + name;
    shapeton::WriteFileBytes(path, "#!/bin/sh\n[ \"$1\" != --version ] || { echo 1.2; exit 0; }\n" + script);
    fs::permissions(path, fs::perms::owner_all);
  }

  Folder m_Folder;
};

Stage
CopyStage(const Bench & bench, const std::string & suffix, const std::string & name = "copying")
{
  Stage stage(name, "Copy");
  stage.Input("", bench / "input").Output("", "").Option("suffix", suffix).Expect({ "copy" });
  return stage;
}

StageResult
RunOnce(const Bench & bench, const Stage & stage)
{
  StagedRun run(bench / "run", bench / "tools");
  return run.Run(stage);
}

TEST(StagedRun, KeepsWhatAToolWritesAndSays)
{
  const Bench       bench;
  StagedRun         run(bench / "run", bench / "tools");
  std::string       steps;
  const StageResult result = run.Run(CopyStage(bench, "a"), [&](const std::string & step, double share) {
    steps += step + ' ' + std::to_string(share).substr(0, 3) + '\n';
  });
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.version, "1.2");
  EXPECT_FALSE(result.isResumed);
  EXPECT_EQ(steps, "Copying 0.5\n");
  EXPECT_EQ(result.warnings, std::vector<std::string>{ "a <remark> &amp;" });
  EXPECT_EQ(shapeton::ReadFileBytes(run.PathOf("copying", "copy")), "inputa\n");
  ASSERT_EQ(result.files.size(), 2u);
  EXPECT_EQ(result.files[0].second, shapeton::Sha256OfBytes("inputa\n"));
  EXPECT_TRUE(result.Has("sub/extra-a"));
  EXPECT_TRUE(fs::exists(run.PathOf("copying", "copy.run.json")));
}

TEST(StagedRun, DoesNotRepeatWhatIsUnchanged)
{
  const Bench       bench;
  const StageResult first = RunOnce(bench, CopyStage(bench, "a"));
  const auto        files = bench.Files();
  const StageResult second = RunOnce(bench, CopyStage(bench, "a").Idle("threads", "3"));
  EXPECT_TRUE(second.isResumed);
  EXPECT_EQ(second.warnings, first.warnings);
  EXPECT_EQ(second.files, first.files);
  EXPECT_EQ(bench.Log(), "a\n");
  EXPECT_EQ(bench.Files(), files);
}

TEST(StagedRun, RepeatsWhatIsChanged)
{
  const Bench bench;
  RunOnce(bench, CopyStage(bench, "a"));
  EXPECT_FALSE(RunOnce(bench, CopyStage(bench, "b")).isResumed) << "an option";
  EXPECT_FALSE(fs::exists(bench / "run/copying/sub/extra-a")) << "files of the other option were removed";
  shapeton::WriteFileBytes(bench / "input", "other");
  EXPECT_FALSE(RunOnce(bench, CopyStage(bench, "b")).isResumed) << "the input";
  shapeton::WriteFileBytes(bench / "run/copying/copy", "touched");
  EXPECT_FALSE(RunOnce(bench, CopyStage(bench, "b")).isResumed) << "a result";
  fs::remove(bench / "run/copying/sub/extra-b");
  EXPECT_FALSE(RunOnce(bench, CopyStage(bench, "b")).isResumed) << "a result that is missing";
  shapeton::WriteFileBytes(bench / "run/stages/copying.json", "{");
  EXPECT_FALSE(RunOnce(bench, CopyStage(bench, "b")).isResumed) << "a damaged record";
  EXPECT_TRUE(RunOnce(bench, CopyStage(bench, "b")).isResumed);
}

TEST(StagedRun, AStageMayTakePartOfAnInput)
{
  const Bench bench;
  const auto  firstLetter = [](const std::string & path) { return shapeton::ReadFileBytes(path).substr(0, 1); };
  const auto  stage = [&] {
    Stage copying("copying", "Copy");
    return copying.Input("", bench / "input", firstLetter).Output("", "");
  };
  RunOnce(bench, stage());
  shapeton::WriteFileBytes(bench / "input", "ink");
  EXPECT_TRUE(RunOnce(bench, stage()).isResumed);
  shapeton::WriteFileBytes(bench / "input", "oil");
  EXPECT_FALSE(RunOnce(bench, stage()).isResumed);
}

TEST(StagedRun, OneStageFeedsTheNext)
{
  const Bench bench;
  const auto  both = [&](const std::string & suffix) {
    StagedRun  run(bench / "run", bench / "tools");
    const auto first = run.Run(CopyStage(bench, suffix));
    Stage      second("again", "Copy");
    second.Input("", run.PathOf("copying", "copy")).Output("", "").Option("suffix", "z");
    return std::make_pair(first.isResumed, run.Run(second).isResumed);
  };
  EXPECT_EQ(both("a"), std::make_pair(false, false));
  EXPECT_EQ(both("a"), std::make_pair(true, true));
  EXPECT_EQ(both("b"), std::make_pair(false, false));
  EXPECT_EQ(shapeton::ReadFileBytes(bench / "run/again/copy"), "inputb\nz\n");
}

TEST(StagedRun, ThreadsRunStagesBesideEachOther)
{
  const Bench alone;
  const Bench beside;
  const auto  suffixes = { "a", "b", "c", "d" };
  const auto  slowStage = [](const Bench & bench, const char * suffix) {
    return CopyStage(bench, suffix, suffix).Option("wait", "0.2");
  };
  for (const char * const suffix : suffixes)
  {
    RunOnce(alone, slowStage(alone, suffix));
  }
  {
    StagedRun                run(beside / "run", beside / "tools");
    std::vector<std::thread> threads;
    for (const char * const suffix : suffixes)
    {
      threads.emplace_back([&, suffix] { EXPECT_EQ(run.Run(slowStage(beside, suffix)).status, 0); });
    }
    std::for_each(threads.begin(), threads.end(), [](std::thread & thread) { thread.join(); });
  }
  EXPECT_EQ(beside.Files(), alone.Files());
  for (const char * const suffix : suffixes)
  {
    EXPECT_TRUE(RunOnce(beside, slowStage(beside, suffix)).isResumed) << suffix;
  }
}

TEST(StagedRun, TellsOfAFailure)
{
  const Bench       bench;
  const StageResult failed = RunOnce(bench, Stage("failing", "Fail"));
  EXPECT_EQ(failed.status, 3);
  EXPECT_EQ(failed.message, "no colon; look at it");
  EXPECT_FALSE(fs::exists(bench / "run/failing"));
  const StageResult crashed = RunOnce(bench, Stage("crashing", "Crash"));
  EXPECT_EQ(crashed.status, 1);
  EXPECT_EQ(crashed.message, "ended by signal " + std::to_string(SIGSEGV));
  const StageResult forgetful = RunOnce(bench, Stage("forgetting", "Forget").Output("", "result"));
  EXPECT_EQ(forgetful.status, 1);
  EXPECT_NE(forgetful.message.find("result"), std::string::npos);
  const StageResult missing = RunOnce(bench, Stage("none", "Missing"));
  EXPECT_EQ(missing.status, 1);
  EXPECT_NE(missing.message.find("is missing"), std::string::npos);
}

TEST(StagedRun, AFailureKeepsTheOlderResultUnlessThereIsAPart)
{
  const Bench bench;
  RunOnce(bench, CopyStage(bench, "a", "stage"));
  RunOnce(bench, Stage("stage", "Fail"));
  EXPECT_TRUE(RunOnce(bench, CopyStage(bench, "a", "stage")).isResumed);
  const auto        partial = CopyStage(bench, "p", "stage").Option("fail", "partial");
  const StageResult part = RunOnce(bench, partial);
  EXPECT_EQ(part.status, 3);
  EXPECT_EQ(part.message, "only a part");
  EXPECT_TRUE(part.Has("copy"));
  EXPECT_FALSE(RunOnce(bench, partial).isResumed) << "partial results are not resumed";
}

TEST(StagedRun, FilesOfOthersStay)
{
  const Bench bench;
  fs::create_directories(bench / "run/copying/sub");
  shapeton::WriteFileBytes(bench / "run/copying/sub/mine", "mine");
  RunOnce(bench, CopyStage(bench, "a"));
  EXPECT_FALSE(RunOnce(bench, CopyStage(bench, "b")).isResumed);
  EXPECT_TRUE(RunOnce(bench, CopyStage(bench, "b")).isResumed);
  EXPECT_EQ(shapeton::ReadFileBytes(bench / "run/copying/sub/mine"), "mine");
}

TEST(StagedRun, ARecordCannotNameFilesElsewhere)
{
  const Bench bench;
  RunOnce(bench, CopyStage(bench, "a"));
  std::string record = shapeton::ReadFileBytes(bench / "run/stages/copying.json");
  record.replace(record.find("\"copy\""), 6, "\"../../input\"");
  shapeton::WriteFileBytes(bench / "run/stages/copying.json", record);
  RunOnce(bench, CopyStage(bench, "b"));
  EXPECT_TRUE(fs::exists(bench / "input"));
}

TEST(StagedRun, AFolderOfWhichFilesAreReadCountsWithThese)
{
  const Bench bench;
  fs::create_directories(bench / "folder");
  shapeton::WriteFileBytes(bench / "folder/read", "1");
  shapeton::WriteFileBytes(bench / "folder/other", "1");
  Stage copying("copying", "Copy");
  copying.Input("", bench / "input").InputFolder("mood", bench / "folder", { "read", "missing" }).Output("", "");
  RunOnce(bench, copying);
  shapeton::WriteFileBytes(bench / "folder/other", "2");
  EXPECT_TRUE(RunOnce(bench, copying).isResumed);
  shapeton::WriteFileBytes(bench / "folder/read", "2");
  EXPECT_FALSE(RunOnce(bench, copying).isResumed);
  shapeton::WriteFileBytes(bench / "folder/missing", "2");
  EXPECT_FALSE(RunOnce(bench, copying).isResumed);
}

/** Three stages, each of which copies the output of the previous one. */
void
RunChain(const Bench & bench, const std::string & suffix, int stages)
{
  StagedRun   run(bench / "run", bench / "tools");
  std::string from = bench / "input";
  for (const std::string name : { "first", "second", "third" })
  {
    if (stages-- > 0)
    {
      run.Run(Stage(name, "Copy").Input("", from).Output("", "").Option("suffix", name == "first" ? suffix : "z"));
      from = run.PathOf(name, "copy");
    }
  }
}

TEST(RunRecords, ResultsOfAnInterruptedRunAreToldFromThoseThatBelongTogether)
{
  const Bench                bench;
  const shapeton::RunRecords records(bench / "run");
  const auto                 faultOf = [&](const std::string & stage) {
    return MessageOf([&] { records.RequireCurrent(stage, "copy"); });
  };
  const std::string none = "no error";
  EXPECT_NE(faultOf("third").find("has not finished"), std::string::npos);
  RunChain(bench, "a", 3);
  EXPECT_EQ(faultOf("third"), none);
  RunChain(bench, "b", 1); // interrupted after the first stage
  EXPECT_EQ(faultOf("first"), none);
  for (const std::string stage : { "second", "third" })
  {
    EXPECT_NE(faultOf(stage).find("stage second in"), std::string::npos) << faultOf(stage);
    EXPECT_NE(faultOf(stage).find("computed from an outdated \"first/copy\""), std::string::npos) << faultOf(stage);
    EXPECT_EQ(MessageOf([&] { records.RequireCurrent(stage); }), faultOf(stage));
  }
  RunChain(bench, "b", 3);
  EXPECT_EQ(faultOf("third"), none);
  shapeton::WriteFileBytes(bench / "run/third/copy", "by hand");
  EXPECT_NE(faultOf("third").find("was changed after the stage third wrote it"), std::string::npos);
  EXPECT_NO_THROW(records.RequireCurrent("third"));
  EXPECT_NO_THROW(records.RequireCurrent("none"));
  EXPECT_EQ(faultOf("second"), none);
}

TEST(RunRecords, AnInputThatDiffersInWhatDoesNotCountIsCurrent)
{
  const Bench bench;
  const auto  run = [&](const std::string & suffix) {
    StagedRun run(bench / "run", bench / "tools");
    run.Run(CopyStage(bench, suffix, "first"));
    const auto firstLetter = [](const std::string & path) { return shapeton::ReadFileBytes(path).substr(0, 1); };
    return run.Run(Stage("second", "Copy").Input("", run.PathOf("first", "copy"), firstLetter).Output("", ""));
  };
  run("a");
  EXPECT_TRUE(run("b").isResumed);
  EXPECT_NO_THROW(shapeton::RunRecords(bench / "run").RequireCurrent("second", "copy"));
  EXPECT_EQ(shapeton::RunRecords(bench / "run").WarningsOf("second"), shapeton::Remarks{ "a <remark> &amp;" });
  EXPECT_TRUE(shapeton::RunRecords(bench / "run").WarningsOf("none").empty());
}

TEST(StagedRun, TwoRunsInOneFolderAreRefused)
{
  const Bench       bench;
  const StagedRun   run(bench / "run", bench / "tools");
  const std::string message = MessageOf([&] { StagedRun(bench / "run", bench / "tools"); });
  EXPECT_EQ(message.substr(0, 13), "OutputError: ");
  EXPECT_NE(message.find("another run"), std::string::npos);
}

/** Runs a long stage in a separate process, and kills that process while the tool is running. */
void
KillRun(const Bench & bench, const Stage & stage, int signal)
{
  const std::string before = bench.Log();
  const pid_t       process = fork();
  if (process == 0)
  {
    RunOnce(bench, stage);
    _exit(0);
  }
  for (int i = 0; i < 300 && bench.Log() == before; ++i)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(50)); // let the tool install its trap
  kill(process, signal);
  int status = 0;
  waitpid(process, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status));
}

TEST(StagedRun, AKilledRunIsTakenUpAndEndsTheSame)
{
  const Bench bench;
  RunOnce(bench, CopyStage(bench, "a"));
  const auto files = bench.Files();
  for (const int signal : { SIGKILL, SIGTERM })
  {
    fs::remove_all(bench / "run/copying");
    KillRun(bench, CopyStage(bench, "a").Idle("wait", "20"), signal);
    EXPECT_FALSE(fs::exists(bench / "run/copying/copy"));
    EXPECT_FALSE(RunOnce(bench, CopyStage(bench, "a")).isResumed); // waits until the child has ended
    EXPECT_EQ(bench.Log().substr(bench.Log().size() - 10), "a\nended\na\n");
    EXPECT_EQ(bench.Files(), files);
  }
}
} // namespace
