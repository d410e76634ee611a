#include "itkFoldShape.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
using Eigen::Vector2d;

constexpr double degrees = 180.0 / 3.14159265358979323846;
/** Share of the pixels at either end whose mean is the end point. */
constexpr double endShare = 0.06;

/** The row that the fold begins at when it is followed around the tube: after the widest gap, or, for a ring, where it
 * has fewest pixels. */
int
FirstRow(const FoldPixels & pixels, int rows)
{
  std::vector<int> counts(rows, 0);
  for (const FlatPixel & pixel : pixels)
  {
    ++counts[pixel.row];
  }
  int first = 0;
  int widest = 0;
  int gap = 0;
  for (int i = 0; i < 2 * rows; ++i)
  {
    const int row = i % rows;
    if (counts[row] == 0)
    {
      ++gap;
    }
    else
    {
      first = gap > widest ? row : first;
      widest = std::max(gap, widest);
      gap = 0;
    }
  }
  return widest > 0 ? first : static_cast<int>(std::min_element(counts.begin(), counts.end()) - counts.begin());
}

/** Pixels as places (column, row), the rows going on beyond the last one. */
std::vector<Vector2d>
Unroll(const FoldPixels & pixels, int rows)
{
  const int             first = FirstRow(pixels, rows);
  std::vector<Vector2d> places;
  places.reserve(pixels.size());
  for (const FlatPixel & pixel : pixels)
  {
    places.emplace_back(pixel.column, pixel.row < first ? pixel.row + rows : pixel.row);
  }
  return places;
}

/** The ellipse with the same moments of second order. */
struct Ellipse
{
  explicit Ellipse(const std::vector<Vector2d> & places)
  {
    centre.setZero();
    for (const Vector2d & place : places)
    {
      centre += place / static_cast<double>(places.size());
    }
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity() / 12.0; // of a pixel
    for (const Vector2d & place : places)
    {
      covariance += (place - centre) * (place - centre).transpose() / static_cast<double>(places.size());
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(covariance);
    axis = solver.eigenvectors().col(1);
    axis = axis.y() < 0.0 || (axis.y() == 0.0 && axis.x() < 0.0) ? Vector2d(-axis) : axis;
    elongation = std::sqrt(solver.eigenvalues()[1] / solver.eigenvalues()[0]);
  }

  Vector2d centre;
  Vector2d axis; ///< long; rows grow along it
  double   elongation;
};

class FoldMeasurer
{
public:
  FoldMeasurer(const FlatColonGrid & grid, const FoldPicture & picture, const FoldPixels & pixels)
    : m_Grid(grid), m_Picture(picture), m_Pixels(pixels), m_Places(Unroll(pixels, picture.rows)), m_Ellipse(m_Places)
  {
    for (const Vector2d & place : m_Places)
    {
      m_Along.push_back((place - m_Ellipse.centre).dot(m_Ellipse.axis));
    }
  }

  HaustralFold
  Measure() const
  {
    HaustralFold fold;
    fold.elongation = m_Ellipse.elongation;
    fold.angle = this->Angle();
    fold.crossesCut = this->CrossesCut();
    this->SumUp(fold);
    fold.length = this->Length();
    this->Locate(this->CrestNear(m_Ellipse.centre), fold.centreUv, fold.centre);
    const std::array<Vector2d, 2> ends = this->Ends();
    for (int end = 0; end < 2; ++end)
    {
      this->Locate(ends[end], fold.endUv[end], fold.ends[end]);
    }
    fold.arcLength = m_Grid.HasArcLength() ? this->ArcLength() : std::numeric_limits<double>::quiet_NaN();
    return fold;
  }

private:
  std::size_t
  IndexOf(std::size_t i) const
  {
    return m_Picture.Index(m_Pixels[i].column, m_Pixels[i].row);
  }

  double
  Angle() const
  {
    const double up = m_Grid.IsMirrored() ? -m_Ellipse.axis.y() : m_Ellipse.axis.y();
    const double angle = degrees * std::atan2(up, m_Ellipse.axis.x());
    return angle > 90.0 ? angle - 180.0 : angle <= -90.0 ? angle + 180.0 : angle;
  }

  bool
  CrossesCut() const
  {
    const auto [least, most] = std::minmax_element(
      m_Places.begin(), m_Places.end(), [](const Vector2d & a, const Vector2d & b) { return a.y() < b.y(); });
    return least->y() < m_Picture.rows && most->y() >= m_Picture.rows;
  }

