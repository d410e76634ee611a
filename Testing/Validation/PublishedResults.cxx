// Published figures of other authors next to our rows.
#include "Tables.h"
#include "ValidationReport.h"

#include "shapetonCsvFile.h"

#include <filesystem>

using namespace shapeton;

namespace
{
/** The value of our row that is closest to a published figure, or a remark that there is none. */
std::string
OwnValue(const CsvFile & figures, std::size_t figure, const std::string & folder)
{
  const std::string   path = folder + '/' + figures.Text(figure, "rows") + ".csv";
  const std::string & column = figures.Text(figure, "column");
  if (std::filesystem::exists(path))
  {
    const CsvFile rows(path, { "section", "measure", column });
    for (std::size_t row = 0; row < rows.Rows(); ++row)
    {
      if (rows.Text(row, "section") == figures.Text(figure, "section") &&
          rows.Text(row, "measure") == figures.Text(figure, "measure"))
      {
        return rows.Text(row, column);
      }
    }
  }
  return "not run yet";
}
} // namespace

void
ValidatePublishedResults(const ValidationSettings & settings, ValidationReport & report)
{
  report.AddText(
    "Our values are rows of the parts `colon-surfaces-fine`, `colon-landmarks-ct` and `colon-registration-ct`, preset "
    "realistic: synthetic patients with a known truth. The published values are from real patients judged by experts, "
    "with other scans, preparation, exclusions and definitions. No row shows that one method is better.");
  CsvTable      table({ "figure", "source", "published", "ours", "comparable" });
  const CsvFile figures(SHAPETON_PUBLISHED_RESULTS,
                        Columns("figure | source | published | rows | section | measure | column | comparable"));
  for (std::size_t i = 0; i < figures.Rows(); ++i)
  {
    table.AddRow({ figures.Text(i, "figure"),
                   figures.Text(i, "source"),
                   figures.Text(i, "published"),
                   OwnValue(figures, i, settings.rowsFolder),
                   figures.Text(i, "comparable") });
  }
  report.AddTable(table);
}
