#include "shapetonShapeTable.h"

#include "shapetonCsvFile.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace shapeton
{
namespace
{
/** Columns of the table. */
constexpr const char * LabelColumn = "label";
constexpr const char * ComponentColumn = "component";
constexpr const char * VoxelsColumn = "voxels";
constexpr const char * MeanColumn = "meanIntensity";
constexpr const char * DeviationColumn = "intensityDeviation";
const std::string      HeatColumn = "remainingHeat_";

/** Calls `body(column, number)` for each number of a signature, const or not. */
template <typename TSignature, typename TBody>
void
ForEachNumber(TSignature & signature, const TBody & body)
{
  body("volume", signature.volume);
  body("surface", signature.surface);
  body("elongation", signature.elongation);
  body("flatness", signature.flatness);
  const auto & times = ShapeSignature::Times();
  for (std::size_t k = 0; k < times.size(); ++k)
  {
    body(HeatColumn + CsvTable::Rounded(times[k], 3), signature.remainingHeat[k]);
  }
  for (std::size_t k = 0; k < times.size(); ++k)
  {
    body("displacement_" + CsvTable::Rounded(times[k], 3), signature.displacement[k]);
  }
  for (std::size_t k = 0; k < signature.spectrum.size(); ++k)
  {
    body("eigenvalue_" + std::to_string(k + 1), signature.spectrum[k]);
  }
}

std::vector<std::string>
Columns()
{
  std::vector<std::string> columns{ LabelColumn, ComponentColumn, VoxelsColumn, MeanColumn, DeviationColumn };
  const ShapeSignature     any;
  ForEachNumber(any, [&](const std::string & column, double) { columns.push_back(column); });
  return columns;
}

/** Mean and standard deviation of the intensities within a shape. */
void
DescribeIntensities(const itk::Image<float, 3> * intensities, const VoxelRuns & shape, ShapeRow & row)
{
  const VoxelGrid grid(shape.size[0], shape.size[1], shape.size[2]);
  const float *   values = intensities->GetBufferPointer();
  double          sum = 0.0, squares = 0.0;
  ForEachRun(shape, [&](std::size_t run, int j, int k) {
    for (int i = shape.runs[run].begin; i < shape.runs[run].end; ++i)
    {
      const double value = values[grid.Index(i, j, k)];
      sum += value;
      squares += value * value;
    }
  });
  const auto voxels = static_cast<double>(row.voxels);
  row.meanIntensity = sum / voxels;
  row.intensityDeviation = std::sqrt(std::max(0.0, squares / voxels - row.meanIntensity * row.meanIntensity));
}

/** Adds a shape, or a remark if it has no signature. */
void
Describe(const itk::Image<float, 3> * intensities, const VoxelRuns & shape, ShapeRow row, ShapeTable & table)
{
  row.voxels = CountVoxels(shape);
  try
  {
    row.signature = ComputeShapeSignature(shape, intensities);
  }
  catch (const InputError & error)
  {
    table.remarks.push_back("label " + row.Name() + " is skipped: " + error.what());
    return;
  }
  DescribeIntensities(intensities, shape, row);
  table.rows.push_back(row);
}

/** The components of a label that are large enough, numbered from 1. */
void
DescribeComponents(const itk::Image<float, 3> * intensities,
                   const VoxelRuns &            label,
                   const ShapeRow &             row,
                   ShapeTable &                 table)
{
  const auto  components = ComponentsOf(label, ShapeSignature::LeastVoxels);
  std::size_t voxels = 0;
  for (std::size_t i = 0; i < components.size(); ++i)
  {
    ShapeRow part = row;
    part.component = static_cast<int>(i) + 1;
    Describe(intensities, components[i], part, table);
    voxels += CountVoxels(components[i]);
  }
  if (const std::size_t rest = CountVoxels(label) - voxels; rest > 0)
  {
    table.remarks.push_back("label " + row.Name() + ": " + std::to_string(rest) +
                            " voxels in components with fewer than " + std::to_string(ShapeSignature::LeastVoxels) +
                            " voxels are skipped");
  }
}

/** Whether the numbers, starting with `first`, are monotonic up to rounding. */
template <std::size_t Size>
bool
IsMonotonic(const std::array<double, Size> & values, bool ascending)
{
  constexpr double clearly = 1.0 - 1e-6; // by more than rounding
  return std::is_sorted(values.begin(), values.end(), [ascending](double a, double b) {
    return ascending ? a < b * clearly : a * clearly > b;
  });
}

int
WholeNumber(const CsvFile & file, std::size_t row, const char * column, const std::string & place)
{
  const double     value = file.Number(row, column);
  constexpr double greatest = 2e9; // fits into 32 bits
  if (!(value >= 0.0 && value <= greatest && value == std::floor(value)))
  {
    throw InputError(place + ": the " + column + " " + file.Text(row, column) + " is not a non-negative integer");
  }
  return static_cast<int>(value);
}
} // namespace

std::string
ShapeRow::Name() const
{
  return std::to_string(label) + (component == 0 ? "" : "." + std::to_string(component));
}

ShapeTable
DescribeShapes(const itk::Image<float, 3> * intensities,
               const LabelMap *             labels,
               const ShapeTableOptions &    options,
               const Progress &             progress)
{
  if (intensities->GetBufferedRegion() != labels->GetBufferedRegion())
  {
    throw std::invalid_argument("The labels and the intensities have different sizes");
  }
  const std::vector<int> all = LabelsOf(labels);
  ShapeTable             table;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    progress(static_cast<double>(i) / static_cast<double>(all.size()));
    ShapeRow row;
    row.label = all[i];
    const VoxelRuns shape = VoxelsOfLabel(labels, row.label);
    if (options.components)
    {
      DescribeComponents(intensities, shape, row, table);
    }
    else
    {
      Describe(intensities, shape, row, table);
    }
  }
  progress(1.0);
  if (table.rows.empty())
  {
    throw InputError("no shape has a signature: " + table.remarks.front());
  }
  return table;
}

