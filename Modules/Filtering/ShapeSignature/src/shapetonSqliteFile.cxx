#include "shapetonSqliteFile.h"

#include "shapetonExceptions.h"
#include "shapetonFileErrors.h"

#include <sqlite3.h>

#include <cerrno>
#include <filesystem>

namespace shapeton
{
namespace
{
/** Maximum time to wait for another writing process. */
constexpr int MostMilliseconds = 20000;

int
FlagsOf(SqliteFile::Access access)
{
  switch (access)
  {
    case SqliteFile::Access::Read:
      return SQLITE_OPEN_READONLY;
    case SqliteFile::Access::Write:
      return SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
    default:
      return SQLITE_OPEN_READWRITE;
  }
}

/** For some names SQLite would open a database in memory, and its message for a non-regular file is unclear. */
std::string
RegularFile(const std::string & path, SqliteFile::Access access)
{
  std::error_code error;
  const auto      status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status) && access != SqliteFile::Access::Write)
  {
    ThrowCannotRead(path, ENOENT);
  }
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
  {
    throw InputError(path + ": not a file; a shape database is a single SQLite file");
  }
  return std::filesystem::absolute(path).string();
}
} // namespace

void
SqliteFile::Close::operator()(sqlite3 * handle) const
{
  sqlite3_close_v2(handle);
}

void
SqliteStatement::Finalize::operator()(sqlite3_stmt * statement) const
{
  sqlite3_finalize(statement);
}

SqliteFile::SqliteFile(const std::string & path, Access access) : m_Path(path), m_Access(access)
{
  sqlite3 * handle = nullptr;
  const int code = sqlite3_open_v2(RegularFile(path, access).c_str(), &handle, FlagsOf(access), nullptr);
  m_Handle.reset(handle);
  if (code != SQLITE_OK)
  {
    this->Fail(code);
  }
  sqlite3_extended_result_codes(handle, 1);
  sqlite3_busy_timeout(handle, MostMilliseconds);
}

void
SqliteFile::Fail(int code) const
{
  const std::string reason = sqlite3_errmsg(m_Handle.get());
  switch (code & 0xff)
  {
    case SQLITE_NOTADB:
      throw InputError(m_Path + ": not a shape database; choose another file");
    case SQLITE_CORRUPT:
      throw InputError(m_Path + ": the database is damaged (" + reason + "); restore a copy of it");
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      throw OutputError(m_Path + ": another process has been writing for " + std::to_string(MostMilliseconds / 1000) +
                        " s; try again when it has ended");
    default:
      break;
  }
  if (m_Access == Access::Read)
  {
    throw InputError(m_Path + ": the database cannot be read (" + reason + ")");
  }
  ThrowCannotWrite(m_Path, reason, "free some disk space, or use a writable folder");
}

void
SqliteFile::Execute(const std::string & sql) const
{
  const int code = sqlite3_exec(m_Handle.get(), sql.c_str(), nullptr, nullptr, nullptr);
  if (code != SQLITE_OK)
  {
    this->Fail(code);
  }
}

long long
SqliteFile::Number(const std::string & sql) const
{
  SqliteStatement statement(*this, sql);
  return statement.Step() ? static_cast<long long>(statement.Number(0)) : 0;
}

std::string
SqliteFile::Text(const std::string & sql) const
{
  SqliteStatement statement(*this, sql);
  return statement.Step() ? statement.Text(0) : std::string();
}

bool
SqliteFile::NeedsRepair() const
{
  return sqlite3_exec(m_Handle.get(), "SELECT count(*) FROM sqlite_schema", nullptr, nullptr, nullptr) ==
         SQLITE_READONLY_ROLLBACK;
}

SqliteStatement::SqliteStatement(const SqliteFile & file, const std::string & sql) : m_File(file)
{
  sqlite3_stmt * statement = nullptr;
  const int      code = sqlite3_prepare_v2(file.Handle(), sql.c_str(), -1, &statement, nullptr);
  m_Statement.reset(statement);
  if (code != SQLITE_OK)
  {
    file.Fail(code);
  }
}

SqliteStatement &
SqliteStatement::Bind(const std::string & text)
{
  const int code =
    sqlite3_bind_text(m_Statement.get(), ++m_Bound, text.c_str(), static_cast<int>(text.size()), SQLITE_TRANSIENT);
  if (code != SQLITE_OK)
  {
    m_File.Fail(code);
  }
  return *this;
}

SqliteStatement &
SqliteStatement::Bind(double number)
{
  if (const int code = sqlite3_bind_double(m_Statement.get(), ++m_Bound, number); code != SQLITE_OK)
  {
    m_File.Fail(code);
  }
  return *this;
}

bool
SqliteStatement::Step()
{
  const int code = sqlite3_step(m_Statement.get());
  if (code != SQLITE_ROW && code != SQLITE_DONE)
  {
    m_File.Fail(code);
  }
  return code == SQLITE_ROW;
}

std::string
SqliteStatement::Text(int column) const
{
  const auto * text = sqlite3_column_text(m_Statement.get(), column);
  return text == nullptr ? std::string() : reinterpret_cast<const char *>(text);
}

double
SqliteStatement::Number(int column) const
{
  return sqlite3_column_double(m_Statement.get(), column);
}
} // namespace shapeton
