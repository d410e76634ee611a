// Writes a table as CSV and in an offline HTML report.
// Usage: ExampleReport OUTPUT.html OUTPUT.csv
#include "shapetonCsvTable.h"
#include "shapetonHtmlReport.h"

#include <cmath>
#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 3)
  {
    std::cerr << "Usage: " << argv[0] << " OUTPUT.html OUTPUT.csv\n";
    return 2;
  }
  shapeton::CsvTable table({ "radius [mm]", "volume [mm^3]" });
  for (const double radius : { 1.0, 2.0, 5.0 })
  {
    const double volume = 4.0 / 3.0 * std::acos(-1.0) * std::pow(radius, 3);
    table.AddRow({ shapeton::CsvTable::Number(radius), shapeton::CsvTable::Rounded(volume, 6) });
  }
  table.Write(argv[2]);

  shapeton::HtmlReport report("Balls");
  report.AddParagraph("Volumes of three balls.");
  report.AddTable(table, "Eight times the volume for twice the radius.");
  report.Write(argv[1]);
  std::cout << table.GetRows().size() << " rows, the last volume " << table.GetRows().back().back() << '\n';
}
