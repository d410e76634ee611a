#include "shapetonDicomToColon.h"

#include "shapetonColonTerms.h"
#include "shapetonExceptions.h"

#include <algorithm>

namespace shapeton
{
namespace
{
std::string
ListOf(const DicomSegmentationFile & file)
{
  std::string text;
  for (const DicomSegmentInFile & segment : file.segments)
  {
    text += (text.empty() ? "" : ", ") + std::to_string(segment.number) + " (" + segment.name + ')';
  }
  return text;
}
} // namespace

std::vector<int>
AllSegmentsOf(const DicomSegmentationFile & file)
{
  std::vector<int> numbers;
  for (const DicomSegmentInFile & segment : file.segments)
  {
    numbers.push_back(segment.number);
  }
  return numbers;
}

std::vector<int>
LumenSegmentsOf(const DicomSegmentationFile & file)
{
  std::vector<int> numbers;
  bool             hasGas = false; // fluid alone does not count as a lumen
  for (const DicomSegmentInFile & segment : file.segments)
  {
    hasGas = hasGas || segment.type == colonterms::gas;
    if (segment.type == colonterms::gas || segment.type == colonterms::fluid)
    {
      numbers.push_back(segment.number);
    }
  }
  if (!hasGas && file.segments.size() != 1)
  {
    throw InputError('"' + file.path + "\" has no gas segment; select segments with the parameter \"segments\" of " +
                     ListOf(file));
  }
  return hasGas ? numbers : AllSegmentsOf(file);
}

CsvTable
TableOfSegments(const DicomSegmentationFile & file, const std::vector<int> & numbers, const DicomSegmentVoxels & voxels)
{
  const auto & spacing = voxels.labels->GetSpacing();
  const double voxel = spacing[0] * spacing[1] * spacing[2] / 1000.0;
  CsvTable     table({ "segment", "name", "code", "scheme", "meaning", "voxels", "volume" });
  for (std::size_t k = 0; k < numbers.size(); ++k)
  {
    const auto segment = std::find_if(file.segments.begin(), file.segments.end(), [&](const DicomSegmentInFile & one) {
      return one.number == numbers[k];
    });
    table.AddRow({ std::to_string(segment->number),
                   segment->name,
                   segment->type.value,
                   segment->type.scheme,
                   segment->type.meaning,
                   std::to_string(voxels.voxels[k]),
                   CsvTable::Rounded(voxel * static_cast<double>(voxels.voxels[k]), 6) });
  }
  return table;
}

std::vector<Markup>
MarkupsOfReport(const std::vector<DicomReportPoints> & points, Remarks & remarks)
{
  Markup      markup;
  std::size_t vertices = 0;
  std::size_t centers = 0;
  markup.name = "Points of the report";
  for (const DicomReportPoints & one : points)
  {
    const bool hasVertices = one.type == "POLYLINE" || one.type == "POLYGON";
    const bool hasCenter = one.type == "CIRCLE" || one.type == "ELLIPSE" || one.type == "ELLIPSOID";
    vertices += hasVertices ? one.places.size() : 0;
    centers += hasCenter ? 1 : 0;
    for (std::size_t i = 0; i < one.places.size(); ++i)
    {
      const auto & place = one.places[i];
      markup.points.emplace_back(place[0], place[1], place[2]);
      markup.labels.push_back(one.name + (hasVertices ? " (vertex " + std::to_string(i + 1) + ")"
                                          : hasCenter ? " (center)"
                                                      : ""));
    }
  }
  if (vertices + centers > 0)
  {
    remarks.push_back("of " + std::to_string(markup.points.size()) + " markers, " + std::to_string(vertices) +
                      " are vertices of lines or polygons and " + std::to_string(centers) +
                      " are centers of circles or ellipses; their labels say so");
  }
  return { markup };
}
} // namespace shapeton
