#include "shapetonFoldShape.h"

#include "shapetonFoldHeight.h"
#include "shapetonPi.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
using Eigen::Vector2d;

/** Minimum curvature of folds, 1/mm. */
constexpr double floorOfFolds = 0.03;
class FoldMeasurer
{
public:
  FoldMeasurer(const FlatColonGrid & grid,
               const FoldPicture &   picture,
               const FoldPixels &    pixels,
               HaustralFoldScheme    scheme)
    : m_Grid(grid)
    , m_Picture(picture)
    , m_Pixels(pixels)
    , m_Places(UnrollFold(pixels, picture.rows))
    , m_Ellipse(m_Places)
    , m_Crest(scheme == HaustralFoldScheme::Published ? CrestOfEllipse(picture, m_Places, m_Ellipse)
                                                      : TraceCrest(picture, m_Places, m_Ellipse, floorOfFolds))
  {}

  HaustralFold
  Measure() const
  {
    HaustralFold fold;
    fold.elongation = m_Ellipse.elongation;
    fold.angle = this->Angle();
    fold.crossesCut = this->CrossesCut();
    this->SumUp(fold);
    fold.length = m_Crest.Length(m_Picture);
    this->Locate(m_Crest.Middle(m_Picture), fold.centerUv, fold.center);
    this->Locate(m_Crest.places.front(), fold.endUv[0], fold.ends[0]);
    this->Locate(m_Crest.places.back(), fold.endUv[1], fold.ends[1]);
    fold.height = HeightOfFold(m_Grid, m_Picture, m_Crest);
    fold.arcLength = m_Grid.HasArcLength() ? this->ArcLength() : std::numeric_limits<double>::quiet_NaN();
    return fold;
  }

  FoldCrest
  TakeCrest()
  {
    return std::move(m_Crest);
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
    const double angle = DegreesPerRadian * std::atan2(up, m_Ellipse.axis.x());
    return angle > 90.0 ? angle - 180.0 : angle <= -90.0 ? angle + 180.0 : angle;
  }

  bool
  CrossesCut() const
  {
    const auto [least, most] = std::minmax_element(
      m_Places.begin(), m_Places.end(), [](const Vector2d & a, const Vector2d & b) { return a.y() < b.y(); });
    const bool   isCut = least->y() < m_Picture.rows && most->y() >= m_Picture.rows;
    const auto   turnOf = [&](const Vector2d & place) { return std::floor((place.y() + 0.5) / m_Picture.rows); };
    const double turn = turnOf(m_Crest.places.front());
    return isCut || std::any_of(m_Crest.places.begin(), m_Crest.places.end(), [&](const Vector2d & place) {
             return turnOf(place) != turn;
           });
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

  void
  Locate(const Vector2d & place, Vector2d & uv, Eigen::Vector3d & point) const
  {
    const double turn = m_Grid.Circumference();
    const double down = (place.y() + 0.5) * m_Picture.pixelSize;
    const double v = m_Grid.IsMirrored() ? turn - down : down;
    uv = { (place.x() + 0.5) * m_Picture.pixelSize, v - turn * std::floor(v / turn) };
    const FlatPixel pixel = m_Grid.PixelOfUv(uv);
    point = m_Grid.PointOfPixel(pixel.column, pixel.row);
    if (!point.allFinite()) // hole in the surface
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
  FoldPlaces            m_Places;
  FoldEllipse           m_Ellipse;
  FoldCrest             m_Crest;
};
} // namespace

MeasuredFold
MeasureFold(const FlatColonGrid & grid, const FoldPicture & picture, FoldPixels pixels, HaustralFoldScheme scheme)
{
  FoldMeasurer measurer(grid, picture, pixels, scheme);
  MeasuredFold measured{ measurer.Measure(), {}, measurer.TakeCrest() };
  measured.pixels = std::move(pixels);
  return measured;
}
} // namespace shapeton
