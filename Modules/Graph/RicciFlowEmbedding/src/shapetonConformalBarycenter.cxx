#include "shapetonConformalBarycenter.h"

#include "shapetonParallelFor.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
constexpr int    mostBoosts = 200;     // chosen; the most iterations
constexpr double wantedOffset = 1e-14; // of the barycenter from the center, radii of the sphere
/** Maximum boost of one step, in units of the speed of light. */
constexpr double fastest = 0.6;

/** A boost of Minkowski space: the Moebius transformation of the sphere that moves points away from `velocity`. */
class Boost
{
public:
  explicit Boost(const Eigen::Vector3d & velocity) : m_Velocity(velocity), m_Double(velocity), m_Extended(velocity) {}

  SphereCircle
  operator()(const SphereCircle & circle) const
  {
    return m_Double.Moved(circle);
  }

  /** A circle in extended precision, as a sum of two doubles per component. */
  void
  Move(SphereCircle & circle, SphereCircle & rest) const
  {
    std::array<long double, 4> sum{};
    for (int k = 0; k < 4; ++k)
    {
      sum[k] = static_cast<long double>(circle[k]) + rest[k];
    }
    sum = m_Extended.Moved(sum);
    for (int k = 0; k < 4; ++k)
    {
      circle[k] = static_cast<double>(sum[k]);
      rest[k] = static_cast<double>(sum[k] - static_cast<long double>(circle[k]));
    }
  }

  std::array<double, 3>
  operator()(const std::array<double, 3> & point) const
  {
    const SphereCircle    image = (*this)(SphereCircle{ point[0], point[1], point[2], 1.0 });
    const Eigen::Vector3d unit = Eigen::Vector3d(image[0], image[1], image[2]).normalized();
    return { unit[0], unit[1], unit[2] };
  }

private:
  template <typename TReal>
  struct Matrix
  {
    explicit Matrix(const Eigen::Vector3d & velocity) : x(velocity[0]), y(velocity[1]), z(velocity[2]) {}

    std::array<TReal, 4>
    Moved(const std::array<TReal, 4> & circle) const
    {
      const TReal along = x * circle[0] + y * circle[1] + z * circle[2];
      const TReal shift = factor * along - gamma * circle[3];
      return { circle[0] + shift * x, circle[1] + shift * y, circle[2] + shift * z, gamma * (circle[3] - along) };
    }

    TReal x, y, z;
    TReal gamma{ 1 / std::sqrt(1 - (x * x + y * y + z * z)) };
    TReal factor{ gamma * gamma / (1 + gamma) }; ///< (gamma - 1) / v^2
  };

  Eigen::Vector3d     m_Velocity;
  Matrix<double>      m_Double;
  Matrix<long double> m_Extended;
};

/** Sums over points on the sphere. */
struct Moments
{
  Eigen::Vector3d first{ Eigen::Vector3d::Zero() };
  Eigen::Matrix3d rejection{ Eigen::Matrix3d::Zero() }; ///< sum of 1 - x x^T
};

/** Sums in blocks of fixed size, so that rounding is independent of the number of threads. */
Moments
MomentsOf(const std::vector<std::array<double, 3>> & points, const std::vector<int> & chosen)
{
  constexpr std::size_t blockSize = 16384;
  std::vector<Moments>  blocks((chosen.size() + blockSize - 1) / blockSize);
  ParallelFor(blocks.size(), [&](std::size_t block) {
    Moments           sum;
    const std::size_t end = std::min(chosen.size(), (block + 1) * blockSize);
    for (std::size_t i = block * blockSize; i < end; ++i)
    {
      const Eigen::Vector3d point(points[chosen[i]].data());
      sum.first += point;
      sum.rejection += Eigen::Matrix3d::Identity() - point * point.transpose();
    }
    blocks[block] = sum;
  });
  Moments all;
  for (const Moments & block : blocks)
  {
    all.first += block.first;
    all.rejection += block.rejection;
  }
  return all;
}

