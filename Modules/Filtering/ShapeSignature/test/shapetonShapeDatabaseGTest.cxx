#include "shapetonShapeDatabase.h"
#include "shapetonTestFolder.h"

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

using namespace shapeton;

namespace
{
/** A valid signature that depends on `scale`. */
ShapeSignature
MadeUp(double scale)
{
  ShapeSignature signature;
  signature.volume = 1000.0 * scale;
  signature.surface = 600.0;
  for (std::size_t k = 0; k < ShapeSignature::NumberOfTimes; ++k)
  {
    signature.remainingHeat[k] = std::exp(-0.1 * scale * (k + 1.0)) / 3.0;
    signature.displacement[k] = 0.1 * (k + 1.0) * scale;
  }
  for (std::size_t k = 0; k < ShapeSignature::NumberOfEigenvalues; ++k)
  {
    signature.spectrum[k] = 25.0 * (k + 1.0) * scale;
  }
  return signature;
}

ShapeTable
Table(int rows)
{
  ShapeTable table;
  for (int i = 1; i <= rows; ++i)
  {
    ShapeRow row;
    row.label = i;
    row.voxels = 100;
    row.signature = MadeUp(1.0 + 0.1 * i);
    table.rows.push_back(row);
  }
  return table;
}

std::string
Bytes(const std::string & path)
{
  std::ifstream      file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/** Runs SQL on a file independently of the code under test. */
void
RunSql(const std::string & path, const std::string & sql)
{
  sqlite3 * handle = nullptr;
  ASSERT_EQ(sqlite3_open(path.c_str(), &handle), SQLITE_OK);
  EXPECT_EQ(sqlite3_exec(handle, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK) << sqlite3_errmsg(handle);
  sqlite3_close(handle);
}

/** Checks that reading and adding throw with this reason and leave the file unchanged. */
void
ExpectRefused(const std::string & path, const std::string & reason)
{
  const std::string before = Bytes(path);
  const std::string reading = basetest::MessageOf([&] { ReadShapeDatabase(path); });
  const std::string adding = basetest::MessageOf([&] { AddToShapeDatabase(path, Table(1), "sha256:1", "x"); });
  for (const std::string & message : { reading, adding })
  {
    EXPECT_EQ(message.rfind("InputError: " + path + ": ", 0), 0U) << message;
    EXPECT_NE(message.find(reason), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
  EXPECT_EQ(Bytes(path), before);
}

struct ShapeDatabase : public testing::Test
{
  basetest::Folder folder;
  std::string      path{ folder / "shapes.sqlite" };
};
} // namespace

TEST_F(ShapeDatabase, GivesBackWhatWasAdded)
{
  EXPECT_EQ(AddToShapeDatabase(path, Table(1), "sha256:1", "talus"), 1U);
  EXPECT_EQ(AddToShapeDatabase(path, Table(3), "sha256:2", "foot"), 4U);
  const auto shapes = ReadShapeDatabase(path);
  ASSERT_EQ(shapes.size(), 4U);
  EXPECT_EQ(shapes[0].name, "talus");
  EXPECT_EQ(shapes[1].name, "foot:1");
  EXPECT_EQ(shapes[3].name, "foot:3");
  const ShapeSignature truth = MadeUp(1.3);
  EXPECT_EQ(shapes[3].signature.remainingHeat, truth.remainingHeat); // to the last bit
  EXPECT_EQ(shapes[3].signature.displacement, truth.displacement);
  EXPECT_EQ(shapes[3].signature.spectrum, truth.spectrum);
  EXPECT_EQ(shapes[3].signature.volume, truth.volume);
}

TEST_F(ShapeDatabase, ReadingChangesNothing)
{
  AddToShapeDatabase(path, Table(2), "sha256:1", "talus");
  const std::string before = Bytes(path);
  ReadShapeDatabase(path);
  EXPECT_EQ(Bytes(path), before);
}

TEST_F(ShapeDatabase, RefusesATableTwice)
{
  AddToShapeDatabase(path, Table(2), "sha256:1", "talus");
  EXPECT_EQ(basetest::MessageOf([&] { AddToShapeDatabase(path, Table(3), "sha256:1", "tarsus"); }),
            "InputError: " + path + ": label 1 of this table already exists as \"talus:1\"; nothing was added");
  EXPECT_EQ(ReadShapeDatabase(path).size(), 2U);
  EXPECT_EQ(AddToShapeDatabase(path, Table(2), "sha256:2", "talus"), 4U); // another table of the same name
}

TEST_F(ShapeDatabase, AddsAllRowsOrNone)
{
  ShapeTable table = Table(3);
  AddToShapeDatabase(path, Table(1), "sha256:0", "first");
  table.rows[2].label = 1; // a second row of that label
  EXPECT_THROW(AddToShapeDatabase(path, table, "sha256:1", "x"), InputError);
  EXPECT_EQ(ReadShapeDatabase(path).size(), 1U);
}

TEST_F(ShapeDatabase, WantsAName) { EXPECT_THROW(AddToShapeDatabase(path, Table(1), "sha256:1", ""), ParameterError); }

TEST_F(ShapeDatabase, RefusesOtherFiles)
{
  std::ofstream(path) << "label,component\n1,0\n";
  ExpectRefused(path, "not a shape database; choose another file");
  std::ofstream(path) << std::string(20000, 'x');
  ExpectRefused(path, "not a shape database; choose another file");
}

TEST_F(ShapeDatabase, RefusesDatabasesOfOthers)
{
  RunSql(path, "CREATE TABLE shape (name TEXT);");
  ExpectRefused(path, "an SQLite database, but not a shape database");
}

TEST_F(ShapeDatabase, RefusesOtherVersions)
{
  AddToShapeDatabase(path, Table(1), "sha256:0", "first");
  RunSql(path, "PRAGMA user_version = 2;");
  ExpectRefused(path, "the database has version 2, but this program supports 1");
}

TEST_F(ShapeDatabase, RefusesDamagedFiles)
{
  AddToShapeDatabase(path, Table(40), "sha256:0", "first");
  std::string bytes = Bytes(path);
  std::fill(bytes.begin() + 4096, bytes.begin() + 4196, '\x5a'); // the header of a page of the tree
  std::ofstream(path, std::ios::binary) << bytes;
  ExpectRefused(path, "the database is damaged");
  const std::string message = basetest::MessageOf([&] { ReadShapeDatabase(path); });
  EXPECT_EQ(message.find("***"), std::string::npos) << message; // SQLite's header line before the error
  std::ofstream(path, std::ios::binary) << bytes.substr(0, bytes.size() / 2);
  ExpectRefused(path, "the database is damaged");
}

TEST_F(ShapeDatabase, RefusesDamagedNumbers)
{
  AddToShapeDatabase(path, Table(1), "sha256:0", "first");
  RunSql(path, "UPDATE shape SET spectrum = '[1, 2]';");
  EXPECT_EQ(basetest::MessageOf([&] { ReadShapeDatabase(path); }),
            "InputError: " + path + ", shape \"first\": a list of numbers is damaged; restore a copy of the database");
  RunSql(path, "UPDATE shape SET spectrum = 'x';");
  EXPECT_THROW(ReadShapeDatabase(path), InputError);
}

TEST_F(ShapeDatabase, SaysWhatIsMissing)
{
  EXPECT_NE(basetest::MessageOf([&] { ReadShapeDatabase(path); }).find("No such file"), std::string::npos);
  std::ofstream{ path };
  EXPECT_EQ(basetest::MessageOf([&] { ReadShapeDatabase(path); }),
            "InputError: " + path + ": the database contains no shapes; add some first");
  EXPECT_NE(basetest::MessageOf([&] { ReadShapeDatabase(folder / "."); }).find("not a file; a shape database"),
            std::string::npos);
  EXPECT_NE(basetest::MessageOf([&] {
              AddToShapeDatabase(folder / "nowhere/a.sqlite", Table(1), "sha256:1", "x");
            }).find("OutputError"),
            std::string::npos);
}

TEST_F(ShapeDatabase, SeveralProcessesAdd)
{
  std::vector<pid_t> children;
  for (int child = 0; child < 4; ++child)
  {
    children.push_back(fork());
    if (children.back() == 0)
    {
      int status = 0;
      for (int i = 0; i < 5; ++i)
      {
        const std::string identity = std::to_string(child) + '-' + std::to_string(i);
        status |= basetest::MessageOf([&] { AddToShapeDatabase(path, Table(2), identity, "x"); }) == "no error" ? 0 : 1;
      }
      _exit(status);
    }
  }
  for (const pid_t child : children)
  {
    int status = 1;
    waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
  EXPECT_EQ(ReadShapeDatabase(path).size(), 40U);
}

// A child process adds tables of three shapes, reports each by a byte in a pipe, and is killed after a while. Returns
// the number of reports.
std::size_t
AddUntilKilled(const std::string & path, int round, std::chrono::microseconds span)
{
  int ends[2];
  EXPECT_EQ(pipe(ends), 0);
  const pid_t child = fork();
  if (child == 0)
  {
    for (int i = 0;; ++i)
    {
      const std::string identity = std::to_string(round) + '-' + std::to_string(i);
      const auto        add = [&] { AddToShapeDatabase(path, Table(3), identity, "x"); };
      if (basetest::MessageOf(add) != "no error" || write(ends[1], "x", 1) != 1)
      {
        _exit(1);
      }
    }
  }
  close(ends[1]);
  std::this_thread::sleep_for(span);
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  std::size_t reported = 0;
  for (char byte; read(ends[0], &byte, 1) == 1;)
  {
    ++reported;
  }
  close(ends[0]);
  return reported;
}

// Times to kill the process before, during and after additions.
std::chrono::microseconds
MomentOfRound(const std::string & path, int round)
{
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  AddToShapeDatabase(path, Table(3), "moment " + std::to_string(round), "x");
  return std::chrono::duration_cast<std::chrono::microseconds>((Clock::now() - start) * (1 + round * 7 % 40) / 8);
}

TEST_F(ShapeDatabase, HoldsWholeTablesAfterKill)
{
  int interrupted = 0;
  for (int round = 0; round < 40 || (interrupted == 0 && round < 400); ++round)
  {
    const auto        moment = MomentOfRound(path, round);
    const std::size_t stored = ReadShapeDatabase(path).size();
    const std::size_t reported = AddUntilKilled(path, round, moment);
    interrupted += std::filesystem::exists(path + "-journal") ? 1 : 0;
    const std::size_t now = ReadShapeDatabase(path).size();
    EXPECT_EQ(now % 3, 0U);
    EXPECT_GE(now, stored + reported * 3); // reported additions must be kept
    EXPECT_LE(now, stored + (reported + 1) * 3);
  }
  EXPECT_GT(interrupted, 0); // otherwise nothing was tested
}

TEST_F(ShapeDatabase, IsMadeAfterAKillInItsFirstAddition)
{
  const std::string other = path + ".other";
  for (int round = 0; round < 20; ++round)
  {
    const std::size_t reported = AddUntilKilled(path, round, MomentOfRound(other, round) / 4);
    const std::size_t now = AddToShapeDatabase(path, Table(3), "afterwards", "x");
    EXPECT_GE(now, (reported + 1) * 3);
    EXPECT_LE(now, (reported + 2) * 3);
    EXPECT_EQ(ReadShapeDatabase(path).size(), now);
    std::filesystem::remove(path);
  }
}
