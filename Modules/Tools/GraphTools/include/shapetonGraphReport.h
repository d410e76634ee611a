#ifndef shapetonGraphReport_h
#define shapetonGraphReport_h

#include "ShapetonGraphToolsExport.h"
#include "shapetonCsvTable.h"
#include "shapetonGraphPictures.h"

namespace shapeton
{
/** Content of a report on embedded graphs.
 * \ingroup ShapetonGraphTools */
struct GraphReport
{
  std::string title;
  /** Views side by side, grouped by geometry; turning, zooming and moving a view applies to its group. */
  std::vector<GraphView>   views{};
  std::vector<std::string> paragraphs{};
  std::vector<std::string> warnings{};
  /** Names and values, such as provenance and statistics. */
  std::vector<std::pair<std::string, std::string>> facts{};
  /** Captions and tables. */
  std::vector<std::pair<std::string, CsvTable>> tables{};
  /** Initial model of the hyperbolic plane; the user can change it. */
  DiskModel disk{ DiskModel::Poincare };
  /** Names of nodes tracked at first, each in a color of its own; the user can add and remove nodes. */
  std::vector<std::string> tracked{};
  /** Whether the views are the steps of a graph, of which the user can choose two and see their differences. */
  bool isSequence{ false };
};

/** Writes one HTML file that opens offline: a canvas view for each graph, to rotate (drag), to move by Moebius
 * transformations (shift and drag; on the disk: drag) and to zoom (wheel), with switches for graph, dual, circles,
 * labels and projection; then paragraphs, warnings, tables and facts. Equal reports give equal bytes. Throws
 * OutputError. \ingroup ShapetonGraphTools */
ShapetonGraphTools_EXPORT void
WriteGraphReport(const GraphReport & report, const std::string & path);

/** Provenance and statistics of a certificate as facts for a report.
 * \ingroup ShapetonGraphTools */
ShapetonGraphTools_EXPORT std::vector<std::pair<std::string, std::string>>
                          FactsOf(const EmbeddingCertificate & certificate);
} // namespace shapeton

#endif
