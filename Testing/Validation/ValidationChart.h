#ifndef ValidationChart_h
#define ValidationChart_h

#include <string>
#include <utility>
#include <vector>

/** A line of a chart: points (x, y) with both above 0. */
struct ChartSeries
{
  std::string                            name;
  std::vector<std::pair<double, double>> points;
};

/** Writes lines on logarithmic axes as SVG. */
void
WriteLogarithmicChart(const std::string &              path,
                      const std::string &              xLabel,
                      const std::string &              yLabel,
                      const std::vector<ChartSeries> & series);

#endif
