#ifndef Tables_h
#define Tables_h

#include "shapetonCsvTable.h"
#include "shapetonQuantiles.h"

#include <string>
#include <type_traits>
#include <vector>

/** Statistics of values, and their text in tables. */

/** Returns 0 without values. */
double
MeanOf(const std::vector<double> & values);
/** Returns part / whole; 1 if `whole` is 0. */
double
ShareOf(int part, int whole);
/** Text of a value with significant digits. */
std::string
Rounded(double value, int digits = 3);
/** Formats "part / whole = share". */
std::string
RatioOf(int part, int whole);
/** Formats a fraction as "12.3 %". */
std::string
Percent(double share);

/** Appends values to others. */
template <typename TValue>
void
Append(const std::vector<TValue> & more, std::vector<TValue> & values)
{
  values.insert(values.end(), more.begin(), more.end());
}

/** Columns of a table from their headings, separated by " | ". */
std::vector<std::string>
Columns(const std::string & headings);

/** \class Cells
 * \brief Cells of a row of a table: texts, and numbers with all their digits. */
class Cells
{
public:
  template <typename TValue>
  Cells &
  operator<<(const TValue & value)
  {
    static_assert(!std::is_same_v<TValue, bool>, "A cell needs a word for a bool.");
    if constexpr (std::is_integral_v<TValue>)
    {
      m_Cells.push_back(std::to_string(value));
    }
    else if constexpr (std::is_floating_point_v<TValue>)
    {
      m_Cells.push_back(shapeton::CsvTable::Number(value));
    }
    else
    {
      m_Cells.emplace_back(value);
    }
    return *this;
  }
  Cells &
  operator<<(const std::vector<std::string> & cells)
  {
    m_Cells.insert(m_Cells.end(), cells.begin(), cells.end());
    return *this;
  }
  operator const std::vector<std::string> &() const { return m_Cells; }

private:
  std::vector<std::string> m_Cells;
};

#endif
