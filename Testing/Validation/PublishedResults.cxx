// Figures of other authors beside our rows.
#include "ValidationReport.h"

#include "shapetonCsvFile.h"

#include <filesystem>

using namespace shapeton;

namespace
{
/** A published figure and the row of another part that is closest to it. */
struct PublishedFigure
{
  std::string figure;
  std::string source;
  std::string published;
  std::string rows; ///< name of the CSV file without extension
  std::string section;
  std::string measure;
  std::string column;
  std::string isComparable;
};

constexpr const char * ofLumen = "No: true lumen of synthetic patients, fluid tagged; theirs are labels of experts on "
                                 "435 scans, which share errors with the method that proposed them.";

constexpr const char * lumens = "seeds-300-colon-surfaces-fine-measures";
constexpr const char * landmarks = "seeds-300-colon-landmarks-ct-measures";
constexpr const char * registrations = "seeds-300-colon-registration-ct-measures";
constexpr const char * lumenSection = "Preset realistic, 0.7 mm voxels";
constexpr const char * ctSection = "Preset realistic, from CT of 0.8 mm";
constexpr const char * mean = "mean [95 % interval]";

const std::vector<PublishedFigure> figures = {
  { "Dice of the lumen, median",
    "HQColon, nnU-Net (arXiv 2502.21183)",
    "0.9929",
    lumens,
    lumenSection,
    "Dice of the lumen, median",
    mean,
    ofLumen },
  { "symmetric surface distance, median, mm",
    "HQColon",
    "0.23",
    lumens,
    lumenSection,
    "symmetric surface distance of the lumen, median, mm",
    mean,
    ofLumen },
  { "95 % Hausdorff distance, median, mm",
    "HQColon",
    "1.0",
    lumens,
    lumenSection,
    "95 % Hausdorff distance of the lumen, median, mm",
    mean,
    "No, as above; definitions differ, too: here the larger of both directions." },
  { "folds found",
    "Zhu et al., IEEE TBME 60 (2013) 321",
    "92.7 %",
    landmarks,
    ctSection,
    "folds >= 3.5 mm high found",
    "value",
    "In part: theirs are drawn by experts on 15 scans with good distension; here only folds of 3.5 mm count." },
  { "segmented-area ratio of folds",
    "Zhu et al.",
    "86.2 %",
    landmarks,
    ctSection,
    "area ratio of folds",
    "value",
    "In part: intersection over union in both, but of areas drawn by experts, and of the wall where a true fold rises "
    "by "
    "1 mm, without the area of its sides." },
  { "error of taeniae, share of the circumference, root mean square",
    "Wei et al., Medical Physics 39 (2012), PMC3281971",
    "4.87 %",
    landmarks,
    ctSection,
    "taeniae, root mean square error, share of the circumference",
    "value",
    "In part: root mean square in both, mean over exams; theirs are 47 scans of patients with lines marked by experts, "
    "all of one assignment." },
  { "fold matches that are right",
    "Hampshire et al., Medical Image Analysis 17 (2013) 946",
    "96.0 to 96.1 %",
    registrations,
    ctSection,
    "fold matches, precision",
    "value",
    "In part: the same share, but of matches judged by experts in patients with and without collapse." },
  { "registration error, median, mm",
    "Medsicight",
    "12",
    registrations,
    ctSection,
    "error in space, median, mm",
    "value",
    "No: theirs is at lesions of patients, ours at wall points of synthetic patients whose folds slide by 3 mm." },
};

/** The value of the row, or the reason why there is none. */
std::string
OwnValue(const PublishedFigure & figure, const std::string & folder)
{
  const std::string path = folder + '/' + figure.rows + ".csv";
  if (std::filesystem::exists(path))
  {
    const CsvFile rows(path, { "section", "measure", figure.column });
    for (std::size_t row = 0; row < rows.Rows(); ++row)
    {
      if (rows.Text(row, "section") == figure.section && rows.Text(row, "measure") == figure.measure)
      {
        return rows.Text(row, figure.column);
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
  CsvTable table({ "figure", "source", "published", "ours", "comparable" });
  for (const PublishedFigure & figure : figures)
  {
    table.AddRow(
      { figure.figure, figure.source, figure.published, OwnValue(figure, settings.rowsFolder), figure.isComparable });
  }
  report.AddTable(table);
}
