#include "shapetonCatheterSearch.h"

#include "shapetonTubeBores.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
constexpr double FarthestFromAnus = 150.0; // mm
constexpr double MostOutside = 0.25;       // of the rays inside the body
constexpr double LeastMentioned = 0.25;    // confidence

/** A limit and how far from it a value is no longer doubtful, on either side. */
struct Margin
{
  double limit;
  double width; ///< negative where the value has to be below the limit

  /** .5 at the limit, 1 and 0 at its sides. */
  double
  Of(double value) const
  {
    return std::clamp(0.5 + 0.5 * (value - limit) / width, 0.0, 1.0);
  }
};

constexpr Margin LengthMargin{ 30.0, 15.0 };   // mm
constexpr Margin EnclosedMargin{ 15.0, 10.0 }; // mm
constexpr Margin ShareMargin{ 0.9, 0.1 };      // of the rays, in 15 mm of sections
constexpr Margin NarrowestMargin{ 1.0, 0.25 }; // mm, radius of the bore
constexpr Margin WidestMargin{ 4.5, -0.75 };   // mm
constexpr Margin SpreadMargin{ 0.5, -0.4 };    // mm
constexpr Margin OvalityMargin{ 0.15, -0.1 };

double
Percentile(std::vector<double> values, double share)
{
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(std::lround(share * (values.size() - 1)));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/** Those whose share is not surely too low, by falling share. */
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

/** Radii and wall of a tube by its enclosed sections. */
void
MeasureWall(const std::vector<const TubeSection *> & enclosed, CatheterTube & tube)
{
  std::vector<double> radii, outer, hu;
  for (const auto * section : enclosed)
  {
    radii.push_back(section->BoreRadius());
    for (const auto & ray : section->rays)
    {
      if (ray.IsEnclosed())
      {
        outer.push_back(ray.outer);
        hu.push_back(ray.wallHU);
      }
    }
  }
  tube.boreRadius = MedianOf(radii);
  tube.outerRadius = MedianOf(outer);
  tube.wallHU = MedianOf(hu);
  tube.evidence.boreSpread = Percentile(radii, 0.8) - Percentile(radii, 0.2);
}

void
Judge(CatheterTube & tube)
{
  CatheterEvidence & e = tube.evidence;
  e.length = static_cast<double>(tube.sections.size());
  const auto enclosed = EnclosedSections(tube.sections);
  if (enclosed.empty())
  {
    return;
  }
  MeasureWall(enclosed, tube);
  std::vector<double> ovality;
  for (const auto * section : enclosed)
  {
    ovality.push_back(section->Ovality());
  }
  e.enclosedLength = static_cast<double>(enclosed.size());
  e.enclosedShare = enclosed[std::min<std::size_t>(EnclosedMargin.limit, enclosed.size()) - 1]->EnclosedShare();
  e.ovality = MedianOf(ovality);
  e.confidence = std::min({ LengthMargin.Of(e.length),
                            EnclosedMargin.Of(e.enclosedLength),
                            ShareMargin.Of(e.enclosedShare),
                            NarrowestMargin.Of(tube.boreRadius),
                            WidestMargin.Of(tube.boreRadius),
                            SpreadMargin.Of(e.boreSpread),
                            OvalityMargin.Of(e.ovality) });
}

/** The sections from the best enclosed one on to both sides, as long as they lie in the body; the anal side first. */
std::vector<TubeSection>
InsideBody(std::vector<TubeSection> && sections)
{
  const auto isOutside = [](const TubeSection & s) { return s.ShareOf(BehindLayer::Outside) >= MostOutside; };
  const auto best =
    std::max_element(sections.begin(), sections.end(), [](const TubeSection & s, const TubeSection & t) {
      return s.EnclosedShare() < t.EnclosedShare();
    });
  const auto               begin = std::find_if(std::make_reverse_iterator(best), sections.rend(), isOutside).base();
  const auto               end = std::find_if(best, sections.end(), isOutside);
  std::vector<TubeSection> inside(begin, end);
  if (!inside.empty() && inside.front().centre[2] > inside.back().centre[2])
  {
    std::reverse(inside.begin(), inside.end());
  }
  return inside;
}
} // namespace

VoxelBox
BoxOfCatheter(const ColonGrid & grid, const ClassVolume & classes)
{
  const VoxelRuns set =
    CollectRuns(grid, [&](std::size_t p) { return classes[p] == ColonGas || classes[p] == ColonFluid; });
  const bool isUpwards = grid.axes(2, 2) > 0.0;
  int        end = -1; // the caudal slice of the lumen
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
  // Half a voxel more than the radii of bores, for the distance ends in the middle of a voxel of the wall.
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
      CatheterTube tube;
      tube.sections = InsideBody(MeasureSections(region, axis));
      Judge(tube);
      const auto & e = tube.evidence;
      if (e.confidence >= LeastMentioned &&
          (!best || e.confidence > best->evidence.confidence ||
           (e.confidence == best->evidence.confidence && e.length > best->evidence.length)))
      {
        best = std::move(tube);
      }
    }
  }
  return best;
}
} // namespace shapeton
