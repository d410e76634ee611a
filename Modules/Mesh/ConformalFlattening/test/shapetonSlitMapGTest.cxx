#include "shapetonSlitMap.h"

#include "shapetonPlanarDomains.h"
#include "shapetonExceptions.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

namespace
{
using namespace shapeton;
using namespace testsurfaces;

constexpr double twoPi = 2.0 * Pi;

SlitMapSolver
SolverOf(const SurfaceMesh & mesh, int outer = 0)
{
  const SurfaceConnectivity connectivity(mesh);
  return { mesh, connectivity, EdgeLengths(connectivity, mesh.V), BoundaryLoopsByLength(connectivity, mesh.V), outer };
}

/** A polar grid of 24 rings with slits on rings 8 and 16. */
struct SlitAnnulus
{
  PolarGrid   grid;
  SurfaceMesh mesh = WithSlits(grid.Mesh(), { Arc(grid, 8, 5, 35), Arc(grid, 16, 50, 80) });
};

TEST(SlitMap, OfAConcentricAnnulusIsItself)
{
  const PolarGrid     grid;
  const SurfaceMesh   mesh = grid.Mesh();
  const SlitMapSolver solver = SolverOf(mesh);
  const SlitMap       map = solver.Map(1);
  const double        modulus = -twoPi / std::log(grid.inner);
  EXPECT_NEAR(map.modulusU, modulus, 2e-3 * modulus);
  EXPECT_NEAR(map.modulusV, modulus, 2e-3 * modulus);
  for (int ring = 0; ring <= grid.rings; ++ring)
  {
    // All rings are similar, so equal steps in log radius are exact on the grid, too.
    const double share = 1.0 - static_cast<double>(ring) / grid.rings;
    EXPECT_NEAR(map.logRadius[grid.At(ring, 7)], -share * twoPi / map.modulusU, 1e-11);
  }
  for (int place = 0; place < grid.around; ++place)
  {
    const double turn = map.angle[grid.At(12, place)] - map.angle[grid.At(12, 0)] - twoPi * place / grid.around;
    EXPECT_NEAR(std::remainder(turn, twoPi), 0.0, 1e-10);
  }
}

TEST(SlitMap, OfAnEccentricAnnulusHasTheModulusOfMoebius)
{
  PolarGrid grid;
  for (const double a : { 0.2, -0.5 })
  {
    const SlitMap map = SolverOf(Moebius(grid.Mesh(), a)).Map(1);
    const double  modulus = -twoPi / std::log(grid.inner);
    EXPECT_NEAR(map.modulusU, modulus, 4e-3 * modulus) << a;
    EXPECT_NEAR(map.modulusV, modulus, 4e-3 * modulus) << a;
    for (int ring = 0; ring <= grid.rings; ring += 4)
    {
      EXPECT_NEAR(map.logRadius[grid.At(ring, 40)], grid.LogRadius(ring), 5e-3);
    }
  }
}

TEST(SlitMap, SlitsStayWhereTheyAre)
{
  const SlitAnnulus   slit;
  const SlitMapSolver solver = SolverOf(slit.mesh);
  ASSERT_EQ(solver.Loops().size(), 4u);
  ASSERT_EQ(solver.InnerLoops(), (std::vector<int>{ 1, 2, 3 }));
  // Loops by length: outer circle, slit on ring 16, inner circle, slit on ring 8.
  const SlitMap map = solver.Map(2);
  const double  depth = twoPi / map.modulusU;
  EXPECT_NEAR(map.logRadiusOfLoops[0], 0.0, 1e-14);
  EXPECT_NEAR(map.logRadiusOfLoops[1], -depth / 3.0, 1e-10);
  EXPECT_NEAR(map.logRadiusOfLoops[2], -depth, 1e-14);
  EXPECT_NEAR(map.logRadiusOfLoops[3], -depth * 2.0 / 3.0, 1e-10);
  for (int place = 1; place < 30; ++place)
  {
    const double turn = map.angle[slit.grid.At(12, place)] - map.angle[slit.grid.At(12, 0)];
    EXPECT_NEAR(std::remainder(turn - twoPi * place / slit.grid.around, twoPi), 0.0, 1e-9);
  }
}

TEST(SlitMap, SlitsAreArcsAndPeriodsAreExact)
{
  const SlitAnnulus   slit;
  const SurfaceMesh   mesh = Roughened(Moebius(slit.mesh, 0.3), 1e-3, 7);
  const SlitMapSolver solver = SolverOf(mesh, 1);
  for (const int inner : solver.InnerLoops())
  {
    const SlitMap map = solver.Map(inner);
    for (int i = 0; i < 4; ++i)
    {
      const double expected = i == 1 ? 1.0 : i == inner ? -1.0 : 0.0;
      EXPECT_NEAR(map.turnsOfLoops[i], expected, 1e-10);
      for (const int vertex : solver.Loops()[i].vertices)
      {
        EXPECT_NEAR(map.logRadius[vertex], map.logRadiusOfLoops[i], 1e-13);
      }
      if (i != 1 && i != inner)
      {
        EXPECT_LT(map.logRadiusOfLoops[i], 0.0);
        EXPECT_GT(map.logRadiusOfLoops[i], map.logRadiusOfLoops[inner]);
      }
    }
    EXPECT_GT(map.modulusU, map.modulusV);
    EXPECT_LT(map.modulusU - map.modulusV, 0.1 * map.modulusU); // the grid is coarse at the slit tips
  }
}

TEST(SlitMap, SlitsAfterMoebiusAreTheKnownOnes)
{
  PolarGrid grid;
  grid.around = 160;
  grid.rings = 42;
  const SurfaceMesh   mesh = Moebius(WithSlits(grid.Mesh(), { Arc(grid, 14, 10, 60), Arc(grid, 28, 90, 130) }), 0.3);
  const SlitMapSolver solver = SolverOf(mesh);
  const SlitMap       map = solver.Map(LoopOfVertices(solver.Loops(), mesh.NumberOfVertices())[grid.At(0, 0)]);
  std::vector<double> levels(map.logRadiusOfLoops.data(), map.logRadiusOfLoops.data() + 4);
  std::sort(levels.begin(), levels.end());
  EXPECT_NEAR(levels[0], grid.LogRadius(0), 5e-3);
  EXPECT_NEAR(levels[1], grid.LogRadius(14), 5e-3);
  EXPECT_NEAR(levels[2], grid.LogRadius(28), 5e-3);
  EXPECT_EQ(levels[3], 0.0);
  // Ends of the first slit, 50 of 160 steps apart.
  const double turn = map.angle[grid.At(14, 60)] - map.angle[grid.At(14, 10)];
  EXPECT_NEAR(std::remainder(turn - twoPi * 50 / 160, twoPi), 0.0, 0.01);
}

TEST(SlitMap, FluxesArePositiveDefiniteAndSumToThoseOfTheOuterLoop)
{
  const SlitAnnulus     slit;
  const SlitMapSolver   solver = SolverOf(Moebius(slit.mesh, 0.2));
  const Eigen::MatrixXd P = solver.Fluxes();
  EXPECT_EQ(P, P.transpose());
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(P).eigenvalues()[0], 0.0);
  EXPECT_LT(P(0, 1), 0.0); // flux from the loop with value 1 to all loops with value 0
  EXPECT_GT(P.row(0).sum(), 0.0);
  const Eigen::MatrixXd & f = solver.HarmonicFunctions();
  EXPECT_GE(f.minCoeff(), -1e-12);
  EXPECT_LE(f.rowwise().sum().maxCoeff(), 1.0 + 1e-12);
}

