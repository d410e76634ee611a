#include "shapetonLumenShapes.h"
#include "shapetonExceptions.h"
#include "shapetonTestImages.h"

#include <gtest/gtest.h>

using namespace lumenshapes;

namespace
{
const shapeton::CurveSet NoCenterline;

/** Expects genus 0 for any input. */
shapeton::LumenTopology
Repaired(const shapeton::OccupancyImage * occupancy, const shapeton::CurveSet & centerline = NoCenterline)
{
  shapeton::LumenTopology topology = shapeton::RepairLumenTopology(occupancy, centerline);
  const auto              numbers = shapeton::TopologyOfMask(topology.mask);
  EXPECT_EQ(1, numbers.components);
  EXPECT_EQ(0, numbers.cavities);
  EXPECT_EQ(0, numbers.handles);
  EXPECT_EQ(0, topology.report.handlesAfter);
  return topology;
}

/** Two legs 1 mm apart, with a hole of radius 1.5 mm in the septum. */
Depth
LeakingUTurn()
{
  const Depth leak = Tube({ { 5, 0, 20 }, { 16, 0, 20 } }, 1.5);
  return Union(Tube(UTurn(40, 21), 10), leak);
}

/** Whether all voxels along the points are in the mask. */
bool
Contains(const shapeton::LumenMaskImage * mask, const Points & points)
{
  for (const auto & point : points)
  {
    const itk::Point<double, 3> place(point.data());
    if (mask->GetPixel(mask->TransformPhysicalPointToIndex(place)) == 0)
    {
      return false;
    }
  }
  return true;
}

/** Distance of the removed voxels from the middle of the septum at x = 10.5. */
double
GreatestDistanceOfCut(const shapeton::OccupancyImage * occupancy, const shapeton::LumenMaskImage * mask)
{
  double greatest = 0.0;
  basetest::ForVoxels(mask, [&](const auto & index, const auto & point) {
    const bool isCut = mask->GetPixel(index) == 0 && occupancy->GetPixel(index) >= 0.5F;
    greatest = isCut ? std::max(greatest, std::abs(point[0] - 10.5)) : greatest;
  });
  return greatest;
}
} // namespace

TEST(LumenTopology, LeavesASoundLumenAlone)
{
  const auto occupancy = Occupancy(Sphere({ 3, 4, 5 }, 12), BoxOf({ { 3, 4, 5 } }, 12), ObliqueGrid(true));
  const auto topology = Repaired(occupancy);
  EXPECT_EQ(0, topology.report.handlesBefore);
  EXPECT_EQ(0.0, topology.report.cutVolume);
  EXPECT_EQ(0.0, topology.report.cavityVolume);
  EXPECT_NEAR(4.0 / 3.0 * Pi * 12 * 12 * 12 / 1000.0, topology.report.lumenVolume, 0.05);
}

TEST(LumenTopology, CutsALeakBetweenLoopsAndNotTheTube)
{
  for (const bool isLeftHanded : { false, true })
  {
    const auto axis = UTurn(40, 21);
    const auto occupancy = Occupancy(LeakingUTurn(), BoxOf(axis, 10), ObliqueGrid(isLeftHanded), 2.0);
    const auto topology = Repaired(occupancy);
    EXPECT_EQ(1, topology.report.handlesBefore);
    EXPECT_LT(0.0, topology.report.cutVolume);
    EXPECT_GT(0.02, topology.report.cutVolume); // a membrane over 7 mm^2, about 1 mm thick
    EXPECT_TRUE(Contains(topology.mask, axis));
    EXPECT_GT(1.5, GreatestDistanceOfCut(occupancy, topology.mask));
  }
}

TEST(LumenTopology, CenterlineKeepsANarrowStretchOpen)
{
  // The tube is narrower at its bend than the leak is; only the centerline distinguishes them.
  Points legs = UTurn(40, 21);
  Depth  lumen = Union(Tube({ { 0, 0, 0 }, { 0, 0, 38 } }, 8), Tube({ { 21, 0, 0 }, { 21, 0, 38 } }, 8));
  lumen = Union(Union(lumen, Tube(legs, 2)), Tube({ { 5, 0, 20 }, { 16, 0, 20 } }, 3));
  const auto occupancy = Occupancy(lumen, BoxOf(legs, 10), {}, 2.0);
  EXPECT_FALSE(Contains(Repaired(occupancy).mask, legs));
  const auto topology = Repaired(occupancy, Centerline(legs));
  EXPECT_TRUE(Contains(topology.mask, legs));
  EXPECT_FALSE(Contains(topology.mask, Line({ 5, 0, 20 }, { 16, 0, 20 }, 0.3)));
  EXPECT_GT(0.1, topology.report.cutVolume);
}

