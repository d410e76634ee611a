#include "shapetonTriangleQualityChart.h"

#include "shapetonPictureAnnotation.h"
#include "shapetonPlotFrame.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace shapeton
{
namespace
{
const RGBColor paper = MakeColor(255, 255, 255);
const RGBColor ink = MakeColor(30, 32, 38);
const RGBColor inSpace = MakeColor(236, 150, 90);
const RGBColor inMetric = MakeColor(60, 120, 180);
const RGBColor limitColor = MakeColor(196, 44, 44);

std::vector<double>
Percentages(const std::vector<int> & histogram)
{
  const double        total = std::max(1.0, std::accumulate(histogram.begin(), histogram.end(), 0.0));
  std::vector<double> percentages;
  for (const int number : histogram)
  {
    percentages.push_back(100.0 * number / total);
  }
  return percentages;
}

/** Draws bars that fill the left or the right half of each bin. */
void
DrawBars(Picture *                   picture,
         const PlotFrame &           frame,
         const std::vector<double> & percentages,
         double                      begin,
         const RGBColor &            color)
{
  const double bins = static_cast<double>(percentages.size());
  for (std::size_t i = 0; i < percentages.size(); ++i)
  {
    const int left = static_cast<int>(std::lround(frame.PixelOfX((i + begin) / bins)));
    const int right = static_cast<int>(std::lround(frame.PixelOfX((i + begin + 0.45) / bins)));
    const int top = static_cast<int>(std::lround(frame.PixelOfY(percentages[i])));
    FillRectangle(picture, left, top, right - left, frame.top + frame.height - top, color);
  }
}
} // namespace

Picture::Pointer
DrawTriangleQualities(const ColonFlattening & flattening)
{
  constexpr int             width = 900;
  constexpr int             height = 340;
  constexpr double          threshold = 0.6;
  constexpr int             left = 90, top = 54, right = 24, bottom = 62; // pixels around the plot
  constexpr double          roomAbove = 1.05;                             // relative to the highest bar
  constexpr double          beginOfFirst = 0.05, beginOfSecond = 0.5;     // of the bars in a bin
  constexpr int             legendTop = 18, legendBottom = 40;
  constexpr int             leftOfMetric = 180, leftOfThreshold = 390; // of the entries of the legend
  const std::vector<double> space = Percentages(flattening.qualityInSpace.histogram);
  const std::vector<double> metric = Percentages(flattening.quality.histogram);
  PlotFrame                 frame;
  frame.left = left;
  frame.top = top;
  frame.width = width - frame.left - right;
  frame.height = height - frame.top - bottom;
  frame.x = { "2r/R of a triangle: 1 is equilateral", 0.0, 1.0 };
  frame.y = { "faces (%)", 0.0, 1.0 };
  for (const auto * percentages : { &space, &metric })
  {
    frame.y.upper = std::max(frame.y.upper, roomAbove * *std::max_element(percentages->begin(), percentages->end()));
  }
  auto picture = NewPicture(width, height, paper);
  DrawPlotFrame(picture, frame);
  DrawBars(picture, frame, space, beginOfFirst, inSpace);
  DrawBars(picture, frame, metric, beginOfSecond, inMetric);
  FillRectangle(
    picture, static_cast<int>(std::lround(frame.PixelOfX(threshold))), frame.top, 2, frame.height, limitColor);
  DrawLegend(picture, { { inSpace, "straight edges" } }, frame.left, legendTop, legendBottom, ink);
  DrawLegend(picture, { { inMetric, "metric of the map" } }, frame.left + leftOfMetric, legendTop, legendBottom, ink);
  DrawLegend(picture, { { limitColor, "0.6" } }, frame.left + leftOfThreshold, legendTop, legendBottom, ink);
  return picture;
}
} // namespace shapeton
