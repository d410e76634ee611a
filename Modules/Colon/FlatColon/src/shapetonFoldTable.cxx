#include "shapetonHaustralFoldFiles.h"

#include "shapetonCsvFile.h"
#include "shapetonExceptions.h"

#include <cmath>

namespace shapeton
{
namespace
{
std::string
Cell(double value)
{
  return std::isfinite(value) ? CsvTable::Number(value) : "";
}

void
AddPoint(std::vector<std::string> & cells, const Eigen::Vector3d & point)
{
  for (int k = 0; k < 3; ++k)
  {
    cells.push_back(Cell(point[k]));
  }
}

Eigen::Vector3d
PointOf(const CsvFile & file, std::size_t row, const std::string & prefix)
{
  return { file.Number(row, prefix.empty() ? "x" : prefix + "X"),
           file.Number(row, prefix.empty() ? "y" : prefix + "Y"),
           file.Number(row, prefix.empty() ? "z" : prefix + "Z") };
}

const std::vector<std::string> &
ColumnsOfFolds()
{
  static const std::vector<std::string> columns{ "fold",
                                                 "arcLength",
                                                 "u",
                                                 "v",
                                                 "x",
                                                 "y",
                                                 "z",
                                                 "length",
                                                 "area",
                                                 "height",
                                                 "elongation",
                                                 "angle",
                                                 "meanCurvature",
                                                 "reliability",
                                                 "crossesCut",
                                                 "notAssessable",
                                                 "end1U",
                                                 "end1V",
                                                 "end1X",
                                                 "end1Y",
                                                 "end1Z",
                                                 "end1Reliability",
                                                 "end2U",
                                                 "end2V",
                                                 "end2X",
                                                 "end2Y",
                                                 "end2Z",
                                                 "end2Reliability" };
  return columns;
}

HaustralFold
FoldOfRow(const CsvFile & file, std::size_t row)
{
  HaustralFold fold;
  fold.label = static_cast<int>(file.Number(row, "fold"));
  fold.arcLength = file.NumberOrNothing(row, "arcLength");
  fold.centerUv = { file.Number(row, "u"), file.Number(row, "v") };
  fold.center = PointOf(file, row, "");
  fold.length = file.Number(row, "length");
  fold.area = file.Number(row, "area");
  fold.height = file.NumberOrNothing(row, "height");
  fold.elongation = file.Number(row, "elongation");
  fold.angle = file.Number(row, "angle");
  fold.meanCurvature = file.Number(row, "meanCurvature");
  fold.reliability = file.Number(row, "reliability");
  fold.crossesCut = file.Number(row, "crossesCut") != 0.0;
  for (int end = 0; end < 2; ++end)
  {
    const std::string name = end == 0 ? "end1" : "end2";
    fold.endUv[end] = { file.Number(row, name + "U"), file.Number(row, name + "V") };
    fold.ends[end] = PointOf(file, row, name);
    fold.endReliability[end] = file.Number(row, name + "Reliability");
  }
  return fold;
}

ColonHindrance
HindranceOfRow(const CsvFile & file, std::size_t row, const std::string & path)
{
  try
  {
    return HindranceOfName(file.Text(row, "notAssessable"));
  }
  catch (const InputError & error)
  {
    throw InputError('"' + path + "\", line " + std::to_string(file.LineOf(row)) + ": " + error.GetDescription());
  }
}
} // namespace

CsvTable
TableOfFolds(const HaustralFolds & folds)
{
  CsvTable table(ColumnsOfFolds());
  for (const HaustralFold & fold : folds.folds)
  {
    std::vector<std::string> cells{
      std::to_string(fold.label), Cell(fold.arcLength), Cell(fold.centerUv.x()), Cell(fold.centerUv.y())
    };
    AddPoint(cells, fold.center);
    for (const double value :
         { fold.length, fold.area, fold.height, fold.elongation, fold.angle, fold.meanCurvature, fold.reliability })
    {
      cells.push_back(Cell(value));
    }
    cells.push_back(fold.crossesCut ? "1" : "0");
    cells.push_back(fold.hindrance == ColonHindrance::None ? "" : NameOf(fold.hindrance));
    for (int end = 0; end < 2; ++end)
    {
      cells.push_back(Cell(fold.endUv[end].x()));
      cells.push_back(Cell(fold.endUv[end].y()));
      AddPoint(cells, fold.ends[end]);
      cells.push_back(Cell(fold.endReliability[end]));
    }
    table.AddRow(std::move(cells));
  }
  return table;
}

std::vector<HaustralFold>
ReadFoldTable(const std::string & path)
{
  const CsvFile             file(path, ColumnsOfFolds());
  std::vector<HaustralFold> folds;
  for (std::size_t row = 0; row < file.Rows(); ++row)
  {
    folds.push_back(FoldOfRow(file, row));
    folds.back().hindrance = HindranceOfRow(file, row, path);
  }
  return folds;
}
} // namespace shapeton
