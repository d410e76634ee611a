#include "shapetonHeatReport.h"

#include "shapetonAxisTicks.h"
#include "shapetonColorMap.h"
#include "shapetonHeatHistogramPicture.h"
#include "shapetonHtmlReport.h"
#include "shapetonJson.h"
#include "shapetonSliceChoice.h"
#include "shapetonSliceMontage.h"
#include "shapetonTransferFunctionPicture.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <set>
#include <stdexcept>

namespace shapeton
{
namespace
{
using Facts = HeatReportContent::Facts;

std::string
Joined(const double (&values)[3])
{
  return CsvTable::Rounded(values[0], 6) + ", " + CsvTable::Rounded(values[1], 6) + ", " +
         CsvTable::Rounded(values[2], 6);
}

Facts
GeometryOf(const itk::ImageBase<3> * image)
{
  const auto   size = image->GetLargestPossibleRegion().GetSize();
  const auto & direction = image->GetDirection();
  const double spacing[3] = { image->GetSpacing()[0], image->GetSpacing()[1], image->GetSpacing()[2] };
  const double origin[3] = { image->GetOrigin()[0], image->GetOrigin()[1], image->GetOrigin()[2] };
  std::string  cosines;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const double column[3] = { direction[0][axis], direction[1][axis], direction[2][axis] };
    cosines += (axis == 0 ? "(" : " (") + Joined(column) + ")";
  }
  return { { "Size, voxels",
             std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " + std::to_string(size[2]) },
           { "Spacing, mm", Joined(spacing) },
           { "Origin, mm (LPS)", Joined(origin) },
           { "Directions of the axes (LPS)", cosines } };
}

template <typename TItem>
void
Append(std::vector<TItem> & items, const std::vector<TItem> & more)
{
  items.insert(items.end(), more.begin(), more.end());
}

Facts
Combined(Facts facts, const Facts & more)
{
  Append(facts, more);
  return facts;
}

std::string
TextOf(const Json & value, int digits)
{
  return value.is_string()          ? value.get<std::string>()
         : !value.is_number_float() ? std::to_string(value.get<std::uint64_t>())
         : digits > 0               ? CsvTable::Rounded(value, digits)
                                    : CsvTable::Number(value);
}

/** A column of classes. */
struct ClassColumn
{
  std::string                              name;    ///< in report.json and classes.csv
  std::string                              heading; ///< in the table for readers
  std::function<Json(const HeatClass &)>   value;
  int                                      digits{ 0 }; ///< in classes.csv; 0: all
  std::function<std::string(const Json &)> shown{ [](const Json & value) { return TextOf(value, 4); } };
};
using ClassColumns = std::vector<ClassColumn>;

/** The columns, in the order of the table for readers. Components are computed for heat only. */
ClassColumns
ColumnsOfClasses(const ShapeQuantity & quantity)
{
  const auto shortly = [](const Json & value) { return TextOf(value, 2); };
  const auto grouped = [](const Json & value) { return GroupedDigits(value); };
  const auto named = [](const Json & label) { return label == 0 ? "background" : TextOf(label, 0); };
  const auto milliliters = [](const Json & volume) { return CsvTable::Rounded(volume.get<double>() / 1000.0, 4); };
  const auto unless0 = [](const Json & value) { return value == 0.0 ? "" : TextOf(value, 4); };
  const auto colorOf = [](const HeatClass & c) -> Json { return c.label == 0 ? "" : HexOf(ColorOfClass(c)); };
  const auto coherence = [](const HeatClass & c) { return c.coherence ? Json(*c.coherence) : Json(""); };
  const std::string title = quantity.GetTitle();
  ClassColumns      columns = {
         { "label", "class", [](const HeatClass & c) { return c.label; }, 0, named },
    { "color", "color", colorOf },
    { "lower" + title, quantity.name + " from", [](const HeatClass & c) { return c.lowerHeat; } },
    { "upper" + title, "to", [](const HeatClass & c) { return c.upperHeat; } },
    { "mean" + title, "mean " + quantity.name, [](const HeatClass & c) { return c.meanHeat; } },
    { "voxels", "voxels", [](const HeatClass & c) { return c.voxels; }, 0, grouped },
    { "volume", "volume, ml", [](const HeatClass & c) { return c.volume; }, 0, milliliters },
    { "borderShare", "share of the border", [](const HeatClass & c) { return c.borderShare; }, 6, shortly },
    { "coherence", "coherence", coherence, 6, shortly }
  };
  if (quantity.kind == ShapeQuantity::Kind::Heat)
  {
    columns.push_back({ "components", "closed components", [](const HeatClass & c) { return c.components; } });
    columns.push_back(
      { "normalizedHeat", "scale-normalized heat", [](const HeatClass & c) { return c.normalizedHeat; }, 0, unless0 });
  }
  else
  {
    columns.push_back({ "meanVisits",
                        "mean number of visits",
                        [greatest = quantity.greatestVisits](const HeatClass & c) { return c.meanHeat * greatest; },
                        6 });
  }
  return columns;
}

/** The columns of a file; those named in `last` are moved to the end. */
ClassColumns
FileColumns(const ShapeQuantity & quantity, const std::vector<std::string> & last)
{
  ClassColumns columns = ColumnsOfClasses(quantity);
  for (const std::string & name : last)
  {
    std::stable_partition(
      columns.begin(), columns.end(), [&](const ClassColumn & column) { return column.name != name; });
  }
  return columns;
}

/** A table with the given heading and text of each column. */
template <typename TText>
CsvTable
TableOf(const std::vector<HeatClass> & classes,
        const ClassColumns &           columns,
        std::string ClassColumn::*heading,
        const TText &             text)
{
  std::vector<std::string> headings;
  for (const ClassColumn & column : columns)
  {
    headings.push_back(column.*heading);
  }
  CsvTable table(headings);
  for (const HeatClass & heatClass : classes)
  {
    std::vector<std::string> row;
    for (const ClassColumn & column : columns)
    {
      row.push_back(text(column, column.value(heatClass)));
    }
    table.AddRow(row);
  }
  return table;
}

Json
JsonOf(const Facts & facts)
{
  Json object = Json::object();
  for (const auto & [name, value] : facts)
  {
    object[name] = value;
  }
  return object;
}

/** The classes, with the named columns, or with all columns if there are no names. */
Json
JsonOf(const std::vector<HeatClass> & classes, const ShapeQuantity & quantity, const std::set<std::string> & names = {})
{
  Json list = Json::array();
  for (const HeatClass & heatClass : classes)
  {
    list.push_back(Json::object());
    for (const ClassColumn & column : FileColumns(quantity, { "color" }))
    {
      if (names.empty() || names.count(column.name) > 0)
      {
        list.back()[column.name] = column.value(heatClass);
      }
    }
  }
  return list;
}

/** Axis of the innermost range, or the whole axis. */
HeatAxis
AxisOf(const HeatReportContent & content, const HeatRange & range = {})
{
  return HeatAxis(content.axisHistogram ? *content.axisHistogram : *content.histogram, content.scale, range);
}

/** Contents of the innermost zoomed range at the last time step. */
struct OpenedRange
{
  explicit OpenedRange(const HeatReportContent & content)
    : range(content.ranges.back())
    , classes(FindClassesInside(*content.histogram, content.histogram->GetNumberOfRows() - 1, range))
    , lines(ShapeTransferFunction::FromClasses(classes))
  {}

