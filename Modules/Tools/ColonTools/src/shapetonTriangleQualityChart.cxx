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
  const std::vector<double> space = Percentages(flattening.qualityInSpace.histogram);
  const std::vector<double> metric = Percentages(flattening.quality.histogram);
  PlotFrame                 frame;
  frame.left = 90;
  frame.top = 54;
  frame.width = width - frame.left - 24;
  frame.height = height - frame.top - 62;
  frame.x = { "2r/R of a triangle: 1 is equilateral", 0.0, 1.0 };
  frame.y = { "faces (%)", 0.0, 1.0 };
  for (const auto * percentages : { &space, &metric })
  {
    frame.y.upper = std::max(frame.y.upper, 1.05 * *std::max_element(percentages->begin(), percentages->end()));
  }
  auto picture = NewPicture(width, height, paper);
  DrawPlotFrame(picture, frame);
  DrawBars(picture, frame, space, 0.05, inSpace);
  DrawBars(picture, frame, metric, 0.5, inMetric);
  FillRectangle(
    picture, static_cast<int>(std::lround(frame.PixelOfX(threshold))), frame.top, 2, frame.height, limitColor);
  DrawLegend(picture, { { inSpace, "straight edges" } }, frame.left, 18, 40, ink);
  DrawLegend(picture, { { inMetric, "metric of the map" } }, frame.left + 180, 18, 40, ink);
  DrawLegend(picture, { { limitColor, "0.6" } }, frame.left + 390, 18, 40, ink);
  return picture;
}
} // namespace shapeton