void
WriteShapeTable(const ShapeTable & table, const std::string & path)
{
  CsvTable csv(Columns());
  for (const ShapeRow & row : table.rows)
  {
    std::vector<std::string> cells{ std::to_string(row.label),
                                    std::to_string(row.component),
                                    std::to_string(row.voxels),
                                    CsvTable::Rounded(row.meanIntensity, 6),
                                    CsvTable::Rounded(row.intensityDeviation, 6) };
    ForEachNumber(row.signature, [&](const std::string &, double value) { cells.push_back(CsvTable::Number(value)); });
    csv.AddRow(cells);
  }
  csv.Write(path);
}

ShapeTable
ReadShapeTable(const std::string & path)
{
  const CsvFile file(path, Columns());
  ShapeTable    table;
  for (std::size_t i = 0; i < file.Rows(); ++i)
  {
    const std::string place = path + ", line " + std::to_string(file.LineOf(i));
    ShapeRow          row;
    row.label = WholeNumber(file, i, LabelColumn, place);
    row.component = WholeNumber(file, i, ComponentColumn, place);
    row.voxels = WholeNumber(file, i, VoxelsColumn, place);
    row.meanIntensity = file.Number(i, MeanColumn);
    row.intensityDeviation = file.Number(i, DeviationColumn);
    ForEachNumber(row.signature, [&](const std::string & column, double & value) { value = file.Number(i, column); });
    RequireSound(row.signature, place);
    table.rows.push_back(row);
  }
  if (table.rows.empty())
  {
    throw InputError(path + ": the table contains no shape; create it with ShapeSignature");
  }
  return table;
}

void
RequireSound(const ShapeSignature & signature, const std::string & what)
{
  ForEachNumber(signature, [&](const std::string & column, double value) {
    const bool isHeat = column.rfind(HeatColumn, 0) == 0; // which ends at 0
    if (!(std::isfinite(value) && (isHeat ? value >= 0.0 : value > 0.0)))
    {
      throw InputError(what + ": " + column + " is " + CsvTable::Number(value) + ", which is out of range");
    }
  });
  if (!IsMonotonic(signature.remainingHeat, false) || !IsMonotonic(signature.displacement, true) ||
      !IsMonotonic(signature.spectrum, true) || signature.remainingHeat[0] > 1.0 || signature.elongation < 1.0 ||
      signature.flatness < 1.0)
  {
    throw InputError(what + ": not a valid signature; heat must decrease, displacement and eigenvalues must increase");
  }
}
} // namespace shapeton
