#include "shapetonDicomSeriesGeometry.h"

#include "shapetonPi.h"
#include "shapetonQuantiles.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
constexpr double RelativeTolerance = 0.01; // of the spacing
constexpr double AbsoluteTolerance = 0.01; // mm
constexpr double LargestTolerance = 0.1;   // of the spacing
constexpr double SmallestDistance = 0.001; // mm

/** This many consecutive wide distances, if equal, indicate a change in spacing rather than missing slices. */
constexpr unsigned int RunOfChangedSpacing = 3;

double
UsualDistance(const std::vector<SlicePlace> & slices)
{
  std::vector<double> distances;
  for (std::size_t i = 1; i < slices.size(); ++i)
  {
    const double distance = slices[i].position - slices[i - 1].position;
    if (distance > SmallestDistance)
    {
      distances.push_back(distance);
    }
  }
  return UpperMedian(std::move(distances));
}

/** The first slice at each position. */
std::vector<unsigned int>
FindDuplicates(const std::vector<SlicePlace> & slices, SlicesGeometry & geometry)
{
  const double              tolerance = std::max(PositionTolerance(geometry.spacing), SmallestDistance);
  std::vector<unsigned int> firsts;
  for (unsigned int i = 0; i < slices.size(); ++i)
  {
    if (firsts.empty() || slices[i].position - slices[firsts.back()].position > tolerance)
    {
      firsts.push_back(i);
    }
    else if (!geometry.duplicates.empty() && geometry.duplicates.back().first == firsts.back())
    {
      ++geometry.duplicates.back().count;
    }
    else
    {
      geometry.duplicates.push_back({ firsts.back(), 2 });
    }
  }
  return firsts;
}

bool
IsChangeOfSpacing(const std::vector<SlicesGeometry::Gap> & gaps)
{
  unsigned int run = 1;
  for (std::size_t i = 1; i < gaps.size(); ++i)
  {
    const bool isNext = gaps[i].before == gaps[i - 1].before + 1 && gaps[i].missing == gaps[i - 1].missing;
    run = isNext ? run + 1 : 1;
    if (run >= RunOfChangedSpacing)
    {
      return true;
    }
  }
  return false;
}

/** Compares each slice with its position in the grid from the first to the last slice. */
void
CheckGrid(const std::vector<SlicePlace> & slices, const std::vector<unsigned int> & firsts, SlicesGeometry & geometry)
{
  const double origin = slices[firsts.front()].position;
  const double spacing = (slices[firsts.back()].position - origin) / static_cast<double>(firsts.size() - 1);
  for (std::size_t i = 0; i < firsts.size(); ++i)
  {
    const double deviation = slices[firsts[i]].position - (origin + static_cast<double>(i) * spacing);
    if (std::abs(deviation) > PositionTolerance(spacing))
    {
      geometry.isVariable = true;
      geometry.unusual.push_back(firsts[i]);
    }
  }
}

void
FindGaps(const std::vector<SlicePlace> & slices, const std::vector<unsigned int> & firsts, SlicesGeometry & geometry)
{
  const double                     tolerance = PositionTolerance(geometry.spacing);
  std::vector<unsigned int>        odd;
  std::vector<SlicesGeometry::Gap> gapsByPosition; // for the runs, `before` counts positions
  for (unsigned int i = 1; i < firsts.size(); ++i)
  {
    const double distance = slices[firsts[i]].position - slices[firsts[i - 1]].position;
    const double multiple = std::round(distance / geometry.spacing);
    if (multiple < 1 || std::abs(distance - multiple * geometry.spacing) > tolerance * std::max(multiple, 1.0))
    {
      odd.push_back(firsts[i - 1]);
    }
    else if (multiple > 1)
    {
      const auto missing = static_cast<unsigned int>(std::min(multiple - 1, 1e9));
      geometry.gaps.push_back({ firsts[i - 1], firsts[i], missing });
      gapsByPosition.push_back({ i - 1, i, missing });
    }
  }
  if (odd.empty() && geometry.gaps.empty())
  {
    return CheckGrid(slices, firsts, geometry);
  }
  if (!odd.empty() || IsChangeOfSpacing(gapsByPosition))
  {
    for (const auto & gap : geometry.gaps)
    {
      odd.push_back(gap.before);
    }
    std::sort(odd.begin(), odd.end());
    geometry.gaps.clear();
    geometry.isVariable = true;
    geometry.unusual = odd;
  }
}

void
FindShear(const std::vector<SlicePlace> & slices, const double (&pixelSpacing)[2], SlicesGeometry & geometry)
{
  const SlicePlace & first = slices.front();
  const SlicePlace & last = slices.back();
  const double       length = last.position - first.position;
  geometry.isLinearShear = length > SmallestDistance;
  double squaredSlope = 0;
  for (int axis = 0; axis < 2; ++axis)
  {
    const double tolerance = PositionTolerance(pixelSpacing[axis]);
    const double slope = length > SmallestDistance ? (last.offset[axis] - first.offset[axis]) / length : 0.0;
    squaredSlope += slope * slope;
    for (const SlicePlace & slice : slices)
    {
      const double offset = slice.offset[axis] - first.offset[axis];
      geometry.isSheared = geometry.isSheared || std::abs(offset) > tolerance;
      geometry.isLinearShear =
        geometry.isLinearShear && std::abs(offset - slope * (slice.position - first.position)) <= tolerance;
    }
  }
  geometry.tiltDegrees = std::atan(std::sqrt(squaredSlope)) * 180.0 / Pi;
}
} // namespace

double
PositionTolerance(double spacing)
{
  return std::max(RelativeTolerance * spacing, std::min(AbsoluteTolerance, LargestTolerance * spacing));
}

double
ResampledSteps(double length, double spacing)
{
  return std::max(1.0, std::round(length / spacing));
}

bool
CanBeResampled(std::size_t slices, double length, double spacing)
{
  return ResampledSteps(length, spacing) <= LargestGrowth * static_cast<double>(slices) + 1;
}

SlicesGeometry
ExamineSlices(const std::vector<SlicePlace> & slices, const double (&pixelSpacing)[2])
{
  SlicesGeometry geometry;
  if (slices.empty())
  {
    return geometry;
  }
  geometry.spacing = UsualDistance(slices);
  const auto firsts = FindDuplicates(slices, geometry);
  if (firsts.size() > 1)
  {
    FindGaps(slices, firsts, geometry);
  }
  FindShear(slices, pixelSpacing, geometry);
  return geometry;
}
} // namespace shapeton
