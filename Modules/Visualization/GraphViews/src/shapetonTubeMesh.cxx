#include "shapetonTubeMesh.h"

#include "shapetonPi.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
/** Maximum angle between neighbors of a section. */
constexpr double widest = Pi / 10.0;
} // namespace

TubeMesh::TubeMesh(const std::vector<TubeSection> &        sections,
                   const std::array<std::vector<int>, 2> & rims,
                   const std::vector<std::array<int, 2>> & ends,
                   std::vector<Eigen::Vector3d> &          vertices,
                   std::vector<std::array<int, 3>> &       triangles)
  : m_Ends(ends), m_Vertices(vertices), m_Triangles(triangles), m_Curves(ends.size())
{
  const Ring first = this->RimOf(sections.front(), rims[0], 0);
  Ring       last = this->RimOf(sections.back(), rims[1], 1);
  this->Unwind(first, last);
  Ring before = first;
  for (std::size_t i = 1; i < sections.size(); ++i)
  {
    const double t = static_cast<double>(i) / static_cast<double>(sections.size() - 1);
    const Ring   ring = i + 1 < sections.size() ? this->RingBetween(first, last, sections[i], t) : last;
    this->Join(before, ring);
    before = ring;
  }
}

TubeMesh::Ring
TubeMesh::RimOf(const TubeSection & section, const std::vector<int> & rim, std::size_t side) const
{
  const int    first = m_Ends.front()[side];
  const double zero = section.AngleOf(m_Vertices[first]);
  const auto   angleOf = [&](int vertex) {
    const double angle = section.AngleOf(m_Vertices[vertex]);
    return vertex == first || angle > zero ? angle : angle + 2.0 * Pi;
  };
  Ring ring{ rim, {}, {} };
  std::sort(ring.vertices.begin(), ring.vertices.end(), [&](int a, int b) { return angleOf(a) < angleOf(b); });
  std::transform(ring.vertices.begin(), ring.vertices.end(), std::back_inserter(ring.angles), angleOf);
  ring.vertices.push_back(first);
  ring.angles.push_back(zero + 2.0 * Pi);
  for (const std::array<int, 2> & end : m_Ends)
  {
    const auto place = std::find(ring.vertices.begin(), ring.vertices.end(), end[side]);
    ring.curves.push_back(static_cast<std::size_t>(place - ring.vertices.begin()));
  }
  ring.curves.push_back(ring.vertices.size() - 1);
  return ring;
}

/** Number of whole turns of the last ring that minimizes the mean winding of the curves. */
void
TubeMesh::Unwind(const Ring & first, Ring & last)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < m_Ends.size(); ++i)
  {
    sum += last.angles[last.curves[i]] - first.angles[first.curves[i]];
  }
  const double turns = sum / (2.0 * Pi * static_cast<double>(m_Ends.size()));
  for (double & angle : last.angles)
  {
    angle -= 2.0 * Pi * std::round(turns);
  }
  m_Twist = turns - std::round(turns);
}

TubeMesh::Ring
TubeMesh::RingBetween(const Ring & first, const Ring & last, const TubeSection & section, double t)
{
  Ring ring;
  for (std::size_t curve = 0; curve < m_Ends.size(); ++curve)
  {
    const double from = first.angles[first.curves[curve]];
    const double fromEnd = first.angles[first.curves[curve + 1]];
    const double to = last.angles[last.curves[curve]];
    const double toEnd = last.angles[last.curves[curve + 1]];
    const int    parts = static_cast<int>(std::ceil(std::max(fromEnd - from, toEnd - to) / widest));
    ring.curves.push_back(ring.vertices.size());
    for (int i = 0; i < parts; ++i)
    {
      const double s = static_cast<double>(i) / parts;
      const double angle = (1.0 - t) * (from + s * (fromEnd - from)) + t * (to + s * (toEnd - to));
      ring.angles.push_back(angle);
      ring.vertices.push_back(static_cast<int>(m_Vertices.size()));
      m_Vertices.push_back(section.At(angle));
    }
  }
  ring.curves.push_back(ring.vertices.size());
  ring.angles.push_back(ring.angles.front() + 2.0 * Pi);
  ring.vertices.push_back(ring.vertices.front());
  return ring;
}

/** Triangles between two rings, from curve to curve, and the segments of the curves. */
void
TubeMesh::Join(const Ring & from, const Ring & to)
{
  for (std::size_t curve = 0; curve < m_Ends.size(); ++curve)
  {
    std::size_t       a = from.curves[curve];
    std::size_t       b = to.curves[curve];
    const std::size_t aEnd = from.curves[curve + 1];
    const std::size_t bEnd = to.curves[curve + 1];
    const auto        share = [](const Ring & ring, std::size_t i, std::size_t begin, std::size_t end) {
      return (ring.angles[i] - ring.angles[begin]) / (ring.angles[end] - ring.angles[begin]);
    };
    const std::size_t aBegin = a;
    const std::size_t bBegin = b;
    if (m_Curves[curve].empty())
    {
      m_Curves[curve].push_back(from.vertices[a]);
    }
    m_Curves[curve].push_back(to.vertices[b]);
    while (a < aEnd || b < bEnd)
    {
      if (b == bEnd || (a < aEnd && share(from, a + 1, aBegin, aEnd) <= share(to, b + 1, bBegin, bEnd)))
      {
        m_Triangles.push_back({ from.vertices[a], from.vertices[a + 1], to.vertices[b] });
        ++a;
      }
      else
      {
        m_Triangles.push_back({ from.vertices[a], to.vertices[b + 1], to.vertices[b] });
        ++b;
      }
    }
  }
}
} // namespace shapeton
