#include "shapetonCatheterBalloon.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
constexpr std::size_t LeastSections = 8;        // 1 mm each
constexpr double      ShareOfRays = 1.0 / 3;    // rays of a section with an exit; chosen
constexpr double      ThickestMembrane = 3.0;   // mm, blurred
constexpr double      ThinnestInFluid = 2.0;    // mm, blurred; excludes partial volume at a level of bright fluid
constexpr double      LeastRoom = 2.5;          // mm between tube and sphere; chosen
constexpr double      LargestBalloon = 30.0;    // mm, radius; chosen
constexpr double      FarFromBall = 1.5;        // mm; chosen: exits farther off are outliers
constexpr double      ShareOnBall = 0.75;       // exits that are not outliers; chosen
constexpr double      LeastResidual = 0.6;      // mm; smaller residuals are always accepted
constexpr double      ShareOfRadius = 1.0 / 12; // residual relative to the radius; chosen
constexpr double      ShareOffAxis = 1.0 / 3;   // of the radius
constexpr double      ShareOfCylinder = 0.5;    // relative to the residual of a cylinder

using Exits = std::vector<BalloonExit>;

/** Threshold (HU) for a membrane, whose contrast may be reduced to a quarter by blur. */
double
MembraneBoundary(const ColonThresholds & thresholds)
{
  return thresholds.gas + 0.25 * (thresholds.tissue - thresholds.gas);
}

/** Point at which the ray exits the matter around the tube. */
std::optional<BalloonExit>
ExitOf(const CatheterTube & tube, const TubeSection & section, int number, const CatheterRegion & region)
{
  const TubeRay & wall = section.rays[number];
  if (wall.inner == 0.0)
  {
    return std::nullopt;
  }
  OutwardRay ray = section.RayAlong(number, region.thresholds.gasBoundary);
  TubeRay    layer;
  bool       isBalloon = false;
  if (wall.behind == BehindLayer::Gas)
  {
    ray.boundary = MembraneBoundary(region.thresholds);
    layer = FirstLayer(region, ray, wall.outer + 1.0, LargestBalloon);
    const double thickness = layer.outer - layer.inner;
    isBalloon = thickness <= ThickestMembrane && (layer.behind != BehindLayer::Fluid || thickness >= ThinnestInFluid);
  }
  else
  {
    layer = CrossLayer(region, ray, wall.inner, LargestBalloon);
    isBalloon = layer.outer >= tube.outerRadius + 0.5 * LeastRoom;
  }
  const BalloonExit exit{ section.center + layer.outer * ray.direction, layer.behind };
  return isBalloon && layer.IsLeft() ? std::optional(exit) : std::nullopt;
}

Exits
ExitsOf(const CatheterTube & tube, const TubeSection & section, const CatheterRegion & region)
{
  Exits exits;
  for (int ray = 0; ray < TubeSection::NumberOfRays; ++ray)
  {
    if (const auto exit = ExitOf(tube, section, ray, region))
    {
      exits.push_back(*exit);
    }
  }
  return exits;
}

/** Least squares sphere: |x|^2 = 2 c x + r^2 - c^2 is linear in c and r^2 - c^2. For coplanar points, the center is in
 * their plane. */
CatheterBalloon
FittedBall(const Exits & exits)
{
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const BalloonExit & exit : exits)
  {
    mean += exit.position / static_cast<double>(exits.size());
  }
  Eigen::Matrix4d squares = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  for (const BalloonExit & exit : exits)
  {
    const Eigen::Vector3d x = exit.position - mean;
    const Eigen::Vector4d row(2.0 * x[0], 2.0 * x[1], 2.0 * x[2], 1.0);
    squares += row * row.transpose();
    right += x.squaredNorm() * row;
  }
  const Eigen::Vector4d solution = squares.completeOrthogonalDecomposition().solve(right);
  const Eigen::Vector3d center = solution.head<3>();
  return { mean + center, std::sqrt(std::max(0.0, solution[3] + center.squaredNorm())), exits };
}

