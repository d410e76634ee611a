#include "shapetonLungTrees.h"

#include "shapetonForEachCell.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
using PointType = PhantomBody::PointType;
using VectorType = itk::Vector<double, 3>;
using Iterator = std::vector<PointType>::iterator;

constexpr double branchingExponent = 2.8; // radius^x of a vessel is the sum of those of its branches; Murray: 3
constexpr double taper = 0.92;            // radius at the end of a branch / mean radius; 1 / taper at its start
constexpr double tipTaper = 0.6;          // the last branches are thinner at their ends

PointType
CenterOf(Iterator first, Iterator last)
{
  VectorType sum(0.0);
  std::for_each(first, last, [&](const PointType & p) { sum += p.GetVectorFromOrigin(); });
  return PointType(0.0) + sum / static_cast<double>(last - first);
}

// The first principal axis by power iteration; a few steps are sufficiently accurate for a split.
VectorType
LongestExtent(Iterator first, Iterator last, const PointType & center)
{
  constexpr int    steps = 6;
  const VectorType start = MakeVector(0.5, 0.6, 0.62); // of the iteration
  VectorType       axis = start;
  for (int i = 0; i < steps; ++i)
  {
    VectorType next(0.0);
    std::for_each(first, last, [&](const PointType & p) { next += (p - center) * ((p - center) * axis); });
    const double norm = next.GetNorm();
    axis = norm > 0.0 ? next / norm : axis;
  }
  return axis;
}

class Growth
{
public:
  Growth(double tipRadius, PhantomRandom & random, std::vector<TaperedTube> & tree)
    : m_TipRadius(tipRadius), m_Random(random), m_Tree(tree)
  {}

  void
  Branch(const PointType & from, Iterator first, Iterator last)
  {
    const auto      count = last - first;
    const double    radius = m_TipRadius * std::pow(static_cast<double>(count), 1.0 / branchingExponent);
    const PointType center = CenterOf(first, last);
    const double    share = m_Random.Uniform(0.28, 0.48);
    const PointType to = count == 1 ? center : from + (center - from) * share;
    m_Tree.push_back({ from, to, radius / taper, radius * (count == 1 ? tipTaper : taper) });
    if (count == 1)
    {
      return;
    }
    const VectorType axis = LongestExtent(first, last, center);
    std::sort(first, last, [&](const PointType & a, const PointType & b) {
      return a.GetVectorFromOrigin() * axis < b.GetVectorFromOrigin() * axis;
    });
    const auto     lower = static_cast<std::ptrdiff_t>(static_cast<double>(count) * m_Random.Uniform(0.3, 0.7));
    const Iterator middle = first + std::clamp<std::ptrdiff_t>(lower, 1, count - 1);
    this->Branch(to, first, middle);
    this->Branch(to, middle, last);
  }

private:
  double                     m_TipRadius;
  PhantomRandom &            m_Random;
  std::vector<TaperedTube> & m_Tree;
};
} // namespace

std::vector<PointType>
ScatteredPoints(const PhantomSolid & solid,
                const PointType &    low,
                const PointType &    high,
                double               spacing,
                double               depth,
                PhantomRandom &      random)
{
  std::vector<PointType> points;
  const double           shift = spacing / 3.0;
  ForEachCell(low, high, spacing, [&](const PointType & at) {
    const double    dx = random.Uniform(-shift, shift);
    const double    dy = random.Uniform(-shift, shift);
    const double    dz = random.Uniform(-shift, shift);
    const PointType p = MakePoint(at[0] + dx, at[1] + dy, at[2] + dz);
    if (solid.distance(p) < -depth)
    {
      points.push_back(p);
    }
  });
  return points;
}

void
GrowTree(const PointType &          root,
         std::vector<PointType>     targets,
         double                     tipRadius,
         PhantomRandom &            random,
         std::vector<TaperedTube> & tree)
{
  if (!targets.empty())
  {
    Growth(tipRadius, random, tree).Branch(root, targets.begin(), targets.end());
  }
}
} // namespace shapeton
