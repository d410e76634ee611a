#include "SurfaceDistances.h"

#include "shapetonExceptions.h"
#include "shapetonPi.h"

#include "itkImageRegionIteratorWithIndex.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace shapeton;

namespace
{
/** Oblique grid: rotated by 30 degrees about z. */
template <typename TInside>
LumenMask::Pointer
MakeMask(const std::array<unsigned int, 3> & size, const std::array<double, 3> & spacing, const TInside & inside)
{
  const auto mask = LumenMask::New();
  mask->SetRegions(LumenMask::SizeType{ { size[0], size[1], size[2] } });
  mask->SetSpacing(spacing.data());
  LumenMask::DirectionType direction;
  direction.SetIdentity();
  direction(0, 0) = direction(1, 1) = std::cos(shapeton::Pi / 6.0);
  direction(1, 0) = std::sin(shapeton::Pi / 6.0);
  direction(0, 1) = -direction(1, 0);
  mask->SetDirection(direction);
  mask->Allocate();
  for (itk::ImageRegionIteratorWithIndex<LumenMask> it(mask, mask->GetLargestPossibleRegion()); !it.IsAtEnd(); ++it)
  {
    it.Set(inside(it.GetIndex()) ? 1 : 0);
  }
  return mask;
}

LumenMask::Pointer
MakeHalfSpace(unsigned int axis, int planes)
{
  return MakeMask({ { 20, 20, 20 } }, { { 0.5, 0.7, 2.0 } }, [&](const itk::Index<3> & i) { return i[axis] < planes; });
}

/** Ball in the middle of an anisotropic grid. */
LumenMask::Pointer
MakeBall(double radius)
{
  const std::array<double, 3> spacing{ { 0.5, 0.6, 0.8 } };
  return MakeMask({ { 100, 84, 64 } }, spacing, [&](const itk::Index<3> & i) {
    return std::hypot((i[0] - 50.0) * spacing[0], (i[1] - 42.0) * spacing[1], (i[2] - 32.0) * spacing[2]) <= radius;
  });
}
} // namespace

TEST(SurfaceDistances, IdenticalMasksAreAtZero)
{
  const SurfaceDistances distances = MeasureSurfaceDistances(MakeBall(15.0), MakeBall(15.0));
  EXPECT_EQ(distances.average, 0.0);
  EXPECT_EQ(distances.hausdorff95, 0.0);
}

TEST(SurfaceDistances, ShiftedPlanesAreAsFarApartAsTheirShift)
{
  const double spacing[3] = { 0.5, 0.7, 2.0 };
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const SurfaceDistances distances = MeasureSurfaceDistances(MakeHalfSpace(axis, 8), MakeHalfSpace(axis, 11));
    EXPECT_NEAR(distances.average, 3.0 * spacing[axis], 1e-6) << axis;
    EXPECT_NEAR(distances.hausdorff95, 3.0 * spacing[axis], 1e-6) << axis;
  }
}

TEST(SurfaceDistances, ConcentricSpheresAreAsFarApartAsTheirRadii)
{
  const SurfaceDistances distances = MeasureSurfaceDistances(MakeBall(12.0), MakeBall(16.0));
  const double           voxel = 0.8; // mm, the largest spacing
  EXPECT_NEAR(distances.average, 4.0, 0.25 * voxel);
  EXPECT_NEAR(distances.hausdorff95, 4.0, voxel);
}

/** A spike of one mask only: far from the other mask, but the other mask is near everywhere. */
TEST(SurfaceDistances, BothDirectionsCount)
{
  const auto isInPlate = [](const itk::Index<3> & i) { return i[2] < 4; };
  const auto isInSpike = [](const itk::Index<3> & i) { return i[0] < 5 && i[1] < 5; };
  const auto make = [&](const auto & inside) { return MakeMask({ { 20, 20, 20 } }, { { 1.0, 1.0, 1.0 } }, inside); };
  const auto plate = make(isInPlate);
  const auto both = make([&](const itk::Index<3> & i) { return isInPlate(i) || isInSpike(i); });
  const SurfaceDistances one = MeasureSurfaceDistances(plate, both);
  const SurfaceDistances other = MeasureSurfaceDistances(both, plate);
  EXPECT_EQ(one.hausdorff95, other.hausdorff95);
  EXPECT_EQ(one.average, other.average);
  EXPECT_GT(one.hausdorff95, 10.0);
}

TEST(SurfaceDistances, AnEmptyMaskIsInfinitelyFarAway)
{
  EXPECT_TRUE(std::isinf(MeasureSurfaceDistances(MakeHalfSpace(0, 8), MakeHalfSpace(0, 0)).average));
  EXPECT_EQ(MeasureSurfaceDistances(MakeHalfSpace(0, 0), MakeHalfSpace(0, 0)).average, 0.0);
}

TEST(SurfaceDistances, DifferentGridsAreRefused)
{
  EXPECT_THROW(MeasureSurfaceDistances(MakeHalfSpace(0, 8), MakeBall(12.0)), InputError);
}
