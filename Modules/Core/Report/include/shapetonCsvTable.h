#ifndef shapetonCsvTable_h
#define shapetonCsvTable_h

#include "ShapetonReportExport.h"

#include <string>
#include <vector>

namespace shapeton
{
/** \class CsvTable
 * \brief A table with named columns, written as RFC 4180 CSV (comma, double quotes where needed, LF).
 *
 * Cells are text in UTF-8.
 *
 * \ingroup ShapetonReport
 */
class ShapetonReport_EXPORT CsvTable
{
public:
  explicit CsvTable(std::vector<std::string> columns);
  ~CsvTable();

  /** Throws std::invalid_argument if the number of cells differs from the number of columns. */
  void
  AddRow(std::vector<std::string> cells);

  const std::vector<std::string> &
  GetColumns() const
  {
    return m_Columns;
  }
  const std::vector<std::vector<std::string>> &
  GetRows() const
  {
    return m_Rows;
  }

  /** The table, excluding columns whose cells are all empty. */
  CsvTable
  WithoutEmptyColumns() const;

  /** Throws OutputError. */
  void
  Write(const std::string & path) const;

  /** The shortest round-trip representation of `value`, with a decimal point in every locale; "nan", "inf", "-inf". */
  static std::string
  Number(double value);

  /** `value` with `digits` significant digits (1 to 17), for display. */
  static std::string
  Rounded(double value, int digits);

private:
  std::vector<std::string>              m_Columns;
  std::vector<std::vector<std::string>> m_Rows;
};
} // namespace shapeton

#endif
