#include "shapetonCatheterSearch.h"

#include "shapetonQuantiles.h"
#include "shapetonTubeBores.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
constexpr double      FarthestFromAnus = 150.0; // mm; chosen: a catheter ends in the rectum
constexpr double      MostOutside = 0.25;       // of the rays inside the body
constexpr double      LeastMentioned = 0.25;    // minimum confidence for a report; chosen
constexpr double      LeastClosed = 0.9;        // fraction of the radial rays that end at the wall of a bore
constexpr double      MostOval = 0.1;           // of the cross-section of a bore
constexpr double      MostUneven = 0.5;         // mm, range of its radius
constexpr std::size_t LongestHole = 6;          // sections of 1 mm; chosen: side holes of the tip

/** A limit, and the width of the uncertain range on each side of it. */
struct Margin
{
  double limit;
  double width; ///< negative for an upper limit

  /** .5 at the limit, 1 or 0 at the ends of the range. */
  double
  Of(double value) const
  {
    return std::clamp(0.5 + 0.5 * (value - limit) / width, 0.0, 1.0);
  }
};

// The only real catheter measured has a uniform bore 43 mm long with a radius of 2.5 mm. All rays are enclosed along 24
// mm of it.
constexpr Margin LengthMargin{ 30.0, 15.0 };   // mm
constexpr Margin EnclosedMargin{ 6.0, 4.0 };   // mm
constexpr Margin ShareMargin{ 0.9, 0.1 };      // of the rays, in 6 mm of sections
constexpr Margin NarrowestMargin{ 1.0, 0.25 }; // mm, radius of the bore
constexpr Margin WidestMargin{ 4.5, -0.75 };   // mm

/** Sections with a sufficient fraction of enclosed rays, in descending order of that fraction. */
std::vector<const TubeSection *>
EnclosedSections(const std::vector<TubeSection> & sections)
{
  std::vector<const TubeSection *> enclosed;
  for (const auto & section : sections)
  {
    if (ShareMargin.Of(section.EnclosedShare()) > 0.0)
    {
      enclosed.push_back(&section);
    }
  }
  std::stable_sort(enclosed.begin(), enclosed.end(), [](const TubeSection * s, const TubeSection * t) {
    return s->EnclosedShare() > t->EnclosedShare();
  });
  return enclosed;
}

/** Measures the outer radius and the wall intensity of a tube from its enclosed sections. */
void
MeasureWall(const std::vector<const TubeSection *> & enclosed, CatheterTube & tube)
{
  std::vector<double> outer, hu;
  for (const auto * section : enclosed)
  {
    for (const auto & ray : section->rays)
    {
      if (ray.IsEnclosed())
      {
        outer.push_back(ray.outer);
        hu.push_back(ray.wallHU);
      }
    }
  }
  tube.outerRadius = UpperMedian(outer);
  tube.wallHU = UpperMedian(hu);
}

/** Range of consecutive sections; the last is excluded. */
struct Stretch
{
  std::size_t first{ 0 };
  std::size_t last{ 0 };

  std::size_t
  Length() const
  {
    return last - first;
  }
};

/** The longest run of round sections of similar width. */
Stretch
LongestEven(const std::vector<TubeSection> & sections)
{
  Stretch longest;
  for (std::size_t first = 0; first < sections.size(); ++first)
  {
    double least = LargestBoreRadius + 1.0;
    double greatest = 0.0;
    for (std::size_t n = first;
         n < sections.size() && sections[n].ClosedShare() >= LeastClosed && sections[n].Ovality() < MostOval;
         ++n)
    {
      least = std::min(least, sections[n].BoreRadius());
      greatest = std::max(greatest, sections[n].BoreRadius());
      if (greatest - least > MostUneven)
      {
        break;
      }
      if (n + 1 - first > longest.Length())
      {
        longest = { first, n + 1 };
      }
    }
  }
  return longest;
}

/** Extends a range of sections on both sides where the bore has the same width, across holes in the wall, up to a
 * nearby end of the bore. */
Stretch
AcrossHoles(const std::vector<TubeSection> & sections, const Stretch & even, double radius)
{
  Stretch    whole = even;
  const auto isAsWide = [&](std::size_t n) {
    const bool isEnd = n == 0 || n + 1 == sections.size();
    return isEnd || std::abs(sections[n].BoreRadius() - radius) <= MostUneven;
  };
  for (std::size_t n = even.last; n < sections.size() && n < whole.last + LongestHole; ++n)
  {
    whole.last = isAsWide(n) ? n + 1 : whole.last;
  }
  for (std::size_t n = even.first; n > 0 && n + LongestHole > whole.first; --n)
  {
    whole.first = isAsWide(n - 1) ? n - 1 : whole.first;
  }
  return whole;
}

