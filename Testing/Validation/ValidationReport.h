#ifndef ValidationReport_h
#define ValidationReport_h

#include "shapetonCsvTable.h"

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

  /** A table with a row per seed, exam or label: it becomes a CSV file named after the page and `name`, whose first column is
   * the page's current section; the page holds a link, the number of rows, and the rows that have failed. */
  void
  AddRows(const std::string & name, const shapeton::CsvTable & table);

  /** Notes the check and returns "pass" or "FAIL" for a table; failures are counted. */
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

  /** Tells on the standard error what a long part is at; the page does not change. */
  static void
  Progress(const std::string & what);

private:
  void
  AddRowsOfMarkdown(const shapeton::CsvTable & table, bool failedOnly);

  std::string  m_Page;
  std::string  m_Section;
  std::map<std::string, shapeton::CsvTable> m_Rows;
  unsigned int m_Checks{ 0 };
  unsigned int m_Failures{ 0 };
};

/** The mean of some values and its 95 % confidence interval by the t distribution; all of the line for one value. */
struct MeanInterval
{
  explicit MeanInterval(const std::vector<double> & values);
  double mean{ 0.0 };
  double lower{ 0.0 };
  double upper{ 0.0 };
};

/** "mean [lower, upper]". */
std::string
MeanWithInterval(const std::vector<double> & values);

/** What a part may use. */
struct ValidationSettings
{
  /** Of the synthetic patients of a preset: `asked` of them (20 of realistic), or as many as are set, from the first
   * seed on: 100, of realistic 140, or the one that is set. */
  std::vector<unsigned int>
  Seeds(int asked, const std::string & preset = "standard") const;

  /** The same in words, and what these patients were used for. */
  std::string
  SeedsInWords() const;

  bool         quick{ false };
  int          patients{ 0 };  ///< synthetic ones of each preset; 0 for what is asked
  unsigned int firstSeed{ 0 }; ///< 0 for those of the published tables
  /** Of the synthetic patients. */
  std::vector<std::string> presets{ "standard", "hard", "realistic" };
  int                      draws{ 0 };          ///< of seeds, in seeded-heat and seeded-heat-organs; 0 for 3
  int                      seedsOfLabel{ 0 };   ///< there; 0 for 5, 20 and 100
  std::string              dataFolder;          ///< empty where there is no real data
  std::string              outputFolder{ "." }; ///< for pictures beside the page
  std::string              pictureFolder;       ///< for those of Documentation/pictures
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
