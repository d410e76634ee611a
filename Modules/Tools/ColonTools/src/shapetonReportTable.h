#ifndef shapetonReportTable_h
#define shapetonReportTable_h

#include "shapetonCsvTable.h"

#include <functional>

namespace shapeton
{
/** A column of a table with a row for each item. */
template <typename TItem>
struct TableColumn
{
  std::string                               heading;
  std::function<std::string(const TItem &)> cell;
};

template <typename TItem>
CsvTable
TableOf(const std::vector<TItem> & items, const std::vector<TableColumn<TItem>> & columns)
{
  std::vector<std::string> texts;
  for (const TableColumn<TItem> & column : columns)
  {
    texts.push_back(column.heading);
  }
  CsvTable table(texts);
  for (const TItem & item : items)
  {
    for (std::size_t i = 0; i < columns.size(); ++i)
    {
      texts[i] = columns[i].cell(item);
    }
    table.AddRow(texts);
  }
  return table;
}
} // namespace shapeton

#endif