/** Newton step for the function on hyperbolic space that is minimal at the barycenter. */
Eigen::Vector3d
NewtonStep(const std::vector<std::array<double, 3>> & points, const std::vector<int> & chosen, double & offset)
{
  const Moments         sums = MomentsOf(points, chosen);
  const Eigen::Vector3d mean = sums.first / static_cast<double>(chosen.size());
  const Eigen::Matrix3d hessian = sums.rejection / static_cast<double>(chosen.size());
  offset = mean.norm();
  const double          determinant = hessian.determinant();
  const Eigen::Vector3d step = std::abs(determinant) < 1e-12 ? mean : Eigen::Vector3d(hessian.inverse() * mean);
  return step.norm() > fastest ? Eigen::Vector3d(step * (fastest / step.norm())) : step;
}

void
Move(SphericalPacking & packing, const Boost & boost)
{
  const auto move = [&](std::vector<SphereCircle> & circles, std::vector<SphereCircle> & rests) {
    ParallelForBlocks(circles.size(), [&](std::size_t c) {
      rests.empty() ? void(circles[c] = boost(circles[c])) : boost.Move(circles[c], rests[c]);
    });
  };
  move(packing.nodes, packing.nodeRests);
  move(packing.faces, packing.faceRests);
  ParallelForBlocks(packing.touchPoints.size(),
                    [&](std::size_t p) { packing.touchPoints[p] = boost(packing.touchPoints[p]); });
}
} // namespace

double
CenterPacking(SphericalPacking & packing, const std::vector<int> & edges, double mostRapidity)
{
  double rapidity = 0.0;
  for (int i = 0; i < mostBoosts && rapidity <= mostRapidity; ++i)
  {
    double                offset = 0.0;
    const Eigen::Vector3d velocity = NewtonStep(packing.touchPoints, edges, offset);
    if (offset < wantedOffset)
    {
      break;
    }
    rapidity += std::atanh(velocity.norm());
    Move(packing, Boost(velocity));
  }
  return rapidity;
}

namespace
{
/** Fourth root of cot(angle / 2) for the cap with this cotangent of its angle. */
double
CapWeight(double cotangent)
{
  const double length = std::hypot(1.0, cotangent);
  return std::sqrt(std::sqrt(cotangent > 0.0 ? length + cotangent : 1.0 / (length - cotangent)));
}

/** Sum of cap weights, with derivatives, for a viewpoint that moves from the center of the ball. */
struct CapSum
{
  explicit CapSum(const std::vector<SphereCircle> & caps)
  {
    constexpr double power = 0.25;
    for (const SphereCircle & cap : caps)
    {
      const double          weight = CapWeight(cap[3]);
      const double          length = std::hypot(1.0, cap[3]);
      const Eigen::Vector3d slope = Eigen::Vector3d(cap.data()) / -length; // gradient of the distance to the plane
      const double          bend = std::max(0.0, cap[3] / length);
      value += weight;
      gradient += power * weight * slope;
      hessian += power * weight * (bend * Eigen::Matrix3d::Identity() + (power - bend) * slope * slope.transpose());
    }
  }
  double          value{ 0.0 };
  Eigen::Vector3d gradient{ Eigen::Vector3d::Zero() };
  Eigen::Matrix3d hessian{ Eigen::Matrix3d::Zero() };
};

double
SumAfter(const std::vector<SphereCircle> & caps, const Boost & boost)
{
  double sum = 0.0;
  for (const SphereCircle & cap : caps)
  {
    sum += CapWeight(boost(cap)[3]);
  }
  return sum;
}

/** Newton step, shortened until the sum decreases; of length 0 if it does not. */
Eigen::Vector3d
StepToLargerCaps(const std::vector<SphereCircle> & caps)
{
  constexpr int    mostHalvings = 30;
  constexpr double shortest = 1e-15;
  const CapSum     sum(caps);
  Eigen::Vector3d  velocity = -sum.hessian.ldlt().solve(sum.gradient);
  velocity *= std::min(1.0, fastest / velocity.norm());
  for (int halvings = 0; halvings < mostHalvings && velocity.norm() > shortest; ++halvings, velocity *= 0.5)
  {
    if (SumAfter(caps, Boost(velocity)) < sum.value)
    {
      return velocity;
    }
  }
  return Eigen::Vector3d::Zero();
}
} // namespace

