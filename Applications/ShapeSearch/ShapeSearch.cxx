#include "ShapeSearchXML.h"

#include "shapetonCommandLine.h"
#include "shapetonCsvTable.h"
#include "shapetonExceptions.h"
#include "shapetonReadOptions.h"
#include "shapetonSha256.h"
#include "shapetonShapeDatabase.h"

#include <iostream>

namespace
{
using namespace shapeton;

struct Answer
{
  std::string       shape;
  ShapeSearchResult result;
};

void
Add(CommandLine & commandLine, const ShapeTable & table, const std::string & identity)
{
  RequireParameter(!commandLine.IsGiven("neighbors"), "--add stores shapes without a search; omit --neighbors");
  const std::string database = commandLine.GetString("database");
  commandLine.MakeParentFolder(database);
  const std::size_t shapes = AddToShapeDatabase(database, table, identity, commandLine.GetString("add"));
  std::cout << table.rows.size() << " added, " << shapes << " shapes in " << database << '\n';
}

std::vector<Answer>
Search(const CommandLine & commandLine, const ShapeTable & table, const std::vector<NamedShape> & entries)
{
  ShapeSearchOptions options;
  ReadOptions(commandLine, options);
  std::vector<Answer> answers;
  for (const ShapeRow & row : table.rows)
  {
    answers.push_back({ row.Name(), FindShape(row.signature, entries, options) });
  }
  return answers;
}

void
Print(const std::vector<Answer> & answers, const std::vector<NamedShape> & entries)
{
  for (const auto & [shape, result] : answers)
  {
    std::cout << shape << ": " << (result.IsUnknown() ? "unknown" : entries[result.neighbors.front().entry].name)
              << " (probability that the nearest is the same shape: " << CsvTable::Rounded(result.probability, 2)
              << ")\n";
    for (const ShapeNeighbor & neighbor : result.neighbors)
    {
      std::cout << "    " << CsvTable::Rounded(neighbor.distance, 3) << "  " << entries[neighbor.entry].name << '\n';
    }
  }
}

void
Write(const std::vector<Answer> & answers, const std::vector<NamedShape> & entries, const std::string & path)
{
  CsvTable table({ "shape", "rank", "name", "distance", "probability", "answer" });
  for (const auto & [shape, result] : answers)
  {
    for (std::size_t i = 0; i < result.neighbors.size(); ++i)
    {
      const bool          isFirst = i == 0; // probability and answer are written once per shape
      const auto &        neighbor = result.neighbors[i];
      const std::string & name = entries[neighbor.entry].name;
      table.AddRow({ shape,
                     std::to_string(i + 1),
                     name,
                     CsvTable::Rounded(neighbor.distance, 6),
                     isFirst ? CsvTable::Rounded(result.probability, 4) : "",
                     isFirst ? (result.IsUnknown() ? "unknown" : name) : "" });
    }
  }
  table.Write(path);
}

void
AddOrSearch(CommandLine & commandLine)
{
  const std::string path = commandLine.GetString("table");
  const std::string identity = "sha256:" + Sha256OfFile(path);
  const ShapeTable  table = ReadShapeTable(path);
  if (commandLine.IsGiven("add"))
  {
    Add(commandLine, table, identity);
    return;
  }
  const std::string output = commandLine.GetString("neighbors");
  const std::string file = commandLine.OutputOf("neighbors");
  const auto        entries = ReadShapeDatabase(commandLine.GetString("database"));
  const auto        answers = Search(commandLine, table, entries);
  if (!file.empty())
  {
    Write(answers, entries, file);
    commandLine.RecordRun(output + ".run.json");
  }
  Print(answers, entries);
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, AddOrSearch);
}
