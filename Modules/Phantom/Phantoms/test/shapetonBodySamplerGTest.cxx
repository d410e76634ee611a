#include "shapetonBodySampler.h"

#include "shapetonTestImages.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using shapeton::PhantomBody;

// A slab between two planes perpendicular to a direction.
class Slab : public PhantomBody
{
public:
  Slab(const itk::Vector<double, 3> & normal, double from, double to, double intensity)
    : m_Normal(normal), m_From(from), m_To(to), m_Intensity(intensity)
  {}
  shapeton::BodyProbe
  Probe(const PointType & p) const override
  {
    return { this->Distance(p), std::abs(this->Distance(p)) };
  }
  double
  Intensity(const PointType &) const override
  {
    return m_Intensity;
  }
  void
  Paint(const PointType & p, double width, double & value) const override
  {
    value += shapeton::ShareInside(this->Distance(p), width) * (m_Intensity - value);
  }

private:
  double
  Distance(const PointType & p) const
  {
    const double height = m_Normal * p.GetVectorFromOrigin();
    return std::max(m_From - height, height - m_To);
  }
  itk::Vector<double, 3> m_Normal;
  double                 m_From;
  double                 m_To;
  double                 m_Intensity;
};

using ImageType = itk::Image<float, 3>;

ImageType::Pointer
Grid(unsigned int size, double x, double y, double z)
{
  const double half = 0.5 * (size - 1.0);
  return basetest::NewImage<ImageType>({ { size, size, size } }, { x, y, z }, { -half * x, -half * y, -half * z });
}

double
NormalDistribution(double x)
{
  return 0.5 * std::erfc(-x / std::sqrt(2.0));
}

// Maximum deviation from the profile of a slab, in units of the step, over all voxels.
double
LargestDeviation(const ImageType *              grid,
                 const itk::Vector<double, 3> & normal,
                 double                         from,
                 double                         to,
                 double                         sigma,
                 double                         blurAlongZ = 0.75)
{
  const shapeton::BodySampler sampler(
    { std::make_shared<Slab>(normal, from, to, 1000.0) }, grid, { { 0.75, 0.75, blurAlongZ } }, 0.0);
  const auto  values = sampler.Sample(grid->GetLargestPossibleRegion());
  double      largest = 0.0;
  std::size_t i = 0;
  basetest::ForVoxels(grid, [&](const auto &, const PhantomBody::PointType & p) {
    const double height = normal * p.GetVectorFromOrigin();
    const double share = NormalDistribution((to - height) / sigma) - NormalDistribution((from - height) / sigma);
    largest = std::max(largest, std::abs(values[i++] / 1000.0 - share));
  });
  return largest;
}

itk::Vector<double, 3>
Direction(double x, double y, double z)
{
  const double           values[3] = { x, y, z };
  itk::Vector<double, 3> direction(values);
  direction.Normalize();
  return direction;
}
} // namespace

TEST(BodySampler, ProfileOfAPlaneFaceIsTheNormalDistribution)
{
  for (const double spacing : { 0.5, 0.7, 0.8, 1.0, 1.4 })
  {
    const auto   grid = Grid(16, spacing, spacing, spacing);
    const double bound = spacing == 0.8 ? 0.012 : 0.008; // the widest cell
    EXPECT_LT(LargestDeviation(grid, Direction(0, 0, 1), 0.123, 1e3, 0.75), bound) << spacing;
    EXPECT_LT(LargestDeviation(grid, Direction(0, 1, 0), 0.123, 1e3, 0.75), bound) << spacing;
    EXPECT_LT(LargestDeviation(grid, Direction(1, 2, 3), 0.123, 1e3, 0.75), bound) << spacing;
  }
}

TEST(BodySampler, EachAxisHasItsBlur)
{
  const auto grid = Grid(16, 0.7, 0.7, 0.7);
  EXPECT_LT(LargestDeviation(grid, Direction(0, 0, 1), 0.123, 1e3, 1.1, 1.1), 0.008);
  EXPECT_LT(LargestDeviation(grid, Direction(0, 1, 0), 0.123, 1e3, 0.75, 1.1), 0.008);
  EXPECT_LT(LargestDeviation(grid, Direction(0, 1, 1), 0.123, 1e3, std::sqrt(0.5 * (0.75 * 0.75 + 1.1 * 1.1)), 1.1),
            0.02);
}

TEST(BodySampler, AnisotropicGridsGetTheSameProfile)
{
  const auto grid = Grid(16, 0.7, 0.7, 1.25);
  EXPECT_LT(LargestDeviation(grid, Direction(0, 0, 1), 0.3, 1e3, 0.75), 0.02);
  EXPECT_LT(LargestDeviation(grid, Direction(1, 0, 1), 0.3, 1e3, 0.75), 0.02);
}

TEST(BodySampler, AThinSeptumHasTheHeightOfItsConvolution)
{
  for (const double thickness : { 1.0, 1.5, 2.0, 3.0 })
  {
    const auto grid = Grid(16, 1.4, 1.4, 1.4);
    EXPECT_LT(LargestDeviation(grid, Direction(0, 0, 1), 0.2, 0.2 + thickness, 0.75), 0.015) << thickness;
    EXPECT_LT(LargestDeviation(grid, Direction(2, -1, 1), 0.2, 0.2 + thickness, 0.75), 0.015) << thickness;
  }
}

TEST(BodySampler, LaterBodiesArePaintedOverEarlierOnes)
{
  const auto                    up = Direction(0, 0, 1);
  const auto                    grid = Grid(8, 1.0, 1.0, 1.0);
  const shapeton::PhantomBodies bodies{ std::make_shared<Slab>(up, -1e3, 1e3, 100.0),
                                        std::make_shared<Slab>(up, -1e3, 1e3, -994.0),
                                        std::make_shared<Slab>(up, 1e3, 2e3, 500.0) };
  const shapeton::BodySampler   sampler(bodies, grid, { { 0.75, 0.75, 0.75 } }, 7.0);
  for (const float value : sampler.Sample(grid->GetLargestPossibleRegion()))
  {
    EXPECT_NEAR(value, -994.0F, 1e-3F);
  }
}

TEST(BodySampler, PiecesOfARegionHaveTheValuesOfTheWhole)
{
  const auto                  grid = Grid(12, 0.9, 1.1, 1.3);
  const shapeton::BodySampler sampler(
    { std::make_shared<Slab>(Direction(1, 2, 3), -2.0, 1.5, 900.0) }, grid, { { 0.75, 0.75, 0.75 } }, -1000.0);
  const auto          whole = sampler.Sample(grid->GetLargestPossibleRegion());
  itk::ImageRegion<3> piece;
  piece.SetIndex({ { 3, 1, 4 } });
  piece.SetSize({ { 5, 7, 3 } });
  const auto  part = sampler.Sample(piece);
  std::size_t i = 0;
  for (std::size_t z = 4; z < 7; ++z)
  {
    for (std::size_t y = 1; y < 8; ++y)
    {
      for (std::size_t x = 3; x < 8; ++x)
      {
        EXPECT_NEAR(part[i++], whole[(z * 12 + y) * 12 + x], 1e-3);
      }
    }
  }
}