  void
  SumUp(HaustralFold & fold) const
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < m_Pixels.size(); ++i)
    {
      const double area = m_Picture.AreaOf(this->IndexOf(i));
      fold.area += area;
      sum += area * m_Picture.curvature[this->IndexOf(i)];
    }
    fold.meanCurvature = sum / fold.area;
  }

  /** Along the long axis: for each step of it the mean scale, and how far the middle has moved sideways. */
  double
  Length() const
  {
    const auto [least, most] = std::minmax_element(m_Along.begin(), m_Along.end());
    const int             bins = static_cast<int>(*most - *least) + 1;
    std::vector<double>   scales(bins, 0.0);
    std::vector<int>      counts(bins, 0);
    for (std::size_t i = 0; i < m_Along.size(); ++i)
    {
      const int bin = static_cast<int>(m_Along[i] - *least);
      scales[bin] += m_Picture.scale[this->IndexOf(i)];
      ++counts[bin];
    }
    double sum = 0.0;
    double last = 1.0;
    for (int bin = 0; bin < bins; ++bin)
    {
      last = counts[bin] > 0 ? scales[bin] / counts[bin] : last;
      sum += last;
    }
    return sum * m_Picture.pixelSize;
  }

  /** Of the extreme pixels, weighted by their curvature, so that they lie on the crest. */
  std::array<Vector2d, 2>
  Ends() const
  {
    std::vector<double> sorted = m_Along;
    std::sort(sorted.begin(), sorted.end());
    const auto   skip = static_cast<std::size_t>(endShare * static_cast<double>(sorted.size() - 1));
    const double low = sorted[skip];
    const double high = sorted[sorted.size() - 1 - skip];
    return { this->MeanWhere([&](std::size_t i) { return m_Along[i] <= low; }),
             this->MeanWhere([&](std::size_t i) { return m_Along[i] >= high; }) };
  }

  Vector2d
  CrestNear(const Vector2d & place) const
  {
    const double along = (place - m_Ellipse.centre).dot(m_Ellipse.axis);
    double nearest = std::numeric_limits<double>::infinity();
    for (const double one : m_Along)
    {
      nearest = std::min(nearest, std::abs(one - along));
    }
    const double reach = std::max(1.0, nearest);
    return this->MeanWhere([&](std::size_t i) { return std::abs(m_Along[i] - along) <= reach; });
  }

  template <typename TWhere>
  Vector2d
  MeanWhere(const TWhere & where) const
  {
    Vector2d sum = Vector2d::Zero();
    double   weights = 0.0;
    for (std::size_t i = 0; i < m_Places.size(); ++i)
    {
      if (where(i))
      {
        const double weight = std::abs(m_Picture.curvature[this->IndexOf(i)]) + 1e-9;
        sum += weight * m_Places[i];
        weights += weight;
      }
    }
    return sum / weights;
  }

  void
  Locate(const Vector2d & place, Vector2d & uv, Eigen::Vector3d & point) const
  {
    const double turn = m_Grid.Circumference();
    const double down = (place.y() + 0.5) * m_Picture.pixelSize;
    const double v = m_Grid.IsMirrored() ? turn - down : down;
    uv = { (place.x() + 0.5) * m_Picture.pixelSize, v - turn * std::floor(v / turn) };
    const FlatPixel pixel = m_Grid.PixelOfUv(uv);
    point = m_Grid.PointOfPixel(pixel.column, pixel.row);
    if (!point.allFinite()) // a hole of the surface within the fold
    {
      point = this->NearestPoint(place);
    }
  }

  Eigen::Vector3d
  NearestPoint(const Vector2d & place) const
  {
    const auto nearest =
      std::min_element(m_Places.begin(), m_Places.end(), [&](const Vector2d & a, const Vector2d & b) {
        return (a - place).squaredNorm() < (b - place).squaredNorm();
      });
    const FlatPixel & pixel = m_Pixels[nearest - m_Places.begin()];
    return m_Grid.PointOfPixel(pixel.column, pixel.row);
  }

  double
  ArcLength() const
  {
    double sum = 0.0;
    for (const FlatPixel & pixel : m_Pixels)
    {
      sum += m_Grid.SampleOfPixel(pixel.column, pixel.row).arcLength;
    }
    return sum / static_cast<double>(m_Pixels.size());
  }

  const FlatColonGrid & m_Grid;
  const FoldPicture &   m_Picture;
  const FoldPixels &    m_Pixels;
  std::vector<Vector2d> m_Places;
  Ellipse               m_Ellipse;
  std::vector<double>   m_Along; ///< pixels, along the long axis
};
} // namespace

HaustralFold
MeasureFold(const FlatColonGrid & grid, const FoldPicture & picture, const FoldPixels & pixels)
{
  return FoldMeasurer(grid, picture, pixels).Measure();
}
} // namespace itk
