#include "shapetonSurfaceLayout.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace shapeton
{
namespace
{
/** Monotonic measure of the displacement of the origin, to six digits, so that symmetric copies keep their search order
 * despite rounding. */
double
Reach(const PlaneMotion & motion)
{
  constexpr double digits = 1e6;
  return std::round(digits * std::log1p(std::norm(motion.b)));
}

bool
IsSameMotion(const PlaneMotion & one, const PlaneMotion & other)
{
  const PlaneMotion difference = one * other.Inverse();
  const double      sign = difference.a.real() < 0.0 && one.geometry == FlowGeometry::Hyperbolic ? -1.0 : 1.0;
  return std::abs(difference.a - sign) < 1e-3 && std::abs(difference.b) < 1e-3;
}
} // namespace

std::vector<PlaneMotion>
UniversalCover(const std::vector<PlaneMotion> & generators, int number)
{
  struct Candidate
  {
    PlaneMotion motion;
    int         order;
    bool
    operator<(const Candidate & other) const
    {
      const double a = Reach(motion);
      const double b = Reach(other.motion);
      return a != b ? a > b : order > other.order;
    }
  };
  std::vector<PlaneMotion>       taken;
  std::priority_queue<Candidate> queue;
  int                            order = 0;
  queue.push({ PlaneMotion::Rotation(generators.front().geometry, 0.0), order++ });
  // A near copy may be reachable only through a farther one.
  while (static_cast<int>(taken.size()) < 4 * number && !queue.empty())
  {
    const PlaneMotion motion = queue.top().motion;
    queue.pop();
    if (std::any_of(taken.begin(), taken.end(), [&](const PlaneMotion & other) { return IsSameMotion(motion, other); }))
    {
      continue;
    }
    taken.push_back(motion);
    for (const PlaneMotion & generator : generators)
    {
      queue.push({ (motion * generator).Normalized(), order++ });
      queue.push({ (motion * generator.Inverse()).Normalized(), order++ });
    }
  }
  std::stable_sort(
    taken.begin(), taken.end(), [](const PlaneMotion & a, const PlaneMotion & b) { return Reach(a) < Reach(b); });
  taken.resize(std::min<std::size_t>(taken.size(), number));
  return taken;
}
} // namespace shapeton