double
OffBall(const CatheterBalloon & ball, const BalloonExit & exit)
{
  return (exit.position - ball.center).norm() - ball.radius;
}

double
RootMeanSquare(const CatheterBalloon & ball)
{
  double sum = 0.0;
  for (const BalloonExit & exit : ball.exits)
  {
    sum += OffBall(ball, exit) * OffBall(ball, exit);
  }
  return std::sqrt(sum / static_cast<double>(ball.exits.size()));
}

/** Robust sphere fit with iterative removal of outliers. */
CatheterBalloon
BallThroughMost(Exits exits)
{
  constexpr int   turns = 12; // chosen: bounds the time; ends earlier without outliers
  CatheterBalloon ball = FittedBall(exits);
  for (int turn = 0; turn < turns && exits.size() > 8; ++turn)
  {
    const double limit = std::max(FarFromBall, 2.0 * RootMeanSquare(ball));
    const auto   far = std::partition(
      exits.begin(), exits.end(), [&](const BalloonExit & exit) { return std::abs(OffBall(ball, exit)) <= limit; });
    if (far == exits.end())
    {
      break;
    }
    exits.erase(far, exits.end());
    ball = FittedBall(exits);
  }
  return ball;
}

/** Root mean square distance of points from the least squares cylinder along a direction. */
double
CylinderResidual(const Exits & exits, const Eigen::Vector3d & along)
{
  Exits across = exits;
  for (BalloonExit & exit : across)
  {
    exit.position -= exit.position.dot(along) * along;
  }
  return RootMeanSquare(FittedBall(across));
}

bool
IsAroundTube(const CatheterBalloon & ball, const CatheterTube & tube)
{
  const auto distance = [&](const TubeSection & section) { return (section.center - ball.center).norm(); };
  const auto nearest =
    std::min_element(tube.sections.begin(), tube.sections.end(), [&](const TubeSection & s, const TubeSection & t) {
      return distance(s) < distance(t);
    });
  return ball.radius >= tube.outerRadius + LeastRoom && ball.radius <= LargestBalloon &&
         distance(*nearest) <= ShareOffAxis * ball.radius &&
         RootMeanSquare(ball) <= ShareOfCylinder * CylinderResidual(ball.exits, nearest->along);
}

/** The balloon in the sections from `first` to `last` (exclusive), if there is one. */
std::optional<CatheterBalloon>
BalloonOf(const CatheterTube & tube, const std::vector<Exits> & ofSection, std::size_t first, std::size_t last)
{
  Exits exits;
  for (std::size_t n = first; n < last; ++n)
  {
    exits.insert(exits.end(), ofSection[n].begin(), ofSection[n].end());
  }
  const CatheterBalloon ball = BallThroughMost(exits);
  const double          share = static_cast<double>(ball.exits.size()) / static_cast<double>(exits.size());
  const bool            isBall =
    share >= ShareOnBall && RootMeanSquare(ball) <= std::max(LeastResidual, ShareOfRadius * ball.radius);
  return isBall && IsAroundTube(ball, tube) ? std::optional(ball) : std::nullopt;
}
} // namespace

std::optional<CatheterBalloon>
FindBalloon(const CatheterTube & tube, const CatheterRegion & region)
{
  std::vector<Exits> exits(tube.sections.size());
  ParallelFor(exits.size(), [&](std::size_t n) { exits[n] = ExitsOf(tube, tube.sections[n], region); });
  std::optional<CatheterBalloon> best;
  for (std::size_t first = 0, n = 0; n <= exits.size(); ++n)
  {
    if (n < exits.size() && static_cast<double>(exits[n].size()) >= ShareOfRays * TubeSection::NumberOfRays)
    {
      continue;
    }
    const auto ball = n - first >= LeastSections ? BalloonOf(tube, exits, first, n) : std::nullopt;
    best = ball && (!best || ball->exits.size() > best->exits.size()) ? ball : best;
    first = n + 1;
  }
  return best;
}
} // namespace shapeton
