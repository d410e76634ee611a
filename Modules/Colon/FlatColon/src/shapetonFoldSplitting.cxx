#include "shapetonFoldSplitting.h"

#include "shapetonDisjointSets.h"
#include "shapetonFlatColonLocator.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

namespace shapeton
{
namespace
{
/** Parts of a fold, grown from its ridges at a decreasing level. */
class FoldFlood
{
public:
  FoldFlood(const FoldPicture & picture, const FoldPixels & pixels, const FoldSplittingRule & rule)
    : m_Picture(picture), m_Pixels(pixels), m_Rule(rule), m_Order(pixels.size())
  {
    for (std::size_t i = 0; i < pixels.size(); ++i)
    {
      m_PlaceOfPixel.emplace(picture.Index(pixels[i].column, pixels[i].row), static_cast<int>(i));
    }
    std::iota(m_Order.begin(), m_Order.end(), 0);
    std::stable_sort(m_Order.begin(), m_Order.end(), [this](int a, int b) { return this->Value(a) > this->Value(b); });
    m_PartOf.assign(pixels.size(), -1);
  }

  std::vector<FoldPixels>
  Run()
  {
    for (const int i : m_Order)
    {
      this->Take(i);
    }
    return this->Collect();
  }

private:
  struct Part
  {
    double peak;
    double area;
  };

  std::size_t
  IndexOf(int i) const
  {
    return m_Picture.Index(m_Pixels[i].column, m_Pixels[i].row);
  }
  double
  Value(int i) const
  {
    return std::abs(m_Picture.curvature[this->IndexOf(i)]);
  }
  /** The parts adjacent to a pixel, starting with that of the highest neighbor. */
  std::vector<int>
  PartsAround(int i)
  {
    std::vector<std::pair<double, int>> found;
    for (int dy = -1; dy <= 1; ++dy)
    {
      for (int dx = -1; dx <= 1; ++dx)
      {
        const int  column = m_Pixels[i].column + dx;
        const int  row = (m_Pixels[i].row + dy + m_Picture.rows) % m_Picture.rows;
        const auto other = column < 0 || column >= m_Picture.columns
                             ? m_PlaceOfPixel.end()
                             : m_PlaceOfPixel.find(m_Picture.Index(column, row));
        if (other != m_PlaceOfPixel.end() && m_PartOf[other->second] >= 0)
        {
          found.emplace_back(-this->Value(other->second), m_Joined.Find(m_PartOf[other->second]));
        }
      }
    }
    std::sort(found.begin(), found.end());
    std::vector<int> parts;
    for (const auto & [value, part] : found)
    {
      if (std::find(parts.begin(), parts.end(), part) == parts.end())
      {
        parts.push_back(part);
      }
    }
    return parts;
  }

  bool
  StaysApart(const Part & a, const Part & b, int i) const
  {
    const bool   isOnTaenia = !m_Rule.isTaenia.empty() && m_Rule.isTaenia[this->IndexOf(i)];
    const double saddle = isOnTaenia ? m_Rule.saddleOnTaenia : m_Rule.saddle;
    return std::min(a.area, b.area) >= m_Rule.leastArea && this->Value(i) < saddle * std::min(a.peak, b.peak);
  }

  void
  Take(int i)
  {
    const std::vector<int> around = this->PartsAround(i);
    if (around.empty())
    {
      m_PartOf[i] = m_Joined.Add();
      m_Parts.push_back({ this->Value(i), m_Picture.AreaOf(this->IndexOf(i)) });
      return;
    }
    int own = around.front();
    for (std::size_t k = 1; k < around.size(); ++k)
    {
      const int other = m_Joined.Find(around[k]);
      if (other != own && !this->StaysApart(m_Parts[own], m_Parts[other], i))
      {
        m_Joined.Absorb(own, other);
        m_Parts[own].peak = std::max(m_Parts[own].peak, m_Parts[other].peak);
        m_Parts[own].area += m_Parts[other].area;
      }
    }
    m_PartOf[i] = own;
    m_Parts[own].area += m_Picture.AreaOf(this->IndexOf(i));
  }

  std::vector<FoldPixels>
  Collect()
  {
    std::vector<int>        places(m_Parts.size(), -1);
    std::vector<FoldPixels> folds;
    for (std::size_t i = 0; i < m_Pixels.size(); ++i)
    {
      int & place = places[m_Joined.Find(m_PartOf[i])];
      if (place < 0)
      {
        place = static_cast<int>(folds.size());
        folds.emplace_back();
      }
      folds[place].push_back(m_Pixels[i]);
    }
    return folds;
  }

  const FoldPicture &                  m_Picture;
  const FoldPixels &                   m_Pixels;
  const FoldSplittingRule &            m_Rule;
  std::vector<int>                     m_Order; ///< by decreasing curvature
  std::unordered_map<std::size_t, int> m_PlaceOfPixel;
  std::vector<int>                     m_PartOf;
  std::vector<Part>                    m_Parts; ///< indexed by the representatives of merged parts
  DisjointSets<>                       m_Joined;
};
/** Points along a curve, at most `step` mm apart. */
std::vector<Eigen::Vector3d>
PointsAlong(const CurveSet & curves, const std::vector<int> & curve, double step)
{
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i + 1 < curve.size(); ++i)
  {
    const Eigen::Vector3d from = curves.V.row(curve[i]);
    const Eigen::Vector3d to = curves.V.row(curve[i + 1]);
    const int             parts = 1 + static_cast<int>((to - from).norm() / step);
    for (int part = 0; part < parts; ++part)
    {
      points.push_back(from + (to - from) * part / parts);
    }
  }
  return points;
}

void
MarkAround(const FlatColonGrid & grid, const FlatPixel & middle, int reach, std::vector<char> & mask)
{
  for (int dy = -reach; dy <= reach; ++dy)
  {
    const int row = ((middle.row + dy) % grid.Rows() + grid.Rows()) % grid.Rows();
    const int last = std::min(grid.Columns() - 1, middle.column + reach);
    for (int column = std::max(0, middle.column - reach); column <= last; ++column)
    {
      mask[static_cast<std::size_t>(row) * grid.Columns() + column] = 1;
    }
  }
}
} // namespace

std::vector<FoldPixels>
SplitFold(const FoldPicture & picture, const FoldPixels & pixels, const FoldSplittingRule & rule)
{
  return FoldFlood(picture, pixels, rule).Run();
}

std::vector<char>
MaskOfTaeniae(const FlatColonGrid & grid, const CurveSet & taeniae, double distance)
{
  constexpr double       farthest = 15.0; // mm; chosen: only taeniae of another surface are farther
  const FlatColonLocator locator(grid);
  const int              reach = std::max(1, static_cast<int>(std::lround(distance / grid.PixelSize())));
  std::vector<char>      mask(static_cast<std::size_t>(grid.Columns()) * grid.Rows(), 0);
  std::size_t            points = 0;
  std::size_t            far = 0;
  for (const std::vector<int> & curve : taeniae.curves)
  {
    for (const Eigen::Vector3d & point : PointsAlong(taeniae, curve, 0.5 * grid.PixelSize()))
    {
      const FlatPlace place = locator.Find(point);
      ++points;
      far += place.distance > farthest;
      MarkAround(grid, place.pixel, reach, mask);
    }
  }
  if (points == 0)
  {
    throw InputError("the taeniae must be curves, not points");
  }
  if (2 * far > points)
  {
    throw InputError("most points of the taeniae are more than 15 mm from the surface; give taeniae of this surface");
  }
  return mask;
}
} // namespace shapeton
