#ifndef shapetonColonTestScene_h
#define shapetonColonTestScene_h

#include "itkImage.h"
#include "itkPoint.h"
#include "itkVector.h"

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
  /** Radius (mm) of the body from the center; air outside. */
  double bodyRadius{ 65.0 };
  /** Tissue (50 HU) that replaces all other matter where positive, for example a fold. */
  std::function<double(const Vec &)> fold;

  ColonTestScene() { gravity[1] = 1.0; }

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
    image->Allocate();
    const auto size = image->GetBufferedRegion().GetSize();
    for (itk::SizeValueType k = 0; k < size[2]; ++k)
    {
      for (itk::SizeValueType j = 0; j < size[1]; ++j)
      {
        for (itk::SizeValueType i = 0; i < size[0]; ++i)
        {
          const itk::Index<3> index{ { static_cast<itk::IndexValueType>(i),
                                       static_cast<itk::IndexValueType>(j),
                                       static_cast<itk::IndexValueType>(k) } };
          image->SetPixel(index, static_cast<float>(this->Voxel(image, index)));
        }
      }
    }
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
  using Axes = vnl_matrix_fixed<double, 3, 3>;
  const double c = std::cos(aboutZ), s = std::sin(aboutZ), d = std::cos(aboutX), t = std::sin(aboutX);
  const double z[9] = { c, -s, 0, s, c, 0, 0, 0, 1 };
  const double x[9] = { 1, 0, 0, 0, d, -t, 0, t, d };
  return itk::Matrix<double, 3, 3>(Axes(z) * Axes(x));
}

/** A tube around the line through `middle` along axis `axis` with round ends. */
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
  auto                             image = itk::Image<float, 3>::New();
  itk::Image<float, 3>::RegionType region;
  itk::Vector<double, 3>           half;
  for (int a = 0; a < 3; ++a)
  {
    region.SetSize(a, size[a]);
    half[a] = -0.5 * (size[a] - 1) * spacing[a];
  }
  image->SetRegions(region);
  image->SetSpacing(spacing.data());
  image->SetDirection(direction);
  itk::Point<double, 3> origin;
  origin.Fill(0.0);
  image->SetOrigin(origin + direction * half);
  return image;
}
} // namespace shapeton

#endif
