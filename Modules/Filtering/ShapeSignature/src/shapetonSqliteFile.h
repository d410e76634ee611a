#ifndef shapetonSqliteFile_h
#define shapetonSqliteFile_h

#include <memory>
#include <string>

struct sqlite3;
struct sqlite3_stmt;

namespace shapeton
{
/** \class SqliteFile
 * \brief An open SQLite database. Failures throw InputError for a file that is not a valid database, OutputError
 * for a failed write. */
class SqliteFile
{
public:
  enum class Access
  {
    Read,
    Write, ///< creates the file if it does not exist
    Repair ///< rolls back an interrupted transaction
  };

  SqliteFile(const std::string & path, Access access);

  /** Runs a statement without results. */
  void
  Execute(const std::string & sql) const;

  /** The number in the first column of the first row. */
  long long
  Number(const std::string & sql) const;

  /** The text in the first column of the first row. */
  std::string
  Text(const std::string & sql) const;

  /** Whether an interrupted transaction must be rolled back, which requires write access. */
  bool
  NeedsRepair() const;

  /** Throws the exception for a result code of SQLite. */
  [[noreturn]] void
  Fail(int code) const;

  sqlite3 *
  Handle() const
  {
    return m_Handle.get();
  }
  const std::string &
  Path() const
  {
    return m_Path;
  }

private:
  struct Close
  {
    void
    operator()(sqlite3 * handle) const;
  };
  std::string                     m_Path;
  Access                          m_Access;
  std::unique_ptr<sqlite3, Close> m_Handle;
};

/** \class SqliteStatement
 * \brief A prepared statement; values are bound and read in column order. */
class SqliteStatement
{
public:
  SqliteStatement(const SqliteFile & file, const std::string & sql);

  SqliteStatement &
  Bind(const std::string & text);
  SqliteStatement &
  Bind(double number);

  /** Advances to the next row; false at the end. */
  bool
  Step();

  std::string
  Text(int column) const;
  double
  Number(int column) const;

private:
  struct Finalize
  {
    void
    operator()(sqlite3_stmt * statement) const;
  };
  const SqliteFile &                      m_File;
  std::unique_ptr<sqlite3_stmt, Finalize> m_Statement;
  int                                     m_Bound{ 0 };
};
} // namespace shapeton

#endif