TEST(SlitMap, DoesNotDependOnPlaceSizeOrNumbering)
{
  const SlitAnnulus     slit;
  SurfaceMesh           mesh = Moebius(slit.mesh, 0.3);
  const SlitMap         map = SolverOf(mesh).Map(1);
  const int             n = mesh.NumberOfVertices();
  SurfaceMesh           other = mesh; // vertices reversed, translated, rotated and scaled by 7
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  for (int i = 0; i < n; ++i)
  {
    other.V.row(n - 1 - i) = (7.0 * (turn * mesh.V.row(i).transpose()) + Eigen::Vector3d(10, 20, 30)).transpose();
  }
  other.F = (n - 1) - mesh.F.array();
  const SlitMap moved = SolverOf(other).Map(1);
  EXPECT_NEAR(moved.modulusU, map.modulusU, 1e-10);
  EXPECT_NEAR(moved.modulusV, map.modulusV, 1e-10);
  for (int i = 0; i < n; ++i)
  {
    EXPECT_NEAR(moved.logRadius[n - 1 - i], map.logRadius[i], 1e-10);
    const double angle = moved.angle[n - 1 - i] - moved.angle[n - 1] - map.angle[i] + map.angle[0];
    EXPECT_NEAR(std::remainder(angle, twoPi), 0.0, 1e-9);
  }
}

TEST(SlitMap, RefusesWhatIsNoChoice)
{
  EXPECT_THROW(SolverOf(Square(4, 10.0)), InputError);
  const SurfaceMesh mesh = PolarGrid().Mesh();
  EXPECT_THROW(SolverOf(mesh, 2), InputError);
  const SlitMapSolver solver = SolverOf(mesh);
  EXPECT_THROW(solver.Map(0), InputError);
  EXPECT_THROW(solver.Map(2), InputError);
}

TEST(BoundaryLoops, AreSortedByLengthAndKnowTheirEars)
{
  const SlitAnnulus         slit;
  const SurfaceConnectivity connectivity(slit.mesh);
  const auto                loops = BoundaryLoopsByLength(connectivity, slit.mesh.V);
  ASSERT_EQ(loops.size(), 4u);
  EXPECT_NEAR(loops[0].length, 96 * 2.0 * std::sin(Pi / 96), 1e-12);
  EXPECT_EQ(loops[2].vertices.size(), 96u);
  for (std::size_t i = 1; i < loops.size(); ++i)
  {
    EXPECT_GE(loops[i - 1].length, loops[i].length);
  }
  const SurfaceMesh square = Square(2, 1.0); // two corners of the square are cut off by a diagonal
  const auto        rim = BoundaryLoopsByLength(SurfaceConnectivity(square), square.V);
  EXPECT_EQ(EarsOfLoops(square.F, LoopOfVertices(rim, 9)).size(), 2u);
}
} // namespace