template <typename TMeasure>
std::vector<double>
MeasuredAlong(const std::vector<TubeSection> & sections, const Stretch & stretch, const TMeasure & measure)
{
  std::vector<double> values(stretch.Length());
  std::transform(sections.begin() + stretch.first, sections.begin() + stretch.last, values.begin(), measure);
  return values;
}

/** The tube along the longest uniform stretch of the sections in the body, and the evidence for it. */
CatheterTube
TubeOf(const std::vector<TubeSection> & sections)
{
  CatheterTube  tube;
  const Stretch even = LongestEven(sections);
  if (even.Length() == 0)
  {
    return tube;
  }
  const auto radii = MeasuredAlong(sections, even, [](const TubeSection & s) { return s.BoreRadius(); });
  tube.boreRadius = UpperMedian(radii);
  const Stretch whole = AcrossHoles(sections, even, tube.boreRadius);
  tube.sections.assign(sections.begin() + whole.first, sections.begin() + whole.last);
  const auto enclosed = EnclosedSections(tube.sections);
  if (enclosed.empty())
  {
    return tube;
  }
  MeasureWall(enclosed, tube);
  CatheterEvidence & e = tube.evidence;
  e.length = static_cast<double>(even.Length());
  constexpr double upper = 0.8, lower = 0.2; // quantiles
  e.boreSpread = NearestQuantile(radii, upper) - NearestQuantile(radii, lower);
  e.ovality = UpperMedian(MeasuredAlong(sections, even, [](const TubeSection & s) { return s.Ovality(); }));
  e.enclosedLength = static_cast<double>(enclosed.size());
  e.enclosedShare = enclosed[std::min<std::size_t>(EnclosedMargin.limit, enclosed.size()) - 1]->EnclosedShare();
  e.confidence = std::min({ LengthMargin.Of(e.length),
                            EnclosedMargin.Of(e.enclosedLength),
                            ShareMargin.Of(e.enclosedShare),
                            NarrowestMargin.Of(tube.boreRadius),
                            WidestMargin.Of(tube.boreRadius) });
  return tube;
}

/** The longest sequence of sections in the body; anal side first. */
std::vector<TubeSection>
InsideBody(const std::vector<TubeSection> & sections)
{
  Stretch longest;
  Stretch inside;
  for (std::size_t n = 0; n < sections.size(); ++n)
  {
    const bool isInside = sections[n].ShareOf(BehindLayer::Outside) < MostOutside;
    inside = { isInside ? inside.first : n + 1, n + 1 };
    longest = inside.Length() > longest.Length() ? inside : longest;
  }
  std::vector<TubeSection> part(sections.begin() + longest.first, sections.begin() + longest.last);
  if (!part.empty() && part.front().center[2] > part.back().center[2])
  {
    std::reverse(part.begin(), part.end());
  }
  return part;
}
} // namespace

VoxelBox
BoxOfCatheter(const ColonGrid & grid, const ClassVolume & classes)
{
  const VoxelRuns set =
    CollectRuns(grid, [&](std::size_t p) { return classes[p] == ColonGas || classes[p] == ColonFluid; });
  const bool isUpwards = grid.axes(2, 2) > 0.0;
  int        end = -1; // the most caudal slice of the lumen
  ForEachRun(set, [&](std::size_t, int, int k) { end = end < 0 || !isUpwards ? k : end; });
  const int slices = static_cast<int>(FarthestFromAnus / grid.spacing[2]);
  VoxelBox  box{ { { 0, 0, 0 } }, grid.size };
  if (isUpwards)
  {
    box.high[2] = std::min(grid.size[2], end + slices);
  }
  else
  {
    box.low[2] = std::max(0, end + 1 - slices);
  }
  return box;
}

std::optional<CatheterTube>
FindCatheterTube(const CatheterRegion & region)
{
  // Half a voxel more than the bore radius, since distances are measured to the center of a wall voxel.
  const double               half = 0.5 * region.grid.spacing.maxCoeff();
  const double               leastLength = LengthMargin.limit - LengthMargin.width;
  std::vector<unsigned char> gas(region.hu.size());
  std::transform(
    region.hu.begin(), region.hu.end(), gas.begin(), [&](float v) { return v < region.thresholds.gasBoundary; });
  const TubeBores             bores(region.grid, std::move(gas));
  std::optional<CatheterTube> best;
  for (const double reach : { 2.0, 3.0, 4.0, LargestBoreRadius })
  {
    for (const auto & axis : bores.Find(reach + half, leastLength))
    {
      CatheterTube tube = TubeOf(InsideBody(MeasureSections(region, axis)));
      const auto & e = tube.evidence;
      if (e.confidence >= LeastMentioned &&
          (!best || e.confidence > best->evidence.confidence ||
           (e.confidence == best->evidence.confidence && tube.sections.size() > best->sections.size())))
      {
        best = std::move(tube);
      }
    }
  }
  return best;
}
} // namespace shapeton
