#ifndef shapetonOpenedRanges_h
#define shapetonOpenedRanges_h

#include "shapetonCommandLine.h"
#include "shapetonExceptions.h"
#include "shapetonHeatReport.h"

namespace shapeton
{
/** The ranges of the parameter histogramRange. Throws ParameterError for wrong ones, and where no file shows them. */
inline HeatRanges
ReadOpenedRanges(const CommandLine & commandLine)
{
  const bool       hasPicture = commandLine.Declares("histogram");
  const HeatRanges ranges = HeatRangesOf(commandLine.GetDoubles("histogramRange"));
  RequireParameter(ranges.empty() || commandLine.IsGiven("report") || (hasPicture && commandLine.IsGiven("histogram")),
                   std::string("the parameter \"histogramRange\" opens a part of the histogram; give ") +
                     (hasPicture ? "--histogram or --report, which show it" : "--report, which shows it"));
  return ranges;
}

/** Has the content show the ranges, with a warning where they hold nothing. */
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
