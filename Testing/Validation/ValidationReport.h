#ifndef ValidationReport_h
#define ValidationReport_h

#include "shapetonCsvTable.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

/** One page of the validation report in Markdown: text, tables, and checks that pass or fail. */
class ValidationReport
{
public:
  explicit ValidationReport(const std::string & title);

  void
  AddText(const std::string & text);
  void
  AddTable(const shapeton::CsvTable & table);

  /** A table with a row per seed, exam or label: it becomes a CSV file named after the page and `name`, whose first
   * column is the page's current section; the page holds a link, the number of rows, and the rows that have failed. */
  void
  AddRows(const std::string & name, const shapeton::CsvTable & table);

  /** Adds all rows to the CSV file, as AddRows() does; the page shows the link, and the rows that have a bound (a cell of
   * the column "bound" that is not empty) or that have failed. */
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
  /** Writes the page to `folder`/`page`.md and the rows to `rowsFolder`/`page`-`name`.csv. */
  void
  Write(const std::string & folder, const std::string & rowsFolder, const std::string & page) const;

  /** Prints the progress of a long part to standard error, without changing the page. */
  static void
  Progress(const std::string & what);

private:
  using RowTest = std::function<bool(const std::vector<std::string> &)>;

  /** Adds those rows to the CSV file `name`, and to the page a link and the rows that pass `isShown`, if any. */
  void
  AddRowsAndShow(const std::string & name, const shapeton::CsvTable & table, const RowTest & isShown);
  void
  AddRowsOfMarkdown(const shapeton::CsvTable & table, const RowTest & isShown);

  std::string                               m_Page;
  std::string                               m_Section;
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
  /** Seeds of the synthetic patients of a preset: `asked` of them (20 for realistic) or the set number, starting at 100
   * (140 for realistic) or the set first seed. */
  std::vector<unsigned int>
  Seeds(int asked, const std::string & preset = "standard") const;

  /** Describes these seeds and the previous use of these patients. */
  std::string
  SeedsInWords() const;

  bool         quick{ false };
  int          patients{ 0 };  ///< synthetic patients per preset; 0: default of the part
  unsigned int firstSeed{ 0 }; ///< 0: that of the published tables
  /** Presets of the synthetic patients. */
  std::vector<std::string> presets{ "standard", "hard", "realistic" };
  int                      draws{ 0 };          ///< seed draws in seeded-heat and seeded-heat-organs; 0: 3
  int                      seedsOfLabel{ 0 };   ///< seeds per label there; 0: 5, 20 and 100
  std::string              dataFolder;          ///< empty without real data
  std::string              outputFolder{ "." }; ///< folder of the page and its pictures
  std::string              pictureFolder;       ///< folder of pictures in Documentation/pictures
};
void
ValidateAccuracyOfHeat(const ValidationSettings & settings, ValidationReport & report);
void
ValidateHeatOfShapes(const ValidationSettings & settings, ValidationReport & report);
void
ValidateFiguresOfChapter2(const ValidationSettings & settings, ValidationReport & report);
void
ValidateClassesOfPhantoms(const ValidationSettings & settings, ValidationReport & report);
void
ValidateOrgansOfAbdomen(const ValidationSettings & settings, ValidationReport & report);
void
ValidateComparisonOfShapetons(const ValidationSettings & settings, ValidationReport & report);
void
ValidateWalkOfShapetons(const ValidationSettings & settings, ValidationReport & report);
void
ValidateSearchOfShapes(const ValidationSettings & settings, ValidationReport & report);
void
ValidateSegmentationFromSeeds(const ValidationSettings & settings, ValidationReport & report);
void
ValidateSegmentationOfOrgans(const ValidationSettings & settings, ValidationReport & report);
void
ValidateAccuracyOfMetric(const ValidationSettings & settings, ValidationReport & report);
void
ValidateAccuracyOfFlattening(const ValidationSettings & settings, ValidationReport & report);
void
ValidateDistancesOfHands(const ValidationSettings & settings, ValidationReport & report);
void
ValidateSlitMapsOfFace(const ValidationSettings & settings, ValidationReport & report);
void
ValidatePotWithHandle(const ValidationSettings & settings, ValidationReport & report);
void
ValidateFlatColonWithHandles(const ValidationSettings & settings, ValidationReport & report);
void
ValidateQualityOfMetric(const ValidationSettings & settings, ValidationReport & report);
void
ValidateColonSurfaces(const ValidationSettings & settings, ValidationReport & report);
void
ValidateColonLandmarks(const ValidationSettings & settings, ValidationReport & report);
void
ValidateColonLandmarksFromCt(const ValidationSettings & settings, ValidationReport & report);
void
ValidateColonRegistration(const ValidationSettings & settings, ValidationReport & report);
void
ValidateColonRegistrationFromCt(const ValidationSettings & settings, ValidationReport & report);
void
ValidateColonCatheters(const ValidationSettings & settings, ValidationReport & report);
void
ValidateReliabilityOfPairs(const ValidationSettings & settings, ValidationReport & report);
void
ValidateColonPolyps(const ValidationSettings & settings, ValidationReport & report);
void
ValidateColonPolypsFromCt(const ValidationSettings & settings, ValidationReport & report);
void
ValidateColonNoise(const ValidationSettings & settings, ValidationReport & report);
void
ValidateColonSurfacesFine(const ValidationSettings & settings, ValidationReport & report);
void
ValidateGraphEmbedding(const ValidationSettings & settings, ValidationReport & report);

#endif
