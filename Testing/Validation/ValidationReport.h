#ifndef ValidationReport_h
#define ValidationReport_h

#include "shapetonCsvTable.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

/** Where a report is written. */
struct ValidationSection
{
  std::string page;          ///< path of the Markdown page
  std::string pageTitle;     ///< heading of a new page
  std::string name;          ///< identifies the section in its page
  std::string rowsFolder;    ///< folder of the CSV files
  std::string rowsPrefix;    ///< first part of their names: `rowsPrefix`-`name of the rows`.csv
  std::string pictureFolder; ///< folder that the text refers to for its pictures
};

/** Replaces the lines between `<!-- part NAME -->` and `<!-- end NAME -->` by `text`. Appends
 * these lines if missing. Keeps everything else byte for byte. Throws std::runtime_error if only one of the two lines
 * exists, if one occurs twice, or if they are in the wrong order. */
std::string
ReplaceSection(const std::string & page, const std::string & name, const std::string & text);

/** One section of a page of the validation report in Markdown: text, tables, and checks that pass or fail. Headings are
 * relative to the section: its title is `#`. */
class ValidationReport
{
public:
  explicit ValidationReport(const std::string & title);

  void
  AddText(const std::string & text);
  /** Adds all rows to the page and to a CSV file: `summary`, or `summary-2` and so on for tables with other columns. */
  void
  AddTable(const shapeton::CsvTable & table);

  /** Adds a table with one row per seed, exam or label as a CSV file named after the part and `name`. Its first
   * column is the current heading; the page contains a link, the number of rows, and the failed rows. */
  void
  AddRows(const std::string & name, const shapeton::CsvTable & table);

  /** Adds all rows to the CSV file, as AddRows() does; the page shows the link, and rows with a bound (a non-empty cell
   * of the column "bound") or a failure. */
  void
  AddSummary(const std::string & name, const shapeton::CsvTable & table);

  /** Records a check and returns "pass" or "FAIL" for a table; failures are counted. */
  std::string
  Check(bool passed);

  unsigned int
  GetNumberOfFailures() const
  {
    return m_Failures;
  }
  /** Replaces the section of the page, or creates the page, and writes the rows. Headings become one level lower. */
  void
  Write(const ValidationSection & section) const;

  /** Prints the progress of a long part to standard error, without changing the page. */
  static void
  Progress(const std::string & what);

private:
  using RowTest = std::function<bool(const std::vector<std::string> &)>;

  void
  AddRowsToFile(const std::string & name, const shapeton::CsvTable & table);
  /** Adds the rows to the CSV file `name`, and to the page a link and the rows that pass `isShown`, if any. */
  void
  AddRowsAndShow(const std::string & name, const shapeton::CsvTable & table, const RowTest & isShown);
  void
  AddRowsOfMarkdown(const shapeton::CsvTable & table, const RowTest & isShown);

  std::string                               m_Text;
  std::string                               m_Heading;
  std::map<std::string, shapeton::CsvTable> m_Rows;
  unsigned int                              m_Checks{ 0 };
  unsigned int                              m_Failures{ 0 };
};

/** Mean of values and its 95 % confidence interval by the t distribution; infinite for a single value. */
struct MeanInterval
{
  explicit MeanInterval(const std::vector<double> & values);
  double mean{ 0.0 };
  double lower{ 0.0 };
  double upper{ 0.0 };
};

/** Formats "mean [lower, upper]". */
std::string
MeanWithInterval(const std::vector<double> & values);

/** Settings of a part. */
struct ValidationSettings
{
  /** Seeds of the synthetic patients of a preset. Their number is `asked` (20 for realistic) unless one is set; the
   * first seed is 100 (300 for realistic) unless one is set. */
  std::vector<unsigned int>
  Seeds(int asked, const std::string & preset = "standard") const;

  /** Describes these seeds and the previous use of these patients. */
  std::string
  SeedsInWords() const;

  /** Refers to the method of another part; states the first seed if it is set. */
  std::string
  MethodOf(const std::string & part) const;

  bool         quick{ false };
  int          patients{ 0 };  ///< synthetic patients per preset; 0: default of the part
  unsigned int firstSeed{ 0 }; ///< 0: as in the published tables
  /** Presets of the synthetic patients. */
  std::vector<std::string> presets{ "standard", "hard", "realistic" };
  int                      draws{ 0 };          ///< seed draws in seeded-heat and seeded-heat-organs; 0: 3
  int                      seedsOfLabel{ 0 };   ///< seeds per label in these parts; 0: 5, 20 and 100
  std::string              dataFolder;          ///< empty without real data
  std::string              rowsFolder{ "." };   ///< folder of the CSV files
  std::string              outputFolder{ "." }; ///< folder of the pictures of Documentation/validation
  std::string              pictureFolder;       ///< folder of pictures in Documentation/pictures
};

/** A part of the validation, which adds its results to the report. */
using ValidationOfPart = void(const ValidationSettings & settings, ValidationReport & report);
ValidationOfPart ValidateAccuracyOfHeat, ValidateHeatOfShapes, ValidateFiguresOfChapter2, ValidateClassesOfPhantoms,
  ValidateOrgansOfAbdomen, ValidateComparisonOfShapetons, ValidateObjectsByShapetons, ValidateWalkOfShapetons,
  ValidateSearchOfShapes, ValidateObjectsOfVolumes, ValidateSegmentationFromSeeds, ValidateSegmentationOfOrgans,
  ValidateAccuracyOfMetric, ValidateAccuracyOfFlattening, ValidateDistancesOfHands, ValidateSlitMapsOfFace,
  ValidatePotWithHandle, ValidateFlatColonWithHandles, ValidateQualityOfMetric, ValidateTopologyOfWalls,
  ValidateColonSurfaces, ValidateColonLandmarks, ValidateColonLandmarksFromCt, ValidateColonRegistration,
  ValidateColonRegistrationFromCt, ValidateColonCatheters, ValidateReliabilityOfPairs, ValidateTaeniae,
  ValidateColonPolyps, ValidateColonPolypsFromCt, ValidatePublishedPolyps, ValidateColonNoise,
  ValidateColonSurfacesFine, ValidatePublishedResults, ValidateGraphEmbedding;

#endif