TEST(LumenTopology, OpensATorusAndADoubleTorus)
{
  const Depth two = Union(Torus({ -12, 0, 0 }, 12, 5), Torus({ 12, 0, 0 }, 12, 5));
  const auto  one = Repaired(Occupancy(Torus({ 0, 0, 0 }, 12, 5), BoxOf({ { 0, 0, 0 } }, 17)));
  EXPECT_EQ(1, one.report.handlesBefore);
  const auto both = Repaired(Occupancy(two, BoxOf({ { -12, 0, 0 }, { 12, 0, 0 } }, 17), ObliqueGrid(false)));
  EXPECT_EQ(2, both.report.handlesBefore);
  // Each membrane closes a cross section of the ring.
  EXPECT_GT(1.8 * Pi * 25 / 1000.0, one.report.cutVolume);
  EXPECT_GT(2.0 * 2.5 * Pi * 25 / 1000.0, both.report.cutVolume);
}

TEST(LumenTopology, FillsACavityAndDropsAPiece)
{
  const Depth lumen = Union(Without(Sphere({ 0, 0, 0 }, 12), Sphere({ 2, 1, 0 }, 4)), Sphere({ 22, 0, 0 }, 5));
  const auto  topology = Repaired(Occupancy(lumen, BoxOf({ { 0, 0, 0 }, { 20, 0, 0 } }, 12), {}, 2.0));
  EXPECT_EQ(1, topology.report.cavities);
  EXPECT_NEAR(4.0 / 3.0 * Pi * 64 / 1000.0, topology.report.cavityVolume, 0.02);
  EXPECT_EQ(1, topology.report.droppedPieces);
  EXPECT_NEAR(4.0 / 3.0 * Pi * 125 / 1000.0, topology.report.droppedVolume, 0.04);
  EXPECT_EQ(0.0, topology.report.cutVolume);
}

TEST(LumenTopology, ClosesAHoleInAFold)
{
  // A half-moon fold across a tube, with a hole of radius 1.2 mm.
  const Depth fold = [](const Eigen::Vector3d & p) { return std::min(1.5 - std::abs(p[2] - 30), 2.0 - p[0]); };
  const Depth hole = Tube({ { -4, 0, 25 }, { -4, 0, 35 } }, 1.2);
  const Depth tube = Tube({ { 0, 0, 0 }, { 0, 0, 60 } }, 10);
  const Depth lumen = Union(Without(tube, fold), [=](const Eigen::Vector3d & p) { return std::min(tube(p), hole(p)); });
  const auto  topology = Repaired(Occupancy(lumen, BoxOf({ { 0, 0, 0 }, { 0, 0, 60 } }, 10), {}, 1.0));
  EXPECT_EQ(1, topology.report.handlesBefore);
  EXPECT_LT(0.0, topology.report.cutVolume);
  EXPECT_GT(0.01, topology.report.cutVolume);
}

TEST(LumenTopology, RefusesAnEmptyLumen)
{
  const auto occupancy = Occupancy([](const Eigen::Vector3d &) { return -9.0; }, BoxOf({ { 0, 0, 0 } }, 4));
  EXPECT_THROW(shapeton::RepairLumenTopology(occupancy, NoCenterline), shapeton::InputError);
}

TEST(LumenTopology, OccupancyOfAMaskKeepsItsVolume)
{
  auto mask = basetest::NewImage<shapeton::LumenMaskImage>({ { 40, 40, 40 } });
  for (int i = 0; i < 40 * 40 * 40; ++i)
  {
    const Eigen::Vector3d p(i % 40, i / 40 % 40, i / 1600);
    mask->GetBufferPointer()[i] = (p - Eigen::Vector3d(19, 20, 21)).norm() < 14 ? 7 : 0;
  }
  const auto sharp = shapeton::OccupancyFromMask(mask);
  const auto smooth = shapeton::OccupancyFromMask(mask, 1.0);
  long       voxels = 0;
  long       kept = 0;
  for (int i = 0; i < 40 * 40 * 40; ++i)
  {
    EXPECT_EQ(mask->GetBufferPointer()[i] != 0 ? 1.0F : 0.0F, sharp->GetBufferPointer()[i]);
    voxels += mask->GetBufferPointer()[i] != 0 ? 1 : 0;
    kept += smooth->GetBufferPointer()[i] >= 0.5F ? 1 : 0;
  }
  EXPECT_NEAR(voxels, kept, 0.005 * voxels); // ties at the level by symmetry
  EXPECT_THROW(shapeton::OccupancyFromMask(mask, -1.0), shapeton::ParameterError);
}
