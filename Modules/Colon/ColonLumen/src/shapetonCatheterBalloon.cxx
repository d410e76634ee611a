#include "shapetonCatheterBalloon.h"

#include <algorithm>

namespace shapeton
{
namespace
{
constexpr double LeastBalloon = 10.0;     // mm of sections
constexpr double MembraneShare = 1.0 / 3; // of the rays
constexpr double BalloonOvality = 0.25;
constexpr double SmallestBalloon = 6.0; // mm, radius
constexpr double LargestBalloon = 30.0;

/** The median distance of a second layer round a section that shows a balloon there, mm; else 0. */
double
BalloonRadius(const TubeSection & section, const CatheterRegion & region)
{
  TubeSection         second = section;
  std::vector<double> radii;
  int                 thin = 0;
  for (int n = 0; n < TubeSection::NumberOfRays; ++n)
  {
    const TubeRay & wall = section.rays[n];
    TubeRay &       ray = second.rays[n];
    ray = wall.IsEnclosed()
            ? FirstLayer(region, section.centre, section.DirectionOf(n), wall.outer + 1.0, LargestBalloon)
            : TubeRay{};
    if (ray.inner > 0.0)
    {
      radii.push_back(ray.inner);
      thin += ray.behind == BehindLayer::Gas && ray.outer - ray.inner <= ThickestMembrane;
    }
  }
  const double radius = MedianOf(radii);
  const bool   isBalloon =
    thin >= MembraneShare * TubeSection::NumberOfRays && radius >= SmallestBalloon && second.Ovality() < BalloonOvality;
  return isBalloon ? radius : 0.0;
}
} // namespace

std::optional<CatheterBalloon>
FindBalloon(const CatheterTube & tube, const CatheterRegion & region)
{
  CatheterBalloon balloon;
  double          sections = 0.0; // 1 mm each
  balloon.centre.setZero();
  for (const auto & section : tube.sections)
  {
    const double radius = BalloonRadius(section, region);
    if (radius > 0.0)
    {
      balloon.centre += section.centre;
      balloon.radius = std::max(balloon.radius, radius);
      sections += 1.0;
    }
  }
  balloon.centre /= std::max(1.0, sections);
  return sections >= LeastBalloon ? std::optional<CatheterBalloon>(balloon) : std::nullopt;
}
} // namespace shapeton
