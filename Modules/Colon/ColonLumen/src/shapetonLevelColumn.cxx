#include "shapetonLevelColumn.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
constexpr double UsualBlur = 0.8;   // mm, standard deviation of the scanner's
constexpr double FirstDepth = 1.2;  // mm below the half-height; above it the rise is too steep to be judged
constexpr double GreatestDip = 0.3; // of the contrast between tissue and what is fainter, the level's fluid or the goal
constexpr double NoiseInDip = 2.0;  // standard deviations
constexpr double LogisticRate = 1.7; // the logistic curve of this rate is within 1 % of the normal distribution

/** The normal distribution, near enough, with the share `half` at 0. */
double
ShareOfRise(double depth, double half, double blur)
{
  return 1.0 / (1.0 + (1.0 / half - 1.0) * std::exp(-LogisticRate * depth / blur));
}

/** How much deeper the half-height lies than the line between the two voxels around it says; `above` is the depth of
 * the upper one, at most 0. The line bends away from a rise that is thinner than a voxel. */
double
ErrorOfLine(double above, double step, double half, double blur)
{
  double low = -step;
  double high = step;
  for (int n = 0; n < 20; ++n)
  {
    const double error = 0.5 * (low + high);
    const double upper = ShareOfRise(above - error, half, blur);
    const double lower = ShareOfRise(above + step - error, half, blur);
    (upper - above / step * (lower - upper) > half ? low : high) = error;
  }
  return 0.5 * (low + high);
}
} // namespace

LevelColumn::LevelColumn(const ColonGrid &          grid,
                         const std::vector<float> & hu,
                         const Fall &               fall,
                         const ColonThresholds &    thresholds,
                         double                     noise,
                         double                     smoothing)
  : m_Grid(grid)
  , m_Hu(hu)
  , m_Fall(fall)
  , m_Thresholds(thresholds)
  , m_Noise(noise)
  , m_Blur(std::sqrt(UsualBlur * UsualBlur + smoothing * smoothing + fall.step * fall.step / 12.0))
{}

bool
LevelColumn::IsOpen(const Level & level, const std::array<int, 3> & floor, int steps) const
{
  const auto value = [&](int t) {
    const auto o = m_Fall.Offset(t);
    return m_Hu[m_Grid.Index(floor[0] + o[0], floor[1] + o[1], floor[2] + o[2])];
  };
  const auto &    t = m_Thresholds;
  const auto      top = m_Grid.Position(Eigen::Vector3d(floor[0], floor[1], floor[2]));
  Eigen::Vector2d place(top.dot(m_Fall.across[0]), top.dot(m_Fall.across[1]));
  const double    line = top.dot(m_Fall.direction) - level.depth - level.slope.dot(place - level.centre);
  const double    plateau = std::min<double>(level.Fluid(), value(steps));
  const double    half = (t.gasBoundary - t.gas) / std::max(1.0, plateau - t.gas);
  const double    above = line - m_Fall.step * std::ceil(line / m_Fall.step);
  const double    below = line - ErrorOfLine(above, m_Fall.step, half, m_Blur);
  const double    most = std::max(GreatestDip * (plateau - t.tissue), NoiseInDip * m_Noise);
  for (int n = 1; n < steps; ++n)
  {
    const double depth = below + n * m_Fall.step;
    const double share = ShareOfRise(depth, half, m_Blur);
    if (depth >= FirstDepth && value(n) < t.gas + share * (plateau - t.gas) - most)
    {
      return false;
    }
  }
  return true;
}
} // namespace shapeton
