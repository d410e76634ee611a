#ifndef shapetonCsvFile_h
#define shapetonCsvFile_h

#include "shapetonCsvTable.h"

namespace shapeton
{
/** \class CsvFile
 * \brief A table as CsvTable writes it, read from a file: a header, then rows with as many cells.
 *
 * RFC 4180: comma, double quotes where needed, LF or CRLF; a byte order mark and lines without a character are passed
 * over. Faults are named with the file and its line.
 *
 * \ingroup Report
 */
class Report_EXPORT CsvFile
{
public:
  /** Throws InputError where the file cannot be read, has no header, lacks one of these columns, names a column twice,
   * or a row has not the cells of the header. Other columns are welcome, in any order. */
  CsvFile(const std::string & path, const std::vector<std::string> & columns);

  std::size_t
  Rows() const
  {
    return m_Rows.size();
  }
  /** Whether there is a column that was not asked for. */
  bool
  HasColumn(const std::string & column) const
  {
    return this->ColumnOf(column) < m_Columns.size();
  }
  /** One of the columns asked for, or one that is there. Rows count from 0. */
  const std::string &
  Text(std::size_t row, const std::string & column) const;
  /** Throws InputError for what is no finite number with a full stop. */
  double
  Number(std::size_t row, const std::string & column) const;
  /** Not a number for an empty cell. */
  double
  NumberOrNothing(std::size_t row, const std::string & column) const;
  /** Of the file, from 1 on. */
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