  HeatRange              range;
  std::vector<HeatClass> classes;
  ShapeTransferFunction  lines;
};

/** The ranges, and the lines of the innermost one. */
Json
JsonOfRanges(const HeatReportContent & content)
{
  const OpenedRange opened(content);
  const std::string title = content.quantity.GetTitle();
  Json              ranges = Json::array();
  for (const HeatRange & range : content.ranges)
  {
    ranges.push_back({ range.lower, range.upper });
  }
  const Json lines = JsonOf(
    opened.classes, content.quantity, { "label", "lower" + title, "upper" + title, "mean" + title, "voxels", "color" });
  return { { "ranges", ranges }, { "lines", lines }, { "transferFunction", opened.lines.ToText() } };
}

Json
JsonOf(const HeatReportContent & content, const ShapeTransferFunction & transferFunction)
{
  Json document;
  document["title"] = content.title;
  document["input"] = JsonOf(Combined(content.input, GeometryOf(content.gray)));
  document["parameters"] = JsonOf(content.parameters);
  if (content.timeStep)
  {
    document["timeStep"] = *content.timeStep;
  }
  document["classes"] = JsonOf(content.classes, content.quantity);
  document["transferFunction"] = transferFunction.ToText();
  if (!content.ranges.empty())
  {
    document["histogramRange"] = JsonOfRanges(content);
  }
  document["warnings"] = content.warnings;
  document["provenance"] = JsonOf(content.provenance);
  return document;
}

/** The lines as text, and a note if there are also classes of objects. */
std::string
TextOfClasses(const ShapeTransferFunction & lines, const ShapeTransferFunction & classes)
{
  const bool hasObjects = classes.GetLines().size() > lines.GetLines().size();
  if (lines.GetLines().empty() && hasObjects)
  {
    return "objects";
  }
  return "the lines " + lines.ToText() + (hasObjects ? " and objects" : "");
}

Picture::Pointer
Slices(const HeatReportContent &        content,
       const std::string &              title,
       const HeatColoring &             coloring,
       const std::vector<LegendEntry> & legend)
{
  const auto          cut = CutThroughParts(content.heat, ShapeTransferFunction::FromClasses(content.classes));
  SliceMontageOptions options{ title, content.window, cut, legend };
  return DrawSliceMontage(content.gray, content.heat, coloring, options);
}

ShapeTransferFunction
ShownLines(const HeatReportContent & content)
{
  return content.transferFunction ? *content.transferFunction : ShapeTransferFunction::FromClasses(content.classes);
}

std::string
TitleOfHistogram(const ShapeQuantity & quantity)
{
  return quantity.GetTitle() + " histogram";
}

HeatHistogramPictureOptions
HistogramOptions(const HeatReportContent & content)
{
  HeatHistogramPictureOptions options;
  options.title = TitleOfHistogram(content.quantity);
  options.quantity = content.quantity;
  options.axisHistogram = content.axisHistogram;
  options.scale = content.scale;
  options.markedTimeSteps = content.markedTimeSteps;
  return options;
}

std::string
CaptionOfRange(const HeatReportContent & content)
{
  const OpenedRange opened(content);
  std::uint64_t     voxels = 0;
  for (const HeatClass & line : opened.classes)
  {
    voxels += line.voxels;
  }
  return "The histogram from " + CsvTable::Rounded(opened.range.lower, 4) + " to " +
         CsvTable::Rounded(opened.range.upper, 4) + " only, equalized again: " + GroupedDigits(voxels) +
         " voxels at the last time step. The bars below are the lines found in this range.";
}

void
AddSummary(HtmlReport & html, const HeatReportContent & content)
{
  html.AddResearchNote();
  html.AddWarnings(content.warnings);
  html.AddHeading("Input");
  html.AddFacts(Combined(content.input, GeometryOf(content.gray)));
  html.AddHeading("Parameters");
  html.AddFacts(content.parameters);
}

std::vector<std::string>
ReadingGuideOfHeat()
{
  return {
    "Heat starts at the edges of the image. In each time step, it flows to neighbors of "
    "similar intensity, but hardly across edges. A region enclosed by edges converges to one value, which "
    "depends on its shape and size. A region open to the border of the volume loses its heat to the "
    "background.",
    "Histogram: time runs downwards, heat to the right. A vertical line at the bottom is an object, or several "
    "objects of similar shape. Early time steps (top) show local shape such as edges and corners, late ones (bottom) "
    "whole objects. On the equalized scale, width is proportional to the number of voxels, so distances along the "
    "axis are not heat differences; use the axis labels.",
    "In the histogram and the slices of heat, colors run from blue (lowest) to red (highest) along the axis. Each "
    "class has one color in rendering, slices, table, label file and in the bars below the histogram. "
    "A class is a heat range; two objects "
    "may share a class without being similar otherwise, and one organ may span several classes. The class "
    "that covers most of the volume's border is the surroundings, shown in gray. "
    "Coherence is near 1 for a class that is a region bounded by edges, and near 0 for speckle and for the voxels of "
    "edges, which rendering and slices omit. "
    "Heat also depends on size: it is lower for a larger object of the same shape. The scale-normalized heat "
    "of closed components is independent of size."
  };
}

std::vector<std::string>
ReadingGuideOfVisits()
{
  return {
    "Shapetons are particles. In each time step, each of them moves by the same distance in a random direction, "
    "weighted by the edges of the image, and the voxel where it ends counts one visit. Density is "
    "the number of visits divided by the maximum.",
    "Histogram: time runs downwards, density to the right. A vertical line at the bottom is an object, or several "
    "objects with similar visits. Visits are a sample: n visits have an error of about the square root of n, so "
    "lines are broad if visits are few; more shapetons or steps sharpen them.",
    "In the histogram and the slices of density, colors run from blue (fewest visits) to red (most) along the axis. "
    "Each class has one color in rendering, slices, table, label file and in the bars below the histogram. A class is "
    "a range of densities; two objects may share a class without being similar otherwise. Coherence is near 1 for a "
    "class that is a region, and 0 for scattered voxels, which rendering and slices omit.",
    "As published, only the end point of a step counts: steps longer than a feature pass over it and its walls. If "
    "all six neighbors are cut off by edges, a shapeton is trapped; such voxels have by far the most visits."
  };
}

void
AddReadingGuide(HtmlReport & html, const ShapeQuantity & quantity)
{
  html.AddHeading("How to read the pictures");
  for (const std::string & paragraph :
       quantity.kind == ShapeQuantity::Kind::Heat ? ReadingGuideOfHeat() : ReadingGuideOfVisits())
  {
    html.AddParagraph(paragraph);
  }
}
} // namespace

CsvTable
ClassTable(const std::vector<HeatClass> & classes, const ShapeQuantity & quantity)
{
  return TableOf(classes,
                 FileColumns(quantity, { "coherence", "color" }),
                 &ClassColumn::name,
                 [](const ClassColumn & column, const Json & value) { return TextOf(value, column.digits); });
}

Picture::Pointer
DrawHistogram(const HeatReportContent & content)
{
  HeatHistogramPictureOptions options = HistogramOptions(content);
  options.classes = content.classes;
  return DrawHeatHistogram(*content.histogram, options);
}

Picture::Pointer
DrawOpenedHistogram(const HeatReportContent & content)
{
  HeatHistogramPictureOptions options = HistogramOptions(content);
  options.title += ", opened";
  options.ranges = content.ranges;
  options.classes = OpenedRange(content).classes;
  return DrawHeatHistogram(*content.histogram, options);
}

Remarks
RangeRemarks(const HeatReportContent & content)
{
  if (content.ranges.empty())
  {
    return {};
  }
  const HeatHistogram & histogram = *content.histogram;
  for (std::size_t row = 0; row < histogram.GetNumberOfRows(); ++row)
  {
    const HeatHistogram         inside = RowInside(histogram, row, content.ranges.back());
    const std::uint32_t * const counts = inside.GetRow(0);
    if (std::any_of(counts + 1, counts + HeatHistogram::NumberOfBins, [](std::uint32_t count) { return count > 0; }))
    {
      return {};
    }
  }
  const HeatRange whole = AxisOf(content).GetRange();
  return { "the zoomed histogram is empty: no " + content.quantity.name +
           " is in its range at any recorded time step; all are between " + CsvTable::Rounded(whole.lower, 4) +
           " and " + CsvTable::Rounded(whole.upper, 4) };
}

CsvTable
ClassTable(const HeatReportContent & content)
{
  return ClassTable(content.classes, content.quantity);
}

CsvTable
HistogramTable(const HeatHistogram & histogram, const ShapeQuantity & quantity)
{
  constexpr unsigned int width = HeatHistogram::BinsPerOctave / 32;
  CsvTable               table({ "timeStep", "lower" + quantity.GetTitle(), "upper" + quantity.GetTitle(), "voxels" });
  for (std::size_t row = 0; row < histogram.GetNumberOfRows(); ++row)
  {
    for (unsigned int first = 0, end = 1; first < HeatHistogram::NumberOfBins; first = end, end += width)
    {
      const std::uint32_t * const counts = histogram.GetRow(row);
      const auto                  voxels = std::accumulate(counts + first, counts + end, std::uint64_t{ 0 });
      if (voxels > 0)
      {
        table.AddRow({ std::to_string(histogram.GetTimeSteps()[row]),
                       CsvTable::Number(HeatHistogram::LowerEdge(first)),
                       CsvTable::Number(HeatHistogram::LowerEdge(end)),
                       std::to_string(voxels) });
      }
    }
  }
  return table;
}

HeatReportContent::Facts
RunFacts(const CumulativeHeatDiffusionResult & result)
{
  Facts facts = { { "Intensity window",
                    CsvTable::Number(result.windowLower) + " to " + CsvTable::Number(result.windowUpper) },
                  { "p", CsvTable::Rounded(result.p, 6) },
                  { "Smoothing, mm", CsvTable::Rounded(result.smoothing, 6) } };
  facts.emplace_back("Time steps", std::to_string(result.timeStep) + (result.steady ? ": the heat is steady" : ""));
  if (result.steady)
  {
    facts.emplace_back(
      "Reason for the number of steps",
      "the histogram's lines are nearly vertical: over the last time interval, with ratio 2.5, the heat of at most "
      "one voxel in 1000 changed by more than 1 %");
  }
  facts.emplace_back("Time step length", CsvTable::Rounded(result.timeStepLength, 6));
  facts.emplace_back("Applications of the operator", std::to_string(result.operatorApplications));
  return facts;
}

HeatReportContent::Facts
ChoiceFacts(const HeatParameterChoice & choice)
{
  const Facts reasons = { { "Reason for the window", choice.windowReason },
                          { "Reason for p", choice.pReason },
                          { "Reason for the smoothing", choice.smoothingReason },
                          { "Reason for the time steps", choice.timeReason } };
  Facts       facts;
  std::copy_if(
    reasons.begin(), reasons.end(), std::back_inserter(facts), [](const auto & fact) { return !fact.second.empty(); });
  return facts;
}

HeatReportContent::Facts
ChosenValues(const HeatParameterChoice & choice)
{
  return { { "intensityWindow",
             CsvTable::Number(choice.intensityWindow[0]) + "," + CsvTable::Number(choice.intensityWindow[1]) },
           { "p", CsvTable::Number(choice.p) },
           { "smoothing", CsvTable::Number(choice.smoothing) },
           { "timeSteps", std::to_string(choice.timeSteps) } };
}

HeatReportContent
MakeReportContent(const CumulativeHeatDiffusionResult & result,
                  const itk::Image<float, 3> *          gray,
                  const itk::Image<float, 3> *          heat)
{
  HeatReportContent content;
  content.parameters = RunFacts(result);
  content.histogram = &result.histogram;
  content.gray = gray;
  content.heat = heat;
  content.timeStep = result.timeStep;
  return content;
}

namespace
{
constexpr long leastRegions = 3; // surroundings and two objects
} // namespace

std::vector<std::string>
RunRemarks(const CumulativeHeatDiffusionResult & result, bool untilSteady, std::uint64_t lastSnapshotStep)
{
  std::vector<std::string> remarks;
  const std::string        steps = std::to_string(result.timeStep) + " steps";
  const auto               regions =
    std::count_if(result.classes.begin(), result.classes.end(), [](const HeatClass & c) { return !IsIncoherent(c); });
  if (!result.cold && !result.classes.empty() && regions < leastRegions)
  {
    remarks.push_back(
      "only " + std::to_string(regions) + " of " + std::to_string(result.classes.size()) +
      " classes, with the surroundings, are regions bounded by edges: at this window, p and time, objects "
      "are connected by gaps without an edge, or differ by less than the noise");
  }
  if (lastSnapshotStep > result.timeStep)
  {
    remarks.push_back("the heat is steady after " + steps + ": snapshots of later steps were not written");
  }
  if (untilSteady && !result.steady)
  {
    remarks.push_back("the heat is not yet steady after " + steps);
  }
  return remarks;
}

void
WriteExplorer(const HeatReportContent & content, HeatExplorer & explorer)
{
  explorer.AddStep(content.heat, content.timeStep.value_or(0));
  HeatExplorerContent page = content;
  page.lines = ShownLines(content);
  page.place = CutThroughParts(content.heat, page.lines);
  explorer.Write(page);
}

void
WriteHeatReport(const HeatReportContent & content, const std::string & folder, const OutputPath & outputPath)
{
  if (!content.histogram || !content.gray || !content.heat)
  {
    throw std::invalid_argument("a heat report requires a histogram, an image and a heat volume");
  }
  const HeatAxis              axis = AxisOf(content);
  const ShapeTransferFunction transferFunction = ShownLines(content);
  const std::string           time =
    content.timeStep ? " after " + GroupedDigits(*content.timeStep) + " time steps" : std::string();

  HtmlReport html(content.title);
  AddSummary(html, content);
  const auto addPicture = [&](const std::string & name, const Picture * picture, const std::string & caption) {
    const std::string path = outputPath(folder + "/" + name);
    WritePng(picture, path);
    html.AddPicture(path, caption);
  };
  const ShapeQuantity & quantity = content.quantity;
  html.AddHeading(TitleOfHistogram(quantity));
  addPicture("histogram.png",
             DrawHistogram(content),
             "Numbers of voxels by " + quantity.name +
               " and time step; the bars below are the classes in their colors.");
  if (!content.ranges.empty())
  {
    addPicture("histogram-range.png", DrawOpenedHistogram(content), CaptionOfRange(content));
  }
  if (content.hasExplorer)
  {
    html.AddMarkup("<p><a href=\"explorer.html\">Heat explorer</a>: pick lines of this histogram; slices and "
                   "rendering follow.</p>");
  }
  html.AddHeading("Classes");
  const CsvTable classes = TableOf(content.classes,
                                   ColumnsOfClasses(quantity),
                                   &ClassColumn::heading,
                                   [](const ClassColumn & column, const Json & value) { return column.shown(value); });
  html.AddTable(classes, "Classes" + time + ", by " + quantity.name);
  addPicture("slices-classes.png",
             Slices(content,
                    "Classes" + time,
                    ColorByLine(ShapeTransferFunction::FromClasses(content.classes)),
                    LegendOf(content.classes)),
             "Slices of the input, colored by class. Surroundings and incoherent classes are not colored.");
  addPicture("slices-" + quantity.name + ".png",
             Slices(content, quantity.GetTitle() + time, ColorByHeat(axis), {}),
             "Slices of the input, colored by " + quantity.name + ".");
  html.AddHeading("Shape-based transfer function");
  const ColoredClasses drawn = content.drawn.value_or(ColoredClasses{ content.heat, transferFunction });
  addPicture(
    "rendering.png",
    DrawTransferFunction(
      content.gray, drawn.values, drawn.lines, "Transfer function" + time, content.window, quantity, content.renderer),
    "The " + quantity.name + " volume with " + TextOfClasses(transferFunction, drawn.lines));
  if (!content.ranges.empty())
  {
    const ShapeTransferFunction inside = OpenedRange(content).lines;
    addPicture("rendering-range.png",
               DrawTransferFunction(
                 content.gray, content.heat, inside, "Inside the opened range" + time, content.window, quantity),
               "The lines inside the opened range: " + inside.ToText());
  }
  AddReadingGuide(html, quantity);
  html.AddHeading("Provenance");
  html.AddFacts(content.provenance);

  ClassTable(content.classes, quantity).Write(outputPath(folder + "/classes.csv"));
  WriteJson(JsonOf(content, transferFunction), outputPath(folder + "/report.json"));
  html.Write(outputPath(folder + "/index.html"));
}
} // namespace shapeton