double
EnlargeSmallCaps(SphericalPacking & packing, const std::vector<char> & isVisible, double mostRapidity)
{
  std::vector<SphereCircle> caps;
  for (std::size_t node = 0; node < isVisible.size(); ++node)
  {
    if (isVisible[node])
    {
      caps.push_back(packing.nodes[node]);
    }
  }
  double rapidity = 0.0;
  for (int i = 0; i < mostBoosts && rapidity <= mostRapidity && !caps.empty(); ++i)
  {
    const Eigen::Vector3d velocity = StepToLargerCaps(caps);
    if (velocity.isZero(0.0))
    {
      break;
    }
    rapidity += std::atanh(velocity.norm());
    const Boost boost(velocity);
    Move(packing, boost);
    std::for_each(caps.begin(), caps.end(), [&](SphereCircle & cap) { cap = boost(cap); });
  }
  return rapidity;
}

namespace
{
/** Sum of the centers with pseudorandom weights by rank. */
Eigen::Vector3d
WeightedSum(const std::vector<SphereCircle> & nodes, const std::vector<int> & rank, double frequency)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < rank.size(); ++i)
  {
    const std::array<double, 3> center = CenterOf(nodes[i]);
    sum += std::cos(frequency * (rank[i] + 1)) * Eigen::Vector3d(center.data());
  }
  return sum;
}

Eigen::Vector3d
Rejected(const Eigen::Vector3d & vector, const Eigen::Vector3d & unit)
{
  return vector - vector.dot(unit) * unit;
}

/** The new axes, as rows. Sums too short to define a direction are skipped. */
Eigen::Matrix3d
CanonicalAxes(const SphericalPacking & packing, const std::vector<int> & rank)
{
  constexpr double shortest = 0.1;
  constexpr double frequencyStep = 0.37; // of the weights, which differ for each sum
  constexpr double notAlong = 0.7;       // cosine
  constexpr int    trials = 20;
  Eigen::Vector3d  north = Eigen::Vector3d::UnitZ();
  double           frequency = 1.0;
  for (int i = 0; i < trials; ++i, frequency += frequencyStep)
  {
    const Eigen::Vector3d sum = WeightedSum(packing.nodes, rank, frequency);
    if (sum.norm() > shortest)
    {
      north = sum.normalized();
      break;
    }
  }
  Eigen::Vector3d meridian =
    Rejected(std::abs(north[0]) < notAlong ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY(), north);
  for (int i = 0; i < trials; ++i)
  {
    frequency += frequencyStep;
    const Eigen::Vector3d sum = Rejected(WeightedSum(packing.nodes, rank, frequency), north);
    if (sum.norm() > shortest)
    {
      meridian = sum;
      break;
    }
  }
  meridian.normalize();
  Eigen::Matrix3d axes;
  axes << meridian.transpose(), north.cross(meridian).transpose(), north.transpose();
  return axes;
}
} // namespace

void
TurnToCanonicalPosition(SphericalPacking & packing, const std::vector<int> & rank)
{
  const Eigen::Matrix3d axes = CanonicalAxes(packing, rank);
  for (auto * circles : { &packing.nodes, &packing.faces })
  {
    for (SphereCircle & circle : *circles)
    {
      const Eigen::Vector3d turned = axes * Eigen::Vector3d(circle.data());
      circle = { turned[0], turned[1], turned[2], circle[3] };
    }
  }
  for (auto & point : packing.touchPoints)
  {
    const Eigen::Vector3d turned = axes * Eigen::Vector3d(point.data());
    point = { turned[0], turned[1], turned[2] };
  }
}
} // namespace shapeton
