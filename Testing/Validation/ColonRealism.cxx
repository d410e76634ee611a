// usage: ColonRealism [--rows FOLDER] PAGE.md NAME=RUN[,RUN...] [NAME=RUN[,RUN...] ...]
//
// Compares colons segment by segment: length, course, caliber, folds. RUN is the folder of a finished run of
// VirtualColonoscopy; the runs of a NAME are merged into one column. FOLDER receives the CSV file (default: the folder
// of PAGE.md). Used to compare phantoms with real colons; see Documentation/validation/colon-surfaces.md.
#include "Tables.h"
#include "ValidationReport.h"
#include "ColonShape.h"

#include "shapetonExaminationFolder.h"
#include "shapetonFlatColon.h"

#include <cstdio>
#include <exception>
#include <filesystem>
#include <sstream>
#include <stdexcept>

using namespace shapeton;

namespace
{
/** Column of the tables. */
struct Colons
{
  std::string title;
  ColonShape  shape;
};

Colons
ReadColons(const std::string & argument)
{
  const std::size_t equals = argument.find('=');
  if (equals == 0 || equals == std::string::npos)
  {
    throw std::invalid_argument("\"" + argument + "\" is not NAME=RUN[,RUN...]");
  }
  Colons             colons{ argument.substr(0, equals), {} };
  std::istringstream runs(argument.substr(equals + 1));
  for (std::string run; std::getline(runs, run, ',');)
  {
    const ExaminationFolder exam(run);
    AddShape(MeasureColonShape(*exam.ReadFlatColon(), exam.ReadCenterline()), colons.shape);
  }
  return colons;
}

/** Three digits, no exponent. */
std::string
Plain(double value)
{
  return Rounded(value, value < 1000.0 ? 3 : 4);
}

/** Mean; for ten or more samples, also the 10, 50 and 90 % quantiles. */
std::string
InWords(const std::vector<double> & samples)
{
  if (samples.empty())
  {
    return "";
  }
  const std::string mean = Plain(MeanOf(samples));
  return samples.size() < 10 ? mean
                             : mean + " [" + Plain(LowerQuantile(samples, 0.1)) + ", " +
                                 Plain(LowerQuantile(samples, 0.5)) + ", " + Plain(LowerQuantile(samples, 0.9)) + "]";
}

/** Means of whole colons on the page; all segments with quantiles in a CSV file. */
void
AddTables(const std::vector<Colons> & columns, ValidationReport & report)
{
  std::vector<std::string> names{ "measure" };
  for (const Colons & column : columns)
  {
    names.push_back(column.title);
  }
  CsvTable wholes(names);
  names.insert(names.begin() + 1, "segment");
  CsvTable segments(names);
  for (const ShapeMeasure & measure : shapeMeasures)
  {
    for (const int segment : { 1, 2, 3, 4, 5, 6, 0 })
    {
      std::vector<std::string> row{ measure.title, segment == 0 ? "colon" : NameOfSegment(segment) };
      for (const Colons & column : columns)
      {
        row.push_back(InWords(column.shape[static_cast<std::size_t>(segment)].*measure.samples));
      }
      segments.AddRow(row);
    }
    std::vector<std::string> whole{ measure.title };
    for (const Colons & column : columns)
    {
      const std::vector<double> & samples = column.shape[0].*measure.samples;
      whole.push_back(samples.empty() ? "" : Plain(MeanOf(samples)));
    }
    wholes.AddRow(whole);
  }
  report.AddTable(wholes);
  report.AddRows("segments", segments);
}
} // namespace

int
main(int argc, char * argv[])
try
{
  std::vector<std::string> arguments(argv + 1, argv + argc);
  std::string              rows;
  if (arguments.size() > 1 && arguments[0] == "--rows")
  {
    rows = arguments[1];
    arguments.erase(arguments.begin(), arguments.begin() + 2);
  }
  if (arguments.size() < 2)
  {
    throw std::invalid_argument(
      "usage: ColonRealism [--rows FOLDER] PAGE.md NAME=RUN[,RUN...] [NAME=RUN[,RUN...] ...]");
  }
  std::vector<Colons> columns;
  for (std::size_t i = 1; i < arguments.size(); ++i)
  {
    columns.push_back(ReadColons(arguments[i]));
  }
  ValidationReport report("Real and synthetic colons");
  report.AddText(
    "Made by `ColonRealism`; the columns are described in [the notes](colon-surfaces.md#real-colons-and-phantoms). The "
    "table has means of whole colons. The file has all segments, between the borders found by the tools: means and, "
    "for ten and more samples, the 10, 50 and 90 % quantiles.");
  AddTables(columns, report);
  const std::filesystem::path page(arguments[0]);
  const std::string           folder = page.has_parent_path() ? page.parent_path().string() : ".";
  report.Write({ page.string(), "Shapes of colons", "colon-realism", rows.empty() ? folder : rows, "colon-realism" });
  return 0;
}
catch (const std::exception & error)
{
  std::fprintf(stderr, "ColonRealism: %s\n", error.what());
  return 2;
}
