#include "ValidationChart.h"
#include "Tables.h"

#include "shapetonCsvTable.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <stdexcept>

namespace
{
constexpr double left = 80, right = 600, top = 20, bottom = 400;

/** Logarithmic axis: maps powers of ten around the values to positions on the page. */
struct Axis
{
  Axis(double begin, double end) : first(begin), last(end) {}

  void
  Cover(double value)
  {
    low = std::min(low, std::floor(std::log10(value) + 1e-9));
    high = std::max(high, std::ceil(std::log10(value) - 1e-9));
  }
  double
  Place(double value) const
  {
    return first + (last - first) * (std::log10(value) - low) / std::max(1.0, high - low);
  }

  double first;
  double last;
  double low{ std::numeric_limits<double>::max() };
  double high{ std::numeric_limits<double>::lowest() };
};

std::string
Text(double x, double y, const std::string & anchor, const std::string & text, const std::string & more = "")
{
  return "<text x=\"" + Rounded(x, 5) + "\" y=\"" + Rounded(y, 5) + "\" text-anchor=\"" + anchor + "\"" + more + ">" +
         text + "</text>\n";
}

std::string
Line(double x1, double y1, double x2, double y2, const std::string & color)
{
  return "<line x1=\"" + Rounded(x1, 5) + "\" y1=\"" + Rounded(y1, 5) + "\" x2=\"" + Rounded(x2, 5) + "\" y2=\"" +
         Rounded(y2, 5) + "\" stroke=\"" + color + "\"/>\n";
}

/** Grid lines at 1, 2 and 5 times each power of ten. */
std::string
Grid(const Axis & x, const Axis & y)
{
  std::string svg;
  for (const bool isX : { true, false })
  {
    const Axis & axis = isX ? x : y;
    for (double power = axis.low; power <= axis.high; ++power)
    {
      for (const double digit : { 1.0, 2.0, 5.0 })
      {
        const double value = digit * std::pow(10.0, power);
        if (value > std::pow(10.0, axis.high) * 1.001)
        {
          break;
        }
        const double place = axis.Place(value);
        svg += isX ? Line(place, top, place, bottom, "#ddd") : Line(left, place, right, place, "#ddd");
        svg += isX ? Text(place, bottom + 18, "middle", shapeton::CsvTable::Number(value))
                   : Text(left - 8, place + 4, "end", shapeton::CsvTable::Number(value));
      }
    }
  }
  return svg;
}
} // namespace

void
WriteLogarithmicChart(const std::string &              path,
                      const std::string &              xLabel,
                      const std::string &              yLabel,
                      const std::vector<ChartSeries> & series)
{
  Axis x(left, right);
  Axis y(bottom, top);
  for (const auto & one : series)
  {
    for (const auto & point : one.points)
    {
      x.Cover(point.first);
      y.Cover(point.second);
    }
  }
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 860 450\" font-family=\"sans-serif\" "
                    "font-size=\"13\">\n<rect width=\"860\" height=\"450\" fill=\"white\"/>\n" +
                    Grid(x, y) + Text((left + right) / 2, bottom + 40, "middle", xLabel) +
                    Text(0, 0, "middle", yLabel, " transform=\"translate(20 210) rotate(-90)\"");
  static const char * const colors[] = { "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9" };
  for (std::size_t i = 0; i < series.size(); ++i)
  {
    const std::string color = colors[i % 6];
    std::string       points;
    for (const auto & point : series[i].points)
    {
      const std::string px = Rounded(x.Place(point.first), 5);
      const std::string py = Rounded(y.Place(point.second), 5);
      points += px + "," + py + " ";
      svg += "<circle cx=\"" + px + "\" cy=\"" + py + "\" r=\"4\" fill=\"" + color + "\"/>\n";
    }
    svg += "<polyline points=\"" + points + "\" fill=\"none\" stroke=\"" + color + "\" stroke-width=\"2\"/>\n";
    const double place = top + 20.0 + 22.0 * static_cast<double>(i);
    svg += Line(right + 15, place, right + 40, place, color) + Text(right + 46, place + 4, "start", series[i].name);
  }
  std::ofstream os(path);
  os << svg << "</svg>\n";
  os.close();
  if (!os)
  {
    throw std::runtime_error("cannot write " + path);
  }
}
