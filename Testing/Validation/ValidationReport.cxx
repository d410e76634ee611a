#include "ValidationReport.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <numeric>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace
{
bool
HasFailed(const std::vector<std::string> & row)
{
  return std::any_of(
    row.begin(), row.end(), [](const std::string & cell) { return cell.find("FAIL") != std::string::npos; });
}

// Placeholder in the page for the link to a file of rows, until both locations are known.
std::string
LinkTo(const std::string & name)
{
  return "{rows " + name + '}';
}

/** Position of a whole line, or npos. Throws std::runtime_error if it occurs twice. */
std::size_t
FindLine(const std::string & text, const std::string & line)
{
  std::size_t found = std::string::npos;
  for (std::size_t at = text.find(line); at != std::string::npos; at = text.find(line, at + 1))
  {
    const std::size_t end = at + line.size();
    if ((at > 0 && text[at - 1] != '\n') || (end < text.size() && text[end] != '\n'))
    {
      continue;
    }
    if (found != std::string::npos)
    {
      throw std::runtime_error("The line " + line + " occurs twice.");
    }
    found = at;
  }
  return found;
}

std::vector<std::string>
WithSection(const std::string & section, std::vector<std::string> cells)
{
  cells.insert(cells.begin(), section);
  return cells;
}

/** Refers to pictures in another folder, relative to the page. */
std::string
WithPicturesOf(const std::string & folder, const std::string & text)
{
  static const std::regex picture("(!\\[[^\\]]*\\]\\()");
  return folder.empty() || folder == "." ? text : std::regex_replace(text, picture, "$1" + folder + '/');
}

std::string
WithLowerHeadings(const std::string & text)
{
  std::istringstream is(text);
  std::string        lowered;
  bool               isCode = false;
  for (std::string line; std::getline(is, line);)
  {
    isCode = isCode != (line.rfind("```", 0) == 0);
    const bool isHeading = !isCode && line.rfind('#', 0) == 0;
    lowered += (isHeading ? "#" : "") + line + '\n';
  }
  return lowered;
}

/** Returns an empty string if the file does not exist. */
std::string
ReadPage(const std::string & path)
{
  if (!std::filesystem::exists(path))
  {
    return {};
  }
  std::ifstream      is(path, std::ios::binary);
  std::ostringstream text;
  text << is.rdbuf();
  if (!is)
  {
    throw std::runtime_error("Cannot read " + path + '.');
  }
  return text.str();
}

void
WritePage(const std::string & path, const std::string & text)
{
  const std::string temporary = path + ".tmp";
  std::ofstream     os(temporary, std::ios::binary);
  os << text;
  os.close();
  std::error_code error;
  if (os)
  {
    std::filesystem::rename(temporary, path, error);
  }
  if (!os || error)
  {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    throw std::runtime_error("Cannot write " + path + '.');
  }
}
} // namespace

std::string
ReplaceSection(const std::string & page, const std::string & name, const std::string & text)
{
  const std::string first = "<!-- part " + name + " -->";
  const std::string last = "<!-- end " + name + " -->";
  const std::size_t begin = FindLine(page, first);
  const std::size_t end = FindLine(page, last);
  if (begin == std::string::npos && end == std::string::npos)
  {
    const std::string newLine = page.empty() || page.back() == '\n' ? "" : "\n";
    const std::string gap = page.empty() ? "" : "\n";
    return page + newLine + gap + first + '\n' + text + last + '\n';
  }
  if (begin == std::string::npos || end == std::string::npos || end < begin)
  {
    throw std::runtime_error("The page requires the line " + first + " and, below it, the line " + last + '.');
  }
  return page.substr(0, begin) + first + '\n' + text + page.substr(end);
}

ValidationReport::ValidationReport(const std::string & title) : m_Text("# " + title + "\n\n") {}

void
ValidationReport::AddText(const std::string & text)
{
  const std::string mark = "## ";
  if (text.rfind(mark, 0) == 0)
  {
    m_Heading = text.substr(mark.size(), text.find('\n') - mark.size());
  }
  m_Text += text + "\n\n";
}

void
ValidationReport::AddRowsOfMarkdown(const shapeton::CsvTable & table, const RowTest & isShown)
{
  const auto line = [this](const std::vector<std::string> & cells) {
    for (const auto & cell : cells)
    {
      m_Text += "| " + cell + ' ';
    }
    m_Text += "|\n";
  };
  line(table.GetColumns());
  line(std::vector<std::string>(table.GetColumns().size(), "---"));
  for (const auto & row : table.GetRows())
  {
    if (isShown(row))
    {
      line(row);
    }
  }
  m_Text += '\n';
}

void
ValidationReport::AddTable(const shapeton::CsvTable & table)
{
  const auto columns = WithSection("section", table.GetColumns());
  const auto hasOtherColumns = [&](const std::string & name) {
    const auto rows = m_Rows.find(name);
    return rows != m_Rows.end() && rows->second.GetColumns() != columns;
  };
  std::string name = "summary";
  for (int number = 2; hasOtherColumns(name); ++number)
  {
    name = "summary-" + std::to_string(number);
  }
  this->AddRowsToFile(name, table);
  this->AddRowsOfMarkdown(table, [](const std::vector<std::string> &) { return true; });
}

void
ValidationReport::AddRows(const std::string & name, const shapeton::CsvTable & table)
{
  this->AddRowsAndShow(name, table, HasFailed);
}

