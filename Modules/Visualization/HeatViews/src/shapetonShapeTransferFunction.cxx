#include "shapetonShapeTransferFunction.h"

#include "shapetonColorMap.h"
#include "shapetonCsvTable.h"
#include "shapetonExceptions.h"
#include "shapetonHeatColoring.h"

#include <vtkColorTransferFunction.h>
#include <vtkPiecewiseFunction.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>

namespace shapeton
{
namespace
{
constexpr double narrowestLine = 1e-7; // heat; narrower lines are refused
// 3D Slicer reads the lines of a .vp file into a buffer of 1024 characters, and samples a function at 16,384 places at
// most, as many as fit a texture: more than it needs for points of this distance over all heats.
constexpr std::size_t greatestLineLength = 1023;
constexpr double      closestForSlicer = 1.0 / 16000.0;

// Lighting of a shaded heat volume.
constexpr double ambient = 0.3;
constexpr double diffuse = 0.6;
constexpr double specular = 0.2;
constexpr double specularPower = 10.0;

std::string
Trimmed(const std::string & text)
{
  const std::size_t first = text.find_first_not_of(" \t");
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::vector<std::string>
Split(const std::string & text, char separator)
{
  std::vector<std::string> parts;
  std::string              part;
  std::istringstream       stream(text);
  while (std::getline(stream, part, separator))
  {
    parts.push_back(Trimmed(part));
  }
  if (text.empty() || text.back() == separator)
  {
    parts.emplace_back();
  }
  return parts;
}

/** Removes the longest unsigned number from the start of the text; returns false if there is none. */
bool
TakeNumber(std::string & text, double & value)
{
  if (text.empty() || !(text[0] == '.' || (text[0] >= '0' && text[0] <= '9')))
  {
    return false;
  }
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc())
  {
    return false;
  }
  text = Trimmed(text.substr(result.ptr - text.data()));
  return true;
}

void
ParseRange(const std::string & text, const std::string & line, TransferFunctionLine & parsed)
{
  std::string rest(text);
  bool        isRange = TakeNumber(rest, parsed.lowerHeat) && !rest.empty() && rest[0] == '-';
  if (isRange)
  {
    rest = Trimmed(rest.substr(1));
    isRange = TakeNumber(rest, parsed.upperHeat) && rest.empty();
  }
  if (!isRange)
  {
    throw ParameterError("\"" + text + "\" in the line \"" + line +
                         "\" is not a heat range a-b, for example 0.18-0.21");
  }
}

TransferFunctionLine
ParseLine(const std::string & text)
{
  const std::vector<std::string> parts = Split(text, ':');
  if (parts.size() != 3)
  {
    throw ParameterError("the line \"" + text +
                         "\" is not of the form a-b:color:opacity, for example 0.18-0.21:red:0.8");
  }
  TransferFunctionLine line;
  ParseRange(parts[0], text, line);
  const auto color = ColorOf(parts[1]);
  if (!color)
  {
    throw ParameterError("\"" + parts[1] + "\" in the line \"" + text + "\" is not a color: use #rrggbb or one of " +
                         ColorNames());
  }
  line.color = *color;
  std::string opacity(parts[2]);
  if (!TakeNumber(opacity, line.opacity) || !opacity.empty())
  {
    throw ParameterError("\"" + parts[2] + "\" in the line \"" + text +
                         "\" is not an opacity: use a number from 0 to 1");
  }
  return line;
}

std::string
RangeText(const TransferFunctionLine & line)
{
  return CsvTable::Number(line.lowerHeat) + "-" + CsvTable::Number(line.upperHeat);
}

void
Check(const TransferFunctionLine & line)
{
  if (!(line.lowerHeat >= 0.0 && line.upperHeat <= 1.0 && line.lowerHeat < line.upperHeat))
  {
    throw ParameterError("the heat range " + RangeText(line) + " is invalid: it requires 0 <= a < b <= 1");
  }
  if (line.upperHeat - line.lowerHeat < narrowestLine)
  {
    throw ParameterError("the heat range " + RangeText(line) + " is narrower than 1e-7: widen it");
  }
  if (!(line.opacity >= 0.0 && line.opacity <= 1.0))
  {
    throw ParameterError("the opacity " + CsvTable::Number(line.opacity) + " of the line " + RangeText(line) +
                         " is invalid: use a number from 0 to 1");
  }
}

/** 0 for incoherent classes; 0.9 up to the median voxel count of the coherent ones. For larger classes,
 * 0.9 (median / voxel count)^(2/3), at least 0.03, so a class that fills much of the volume becomes a veil. */
double
OpacityFor(const HeatClass & heatClass, std::uint64_t middleVoxels)
{
  if (IsIncoherent(heatClass))
  {
    return 0.0;
  }
  constexpr double most = 0.9;
  constexpr double least = 0.03;
  const double     root = std::cbrt(static_cast<double>(std::max<std::uint64_t>(middleVoxels, 1)) /
                                static_cast<double>(std::max<std::uint64_t>(heatClass.voxels, 1)));
  return std::round(100.0 * std::clamp(most * root * root, least, most)) / 100.0;
}

std::uint64_t
MiddleNumberOfVoxels(const std::vector<HeatClass> & classes)
{
  std::vector<std::uint64_t> voxels;
  for (const HeatClass & heatClass : classes)
  {
    if (!IsIncoherent(heatClass))
    {
      voxels.push_back(heatClass.voxels);
    }
  }
  std::sort(voxels.begin(), voxels.end());
  return voxels.empty() ? 0 : voxels[(voxels.size() - 1) / 2];
}

/** Points of a piecewise linear function: heat and `Size` values. */
template <std::size_t Size>
using Points = std::vector<std::array<double, Size + 1>>;

/** Width of the ramp that approximates a step, small relative to the line. */
double
NarrowRamp(const TransferFunctionLine & line)
{
  constexpr double widest = 1e-6;
  return std::min(widest, 0.125 * (line.upperHeat - line.lowerHeat));
}

double
RampForSlicer(const TransferFunctionLine &)
{
  return closestForSlicer;
}

/** Moves points up that are closer than 3D Slicer samples. */
template <typename TPoints>
TPoints
SpreadForSlicer(TPoints points)
{
  for (std::size_t k = 1; k < points.size(); ++k)
  {
    points[k][0] = std::max(points[k][0], points[k - 1][0] + closestForSlicer);
  }
  return points;
}

using Ramp = double(const TransferFunctionLine &);

Points<1>
OpacityPoints(const std::vector<TransferFunctionLine> & lines, Ramp & rampOf)
{
  Points<1> points;
  double    previousEnd = 0.0;
  if (lines.empty() || lines.front().lowerHeat > 0.0)
  {
    points.push_back({ 0.0, 0.0 });
  }
  for (const TransferFunctionLine & line : lines)
  {
    const double gap = line.lowerHeat - previousEnd;
    if (gap > 0.0)
    {
      points.push_back({ line.lowerHeat - std::min(rampOf(line), 0.5 * gap), 0.0 });
    }
    points.push_back({ line.lowerHeat, line.opacity });
    points.push_back({ line.upperHeat - rampOf(line), line.opacity });
    const bool isFollowed = &line != &lines.back() && (&line + 1)->lowerHeat <= line.upperHeat;
    if (!isFollowed)
    {
      points.push_back({ line.upperHeat, 0.0 });
    }
    previousEnd = line.upperHeat;
  }
  return points;
}

Points<3>
ColorPoints(const std::vector<TransferFunctionLine> & lines, Ramp & rampOf)
{
  Points<3> points;
  for (const TransferFunctionLine & line : lines)
  {
    const double red = line.color[0] / 255.0;
    const double green = line.color[1] / 255.0;
    const double blue = line.color[2] / 255.0;
    points.push_back({ line.lowerHeat, red, green, blue });
    points.push_back({ line.upperHeat - rampOf(line), red, green, blue });
  }
  return points;
}

/** "<number of values> <heat> <value>... <heat> <value>...". */
template <typename TPoints>
std::string
PointsText(const TPoints & points, double unit)
{
  std::string values;
  std::size_t number = 0;
  for (const auto & point : points)
  {
    values += " " + CsvTable::Rounded(point[0] * unit, 9);
    for (std::size_t i = 1; i < point.size(); ++i)
    {
      values += " " + CsvTable::Rounded(point[i], 4);
    }
    number += point.size();
  }
  return std::to_string(number) + values;
}

} // namespace

ShapeTransferFunction::ShapeTransferFunction(std::vector<TransferFunctionLine> lines) : m_Lines(std::move(lines))
{
  std::for_each(m_Lines.begin(), m_Lines.end(), Check);
  if (m_Lines.size() > MaximumNumberOfLines)
  {
    throw ParameterError("a transfer function has at most " + std::to_string(MaximumNumberOfLines) + " lines, not " +
                         std::to_string(m_Lines.size()) + ": 3D Slicer cannot read more from a volume property file");
  }
  std::sort(m_Lines.begin(), m_Lines.end(), [](const TransferFunctionLine & a, const TransferFunctionLine & b) {
    return a.lowerHeat < b.lowerHeat;
  });
  for (std::size_t i = 1; i < m_Lines.size(); ++i)
  {
    if (m_Lines[i].lowerHeat < m_Lines[i - 1].upperHeat)
    {
      throw ParameterError("the lines " + RangeText(m_Lines[i - 1]) + " and " + RangeText(m_Lines[i]) +
                           " overlap: lines must be disjoint");
    }
  }
}

ShapeTransferFunction
ShapeTransferFunction::OfClasses(std::vector<TransferFunctionLine> lines)
{
  const auto number = static_cast<double>(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    lines[i].lowerHeat = static_cast<double>(i) / number;
    lines[i].upperHeat = static_cast<double>(i + 1) / number;
  }
  ShapeTransferFunction classes;
  classes.m_Lines = std::move(lines);
  return classes;
}

ShapeTransferFunction
ShapeTransferFunction::Parse(const std::string & text)
{
  std::vector<TransferFunctionLine> lines;
  for (const std::string & line : Split(text, ','))
  {
    lines.push_back(ParseLine(line));
  }
  return ShapeTransferFunction(std::move(lines));
}

ShapeTransferFunction
ShapeTransferFunction::FromClasses(const std::vector<HeatClass> & classes)
{
  std::vector<HeatClass> objects;
  std::copy_if(classes.begin(), classes.end(), std::back_inserter(objects), [](const HeatClass & heatClass) {
    return heatClass.label != 0 && heatClass.upperHeat - heatClass.lowerHeat >= narrowestLine;
  });
  const auto isSurroundings = [](const HeatClass & heatClass) { return heatClass.isSurroundings; };
  if (!std::all_of(objects.begin(), objects.end(), isSurroundings))
  {
    objects.erase(std::remove_if(objects.begin(), objects.end(), isSurroundings), objects.end());
  }
  const std::uint64_t               middle = MiddleNumberOfVoxels(objects);
  std::vector<TransferFunctionLine> lines;
  for (const HeatClass & object : objects)
  {
    const double upper = std::min(object.upperHeat, 1.0);
    lines.push_back({ object.lowerHeat, upper, ColorOfClass(object), OpacityFor(object, middle), NameOfClass(object) });
  }
  return ShapeTransferFunction(std::move(lines));
}

int
ShapeTransferFunction::LineOf(float heat) const
{
  const auto after =
    std::upper_bound(m_Lines.begin(), m_Lines.end(), heat, [](double value, const TransferFunctionLine & l) {
      return value < l.lowerHeat;
    });
  if (after == m_Lines.begin() || heat >= (after - 1)->upperHeat)
  {
    // Heat 1 is included in a line that ends at 1.
    const bool isAtEnd = !m_Lines.empty() && heat >= 1.0F && m_Lines.back().upperHeat >= 1.0;
    return isAtEnd ? static_cast<int>(m_Lines.size()) - 1 : -1;
  }
  return static_cast<int>(after - m_Lines.begin()) - 1;
}

ShapeTransferFunction
ShapeTransferFunction::OnlyLine(std::size_t line) const
{
  return ShapeTransferFunction({ m_Lines.at(line) });
}

std::string
ShapeTransferFunction::ToText() const
{
  std::string text;
  for (const TransferFunctionLine & line : m_Lines)
  {
    text +=
      (text.empty() ? "" : ",") + RangeText(line) + ":" + HexOf(line.color) + ":" + CsvTable::Number(line.opacity);
  }
  return text;
}

vtkSmartPointer<vtkVolumeProperty>
ShapeTransferFunction::ToVolumeProperty() const
{
  auto opacity = vtkSmartPointer<vtkPiecewiseFunction>::New();
  for (const auto & point : OpacityPoints(m_Lines, NarrowRamp))
  {
    opacity->AddPoint(point[0], point[1]);
  }
  auto color = vtkSmartPointer<vtkColorTransferFunction>::New();
  for (const auto & point : ColorPoints(m_Lines, NarrowRamp))
  {
    color->AddRGBPoint(point[0], point[1], point[2], point[3]);
  }
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  property->SetScalarOpacity(opacity);
  property->SetColor(color);
  property->SetInterpolationTypeToNearest();
  property->ShadeOn();
  property->SetAmbient(ambient);
  property->SetDiffuse(diffuse);
  property->SetSpecular(specular);
  property->SetSpecularPower(specularPower);
  return property;
}

void
ShapeTransferFunction::WriteVolumeProperty(const std::string & path, double unit) const
{
  constexpr int                  nearestNeighbor = 0;
  constexpr int                  shaded = 1;
  const std::vector<std::string> rows{ std::to_string(nearestNeighbor),
                                       std::to_string(shaded),
                                       CsvTable::Number(diffuse),
                                       CsvTable::Number(ambient),
                                       CsvTable::Number(specular),
                                       CsvTable::Number(specularPower),
                                       PointsText(SpreadForSlicer(OpacityPoints(m_Lines, RampForSlicer)), unit),
                                       PointsText(Points<1>{ { 0.0, 1.0 }, { 1.0, 1.0 } }, unit),
                                       PointsText(SpreadForSlicer(ColorPoints(m_Lines, RampForSlicer)), unit) };
  std::ofstream                  file(path, std::ios::binary);
  for (const std::string & row : rows)
  {
    if (row.size() > greatestLineLength)
    {
      throw OutputError("the volume property " + path +
                        " would have a line longer than 3D Slicer can read: use fewer lines");
    }
    file << row << '\n';
  }
  file.close();
  if (!file)
  {
    throw OutputError("cannot write the volume property " + path +
                      ": check that the folder exists, is writable and not full");
  }
}
} // namespace shapeton
