#include "shapetonDicomSeriesListing.h"

#include "shapetonDicomSeriesDefects.h"
#include "shapetonJson.h"
#include "shapetonNumberText.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

namespace shapeton
{
namespace
{
namespace fs = std::filesystem;
using Row = std::vector<std::string>;

// Tolerance of 5 degrees for naming an axis after a body axis.
constexpr double AxisCosine = 0.9962;

constexpr std::size_t LongestFileList = 20; // names listed; chosen

std::string
PlaneOf(const DicomSeries & series)
{
  if (!(series.spacing[0] > 0))
  {
    return {};
  }
  const char * const names[] = { "sagittal", "coronal", "axial" };
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    if (std::abs(series.direction(axis, 2)) >= AxisCosine)
    {
      return names[axis];
    }
  }
  return "oblique";
}

std::string
SizeOf(const DicomSeries & series)
{
  return std::to_string(series.size[0]) + " x " + std::to_string(series.size[1]) + " x " +
         std::to_string(series.size[2]);
}

std::string
SpacingOf(const DicomSeries & series)
{
  if (!(series.spacing[0] > 0))
  {
    return "-";
  }
  constexpr int     digits = 5;
  const std::string plane = NumberText(series.spacing[0], digits) + " x " + NumberText(series.spacing[1], digits);
  return series.spacing[2] > 0 ? plane + " x " + NumberText(series.spacing[2], digits) : plane;
}

/** "yes", or brief reasons. */
std::string
VerdictOn(const DicomSeries & series)
{
  if (series.IsUsable())
  {
    return "yes";
  }
  std::string reasons;
  for (const DicomDefect & defect : series.defects)
  {
    reasons += (reasons.empty() ? "" : ", ") + std::string(GetDicomDefectName(defect.kind));
  }
  return "no: " + (reasons.empty() ? series.refusal : reasons);
}

std::string
OrDash(const std::string & text)
{
  return text.empty() ? "-" : text;
}

/** Columns of equal width, counted in UTF-8 characters, not bytes. */
std::string
Align(const std::vector<Row> & rows)
{
  const auto width = [](const std::string & text) {
    return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
  };
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const Row & row : rows)
  {
    for (std::size_t i = 0; i < row.size(); ++i)
    {
      widths[i] = std::max(widths[i], width(row[i]));
    }
  }
  std::string text;
  for (const Row & row : rows)
  {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i)
    {
      line += row[i] + (i + 1 < row.size() ? std::string(widths[i] - width(row[i]) + 2, ' ') : "");
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

std::vector<const DicomSeries *>
PointersTo(const DicomScan & scan)
{
  std::vector<const DicomSeries *> list;
  for (const DicomSeries & series : scan.series)
  {
    list.push_back(&series);
  }
  return list;
}

/** "3", or "3-277": a range of list elements that starts at an index, counted from 1. */
std::string
NumbersFrom(std::size_t index, std::size_t number)
{
  const std::string first = std::to_string(index + 1);
  return number > 1 ? first + "-" + std::to_string(index + number) : first;
}

std::string
FormatTable(const DicomScan & scan)
{
  std::vector<Row> rows{
    { "No.", "Series", "Description", "Modality", "Plane", "Size", "Spacing [mm]", "Position", "Usable" }
  };
  const auto list = PointersTo(scan);
  for (std::size_t i = 0, number = 1; i < list.size(); i += number)
  {
    const DicomSeries & series = *list[i];
    number = LengthOfSingles(list, i);
    rows.push_back({ NumbersFrom(i, number),
                     std::to_string(series.number),
                     OrDash(series.description),
                     OrDash(series.modality),
                     OrDash(PlaneOf(series)),
                     SizeOf(series) + (number > 1 ? ", " + std::to_string(number) + " times" : ""),
                     SpacingOf(series),
                     OrDash(series.patientPosition),
                     VerdictOn(series) });
  }
  return Align(rows);
}

std::string
AdviceOn(const DicomDefect & defect, const AdviceInWords & inWords)
{
  const std::string advice = GetDicomDefectAdvice(defect);
  return inWords ? inWords(advice) : advice;
}

std::string
FormatDetails(const DicomSeries &   series,
              const std::string &   numbers,
              const std::string &   selectors,
              const AdviceInWords & inWords)
{
  std::string text = "\nNo. " + numbers + "  UID " + OrDash(selectors) + "\n";
  text += "  encoding: " + OrDash(series.transferSyntax) + (series.isLossy ? " (lossy)" : "") + "\n";
  for (const DicomDefect & defect : series.defects)
  {
    text += "  " + std::string(GetDicomDefectName(defect.kind)) + ": " + defect.message + "; " +
            AdviceOn(defect, inWords) + "\n";
  }
  for (const DicomDefect & remark : series.remarks)
  {
    text += "  " + std::string(GetDicomDefectName(remark.kind)) + " (a remark): " + remark.message + "; " +
            AdviceOn(remark, inWords) + "\n";
  }
  const bool isExplained = series.refusal.empty() || !series.defects.empty();
  return isExplained ? text : text + "  no volume: " + series.refusal + "\n";
}

std::string
FormatOtherFiles(const DicomScan & scan)
{
  if (scan.otherFiles.empty())
  {
    return {};
  }
  std::string text = "\nFiles outside any series: " + std::to_string(scan.otherFiles.size()) + "\n";
  for (std::size_t i = 0; i < scan.otherFiles.size() && i < LongestFileList; ++i)
  {
    const DicomDefect & file = scan.otherFiles[i];
    text += "  " + std::string(GetDicomDefectName(file.kind)) + ": " + file.message + "\n";
  }
  if (scan.otherFiles.size() > LongestFileList)
  {
    text += "  and " + std::to_string(scan.otherFiles.size() - LongestFileList) + " more\n";
  }
  return text;
}

// ---- JSON ----

std::string
RelativeName(const DicomScan & scan, const std::string & file)
{
  const fs::path name = fs::path(file).lexically_relative(scan.path);
  return name.empty() || name == "." ? fs::path(file).filename().string() : name.generic_string();
}

Json
DescribeFiles(const DicomScan & scan, const DicomDefect & defect)
{
  Json files = Json::array();
  for (const std::string & file : defect.files)
  {
    files.push_back(RelativeName(scan, file));
  }
  return files;
}

Json
DescribeDefects(const DicomScan & scan, const std::vector<DicomDefect> & defects, const AdviceInWords & inWords)
{
  Json list = Json::array();
  for (const DicomDefect & defect : defects)
  {
    list.push_back({ { "name", GetDicomDefectName(defect.kind) },
                     { "message", defect.message },
                     { "advice", AdviceOn(defect, inWords) },
                     { "files", DescribeFiles(scan, defect) },
                     { "slices", defect.slices } });
  }
  return list;
}

Json
DescribeSlices(const DicomScan & scan, const DicomSeries & series)
{
  Json slices = Json::array();
  for (const DicomSlice & slice : series.slices)
  {
    slices.push_back({ { "file", RelativeName(scan, slice.file) },
                       { "frame", slice.frame + 1 },
                       { "instanceNumber", slice.instanceNumber },
                       { "position", slice.position } });
  }
  return slices;
}

Json
DescribeSeries(const DicomScan & scan, const DicomSeries & series, const AdviceInWords & inWords)
{
  Json direction = Json::array();
  for (unsigned int i = 0; i < 9; ++i)
  {
    direction.push_back(series.direction(i / 3, i % 3));
  }
  const auto & origin = series.slices.front().imagePosition;
  return { { "selector", series.GetSelector() },
           { "seriesInstanceUID", series.uid },
           { "part", series.part },
           { "parts", series.parts },
           { "seriesNumber", series.number },
           { "description", series.description },
           { "modality", series.modality },
           { "patientID", series.patientID },
           { "studyDate", series.studyDate },
           { "patientPosition", series.patientPosition },
           { "transferSyntax", series.transferSyntax },
           { "lossy", series.isLossy },
           { "derived", series.isDerived },
           { "plane", PlaneOf(series) },
           { "size", series.size },
           { "spacing", series.spacing },
           { "origin", { origin[0], origin[1], origin[2] } },
           { "direction", direction },
           { "usable", series.IsUsable() },
           { "refusal", series.refusal },
           { "defects", DescribeDefects(scan, series.defects, inWords) },
           { "remarks", DescribeDefects(scan, series.remarks, inWords) },
           { "slices", DescribeSlices(scan, series) } };
}
} // namespace

std::string
FormatDicomScan(const DicomScan & scan, const AdviceInWords & inWords)
{
  if (scan.series.empty())
  {
    return FormatOtherFiles(scan);
  }
  std::string text = FormatTable(scan);
  const auto  list = PointersTo(scan);
  for (std::size_t i = 0, number = 1; i < list.size(); i += number)
  {
    number = LengthOfSingles(list, i);
    const std::string first = list[i]->GetSelector();
    const std::string selectors = number > 1 ? first + " to " + list[i + number - 1]->GetSelector() : first;
    text += FormatDetails(*list[i], NumbersFrom(i, number), selectors, inWords);
  }
  return text + FormatOtherFiles(scan);
}

void
WriteDicomScan(const DicomScan & scan, const std::string & path, const AdviceInWords & inWords)
{
  Json series = Json::array();
  for (const DicomSeries & each : scan.series)
  {
    series.push_back(DescribeSeries(scan, each, inWords));
  }
  Json others = Json::array();
  for (const DicomDefect & file : scan.otherFiles)
  {
    others.push_back({ { "name", GetDicomDefectName(file.kind) },
                       { "message", file.message },
                       { "files", DescribeFiles(scan, file) } });
  }
  WriteJson(
    { { "schema", "shapeton.dicomSeries.1" }, { "files", scan.files }, { "series", series }, { "otherFiles", others } },
    path);
}
} // namespace shapeton
