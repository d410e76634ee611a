#ifndef shapetonColonTestScene_h
#define shapetonColonTestScene_h

#include "itkImage.h"
#include "itkPoint.h"
#include "itkVector.h"
#include "shapetonTestImages.h"

#include <array>
#include <cmath>
#include <functional>
#include <vector>

namespace shapeton
{
/** A synthetic abdomen defined by functions in physical space; voxels are means over 3 by 3 by 3 points, which models
 * partial volume. */
class ColonTestScene
{
public:
  using Vec = itk::Vector<double, 3>;

  /** A ball, tube or box: depth(x) is positive inside. Gas is above `level` (mm along gravity), fluid below. */
  struct Lumen
  {
    std::function<double(const Vec &)> depth;
    double                             level{ 1e9 };
    double                             fluid{ 700.0 };
    double                             gas{ -1000.0 };
  };

  Vec                gravity{ 0.0 };
  std::vector<Lumen> lumens;
  /** Radius (mm) of the body around the center; outside is air. */
  double bodyRadius;
  /** Tissue (50 HU), for example a fold, that replaces all other matter where the function is positive. */
  std::function<double(const Vec &)> fold;

  explicit ColonTestScene(std::vector<Lumen> itsLumens = {}, double itsBodyRadius = 65.0)
    : lumens(std::move(itsLumens)), bodyRadius(itsBodyRadius)
  {
    gravity[1] = 1.0;
  }

  double
  At(const Vec & x) const
  {
    if (std::hypot(x[0], x[1]) > bodyRadius)
    {
      return -1000.0;
    }
    if (!fold || fold(x) <= 0.0)
    {
      for (const auto & lumen : lumens)
      {
        if (lumen.depth(x) > 0.0)
        {
          return x * gravity < lumen.level ? lumen.gas : lumen.fluid;
        }
      }
    }
    return 50.0;
  }

  bool
  IsLumen(std::size_t n, const Vec & x) const
  {
    return n < lumens.size() && lumens[n].depth(x) > 0.0 && (!fold || fold(x) <= 0.0);
  }

  void
  Sample(itk::Image<float, 3> * image) const
  {
    basetest::ForVoxels(image, [&](const itk::Index<3> & index, const auto &) {
      image->SetPixel(index, static_cast<float>(this->Voxel(image, index)));
    });
  }

private:
  double
  Voxel(const itk::Image<float, 3> * image, const itk::Index<3> & index) const
  {
    double sum = 0.0;
    for (int n = 0; n < 27; ++n)
    {
      itk::ContinuousIndex<double, 3> c;
      c[0] = index[0] + (n % 3 - 1) / 3.0;
      c[1] = index[1] + (n / 3 % 3 - 1) / 3.0;
      c[2] = index[2] + (n / 9 - 1) / 3.0;
      itk::Point<double, 3> x;
      image->TransformContinuousIndexToPhysicalPoint(c, x);
      sum += this->At(x.GetVectorFromOrigin());
    }
    return sum / 27.0;
  }
};

inline ColonTestScene::Vec
At(double x, double y, double z)
{
  const double values[3] = { x, y, z };
  return ColonTestScene::Vec(values);
}

/** Rotation about z and then about x, radians. */
inline itk::Matrix<double, 3, 3>
TurnedAxes(double aboutZ, double aboutX)
{
  return itk::Matrix<double, 3, 3>(basetest::Rotation(2, aboutZ) * basetest::Rotation(0, aboutX));
}

/** A tube with round ends around the line through `middle` along axis `axis`. */
inline std::function<double(const itk::Vector<double, 3> &)>
Tube(const itk::Vector<double, 3> & middle, int axis, double halfLength, double radius)
{
  return [=](const itk::Vector<double, 3> & x) {
    itk::Vector<double, 3> d = x - middle;
    d[axis] = std::max(0.0, std::abs(d[axis]) - halfLength);
    return radius - d.GetNorm();
  };
}

/** Creates an image centered at the origin. */
inline itk::Image<float, 3>::Pointer
CenteredImage(const std::array<int, 3> &        size,
              const std::array<double, 3> &     spacing,
              const itk::Matrix<double, 3, 3> & direction)
{
  itk::Size<3>           voxels;
  itk::Vector<double, 3> half;
  for (int a = 0; a < 3; ++a)
  {
    voxels[a] = size[a];
    half[a] = 0.5 * (size[a] - 1) * spacing[a];
  }
  const auto middle = direction * half;
  return basetest::NewImage<itk::Image<float, 3>>(
    voxels, spacing, { { -middle[0], -middle[1], -middle[2] } }, direction);
}

/** A scene around the origin. */
inline itk::Image<float, 3>::Pointer
SampledImage(const ColonTestScene &            scene,
             const std::array<int, 3> &        size,
             const std::array<double, 3> &     spacing,
             const itk::Matrix<double, 3, 3> & direction = TurnedAxes(0.0, 0.0))
{
  const auto image = CenteredImage(size, spacing, direction);
  scene.Sample(image);
  return image;
}
} // namespace shapeton

#endif
