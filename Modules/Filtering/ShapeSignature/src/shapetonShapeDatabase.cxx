#include "shapetonShapeDatabase.h"

#include "shapetonExceptions.h"
#include "shapetonJson.h"
#include "shapetonSqliteFile.h"

#include <algorithm>

namespace shapeton
{
namespace
{
constexpr int ApplicationId = 0x53687074; // "Shpt"
constexpr int SchemaVersion = 1;          // increased when tables change

const std::string schema = "CREATE TABLE shape ("
                           "  id INTEGER PRIMARY KEY,"
                           "  name TEXT NOT NULL,"
                           "  source TEXT NOT NULL," // identity of the source table
                           "  label TEXT NOT NULL,"
                           "  volume REAL NOT NULL,"  // mm^3
                           "  surface REAL NOT NULL," // mm^2
                           "  elongation REAL NOT NULL,"
                           "  flatness REAL NOT NULL,"
                           "  remainingHeat TEXT NOT NULL," // lists of numbers in JSON
                           "  displacement TEXT NOT NULL,"
                           "  spectrum TEXT NOT NULL,"
                           "  UNIQUE (source, label)"
                           ") STRICT;";

template <std::size_t Size>
std::string
ListOf(const std::array<double, Size> & numbers)
{
  return Json(numbers).dump();
}

template <std::size_t Size>
void
ReadList(const std::string & text, std::array<double, Size> & numbers, const std::string & place)
{
  const Json list = Json::parse(text, nullptr, false);
  const bool areNumbers =
    list.is_array() && std::all_of(list.begin(), list.end(), [](const Json & number) { return number.is_number(); });
  if (!areNumbers || list.size() != Size)
  {
    throw InputError(place + ": a list of numbers is damaged; restore a copy of the database");
  }
  std::transform(list.begin(), list.end(), numbers.begin(), [](const Json & number) { return number.get<double>(); });
}

void
RequireShapeDatabase(const SqliteFile & file)
{
  if (file.Number("PRAGMA application_id") != ApplicationId)
  {
    throw InputError(file.Path() + ": an SQLite database, but not a shape database; choose another file");
  }
  if (const auto version = file.Number("PRAGMA user_version"); version != SchemaVersion)
  {
    throw InputError(file.Path() + ": the database has version " + std::to_string(version) +
                     ", but this program supports " + std::to_string(SchemaVersion) +
                     "; use the program that created it, or create a new database");
  }
  if (const std::string fault = file.Text("PRAGMA quick_check(1)"); fault != "ok")
  {
    // All lines except the last one only repeat the database name.
    throw InputError(file.Path() + ": the database is damaged (" + fault.substr(fault.rfind('\n') + 1) +
                     "); restore a copy of it");
  }
}

/** An empty file, or a database without an application id. */
bool
IsEmpty(const SqliteFile & file)
{
  return file.Number("PRAGMA application_id") == 0 && file.Number("PRAGMA user_version") == 0 &&
         file.Number("SELECT count(*) FROM sqlite_schema") == 0;
}

/** Must be called within a transaction. */
void
MakeOrRequire(const SqliteFile & file)
{
  if (!IsEmpty(file))
  {
    RequireShapeDatabase(file);
    return;
  }
  file.Execute("PRAGMA application_id = " + std::to_string(ApplicationId));
  file.Execute("PRAGMA user_version = " + std::to_string(SchemaVersion));
  file.Execute(schema);
}

void
RequireNew(const SqliteFile & file, const std::string & identity, const std::string & label)
{
  SqliteStatement query(file, "SELECT name FROM shape WHERE source = ? AND label = ?");
  query.Bind(identity).Bind(label);
  if (query.Step())
  {
    throw InputError(file.Path() + ": label " + label + " of this table already exists as \"" + query.Text(0) +
                     "\"; nothing was added");
  }
}

void
Insert(const SqliteFile & file, const ShapeRow & row, const std::string & identity, const std::string & name)
{
  RequireNew(file, identity, row.Name());
  const ShapeSignature & shape = row.signature;
  SqliteStatement        insertion(file,
                            "INSERT INTO shape (name, source, label, volume, surface, elongation, flatness, "
                                   "remainingHeat, displacement, spectrum) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  insertion.Bind(name).Bind(identity).Bind(row.Name());
  insertion.Bind(shape.volume).Bind(shape.surface).Bind(shape.elongation).Bind(shape.flatness);
  insertion.Bind(ListOf(shape.remainingHeat)).Bind(ListOf(shape.displacement)).Bind(ListOf(shape.spectrum));
  insertion.Step();
}

NamedShape
ShapeOf(const SqliteStatement & row, const std::string & path)
{
  NamedShape shape;
  shape.name = row.Text(0);
  const std::string place = path + ", shape \"" + shape.name + "\"";
  ShapeSignature &  signature = shape.signature;
  signature.volume = row.Number(1);
  signature.surface = row.Number(2);
  signature.elongation = row.Number(3);
  signature.flatness = row.Number(4);
  constexpr int remainingHeat = 5, displacement = 6, spectrum = 7; // columns
  ReadList(row.Text(remainingHeat), signature.remainingHeat, place);
  ReadList(row.Text(displacement), signature.displacement, place);
  ReadList(row.Text(spectrum), signature.spectrum, place);
  RequireSound(signature, place);
  return shape;
}

/** Opens read-only unless a transaction must be rolled back. */
SqliteFile
OpenForReading(const std::string & path)
{
  if (SqliteFile file(path, SqliteFile::Access::Read); !file.NeedsRepair())
  {
    return file;
  }
  SqliteFile(path, SqliteFile::Access::Repair).Number("SELECT count(*) FROM sqlite_schema"); // reading rolls it back
  return SqliteFile(path, SqliteFile::Access::Read);
}
} // namespace

std::size_t
AddToShapeDatabase(const std::string & path,
                   const ShapeTable &  table,
                   const std::string & identity,
                   const std::string & name)
{
  RequireParameter(!name.empty(), "the name of a shape must not be empty");
  const SqliteFile file(path, SqliteFile::Access::Write);
  file.Execute("PRAGMA synchronous = FULL");
  file.Execute("BEGIN IMMEDIATE"); // an exception before COMMIT rolls back when the file is closed
  MakeOrRequire(file);
  for (const ShapeRow & row : table.rows)
  {
    Insert(file, row, identity, table.rows.size() == 1 ? name : name + ':' + row.Name());
  }
  file.Execute("COMMIT");
  return static_cast<std::size_t>(file.Number("SELECT count(*) FROM shape"));
}

std::vector<NamedShape>
ReadShapeDatabase(const std::string & path)
{
  const SqliteFile        file = OpenForReading(path);
  std::vector<NamedShape> shapes;
  if (!IsEmpty(file))
  {
    RequireShapeDatabase(file);
    SqliteStatement rows(file,
                         "SELECT name, volume, surface, elongation, flatness, remainingHeat, displacement, spectrum "
                         "FROM shape ORDER BY id");
    while (rows.Step())
    {
      shapes.push_back(ShapeOf(rows, path));
    }
  }
  if (shapes.empty())
  {
    throw InputError(path + ": the database contains no shapes; add some first");
  }
  return shapes;
}
} // namespace shapeton