void
ValidationReport::AddSummary(const std::string & name, const shapeton::CsvTable & table)
{
  const auto & columns = table.GetColumns();
  const auto   bound = std::find(columns.begin(), columns.end(), "bound");
  if (bound == columns.end())
  {
    throw std::logic_error("The table " + name + " of a summary requires the column \"bound\".");
  }
  const std::size_t at = static_cast<std::size_t>(bound - columns.begin());
  this->AddRowsAndShow(
    name, table, [at](const std::vector<std::string> & row) { return !row[at].empty() || HasFailed(row); });
}

void
ValidationReport::AddRowsToFile(const std::string & name, const shapeton::CsvTable & table)
{
  shapeton::CsvTable & all = m_Rows.try_emplace(name, WithSection("section", table.GetColumns())).first->second;
  for (const std::vector<std::string> & row : table.GetRows())
  {
    all.AddRow(WithSection(m_Heading, row));
  }
}

void
ValidationReport::AddRowsAndShow(const std::string & name, const shapeton::CsvTable & table, const RowTest & isShown)
{
  this->AddRowsToFile(name, table);
  const auto & rows = table.GetRows();
  const auto   failed = std::count_if(rows.begin(), rows.end(), HasFailed);
  this->AddText(std::to_string(rows.size()) + (rows.size() == 1 ? " row" : " rows") +
                (failed > 0 ? ", " + std::to_string(failed) + " failed: " : ": ") + LinkTo(name) + '.');
  if (std::any_of(rows.begin(), rows.end(), isShown))
  {
    this->AddRowsOfMarkdown(table, isShown);
  }
}

std::string
ValidationReport::Check(bool passed)
{
  ++m_Checks;
  m_Failures += passed ? 0 : 1;
  return passed ? "pass" : "FAIL";
}

void
ValidationReport::Write(const ValidationSection & section) const
{
  const auto  folder = std::filesystem::absolute(section.page).parent_path();
  std::string text = WithPicturesOf(std::filesystem::proximate(section.pictureFolder, folder).generic_string(), m_Text);
  for (const auto & [name, table] : m_Rows)
  {
    const std::string path = section.rowsFolder + '/' + section.rowsPrefix + '-' + name + ".csv";
    table.Write(path);
    const std::string link = std::filesystem::proximate(path, folder).generic_string();
    for (std::size_t at = text.find(LinkTo(name)); at != std::string::npos; at = text.find(LinkTo(name)))
    {
      text.replace(at, LinkTo(name).size(), '[' + name + "](" + link + ')');
    }
  }
  text += std::to_string(m_Checks - m_Failures) + " of " + std::to_string(m_Checks) + " checks passed.\n\n";
  std::string page = ReadPage(section.page);
  if (page.empty())
  {
    page = "# " + section.pageTitle + '\n';
  }
  try
  {
    page = ReplaceSection(page, section.name, WithLowerHeadings(text));
  }
  catch (const std::runtime_error & error)
  {
    throw std::runtime_error(section.page + ": " + error.what());
  }
  WritePage(section.page, page);
}

void
ValidationReport::Progress(const std::string & what)
{
  std::cerr << what << std::endl;
}

MeanInterval::MeanInterval(const std::vector<double> & values)
{
  const double n = static_cast<double>(values.size());
  mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  double squares = 0.0;
  for (const double value : values)
  {
    squares += (value - mean) * (value - mean);
  }
  // 97.5 % quantiles of Student's t for 1 to 30 degrees of freedom.
  static const std::array<double, 30> t = { 12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228,
                                            2.201,  2.179, 2.160, 2.145, 2.131, 2.120, 2.110, 2.101, 2.093, 2.086,
                                            2.080,  2.074, 2.069, 2.064, 2.060, 2.056, 2.052, 2.048, 2.045, 2.042 };
  const double quantile = values.size() < 2 ? HUGE_VAL : values.size() <= t.size() + 1 ? t[values.size() - 2] : 1.96;
  const double half = values.size() < 2 ? HUGE_VAL : quantile * std::sqrt(squares / (n - 1.0) / n);
  lower = mean - half;
  upper = mean + half;
}

std::string
MeanWithInterval(const std::vector<double> & values)
{
  const MeanInterval interval(values);
  const std::string  text = shapeton::CsvTable::Rounded(interval.mean, 4);
  return values.size() < 2 ? text + " (one sample)"
                           : text + " [" + shapeton::CsvTable::Rounded(interval.lower, 4) + ", " +
                               shapeton::CsvTable::Rounded(interval.upper, 4) + "]";
}

std::vector<unsigned int>
ValidationSettings::Seeds(int asked, const std::string & preset) const
{
  const bool                isRealistic = preset == "realistic";
  std::vector<unsigned int> seeds(patients > 0 ? patients : isRealistic ? 20 : asked);
  std::iota(seeds.begin(), seeds.end(), firstSeed > 0 ? firstSeed : isRealistic ? 300 : 100);
  return seeds;
}

std::string
ValidationSettings::SeedsInWords() const
{
  return "`ColonPhantom`, seeds from " + (firstSeed > 0 ? std::to_string(firstSeed) : "100, realistic from 300") +
         "; parameters fitted on seeds 1 to 99, a few rules chosen with knowledge of some of seeds 100 to 119";
}

std::string
ValidationSettings::MethodOf(const std::string & part) const
{
  return (firstSeed > 0 ? "Seeds from " + std::to_string(firstSeed) + ". " : std::string()) +
         "For data and method see `" + part + "`.";
}
