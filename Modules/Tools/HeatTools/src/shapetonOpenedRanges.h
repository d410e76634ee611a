#ifndef shapetonOpenedRanges_h
#define shapetonOpenedRanges_h

#include "shapetonCommandLine.h"
#include "shapetonExceptions.h"
#include "shapetonHeatReport.h"

namespace shapeton
{
/** The ranges of the parameter histogramRange. Throws ParameterError for wrong ranges, or if no output shows them. */
inline HeatRanges
ReadOpenedRanges(const CommandLine & commandLine)
{
  const bool       hasPicture = commandLine.Declares("histogram");
  const HeatRanges ranges = HeatRangesOf(commandLine.GetDoubles("histogramRange"));
  RequireParameter(ranges.empty() || commandLine.IsGiven("report") || (hasPicture && commandLine.IsGiven("histogram")),
                   std::string("the parameter \"histogramRange\" requires ") +
                     (hasPicture ? "--histogram or --report" : "--report"));
  return ranges;
}

/** Sets the ranges of the content, with a warning for an empty range. */
inline void
OpenRanges(CommandLine & commandLine, const HeatRanges & ranges, HeatReportContent & content)
{
  content.ranges = ranges;
  for (const std::string & remark : RangeRemarks(content))
  {
    commandLine.Warn(remark);
    content.warnings.push_back(remark);
  }
}
} // namespace shapeton

#endif
