#include "shapetonColonDistension.h"

#include "shapetonExceptions.h"

#include <algorithm>

namespace shapeton
{
namespace
{
void
RequireBorders(const std::vector<ColonSegmentBorder> & borders)
{
  RequireParameter(!borders.empty(), "distension requires at least one segment of the colon");
  for (std::size_t i = 1; i < borders.size(); ++i)
  {
    RequireParameter(borders[i].end >= borders[i - 1].end,
                     "the border of the segment \"" + borders[i].name + "\" must not precede the previous border");
  }
}

/** Adds the part of one step of the line within the segment. */
void
AddStep(double from, double to, double caliber, bool isGap, SegmentDistension & segment)
{
  const double part = std::min(to, segment.end) - std::max(from, segment.begin);
  if (part <= 0.0)
  {
    return;
  }
  segment.share += caliber >= LeastDistendedCaliber ? part : 0.0;
  segment.meanCaliber += part * caliber;
  segment.collapsedLength += isGap ? part : 0.0;
}
} // namespace

std::vector<ColonSegmentBorder>
CustomarySegments(double length)
{
  constexpr double rectum = 0.10, sigmoid = 0.35, descending = 0.52, transverse = 0.83, ascending = 0.96;
  return { { "rectum", rectum * length },         { "sigmoid", sigmoid * length },
           { "descending", descending * length }, { "transverse", transverse * length },
           { "ascending", ascending * length },   { "cecum", length } };
}

std::vector<SegmentDistension>
MeasureDistension(const CurveSet & curve, const std::vector<ColonSegmentBorder> & borders)
{
  RequireBorders(borders);
  const Eigen::VectorXd arc = PointValues(curve, "arcLength", "the centerline");
  const Eigen::VectorXd radius = PointValues(curve, "radius", "the centerline");
  const Eigen::VectorXd gap = PointValues(curve, "gap", "the centerline");
  const Eigen::Index    last = arc.size() - 1;
  if (last < 1 || !(arc[last] > arc[0]))
  {
    throw InputError("the centerline has zero length: distension cannot be measured. Give a line of several points.");
  }
  std::vector<SegmentDistension> segments;
  double                         begin = arc[0];
  for (const ColonSegmentBorder & border : borders)
  {
    const bool        isLast = &border == &borders.back();
    SegmentDistension segment;
    segment.name = border.name;
    segment.begin = begin;
    segment.end = isLast ? arc[last] : std::clamp(border.end, begin, arc[last]);
    for (Eigen::Index i = 0; i < last; ++i)
    {
      const bool   isGap = gap[i] != 0.0 || gap[i + 1] != 0.0;
      const double caliber = isGap ? 0.0 : radius[i] + radius[i + 1];
      AddStep(arc[i], arc[i + 1], caliber, isGap, segment);
    }
    const double length = segment.end - segment.begin;
    segment.share = length > 0.0 ? segment.share / length : 0.0;
    segment.meanCaliber = length > 0.0 ? segment.meanCaliber / length : 0.0;
    begin = segment.end;
    segments.push_back(segment);
  }
  return segments;
}

std::vector<SegmentDistension>
MeasureDistension(const CurveSet & curve)
{
  const Eigen::VectorXd arc = PointValues(curve, "arcLength", "the centerline");
  return MeasureDistension(curve, CustomarySegments(arc.size() > 0 ? arc[arc.size() - 1] : 0.0));
}
} // namespace shapeton
