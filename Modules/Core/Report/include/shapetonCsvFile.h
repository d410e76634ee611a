#ifndef shapetonCsvFile_h
#define shapetonCsvFile_h

#include "shapetonCsvTable.h"

namespace shapeton
{
/** \class CsvFile
 * \brief A table read from a CSV file as written by CsvTable: a header, then rows with the same number of cells.
 *
 * RFC 4180: comma, double quotes where needed, LF or CRLF; a byte order mark and empty lines are skipped. Error
 * messages state the file and the line.
 *
 * \ingroup ShapetonReport */
class ShapetonReport_EXPORT CsvFile
{
public:
  /** Throws InputError if the file cannot be read, has no header, lacks one of these columns, repeats a column name,
   * or a row has a different number of cells than the header. Other columns are allowed, in any order. */
  CsvFile(const std::string & path, const std::vector<std::string> & columns);

  std::size_t
  Rows() const
  {
    return m_Rows.size();
  }
  /** Whether the file has a column that was not required. */
  bool
  HasColumn(const std::string & column) const
  {
    return this->ColumnOf(column) < m_Columns.size();
  }
  /** The cell of a required or existing column. Rows count from 0. */
  const std::string &
  Text(std::size_t row, const std::string & column) const;
  /** Throws InputError unless the cell is a finite number with a decimal point. */
  double
  Number(std::size_t row, const std::string & column) const;
  /** NaN for an empty cell. */
  double
  NumberOrNothing(std::size_t row, const std::string & column) const;
  /** Line number of the row in the file, from 1. */
  int
  LineOf(std::size_t row) const
  {
    return m_Rows[row].line;
  }

private:
  struct Row
  {
    int                      line{ 0 };
    std::vector<std::string> cells;
  };
  void
  Parse(const std::string & text);
  void
  RequireColumns(const std::vector<std::string> & columns) const;
  std::size_t
  ColumnOf(const std::string & name) const;
  [[noreturn]] void
  Refuse(int line, const std::string & fault) const;

  std::string              m_Path;
  std::vector<std::string> m_Columns;
  std::vector<Row>         m_Rows;
};
} // namespace shapeton

#endif
