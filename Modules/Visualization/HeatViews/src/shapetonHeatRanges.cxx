#include "shapetonHeatRanges.h"

#include "shapetonCsvTable.h"
#include "shapetonExceptions.h"
#include "shapetonHeatClassification.h"

namespace shapeton
{
namespace
{
std::string
ExactTextOf(const HeatRange & range)
{
  return CsvTable::Number(range.lower) + " to " + CsvTable::Number(range.upper);
}

/** Whether a bin overlaps the range. */
bool
IsInside(unsigned int bin, const HeatRange & range)
{
  return HeatHistogram::LowerEdge(bin + 1) > range.lower && HeatHistogram::LowerEdge(bin) < range.upper;
}

void
RequireRange(const HeatRange & range)
{
  const std::string parameter = "the parameter \"histogramRange\": " + ExactTextOf(range);
  RequireParameter(range.lower >= 0.0 && range.lower < range.upper && range.upper <= 1.0,
                   parameter + " is not a range; give two numbers from 0 to 1, the lower one first");
  const unsigned int bin = HeatHistogram::BinOf(static_cast<float>(range.lower));
  RequireParameter(IsInside(bin + 1, range) && bin + 1 < HeatHistogram::NumberOfBins,
                   parameter + " is inside one bin of the histogram, which extends to " +
                     CsvTable::Number(HeatHistogram::LowerEdge(bin + 1)) + "; give a wider range");
}
} // namespace

HeatRanges
HeatRangesOf(const std::vector<double> & ends)
{
  RequireParameter(
    ends.size() % 2 == 0,
    "the parameter \"histogramRange\" requires pairs of numbers: a,b, followed by c,d for a range within "
    "a,b, for example 0.1,0.4,0.2,0.25");
  HeatRanges ranges;
  for (std::size_t i = 0; i < ends.size(); i += 2)
  {
    const HeatRange range{ ends[i], ends[i + 1] };
    RequireRange(range);
    RequireParameter(ranges.empty() || (range.lower >= ranges.back().lower && range.upper <= ranges.back().upper),
                     "the parameter \"histogramRange\": " + ExactTextOf(range) + " is not inside the previous range, " +
                       (ranges.empty() ? "" : ExactTextOf(ranges.back())) +
                       "; give ranges from the widest to the narrowest");
    ranges.push_back(range);
  }
  return ranges;
}

HeatHistogram
RowInside(const HeatHistogram & histogram, std::size_t row, const HeatRange & range)
{
  HeatHistogram              inside({ histogram.GetTimeSteps()[row] });
  std::vector<std::uint32_t> counts(HeatHistogram::NumberOfBins, 0);
  for (unsigned int bin = 0; bin < HeatHistogram::NumberOfBins; ++bin)
  {
    counts[bin] = IsInside(bin, range) ? histogram.GetCount(row, bin) : 0;
  }
  inside.AddToRow(0, counts.data());
  return inside;
}

std::vector<HeatClass>
FindClassesInside(const HeatHistogram & histogram, std::size_t row, const HeatRange & range)
{
  HeatClassificationRule rule;
  rule.backgroundHeat = 0.0; // low heat values also belong to the range
  std::vector<HeatClass> classes = FindHeatClasses(RowInside(histogram, row, range), 0, rule);
  classes.erase(classes.begin()); // the background, bin 0
  if (!classes.empty())
  {
    classes.front().lowerHeat = range.lower;
    classes.back().upperHeat = range.upper;
  }
  return classes;
}
} // namespace shapeton
