#include "shapetonHeatHistogramPicture.h"

#include "shapetonAxisTicks.h"
#include "shapetonColorMap.h"
#include "shapetonHeatColoring.h"
#include "shapetonPageColors.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace shapeton
{
namespace
{
/** Layout, pixels. */
constexpr int backgroundLineWidth = 5;
constexpr int backgroundLineGap = 3;
constexpr int colorStripHeight = 8;
constexpr int classStripHeight = 44;
constexpr int tickLength = 6;
constexpr int openingStripHeight = 8;
constexpr int openingHeight = 30; // a strip and the lines to the next one
constexpr int mainTitleSize = 24;
constexpr int axisTitleSize = 17;
constexpr int numberSize = 15; // font height on the axes and of the key
constexpr int labelSize = 14;  // of classes and marked time steps
constexpr int openingSize = 12;
// Maximum number of drawn zoom levels; only the last ones are drawn.
constexpr std::size_t mostOpenings = 6;
// Maximum width of a drawn bin. On the equalized axis, a converged line has a large fraction of the counts and thus of
// the axis, but should look like a line.
constexpr double greatestLineWidth = 6.0;

const RGBColor faintInk = MakeColor(96, 100, 110);
const RGBColor plotBackground = MakeColor(12, 13, 18);
const RGBColor pink = MakeColor(255, 105, 180);
const RGBColor darkPink = MakeColor(200, 30, 120);

TextStyle
Style(int size, HorizontalAnchor horizontal, VerticalAnchor vertical, const RGBColor & color = InkColor)
{
  return { size, color, false, horizontal, vertical };
}

/** Counts of every column of the plot, for each row of the histogram. */
class ColumnCounts
{
public:
  ColumnCounts(const HeatHistogram & histogram, const HeatAxis & axis, int columns)
    : m_Columns(columns), m_Counts(histogram.GetNumberOfRows() * columns, 0.0F)
  {
    for (unsigned int bin = 1; bin < HeatHistogram::NumberOfBins; ++bin)
    {
      const double lower = HeatHistogram::LowerEdge(bin);
      const double upper = HeatHistogram::LowerEdge(bin + 1);
      if (upper > axis.GetRange().lower && lower < axis.GetRange().upper)
      {
        this->AddBin(histogram, bin, axis.PositionOf(lower) * (columns - 1), axis.PositionOf(upper) * (columns - 1));
      }
    }
  }

  float
  operator()(std::size_t row, int column) const
  {
    return m_Counts[row * m_Columns + column];
  }

  float
  Greatest() const
  {
    return *std::max_element(m_Counts.begin(), m_Counts.end());
  }

private:
  /** Adds the counts of a bin: over all columns that it covers in rows where neighboring bins have counts, otherwise as
   * a line at its center. */
  void
  AddBin(const HeatHistogram & histogram, unsigned int bin, double left, double right)
  {
    const double center = 0.5 * (left + right);
    const double width = std::max(right - left, 1e-6);
    for (std::size_t row = 0; row < histogram.GetNumberOfRows(); ++row)
    {
      if (const std::uint32_t count = histogram.GetCount(row, bin); count > 0)
      {
        const bool isLine = width > greatestLineWidth && !IsPartOfSpread(histogram, row, bin);
        this->AddCount(row, count, center, isLine ? greatestLineWidth : width);
      }
    }
  }

  static bool
  IsPartOfSpread(const HeatHistogram & histogram, std::size_t row, unsigned int bin)
  {
    const std::uint32_t least = histogram.GetCount(row, bin) / 8;
    return bin > 1 && bin + 1 < HeatHistogram::NumberOfBins && histogram.GetCount(row, bin - 1) > least &&
           histogram.GetCount(row, bin + 1) > least;
  }

  /** Distributes a count over the columns within half a pixel of a position. */
  void
  AddCount(std::size_t row, std::uint32_t count, double center, double width)
  {
    const int first = std::max(static_cast<int>(std::lround(center - 0.5 * width)), 0);
    const int last = std::min(static_cast<int>(std::lround(center + 0.5 * width)), m_Columns - 1);
    for (int column = first; column <= last; ++column)
    {
      const double overlap =
        std::min(center + 0.5 * width, column + 0.5) - std::max(center - 0.5 * width, column - 0.5);
      const double share = first == last ? 1.0 : std::max(overlap, 0.0) / width;
      m_Counts[row * m_Columns + column] += static_cast<float>(count * share);
    }
  }

  int                m_Columns;
  std::vector<float> m_Counts;
};

/** Brightness, in [0, 1], of a count: logarithmic; a single voxel is visible, 0 is black. */
double
BrightnessOf(double count, double greatest)
{
  constexpr double least = 0.15;
  return count > 0.0 && greatest > 0.0 ? least + (1.0 - least) * std::log2(1.0 + count) / std::log2(1.0 + greatest)
                                       : 0.0;
}

/** Raises pixels brighter than their neighborhood in the row and lowers the rest, so lines are visible in the haze
 * of drifting heat that equalization spreads evenly. */
void
Sharpen(std::vector<double> & brightness)
{
  constexpr int       reach = 16;
  constexpr double    strength = 2.5;
  constexpr double    kept = 0.8;
  constexpr double    darkest = 0.1;
  const int           size = static_cast<int>(brightness.size());
  std::vector<double> sumBefore(size + 1, 0.0);
  for (int x = 0; x < size; ++x)
  {
    sumBefore[x + 1] = sumBefore[x] + brightness[x];
  }
  for (int x = 0; x < size; ++x)
  {
    const int    first = std::max(x - reach, 0);
    const int    last = std::min(x + reach + 1, size);
    const double mean = (sumBefore[last] - sumBefore[first]) / (last - first);
    if (brightness[x] > 0.0)
    {
      brightness[x] = std::clamp(kept * brightness[x] + strength * (brightness[x] - mean), darkest, 1.0);
    }
  }
}

/** Position of a time step on the vertical axis. */
class TimeAxis
{
public:
  TimeAxis(const std::vector<std::uint64_t> & timeSteps, const PlotArea & area) : m_TimeSteps(timeSteps), m_Area(area)
  {}

  bool
  Contains(std::uint64_t timeStep) const
  {
    return timeStep >= m_TimeSteps.front() && timeStep <= m_TimeSteps.back();
  }

  int
  RowAt(int pixel, int numberOfPixels) const
  {
    return static_cast<int>(static_cast<std::size_t>(pixel) * m_TimeSteps.size() / numberOfPixels);
  }

  double
  PixelOf(double timeStep) const
  {
    const auto after = std::upper_bound(m_TimeSteps.begin(), m_TimeSteps.end(), timeStep);
    double     row = static_cast<double>(after - m_TimeSteps.begin()) - 1.0;
    if (after != m_TimeSteps.end() && after != m_TimeSteps.begin())
    {
      const auto before = static_cast<double>(*(after - 1));
      row += (timeStep - before) / (static_cast<double>(*after) - before);
    }
    return m_Area.top + (row + 0.5) * m_Area.height / static_cast<double>(m_TimeSteps.size());
  }

private:
  const std::vector<std::uint64_t> & m_TimeSteps;
  PlotArea                           m_Area;
};

void
DrawBackgroundLine(Picture * picture, const HeatHistogram & histogram, const TimeAxis & time, const PlotArea & area)
{
  std::uint32_t greatest = 0;
  for (std::size_t row = 0; row < histogram.GetNumberOfRows(); ++row)
  {
    greatest = std::max(greatest, histogram.GetCount(row, 0));
  }
  const int left = area.left - backgroundLineWidth - backgroundLineGap;
  for (int y = 0; y < area.height; ++y)
  {
    const double brightness = BrightnessOf(histogram.GetCount(time.RowAt(y, area.height), 0), greatest);
    FillRectangle(picture, left, area.top + y, backgroundLineWidth, 1, PaperColor, brightness);
  }
}

/** Brightness of a row of pixels; shows the largest count if several histogram rows share it. */
std::vector<double>
BrightnessOfLine(const ColumnCounts & counts, int firstRow, int endRow, int columns, double greatest)
{
  std::vector<double> brightness(columns);
  for (int x = 0; x < columns; ++x)
  {
    float count = 0.0F;
    for (int row = firstRow; row < endRow; ++row)
    {
      count = std::max(count, counts(row, x));
    }
    brightness[x] = BrightnessOf(count, greatest);
  }
  Sharpen(brightness);
  return brightness;
}

void
DrawCounts(Picture *             picture,
           const HeatHistogram & histogram,
           const HeatAxis &      axis,
           const TimeAxis &      time,
           PlotArea              area)
{
  const ColumnCounts counts(histogram, axis, area.width);
  const double       greatest = counts.Greatest();
  for (int y = 0; y < area.height; ++y)
  {
    const int                 row = time.RowAt(y, area.height);
    const int                 endRow = std::max(time.RowAt(y + 1, area.height), row + 1);
    const std::vector<double> brightness = BrightnessOfLine(counts, row, endRow, area.width, greatest);
    for (int x = 0; x < area.width; ++x)
    {
      const RGBColor color = HeatColor(x / (area.width - 1.0));
      FillRectangle(picture, area.left + x, area.top + y, 1, 1, color, brightness[x]);
    }
  }
}

void
DrawPlotBackground(Picture * picture, const PlotArea & area)
{
  const int left = area.left - backgroundLineWidth - backgroundLineGap;
  FillRectangle(picture, left, area.top, area.left + area.width - left, area.height, plotBackground);
}

void
DrawColorStrip(Picture * picture, const PlotArea & area)
{
  for (int x = 0; x < area.width; ++x)
  {
    FillRectangle(
      picture, area.left + x, area.top + area.height + 2, 1, colorStripHeight, HeatColor(x / (area.width - 1.0)));
  }
}

void
DrawTimeAxis(Picture *                          picture,
             const std::vector<std::uint64_t> & timeSteps,
             const TimeAxis &                   time,
             const PlotArea &                   area)
{
  constexpr int leastDistance = 30;
  const int     right = area.left - backgroundLineWidth - backgroundLineGap;
  for (const std::uint64_t step : TimeTicks(timeSteps, leastDistance, [&](double t) { return time.PixelOf(t); }))
  {
    const int y = static_cast<int>(time.PixelOf(static_cast<double>(step)));
    FillRectangle(picture, right - tickLength, y, tickLength, 1, InkColor);
    DrawText(picture,
             GroupedDigits(step),
             right - tickLength - 4,
             y,
             Style(numberSize, HorizontalAnchor::Right, VerticalAnchor::Center));
  }
  TextStyle style = Style(axisTitleSize, HorizontalAnchor::Left, VerticalAnchor::Center);
  style.upwards = true;
  DrawText(picture, "time step", 10, area.top + area.height / 2, style);
}

void
DrawHeatTicks(Picture * picture, const HeatAxis & axis, const PlotArea & area, int top)
{
  constexpr int       leastDistance = 62;
  constexpr int       digits = 3;
  constexpr int       digitsOfNarrow = 5;
  const auto          pixelOf = [&](double heat) { return area.left + axis.PositionOf(heat) * (area.width - 1); };
  const HeatRange &   range = axis.GetRange();
  std::vector<double> heats = HeatTicks(range.lower, range.upper, leastDistance, pixelOf);
  const bool          isNarrow = heats.size() < 2; // the range does not contain two round numbers
  if (isNarrow)
  {
    heats = { range.lower, range.upper };
  }
  for (const double heat : heats)
  {
    const int x = static_cast<int>(std::lround(pixelOf(heat)));
    FillRectangle(picture, x, top, 1, tickLength, InkColor);
    DrawText(picture,
             HeatLabel(heat, isNarrow ? digitsOfNarrow : digits),
             x,
             top + tickLength + 2,
             Style(numberSize, HorizontalAnchor::Center, VerticalAnchor::Top));
  }
}

/** Draws a bar from the lower to the upper heat of each class in its color. Its number is below the bar, on the first
 * of two lines where it fits. */
void
DrawClasses(Picture *                      picture,
            const HeatAxis &               axis,
            const std::vector<HeatClass> & classes,
            const PlotArea &               area,
            int                            top)
{
  constexpr int barHeight = 9;
  constexpr int lineHeight = 15;
  int           endOfText[2] = { 0, 0 };
  for (const HeatClass & heatClass : classes)
  {
    if (heatClass.label == 0 || heatClass.upperHeat <= axis.GetRange().lower ||
        heatClass.lowerHeat >= axis.GetRange().upper)
    {
      continue;
    }
    const int left = area.left + static_cast<int>(axis.PositionOf(heatClass.lowerHeat) * (area.width - 1));
    const int right = area.left + static_cast<int>(axis.PositionOf(heatClass.upperHeat) * (area.width - 1));
    const int width = std::max(right - left, 3);
    FillRectangle(picture, left, top, width, barHeight, ColorOfClass(heatClass));
    FillRectangle(picture, left, top, 1, barHeight + 3, InkColor);
    FillRectangle(picture, left + width - 1, top, 1, barHeight + 3, InkColor);
    const std::string number = std::to_string(heatClass.label);
    const TextStyle   style = Style(labelSize, HorizontalAnchor::Center, VerticalAnchor::Top);
    const int         middle = left + width / 2;
    const int         textWidth = MeasureText(number, style).width;
    const auto        line = std::find_if(
      std::begin(endOfText), std::end(endOfText), [&](int end) { return middle - textWidth / 2 > end + 4; });
    if (line != std::end(endOfText))
    {
      *line = middle + textWidth / 2;
      const auto level = static_cast<int>(line - std::begin(endOfText));
      DrawText(picture, number, middle, top + barHeight + 4 + level * lineHeight, style);
    }
  }
}

/** Label positions without overlap, each moved down as little as possible, all above `bottom`. */
std::vector<int>
SpreadLabels(const std::vector<double> & wanted, int distance, int bottom)
{
  std::vector<int> places(wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i)
  {
    const int own = static_cast<int>(wanted[i]);
    places[i] = i == 0 ? own : std::max(own, places[i - 1] + distance);
  }
  int limit = bottom;
  for (std::size_t i = places.size(); i-- > 0; limit -= distance)
  {
    places[i] = std::min(places[i], limit);
  }
  return places;
}

void
DrawMarkedTimeSteps(Picture * picture, std::vector<std::uint64_t> steps, const TimeAxis & time, const PlotArea & area)
{
  constexpr int lineHeight = 18;
  constexpr int endOfLine = 14; // to the right of the plot
  constexpr int leftOfLabel = 18;
  std::sort(steps.begin(), steps.end());
  steps.erase(std::remove_if(steps.begin(), steps.end(), [&](std::uint64_t step) { return !time.Contains(step); }),
              steps.end());
  std::vector<double> lines;
  for (const std::uint64_t step : steps)
  {
    lines.push_back(time.PixelOf(static_cast<double>(step)));
  }
  const std::vector<int> labels = SpreadLabels(lines, lineHeight, area.top + area.height - 8);
  const int              left = area.left - backgroundLineWidth - backgroundLineGap;
  const int              right = area.left + area.width;
  for (std::size_t i = 0; i < steps.size(); ++i)
  {
    const int y = static_cast<int>(lines[i]);
    FillRectangle(picture, left, y, right - left, 1, pink);
    DrawLine(picture, right, y, right + endOfLine, labels[i], pink, 1.0);
    DrawText(picture,
             "t = " + GroupedDigits(steps[i]),
             right + leftOfLabel,
             labels[i],
             Style(labelSize, HorizontalAnchor::Left, VerticalAnchor::Center, darkPink));
  }
}

std::size_t
NumberOfOpenings(const HeatHistogramPictureOptions & options)
{
  return std::min(options.ranges.size(), mostOpenings);
}

HeatRange
ShownRange(const HeatHistogramPictureOptions & options)
{
  return options.ranges.empty() ? HeatRange() : options.ranges.back();
}

std::string
TextOf(const HeatRange & range)
{
  return HeatLabel(range.lower, 4) + " to " + HeatLabel(range.upper, 4);
}

/** Draws the strip of an axis, dimmed except for the zoomed range, and lines from the ends of this range to the ends of
 * the next level. */
void
DrawOpening(Picture *           picture,
            const HeatAxis &    axis,
            const std::string & name,
            const HeatRange &   opened,
            const PlotArea &    area,
            int                 top)
{
  const int    right = area.left + area.width - 1;
  const double from = axis.PositionOf(opened.lower) * (area.width - 1);
  const double to = axis.PositionOf(opened.upper) * (area.width - 1);
  for (int x = 0; x < area.width; ++x)
  {
    const double opacity = x + 0.5 >= from && x - 0.5 <= to ? 1.0 : 0.25;
    FillRectangle(picture, area.left + x, top, 1, openingStripHeight, HeatColor(x / (area.width - 1.0)), opacity);
  }
  const int bottom = top + openingHeight - 1;
  DrawLine(picture, area.left + from, top + openingStripHeight, area.left, bottom, faintInk);
  DrawLine(picture, area.left + to, top + openingStripHeight, right, bottom, faintInk);
  DrawText(picture,
           name,
           area.left - 4,
           top + openingStripHeight / 2,
           Style(openingSize, HorizontalAnchor::Right, VerticalAnchor::Center, faintInk));
}

void
DrawOpenings(Picture *                           picture,
             const HeatHistogram &               axisHistogram,
             const HeatHistogramPictureOptions & options,
             const PlotArea &                    area)
{
  const std::size_t first = options.ranges.size() - NumberOfOpenings(options);
  int               top = area.top - openingHeight * static_cast<int>(NumberOfOpenings(options));
  for (std::size_t i = first; i < options.ranges.size(); ++i, top += openingHeight)
  {
    const HeatRange   shown = i == 0 ? HeatRange() : options.ranges[i - 1];
    const std::string name = i == 0 ? "all" : TextOf(shown);
    DrawOpening(picture, HeatAxis(axisHistogram, options.scale, shown), name, options.ranges[i], area, top);
  }
}

void
DrawTitles(Picture * picture, const HeatHistogramPictureOptions & options, const HeatAxis & axis, const PlotArea & area)
{
  constexpr int     topOfTitle = 14;
  constexpr int     topOfKey = 48;
  const int         left = area.left - backgroundLineWidth - backgroundLineGap;
  const int         width = static_cast<int>(options.width) - left - 8;
  const std::string key = "color: " + options.quantity.name +
                          "; brightness: number of voxels, logarithmic; white line at the left: background";
  TextStyle title = Style(mainTitleSize, HorizontalAnchor::Left, VerticalAnchor::Top);
  title.bold = true;
  DrawText(picture, options.title, left, topOfTitle, FitText(options.title, title, width));
  const TextStyle style = Style(numberSize, HorizontalAnchor::Left, VerticalAnchor::Top, faintInk);
  DrawText(picture, key, left, topOfKey, FitText(key, style, width));
  std::string name = options.quantity.name;
  if (options.quantity.kind == ShapeQuantity::Kind::Visits)
  {
    name += " (1: " + GroupedDigits(options.quantity.greatestVisits) + " visits)";
  }
  name += axis.GetScale() == HeatScale::Equalized ? ", on the equalized scale" : "";
  if (!options.ranges.empty())
  {
    name += ", only " + TextOf(options.ranges.back());
  }
  DrawText(picture,
           name,
           area.left + area.width / 2,
           static_cast<int>(options.height) - 8,
           Style(axisTitleSize, HorizontalAnchor::Center, VerticalAnchor::Bottom));
}
} // namespace

PlotArea
PlotAreaOf(const HeatHistogramPictureOptions & options)
{
  constexpr int left = 126, top = 78; // pixels beside the plot
  const int     right = options.markedTimeSteps.empty() ? 40 : 130;
  const int     bottom = 66 + colorStripHeight + (options.classes.empty() ? 0 : classStripHeight);
  PlotArea      area;
  area.left = left;
  area.top = top + openingHeight * static_cast<int>(NumberOfOpenings(options));
  area.width = static_cast<int>(options.width) - area.left - right;
  area.height = static_cast<int>(options.height) - area.top - bottom;
  return area;
}

Picture::Pointer
DrawHeatHistogram(const HeatHistogram & histogram, const HeatHistogramPictureOptions & options)
{
  if (histogram.GetNumberOfRows() == 0)
  {
    throw std::invalid_argument("a heat histogram without rows cannot be drawn");
  }
  constexpr unsigned int smallestWidth = 600;
  constexpr unsigned int smallestHeight = 400;
  if (options.width < smallestWidth || options.height < smallestHeight)
  {
    throw std::invalid_argument("the picture of a heat histogram must have at least 600 x 400 pixels");
  }
  const HeatHistogram & axisHistogram = options.axisHistogram ? *options.axisHistogram : histogram;
  const HeatAxis        axis(axisHistogram, options.scale, ShownRange(options));
  const PlotArea        area = PlotAreaOf(options);
  const TimeAxis        time(histogram.GetTimeSteps(), area);
  auto                  picture = NewPicture(options.width, options.height, PaperColor);
  DrawOpenings(picture, axisHistogram, options, area);
  DrawPlotBackground(picture, area);
  DrawBackgroundLine(picture, histogram, time, area);
  DrawCounts(picture, histogram, axis, time, area);
  DrawColorStrip(picture, area);
  int below = area.top + area.height + colorStripHeight + 4;
  if (!options.classes.empty())
  {
    DrawClasses(picture, axis, options.classes, area, below);
    below += classStripHeight;
  }
  DrawHeatTicks(picture, axis, area, below);
  DrawTimeAxis(picture, histogram.GetTimeSteps(), time, area);
  DrawMarkedTimeSteps(picture, options.markedTimeSteps, time, area);
  DrawTitles(picture, options, axis, area);
  return picture;
}
} // namespace shapeton
