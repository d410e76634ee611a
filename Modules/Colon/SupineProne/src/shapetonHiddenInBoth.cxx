#include "shapetonHiddenInBoth.h"

#include "shapetonColonCylinder.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
constexpr double step = 1.0; // mm along the centerline: a tenth of the shortest stretch that matters

/** Distance along the second centerline at each step along the first one: the mean around the tube. */
class MeanWay
{
public:
  MeanWay(const ColonCylinder & from, const ColonCylinder & to, const SurfaceMesh & map) : m_Begin(from.Begin())
  {
    const SurfaceArray * const uv = FindSurfaceArray(map.pointArrays, "uv");
    const SurfaceArray * const mapped = FindSurfaceArray(map.pointArrays, "mappedUv");
    if (!uv || !mapped)
    {
      throw InputError("the map between the positions lacks the point array \"" + std::string(uv ? "mappedUv" : "uv") +
                       "\"; run ColonRegistration again");
    }
    const auto       bins = static_cast<std::size_t>(std::ceil((from.End() - from.Begin()) / step)) + 1;
    std::vector<int> numbers(bins, 0);
    m_Other.assign(bins, 0.0); // sums, then means
    for (Eigen::Index i = 0; i < uv->values.rows(); ++i)
    {
      const std::size_t bin = this->BinOf(from.PlaceOfUv(uv->values.row(i).transpose()).s);
      m_Other[bin] += to.PlaceOfUv(mapped->values.row(i).transpose()).s;
      ++numbers[bin];
    }
    double last = to.Begin();
    for (std::size_t bin = 0; bin < bins; ++bin) // bins without vertices repeat the previous value
    {
      m_Other[bin] = last = numbers[bin] > 0 ? m_Other[bin] / numbers[bin] : last;
    }
  }

  double
  operator()(double s) const
  {
    return m_Other[this->BinOf(s)];
  }

private:
  std::size_t
  BinOf(double s) const
  {
    const double last = static_cast<double>(m_Other.size()) - 1.0;
    return static_cast<std::size_t>(std::clamp(std::round((s - m_Begin) / step), 0.0, last));
  }

  double              m_Begin;
  std::vector<double> m_Other;
};

/** Adds the parts of a stretch that are hidden according to the test. */
template <typename TTest>
void
AddParts(const HinderedStretch & stretch, const TTest & isHidden, std::vector<HinderedStretch> & parts)
{
  bool wasHidden = false;
  for (double s = stretch.begin; s < stretch.end; s += step)
  {
    const double end = std::min(stretch.end, s + step);
    const bool   isHiddenHere = isHidden(0.5 * (s + end));
    if (isHiddenHere && !wasHidden)
    {
      parts.push_back({ s, end, stretch.hindrance });
    }
    else if (isHiddenHere)
    {
      parts.back().end = end;
    }
    wasHidden = isHiddenHere;
  }
}
} // namespace

std::vector<HinderedStretch>
FindHiddenInBoth(const ColonPosition & first, const ColonPosition & second, const SurfaceMesh & firstToSecond)
{
  const ColonCylinder                from(*first.flat, first.centerline);
  const ColonCylinder                to(*second.flat, second.centerline);
  const MeanWay                      way(from, to, firstToSecond);
  const std::vector<HinderedStretch> hiddenThere = FindHinderedStretches(second.centerline);
  std::vector<HinderedStretch>       parts;
  for (const HinderedStretch & stretch : FindHinderedStretches(first.centerline))
  {
    AddParts(
      stretch, [&](double s) { return HindranceAt(hiddenThere, way(s)) != ColonHindrance::None; }, parts);
  }
  return parts;
}
} // namespace shapeton
