// usage: ColonRealism TABLE.md NAME=RUN[,RUN...] [NAME=RUN[,RUN...] ...]
//
// Compares colons segment by segment: length, course, caliber, folds. RUN is a finished folder of VirtualColonoscopy;
// the runs of a NAME are merged into one column. Used to compare phantoms with real colons; see
// Documentation/validation/colon-realism.md.
#include "BoundTable.h"
#include "ColonShape.h"

#include "shapetonSurfaceReader.h"

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

/** One value per position, fold or colon of a segment. */
struct Measure
{
  std::string         title;
  std::vector<double> SegmentShape::*samples;
};

const std::vector<Measure> measures = {
  { "Length along the centerline, mm", &SegmentShape::lengths },
  { "Length over the straight way between the ends", &SegmentShape::tortuosities },
  { "Turning of the centerline, smoothed by 10 mm, degrees for each dm", &SegmentShape::turnings },
  { "Radius of the largest ball on the centerline, mm", &SegmentShape::inscribedRadii },
  { "Radius of the circle with the area of the wall's section, mm", &SegmentShape::radii },
  { "Folds for each dm", &SegmentShape::foldsPerDecimeter },
  { "Way along the wall from fold to fold, mm", &SegmentShape::spacings },
  { "Height of folds, mm", &SegmentShape::heights },
  { "Thickness of folds at half of their height, mm", &SegmentShape::thicknesses },
  { "Extent of folds around the tube, degrees", &SegmentShape::extents },
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
    const FlatColon flat(ReadSurface(run + "/flattening/flat.vtp").mesh);
    AddShape(MeasureColonShape(flat, ReadCurves(run + "/segmentation/centerline.vtp")), colons.shape);
  }
  return colons;
}

/** Three digits, no exponent. */
std::string
Plain(double value)
{
  return Rounded(value, value < 1000.0 ? 3 : 4);
}

/** Mean; for ten samples and more, also the 10, 50 and 90 % quantiles. */
std::string
InWords(const std::vector<double> & samples)
{
  if (samples.empty())
  {
    return "";
  }
  const std::string mean = Plain(MeanOf(samples));
  return samples.size() < 10 ? mean
                             : mean + " [" + Plain(Percentile(samples, 0.1)) + ", " + Plain(Percentile(samples, 0.5)) +
                                 ", " + Plain(Percentile(samples, 0.9)) + "]";
}

void
AddTable(const Measure & measure, const std::vector<Colons> & columns, ValidationReport & report)
{
  report.AddText("## " + measure.title);
  std::vector<std::string> names{ "segment" };
  for (const Colons & column : columns)
  {
    names.push_back(column.title);
  }
  CsvTable table(names);
  for (const int segment : { 1, 2, 3, 4, 5, 6, 0 })
  {
    std::vector<std::string> row{ segment == 0 ? "colon" : NameOfSegment(segment) };
    for (const Colons & column : columns)
    {
      row.push_back(InWords(column.shape[static_cast<std::size_t>(segment)].*measure.samples));
    }
    table.AddRow(row);
  }
  report.AddTable(table);
}
} // namespace

int
main(int argc, char * argv[])
try
{
  if (argc < 3)
  {
    throw std::invalid_argument("usage: ColonRealism TABLE.md NAME=RUN[,RUN...] [NAME=RUN[,RUN...] ...]");
  }
  std::vector<Colons> columns;
  for (int i = 2; i < argc; ++i)
  {
    columns.push_back(ReadColons(argv[i]));
  }
  ValidationReport report("Colons beside each other");
  report.AddText(
    "Made by `ColonRealism`; [what the columns are](notes-real-colons.md). Segments lie between the borders "
    "that the tools find. A cell holds the mean over all places or folds of a segment and, of ten and "
    "more, the values that 10, 50 and 90 % do not exceed; what each colon has one of is a mean of colons.");
  for (const Measure & measure : measures)
  {
    AddTable(measure, columns, report);
  }
  const std::filesystem::path page(argv[1]);
  const std::string           folder = page.has_parent_path() ? page.parent_path().string() : ".";
  report.Write({ page.string(), "Shapes of colons", "colon-realism", folder, "colon-realism" });
  return 0;
}
catch (const std::exception & error)
{
  std::fprintf(stderr, "ColonRealism: %s\n", error.what());
  return 2;
}
