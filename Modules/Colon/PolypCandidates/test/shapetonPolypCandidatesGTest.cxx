#include "shapetonPolypContent.h"
#include "shapetonPolypMorphology.h"
#include "shapetonPolypSearch.h"

#include "shapetonPolypTubes.h"
#include "shapetonExceptions.h"
#include "shapetonPi.h"
#include "shapetonTestThreads.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>

namespace
{
using namespace polyptubes;
using shapeton::PolypCandidate;

std::vector<PolypCandidate>
Find(const shapeton::SurfaceMesh & wall, double sensitivity = shapeton::defaultPolypSensitivity)
{
  shapeton::PolypCandidateOptions options;
  options.sensitivity = sensitivity;
  return shapeton::FindPolypCandidates(wall, options);
}

/** The only candidate on a wall. */
PolypCandidate
FindOne(const shapeton::SurfaceMesh & wall)
{
  const auto candidates = Find(wall);
  EXPECT_EQ(candidates.size(), 1u);
  return candidates.empty() ? PolypCandidate() : candidates.front();
}

PolypCandidate
CandidateAt(const Vector3d & position, double score = 0.0, int number = 0)
{
  PolypCandidate candidate;
  candidate.position = position;
  candidate.score = score;
  candidate.number = number;
  return candidate;
}

/** A ball whose center is 0.8 radii above the lower wall. */
Body
Head(double radiusOfHead)
{
  return Ball(Base(0.0) + 0.8 * radiusOfHead * Vector3d::UnitZ(), radiusOfHead);
}

const Body polyp = Ellipsoid(Base(0.0), 5.0, 6.0);
} // namespace

TEST(PolypCandidates, HalfEllipsoidIsFoundWithItsSize)
{
  for (const double spacing : { 0.6, 0.8, 1.0 }) // results are independent of mesh density
  {
    SCOPED_TRACE(spacing);
    const PolypCandidate one = FindOne(MakeWall({ polyp }, spacing));
    EXPECT_EQ(one.number, 1);
    EXPECT_NEAR(one.diameter, 10.0, 1.0);
    EXPECT_NEAR(one.leastDiameter, 10.0, 1.2);
    // The height is measured from a ring on the concave wall, which is higher than the base.
    EXPECT_GT(one.height, 3.8);
    EXPECT_LT(one.height, 6.0);
    EXPECT_LT((one.position - Base(0.0)).norm(), 5.0);
    EXPECT_LT((one.apex - (Base(0.0) + 6.0 * Vector3d::UnitZ())).norm(), 0.8);
    EXPECT_GT(one.axis.z(), 0.99);
    EXPECT_GT(one.score, 0.9);
    EXPECT_TRUE(std::isnan(one.arcLength));
    EXPECT_TRUE(std::isnan(one.features.heat));
  }
}

// Edges may be longer than the width of the ring around the foot, 2 mm.
TEST(PolypCandidates, CoarseWallsHaveFeetToo)
{
  for (const double spacing : { 1.4, 2.0, 2.8 })
  {
    EXPECT_GT(FindOne(MakeWall({ polyp }, spacing)).features.hollowness, 0.4) << spacing;
  }
}

TEST(PolypCandidates, BallIsMeasuredAcross)
{
  for (const double radiusOfHead : { 3.5, 5.0, 8.0 })
  {
    const PolypCandidate one = FindOne(MakeWall({ Head(radiusOfHead) }));
    EXPECT_NEAR(one.diameter, 2.0 * radiusOfHead, 0.5);
    EXPECT_GT(one.features.solidAngle, shapeton::TwoPi); // more than a hemisphere is exposed
  }
}

TEST(PolypCandidates, PolypOnAFoldIsOne)
{
  const Vector3d       middle(0.0, 0.0, -radius + 8.0);
  const PolypCandidate one = FindOne(MakeWall({ Plate(0.0, 7.0), Ball(middle, 4.0) }));
  EXPECT_LT((one.position - middle).norm(), 3.0);
  EXPECT_NEAR(one.diameter, 8.0, 1.0);
}

TEST(PolypCandidates, FlatPolypIsFound)
{
  const PolypCandidate one = FindOne(MakeWall({ Ellipsoid(Base(0.0), 6.0, 2.0) }));
  EXPECT_NEAR(one.diameter, 12.0, 1.5);
  EXPECT_LT(one.height, 2.0);
}

// The plaque is so broad and low that its solid angle is smaller than that of any bulge.
TEST(PolypCandidates, PlaqueIsFoundAndFoldAndBareTubeHaveNone)
{
  const PolypCandidate one = FindOne(MakeWall({ Ellipsoid(Base(0.0), 11.0, 1.9) }));
  EXPECT_LT(one.features.solidAngle, shapeton::LeastSolidAngleOfBulge);
  EXPECT_NEAR(one.diameter, 22.0, 1.5);
  EXPECT_LT((one.position - Base(0.0)).norm(), 2.5);
  EXPECT_GT(one.score, 0.4);
  for (const double height : { 4.0, 7.0 })
  {
    EXPECT_TRUE(Find(MakeWall({ Plate(0.0, height) })).empty()) << height;
  }
  EXPECT_TRUE(Find(MakeWall({}), 1.0).empty());
}

// Caps of a ball that protrude from the wall by different amounts; the foot of a lower cap is less concave.
TEST(PolypCandidates, FootOfALowHeadIsLessHollow)
{
  constexpr double ballRadius = 8.0;
  double           before = 0.0;
  for (const double height : { 2.0, 3.0, 4.5, 7.0 })
  {
    const auto candidates =
      Find(MakeWall({ Ball(Base(0.0) + (height - ballRadius) * Vector3d::UnitZ(), ballRadius) }), 1.0);
    ASSERT_FALSE(candidates.empty()) << height;
    const PolypCandidate & one = candidates.front();
    EXPECT_GT(one.features.hollowness, before + 0.2) << height;
    before = one.features.hollowness;
  }
}

TEST(PolypCandidates, CurvednessOfABallIsThatOfItsRadius)
{
  for (const double ballRadius : { 4.0, 6.0 })
  {
    const auto one = FindOne(MakeWall({ Ball(Base(0.0) + 0.9 * ballRadius * Vector3d::UnitZ(), ballRadius) }));
    EXPECT_NEAR(one.features.curvedness * ballRadius, 1.0, 0.1) << ballRadius;
  }
}

TEST(PolypCandidates, SmallerOnesThanAskedForAreLeftOut)
{
  const shapeton::SurfaceMesh wall =
    MakeWall({ Ball(Base(0.0) + 2.6 * Vector3d::UnitZ(), 2.8), Ellipsoid(Base(14.0), 5.0, 6.0) });
  shapeton::PolypCandidateOptions options;
  options.sensitivity = 1.0;
  const auto all = shapeton::FindPolypCandidates(wall, options);
  ASSERT_EQ(all.size(), 2u);
  options.leastDiameter = 7.0;
  const auto large = shapeton::FindPolypCandidates(wall, options);
  ASSERT_EQ(large.size(), 1u);
  EXPECT_NEAR(large.front().diameter, 10.0, 1.0);
}

TEST(PolypCandidates, ScoreGoesWithItsFeatures)
{
  shapeton::PolypFeatures lump; // residue of poorly mixed fluid
  lump.shapeIndex = 0.74;
  lump.roundness = 0.8;
  lump.hollowness = 0.9;
  lump.curvedness = 0.2;
  const double score = shapeton::PolypScore(lump);
  EXPECT_GT(score, 1.0 - shapeton::defaultPolypSensitivity);
  shapeton::PolypFeatures other = lump;
  other.curvedness = 0.1; // the score does not depend on size above a minimum
  EXPECT_EQ(shapeton::PolypScore(other), score);
  other.curvedness = 0.45;
  EXPECT_LT(shapeton::PolypScore(other), 0.05);
  for (double shapeton::PolypFeatures::*const feature : { &shapeton::PolypFeatures::shapeIndex,
                                                          &shapeton::PolypFeatures::roundness,
                                                          &shapeton::PolypFeatures::hollowness })
  {
    other = lump;
    other.*feature *= 0.8;
    EXPECT_LT(shapeton::PolypScore(other), score);
  }
}

TEST(PolypCandidates, RigidMotionMovesThemAlong)
{
  shapeton::SurfaceMesh wall = MakeWall({ polyp, Ball(Base(16.0), 4.0) });
  const auto            before = Find(wall);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vector3d(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  const Vector3d        shift(30.0, -200.0, 70.0);
  wall.V = (wall.V * turn.transpose()).rowwise() + shift.transpose();
  const auto after = Find(wall);
  ASSERT_EQ(before.size(), 2u);
  ASSERT_EQ(after.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i)
  {
    EXPECT_LT((turn * before[i].position + shift - after[i].position).norm(), 0.01);
    EXPECT_NEAR(before[i].score, after[i].score, 1e-3);
    EXPECT_NEAR(before[i].diameter, after[i].diameter, 0.1); // widths are measured in other directions
  }
}

namespace
{
/** The mirrored wall, with vertices and faces in a different order. */
shapeton::SurfaceMesh
MirroredAndRenumbered(const shapeton::SurfaceMesh & wall)
{
  const int             vertices = wall.NumberOfVertices();
  shapeton::SurfaceMesh other;
  other.V = wall.V.colwise().reverse();
  other.V.col(0) *= -1.0;
  other.F = (vertices - 1 - wall.F.array()).matrix().colwise().reverse();
  other.F.col(1).swap(other.F.col(2)); // restores the orientation after mirroring
  return other;
}
} // namespace

TEST(PolypCandidates, AMirroredWallHasTheMirroredList)
{
  const shapeton::SurfaceMesh wall =
    MakeWall({ polyp, Ellipsoid(Base(14.0), 3.0, 2.0), Ball(Base(-14.0), 3.0), Plate(-14.0, 5.0) });
  const auto list = Find(wall, 1.0);
  const auto mirrored = Find(MirroredAndRenumbered(wall), 1.0);
  ASSERT_GE(list.size(), 4u);
  ASSERT_EQ(list.size(), mirrored.size());
  for (std::size_t i = 0; i < list.size(); ++i)
  {
    const Vector3d inMirror = list[i].position.cwiseProduct(Vector3d(-1.0, 1.0, 1.0));
    EXPECT_LT((inMirror - mirrored[i].position).norm(), 1e-6) << i;
    EXPECT_NEAR(list[i].score, mirrored[i].score, 1e-6) << i;
    EXPECT_NEAR(list[i].diameter, mirrored[i].diameter, 1e-6) << i;
    EXPECT_NEAR(list[i].leastDiameter, mirrored[i].leastDiameter, 1e-6) << i;
    EXPECT_NEAR(list[i].height, mirrored[i].height, 1e-6) << i;
  }
}

// A head with a width of a few voxels must not depend on the voxel grid. It is rotated around the tube and shifted
// along it by fractions of a voxel.
TEST(PolypCandidates, ASmallHeadIsOneWhateverTheVoxelsAre)
{
  for (const double spacing : { 0.7, 0.85, 1.0, 1.2 })
  {
    for (int place = 0; place < 5; ++place)
    {
      SCOPED_TRACE(testing::Message() << spacing << ' ' << place);
      const double   angle = 0.17 * place;
      const Vector3d inwards(0.0, std::sin(angle), std::cos(angle));
      const auto     one =
        FindOne(MakeWall({ Ball(Vector3d(0.23 * place, 0.0, 0.0) - (radius - 0.6) * inwards, 2.35) }, spacing));
      EXPECT_NEAR(one.diameter, 4.7, 0.7);
      EXPECT_GT(one.features.roundness, 0.85);
      EXPECT_NEAR(one.features.shapeIndex, 0.89, 0.03);
      EXPECT_NEAR(std::log(one.features.hollowness), std::log(1.0), 0.3);
    }
  }
}

TEST(PolypCandidates, MoreSensitivityFindsAtLeastAsMany)
{
  const shapeton::SurfaceMesh wall = MakeWall({ polyp, Ellipsoid(Base(15.0), 5.0, 1.5), Plate(-14.0, 6.0) });
  const auto                  few = Find(wall, 0.05);
  const auto                  some = Find(wall);
  const auto                  all = Find(wall, 1.0);
  EXPECT_GE(some.size(), few.size());
  EXPECT_GT(all.size(), some.size());
  for (std::size_t i = 0; i < some.size(); ++i)
  {
    EXPECT_EQ(some[i].position, all[i].position);
    EXPECT_GE(some[i].score, 1.0 - shapeton::defaultPolypSensitivity);
    EXPECT_TRUE(i == 0 || some[i - 1].score >= some[i].score);
  }
  EXPECT_THROW(Find(wall, 1.1), shapeton::ParameterError);
  EXPECT_THROW(Find(wall, -0.1), shapeton::ParameterError);
}

TEST(PolypCandidates, BridgesAreLeftOutAndArcLengthsTaken)
{
  shapeton::SurfaceMesh wall = MakeWall({ polyp });
  wall.pointArrays.push_back({ "arcLength", wall.V.col(0).array() + 100.0, false });
  wall.cellArrays.push_back({ "bridged", Eigen::MatrixXd::Zero(wall.F.rows(), 1), false });
  EXPECT_NEAR(FindOne(wall).arcLength, 100.0, 0.5);
  wall.cellArrays[0].values.setOnes();
  EXPECT_TRUE(Find(wall, 1.0).empty());
}

TEST(PolypCandidates, SameBytesForAnyNumberOfThreads)
{
  const std::vector<Body>         bodies{ polyp, Ball(Base(16.0), 4.0) };
  const shapeton::SurfaceMesh     wall = MakeWall(bodies);
  const auto                      lumen = MakeLumen(bodies);
  shapeton::PublishedPolypOptions published;
  published.steps = 200;
  published.sensitivity = 1.0;
  basetest::ExpectSameWithAnyThreads(
    [&] {
      auto candidates = Find(wall, 1.0);
      shapeton::MeasureShapeDiffusion(wall, lumen, candidates);
      const auto others = shapeton::FindPublishedPolypCandidates(wall, lumen, nullptr, published);
      EXPECT_FALSE(shapeton::TableOfPolypCandidates(others).GetRows().empty());
      return std::make_pair(shapeton::TableOfPolypCandidates(candidates).GetRows(),
                            shapeton::TableOfPolypCandidates(others).GetRows());
    },
    { 3 });
}

TEST(PolypCandidates, EndsOfTheVisitsAreApart)
{
  const std::vector<Body>         bodies{ polyp, Ball(Base(16.0), 4.0) };
  const shapeton::SurfaceMesh     wall = MakeWall(bodies);
  const auto                      lumen = MakeLumen(bodies);
  shapeton::PublishedPolypOptions options;
  options.steps = 200;
  options.sensitivity = 1.0;
  EXPECT_EQ(options.visited, shapeton::VisitedWall::Least); // as in Figure 3.10
  const auto least = shapeton::FindPublishedPolypCandidates(wall, lumen, nullptr, options);
  options.visited = shapeton::VisitedWall::Most;
  const auto most = shapeton::FindPublishedPolypCandidates(wall, lumen, nullptr, options);
  ASSERT_FALSE(least.empty());
  ASSERT_FALSE(most.empty());
  std::set<int> visited;
  for (const auto & candidate : most)
  {
    visited.insert(candidate.vertices.begin(), candidate.vertices.end());
  }
  for (const auto & candidate : least)
  {
    for (const int vertex : candidate.vertices)
    {
      EXPECT_EQ(visited.count(vertex), 0u);
    }
  }
}

TEST(PolypCandidates, PlacesAreReadFromTheTable)
{
  const std::string path = SHAPETON_TEST_TEMPORARY_DIR "/PolypCandidatePlaces.csv";
  shapeton::TableOfPolypCandidates({}).Write(path);
  EXPECT_TRUE(shapeton::ReadOtherPolypCandidates(path).empty());
  std::vector<shapeton::PolypCandidate> candidates(2);
  candidates[0].number = 4;
  candidates[0].position = { 1.5, -2.25, 3.0 };
  candidates[0].diameter = 7.5;
  candidates[0].score = 0.5;
  candidates[1].position = { -40.0, 50.5, 60.0 };
  candidates[1].score = 0.25;
  candidates[1].other = shapeton::PolypInOtherPosition();
  candidates[1].other->ownScore = 0.75; // .25 is the updated score
  shapeton::TableOfPolypCandidates(candidates).Write(path);
  const auto others = shapeton::ReadOtherPolypCandidates(path);
  ASSERT_EQ(others.size(), 2u);
  EXPECT_LT((others[0].position - candidates[0].position).norm(), 1e-6);
  EXPECT_LT((others[1].position - candidates[1].position).norm(), 1e-6);
  EXPECT_EQ(others[0].number, 4);
  EXPECT_EQ(others[0].diameter, 7.5);
  EXPECT_EQ(others[0].score, 0.5);
  EXPECT_EQ(others[1].score, 0.75);
  EXPECT_EQ(shapeton::AsOthers(candidates)[1].score, 0.75);
  std::ofstream(path) << "x,y,z\n1,2,3\n"; // annotations of a reader
  const auto marks = shapeton::ReadOtherPolypCandidates(path);
  ASSERT_EQ(marks.size(), 1u);
  EXPECT_EQ(marks[0].number, 1);
  EXPECT_EQ(marks[0].score, 1.0);
  EXPECT_TRUE(std::isnan(marks[0].diameter));
}

TEST(PolypCandidates, ATableTellsWhatWasWritten)
{
  const std::string        path = SHAPETON_TEST_TEMPORARY_DIR "/PolypCandidateTable.csv";
  shapeton::PolypCandidate bare;
  bare.number = 2;
  shapeton::PolypCandidate full;
  full.number = 1;
  full.score = 0.875;
  full.position = { 1.5, -2.25, 3.0 };
  full.segment = 4;
  full.arcLength = 812.5;
  full.diameter = 11.5;
  full.leastDiameter = 9.25;
  full.height = 4.5;
  full.attenuation = 37.5;
  full.tissue = shapeton::PolypTissue::Soft;
  full.uv = { 900.5, 12.25 };
  full.other = shapeton::PolypInOtherPosition{ { 4.0, 5.0, -6.5 }, 7.25, 3, true, false, 0.75, 0.5, 0.625 };
  full.remark = "with, comma and \"quotes\"";
  const shapeton::CsvTable table = shapeton::TableOfPolypCandidates({ full, bare });
  table.Write(path);
  EXPECT_EQ(shapeton::TableOfPolypCandidates(shapeton::ReadPolypCandidates(path)).GetRows(), table.GetRows());
}

// The heat of a closed body scales with its ratio of surface to volume.
TEST(PolypCandidates, SmallHeadsAreHotter)
{
  std::vector<double> heats;
  for (const double radiusOfHead : { 3.0, 6.0 })
  {
    const std::vector<Body>     bodies{ Head(radiusOfHead) };
    const shapeton::SurfaceMesh wall = MakeWall(bodies);
    std::vector<PolypCandidate> candidates{ FindOne(wall) };
    shapeton::MeasureShapeDiffusion(wall, MakeLumen(bodies), candidates);
    heats.push_back(candidates.front().features.heat);
    EXPECT_GT(candidates.front().features.shapetonDensity, 0.0);
  }
  EXPECT_GT(heats[0], 1.3 * heats[1]);
  EXPECT_LT(heats[0], 1.0);
}

TEST(PolypCandidates, ContentIsMeasuredInsideAndRanks)
{
  const std::vector<Body>     bodies{ Ball(Base(0.0) + 4.0 * Vector3d::UnitZ(), 5.0) };
  const shapeton::SurfaceMesh wall = MakeWall(bodies);
  const PolypCandidate        found = FindOne(wall);
  for (const auto & [hounsfield, tissue] : { std::pair(45.0, shapeton::PolypTissue::Soft),
                                             { -90.0, shapeton::PolypTissue::Fat },
                                             { -860.0, shapeton::PolypTissue::Gas },
                                             { 600.0, shapeton::PolypTissue::Tagged } })
  {
    const double inside = hounsfield;
    // Partial volume over 2 mm must not affect the value.
    const auto ct = MakeImage<itk::Image<float, 3>>(
      0.8, [=](double d) { return inside + (-900.0 - inside) * std::clamp(0.5 * d + 0.5, 0.0, 1.0); }, bodies);
    std::vector<PolypCandidate> candidates{ found };
    shapeton::MeasureContent(wall, ct, MakeLumen(bodies), candidates);
    EXPECT_NEAR(candidates.front().attenuation, hounsfield, 1.0);
    EXPECT_EQ(candidates.front().tissue, tissue);
    EXPECT_EQ(candidates.front().submergedShare, 0.0);
    EXPECT_NEAR(
      candidates.front().score, found.score * shapeton::TissueLikelihood(candidates.front().attenuation), 1e-12);
    EXPECT_EQ(candidates.front().shapeScore, found.score);
    EXPECT_EQ(candidates.front().remark.empty(), hounsfield > -150.0 && hounsfield < 150.0);
    candidates = { found };
    shapeton::MeasureContent(wall, ct, MakeLumen(bodies, 2.0), candidates);
    EXPECT_GT(candidates.front().submergedShare, 0.95);
  }
  // Tissue with a pocket of gas 3.5 mm below the surface.
  const auto mixed = MakeImage<itk::Image<float, 3>>(
    0.8, [](double d) { return d < -3.5 ? -900.0 : -60.0 - 840.0 * std::clamp(0.5 * d + 0.5, 0.0, 1.0); }, bodies);
  std::vector<PolypCandidate> candidates{ found };
  shapeton::MeasureContent(wall, mixed, MakeLumen(bodies), candidates);
  EXPECT_EQ(candidates.front().tissue, shapeton::PolypTissue::WithGas);
  EXPECT_EQ(candidates.front().remark, "gas inside, as in stool");
  EXPECT_EQ(shapeton::TissueOf(-600.0), shapeton::PolypTissue::Gas);
  EXPECT_EQ(shapeton::TissueOf(std::nan("")), shapeton::PolypTissue::Unknown);
}

TEST(PolypCandidates, AFilmOfContrastIsNoStool)
{
  constexpr double gasIntensity = -900.0, contrast = 600.0, tissue = 45.0, wholeHead = 20.0;
  for (const double radius : { 3.0, 5.0 })
  {
    const std::vector<Body>     bodies{ Head(radius) };
    const shapeton::SurfaceMesh wall = MakeWall(bodies);
    const PolypCandidate        found = FindOne(wall);
    const auto                  lumen = MakeLumen(bodies);
    for (const double film : { 0.0, 1.0, 0.3 * radius, wholeHead })
    {
      // Partial volume over 1.2 mm at both surfaces of the film.
      const auto hounsfield = [=](double d) {
        const auto outside = [d](double border) { return std::clamp((d - border) / 1.2 + 0.5, 0.0, 1.0); };
        return tissue + (contrast - tissue) * outside(-film) + (gasIntensity - contrast) * outside(0.0);
      };
      std::vector<PolypCandidate> candidates{ found };
      shapeton::MeasureContent(wall, MakeImage<itk::Image<float, 3>>(0.8, hounsfield, bodies), lumen, candidates);
      const PolypCandidate & one = candidates.front();
      const bool             isStool = film == wholeHead;
      EXPECT_EQ(one.tissue, isStool ? shapeton::PolypTissue::Tagged : shapeton::PolypTissue::Soft) << radius << film;
      EXPECT_NEAR(one.attenuation, isStool ? contrast : tissue, 75.0) << radius << film;
      EXPECT_EQ(one.remark, isStool ? "tagged: stool or residue" : film > 0.0 ? "contrast on its surface" : "");
      EXPECT_TRUE(film > 0.0 ? one.filmShare > 0.95 : one.filmShare == 0.0) << one.filmShare;
      EXPECT_NEAR(one.score, one.shapeScore * (isStool ? 0.25 : 1.0), 0.01);
    }
  }
}

TEST(PolypCandidates, FluidThatCleansingLeftIsResidue)
{
  const std::vector<Body>     bodies{ Ball(Base(0.0) + 3.0 * Vector3d::UnitZ(), 3.5) };
  const shapeton::SurfaceMesh wall = MakeWall(bodies);
  std::vector<PolypCandidate> candidates{ FindOne(wall) };
  const auto                  lumen = MakeLumen(bodies, 2.0);
  for (const double inside : { 45.0, 700.0 })
  {
    // Before cleansing, there is fluid of 700 HU around the head, with partial volume over 2 mm.
    const auto original = MakeImage<itk::Image<float, 3>>(
      0.8, [=](double d) { return inside + (700.0 - inside) * std::clamp(0.5 * d + 0.5, 0.0, 1.0); }, bodies);
    shapeton::NoteResidue(wall, original, lumen, candidates);
    EXPECT_EQ(candidates.front().lookalike,
              inside > 100.0 ? shapeton::PolypLookalike::Residue : shapeton::PolypLookalike::None);
    EXPECT_NEAR(candidates.front().uncleansedAttenuation, inside, 30.0);
  }
  EXPECT_EQ(candidates.front().remark, "residue of electronic cleansing");
}

/** At a level, a mixture of gas and fluid looks like tissue after cleansing; a polyp hardly changes. */
TEST(PolypCandidates, AWaferAtAFluidLevelIsResidueAndAPolypIsNot)
{
  const std::vector<Body>     bodies{ Ball(Base(0.0) + 3.0 * Vector3d::UnitZ(), 3.5) };
  const shapeton::SurfaceMesh wall = MakeWall(bodies);
  const auto                  lumen = MakeLumen(bodies, 2.0);
  for (const double share : { 0.05, 0.4, 0.95 })
  {
    for (const double before : { 60.0, 230.0 })
    {
      std::vector<PolypCandidate> candidates{ FindOne(wall) };
      candidates.front().submergedShare = share;
      candidates.front().meanAttenuation = 45.0;
      const auto original = MakeImage<itk::Image<float, 3>>(
        0.8, [=](double) { return before; }, bodies);
      shapeton::NoteResidue(wall, original, lumen, candidates);
      const bool isWafer = share == 0.4 && before > 200.0;
      EXPECT_EQ(candidates.front().lookalike == shapeton::PolypLookalike::Residue, isWafer) << share << ' ' << before;
    }
  }
}

TEST(PolypCandidates, HeadsAreVoxelsOfTheirTissue)
{
  const Vector3d          middle = Base(0.0) + 4.0 * Vector3d::UnitZ();
  const std::vector<Body> bodies{ Ball(middle, 5.0) };
  const auto              wall = MakeWall(bodies);
  const auto              lumen = MakeLumen(bodies);
  PolypCandidate          candidate = FindOne(wall);
  candidate.number = 7;
  const auto heads = shapeton::LabelPolypHeads(wall, lumen, { candidate });
  double     volume = 0.0;
  basetest::ForVoxels(heads, [&](const auto & index, const auto & point) {
    if (heads->GetPixel(index) != 0)
    {
      EXPECT_EQ(heads->GetPixel(index), 7);
      EXPECT_EQ(lumen->GetPixel(index), 0);
      EXPECT_LT((basetest::ToEigen(point) - middle).norm(), 5.0 + 0.8 * std::sqrt(3.0));
      volume += 0.8 * 0.8 * 0.8;
    }
  });
  const double ball = 4.0 / 3.0 * shapeton::Pi * 125.0;
  EXPECT_GT(volume, 0.5 * ball); // a part is below the surrounding wall
  EXPECT_LT(volume, 1.1 * ball);
}

TEST(PolypCandidates, TissueLikelihoodKeepsTissueAndDropsGas)
{
  for (double hounsfield = -180.0; hounsfield <= 150.0; hounsfield += 10.0)
  {
    EXPECT_GT(shapeton::TissueLikelihood(hounsfield), 0.95) << hounsfield;
  }
  EXPECT_LT(shapeton::TissueLikelihood(-420.0), 0.05);
  EXPECT_NEAR(shapeton::TissueLikelihood(500.0), 0.25, 1e-3);
  EXPECT_EQ(shapeton::TissueLikelihood(std::nan("")), 1.0);
  EXPECT_EQ(shapeton::TissueLikelihood(40.0, std::nan("")), shapeton::TissueLikelihood(40.0, 0.0));
  // Heads under fluid are not darkened by gas: values below fat are bubbles; 3 mm bubbles have -150 to -270 HU on CT.
  EXPECT_GT(shapeton::TissueLikelihood(40.0, 1.0), 0.99);
  EXPECT_GT(shapeton::TissueLikelihood(-90.0, 1.0), 0.85);
  EXPECT_LT(shapeton::TissueLikelihood(-160.0, 1.0), 0.25);
  EXPECT_LT(shapeton::TissueLikelihood(-160.0, 1.0), shapeton::TissueLikelihood(-160.0, 0.5));
}

TEST(PolypCandidates, OtherPositionIsFoundThroughTheMap)
{
  const shapeton::SurfaceMesh wall = MakeWall({ polyp });
  std::vector<PolypCandidate> candidates{ FindOne(wall) };
  shapeton::SurfaceMesh       map;
  map.V = wall.V;
  map.F = wall.F;
  EXPECT_THROW(shapeton::FindInOtherPosition(map, "map", {}, candidates), shapeton::InputError); // no arrays
  map.pointArrays.push_back({ "mapped", wall.V.rowwise() + Eigen::RowVector3d(100.0, 0.0, 0.0), false });
  map.pointArrays.push_back({ "confidence", Eigen::MatrixXd::Constant(wall.V.rows(), 1, 0.75), false });
  map.pointArrays.push_back({ "excluded", Eigen::MatrixXd::Zero(wall.V.rows(), 1), false });
  const Vector3d there = candidates.front().position + Vector3d(100.0, 0.0, 0.0);
  const double   diameter = candidates.front().diameter;
  shapeton::FindInOtherPosition(map,
                                "map",
                                { { 1, there + Vector3d(0.0, 80.0, 0.0), diameter, 1.0 },
                                  { 2, there + Vector3d(8.0, 0.0, 0.0), diameter, 0.9 },
                                  { 3, there, 4.0 * diameter, 1.0 } }, // closer, but far too wide
                                candidates);
  ASSERT_TRUE(candidates.front().other.has_value());
  const shapeton::PolypInOtherPosition & other = *candidates.front().other;
  EXPECT_LT((other.point - there).norm(), 3.0); // the nearest point of the wall is used
  EXPECT_EQ(other.candidate, 2);
  EXPECT_TRUE(other.isSeen);
  EXPECT_NEAR(other.confidence, 0.75, 1e-9);
  const double away = (there + Vector3d(8.0, 0.0, 0.0) - other.point).norm() / 8.0;
  EXPECT_NEAR(other.likeness, 0.9 * std::exp(-0.5 * away * away), 1e-9);
  shapeton::FindInOtherPosition(map, "map", { { 7, there + Vector3d(0.0, 80.0, 0.0), diameter, 1.0 } }, candidates);
  EXPECT_FALSE(candidates.front().other->isSeen);
  EXPECT_EQ(candidates.front().other->candidate, 7); // the nearest, if none is similar
  map.pointArrays[1].values.setConstant(0.29);
  shapeton::FindInOtherPosition(map, "map", {}, candidates);
  EXPECT_TRUE(candidates.front().other->isExcluded);
  map.pointArrays[1].values.setConstant(0.75);
  map.pointArrays[2].values.setOnes();
  shapeton::FindInOtherPosition(map, "map", { { 1, there, diameter, 1.0 } }, candidates);
  EXPECT_TRUE(candidates.front().other->isExcluded);
  EXPECT_FALSE(candidates.front().other->isSeen);
  map.V.rowwise() += Eigen::RowVector3d(0.0, 0.0, 500.0); // surface of another colon
  EXPECT_THROW(shapeton::FindInOtherPosition(map, "map", {}, candidates), shapeton::InputError);
}

TEST(PolypCandidates, AllPointsTellOnWhichWallTheyAre)
{
  const auto square = [](double slope) { // through the x axis
    shapeton::SurfaceMesh wall;
    wall.V.resize(4, 3);
    wall.V << -100.0, 0.0, -slope, 100.0, 0.0, slope, 100.0, 100.0, slope, -100.0, 100.0, -slope;
    wall.F.resize(2, 3);
    wall.F << 0, 1, 2, 0, 2, 3;
    return wall;
  };
  shapeton::VertexMatrix points(3, 3);
  points << 0.0, 50.0, 1.0, // equidistant from both walls
    80.0, 50.0, 2.0, -80.0, 50.0, 3.0;
  EXPECT_NEAR(shapeton::MeanDistanceToWall(square(0.0), points), 2.0, 1e-12);
  EXPECT_NEAR(shapeton::MeanDistanceToWall(square(0.0), points.replicate(1001, 1)), 2.0, 0.01); // every 4th
  const double cosine = std::sqrt(0.5);
  EXPECT_NEAR(shapeton::MeanDistanceToWall(square(100.0), points), cosine * (1.0 + 78.0 + 83.0) / 3.0, 1e-9);
  EXPECT_EQ(shapeton::MeanDistanceToWall(square(0.0), {}), 0.0);
}

TEST(PolypCandidates, SizesIfConfirmedLeaveOutWhatIsNamed)
{
  EXPECT_EQ(shapeton::SizeOf(5.94), shapeton::PolypSize::Below6);
  EXPECT_EQ(shapeton::SizeOf(5.96), shapeton::PolypSize::From6To9); // printed as 6.0 mm
  EXPECT_EQ(shapeton::SizeOf(9.94), shapeton::PolypSize::From6To9);
  EXPECT_EQ(shapeton::SizeOf(9.96), shapeton::PolypSize::From10);
  EXPECT_EQ(shapeton::SizeOf(29.96), shapeton::PolypSize::From30);
  EXPECT_EQ(shapeton::SizeInWords(9.96), "10.0 mm");
  PolypCandidate medium, large;
  medium.diameter = 7.0;
  large.diameter = 12.0;
  large.score = 0.5;
  medium.score = 0.49;
  const auto confirmed = [](int ofLarge, int ofMedium) {
    const std::string large = std::to_string(ofLarge), medium = std::to_string(ofMedium);
    return "If confirmed: " + large + " of 10 mm and more (" + large + " likely), " + medium +
           " of 6 to 9 mm (0 likely)";
  };
  EXPECT_EQ(shapeton::SizesIfConfirmed({}), confirmed(0, 0));
  medium.number = 1;
  large.number = 2;
  EXPECT_EQ(shapeton::SizesIfConfirmed({ medium, large }), confirmed(1, 1));
  PolypCandidate valve = large, fragment = large;
  valve.lookalike = shapeton::PolypLookalike::Valve;
  valve.number = 3;
  fragment.number = 4;
  fragment.mainCandidate = 2;
  EXPECT_EQ(shapeton::SizesIfConfirmed({ large, valve, fragment }), confirmed(1, 0));
}

TEST(PolypCandidates, LesionsOfTwoPositionsCountOnce)
{
  const auto candidate = [](int number, double diameter, int there) {
    PolypCandidate one;
    one.number = number;
    one.diameter = diameter;
    one.other.emplace();
    one.other->isSeen = there > 0;
    one.other->candidate = there;
    return one;
  };
  std::vector<PolypCandidate> first{ candidate(1, 8.0, 2), candidate(2, 12.0, 0), candidate(3, 7.0, 2) };
  std::vector<PolypCandidate> second{ candidate(1, 6.0, 0), candidate(2, 10.0, 1), candidate(3, 9.0, 4) };
  first.push_back(candidate(4, 9.0, 3));
  first.back().lookalike = shapeton::PolypLookalike::Tagged;
  std::string lesions;
  for (const shapeton::PolypLesion & one : shapeton::LesionsOfPositions(first, second))
  {
    lesions += one.letter + std::to_string(one.first) + std::to_string(one.second) + (one.isDisputed ? "? " : " ");
  }
  EXPECT_EQ(lesions, "A12 B20 C30 D01 E43? ");
  EXPECT_EQ(shapeton::SizesIfConfirmed(first, second),
            "If confirmed: 2 of 10 mm and more (0 likely), 2 of 6 to 9 mm (0 likely)");
  second[0].score = 0.6; // of D, smaller than 10 mm
  second[1].score = 0.7; // of A
  EXPECT_EQ(shapeton::SizesIfConfirmed(first, second),
            "If confirmed: 2 of 10 mm and more (1 likely), 2 of 6 to 9 mm (1 likely)");
  EXPECT_EQ(shapeton::LesionsOfPositions(std::vector<PolypCandidate>(28), {}).back().letter, "AB");
}

TEST(PolypCandidates, FormIsThatOfTheBody)
{
  const auto stalk = [](const Vector3d & p) {
    const double along = std::clamp(p.z(), -radius - 2.0, -radius + 8.0);
    return (p - Vector3d(0.0, 0.0, along)).norm() - 1.6;
  };
  const auto formOf = [](const std::vector<Body> & bodies) {
    const shapeton::SurfaceMesh wall = MakeWall(bodies);
    std::vector<PolypCandidate> candidates{ FindOne(wall) };
    shapeton::MeasureMorphology(
      wall, [](const Vector3d & p) { return p.x() > 0.0; }, candidates);
    return candidates.front();
  };
  const auto onStalk = formOf({ stalk, Ball(Base(0.0) + 11.0 * Vector3d::UnitZ(), 4.0) });
  EXPECT_EQ(onStalk.morphology, shapeton::PolypMorphology::Pedunculated);
  EXPECT_NEAR(onStalk.planeDiameter, 8.0, 0.8);
  const auto sessile = formOf({ polyp });
  EXPECT_EQ(sessile.morphology, shapeton::PolypMorphology::Sessile);
  EXPECT_NEAR(sessile.planeDiameter, 10.0, 1.2);
  const auto flat = formOf({ Ellipsoid(Base(0.0), 8.0, 2.6) });
  EXPECT_EQ(flat.morphology, shapeton::PolypMorphology::Flat);
  EXPECT_EQ(shapeton::MorphologyInWords(flat), "flat");
  const auto onFold = formOf({ Ellipsoid(Base(8.0), 5.0, 6.0) });
  EXPECT_EQ(shapeton::MorphologyInWords(onFold), "sessile, on a fold");
  PolypCandidate small = onFold;
  small.diameter = small.planeDiameter = 5.4; // rounded to 5 mm
  EXPECT_EQ(shapeton::MorphologyInWords(small), "diminutive, on a fold");
}

TEST(PolypCandidates, FragmentsBelongToTheBestOne)
{
  const shapeton::SurfaceMesh wall = MakeWall({});
  const auto                  headAround = [&](const Vector3d & middle, int number) {
    PolypCandidate candidate;
    candidate.number = number;
    for (int i = 0; i < wall.NumberOfVertices(); ++i)
    {
      if ((wall.V.row(i).transpose() - middle).norm() < 3.0)
      {
        candidate.vertices.push_back(i);
      }
    }
    return candidate;
  };
  std::vector<PolypCandidate> candidates{
    headAround(Base(0.0), 1), headAround(Base(15.0), 2), headAround(Base(7.0), 3), headAround(Base(-11.0), 4)
  };
  shapeton::JoinFragments(wall, candidates);
  EXPECT_EQ(candidates[1].mainCandidate, 2);
  EXPECT_EQ(candidates[2].mainCandidate, 1);
  EXPECT_EQ(candidates[3].mainCandidate, 4);
  EXPECT_TRUE(shapeton::IsListedAsPolyp(candidates[3]));
  EXPECT_FALSE(shapeton::IsListedAsPolyp(candidates[2]));

  // A head 3 mm from stool may be a polyp; one 3 mm from another head is a fragment.
  candidates = { headAround(Base(0.0), 1), headAround(Base(9.0), 2) };
  shapeton::JoinFragments(wall, candidates);
  EXPECT_EQ(candidates[1].mainCandidate, 1);
  candidates[0].lookalike = shapeton::PolypLookalike::Tagged;
  shapeton::JoinFragments(wall, candidates);
  EXPECT_EQ(candidates[1].mainCandidate, 2);
  EXPECT_TRUE(shapeton::IsListedAsPolyp(candidates[1]));
}

TEST(PolypCandidates, AlternativesToTheValveSaySoAndKeepTheirScores)
{
  shapeton::IleocecalValve decided, alternative, unlikely;
  alternative.position = { 60.0, 0.0, 0.0 };
  alternative.confidence = 0.396;
  unlikely.position = { 0.0, 60.0, 0.0 };
  unlikely.confidence = 0.04;
  decided.confidence = 0.6;
  std::vector<PolypCandidate> candidates{ CandidateAt({ 71.9, 0.0, 0.0 }, 0.96),
                                          CandidateAt({ 72.1, 0.0, 0.0 }, 0.9),
                                          CandidateAt({ 0.0, 60.0, 0.0 }, 0.8),
                                          CandidateAt({ 0.0, 0.0, 0.0 }, 0.7) };
  shapeton::RankValveLast(decided, candidates);
  shapeton::NoteIleocecalValve({ decided, alternative, unlikely }, candidates);
  ASSERT_EQ(candidates.size(), 4U);
  EXPECT_EQ(candidates[0].remark, "may be the ileocecal valve (40 %)");
  EXPECT_EQ(candidates[0].score, 0.96);
  EXPECT_EQ(candidates[1].remark, "");
  EXPECT_EQ(candidates[2].remark, "");
  EXPECT_EQ(candidates[3].remark, "the ileocecal valve");
}

TEST(PolypCandidates, KnownValveIsNamedAndRanksBehindSoftTissue)
{
  shapeton::IleocecalValve valve;
  valve.length = 26.0;
  valve.confidence = 0.6;
  valve.arcLength = 1700.0;
  PolypCandidate lip = CandidateAt({ 15.9, 0.0, 0.0 }, 0.9); // half the length plus 3 mm
  lip.arcLength = 1685.0;
  lip.segment = 5;
  const PolypCandidate beside = CandidateAt({ 16.1, 0.0, 0.0 }, 0.3);
  PolypCandidate       bubble = CandidateAt({ 100.0, 0.0, 0.0 }, 0.01);
  bubble.tissue = shapeton::PolypTissue::Gas;
  std::vector<PolypCandidate> candidates{ lip, beside, bubble };
  shapeton::RankValveLast(valve, candidates);
  EXPECT_EQ(candidates[0].position, beside.position);
  EXPECT_EQ(candidates[0].remark, "");
  EXPECT_EQ(candidates[1].remark, "the ileocecal valve");
  EXPECT_EQ(candidates[1].arcLength, valve.arcLength);
  EXPECT_EQ(candidates[1].segment, 6);
  EXPECT_EQ(candidates[1].number, 2);
  EXPECT_LE(candidates[1].score, (1.0 - valve.confidence) * lip.score);
  EXPECT_EQ(candidates[2].tissue, shapeton::PolypTissue::Gas);
}

TEST(PolypCandidates, WhatIsLeftOfACatheterRanksLast)
{
  shapeton::CurveSet catheter;
  catheter.V.resize(2, 3);
  catheter.V << 0.0, 0.0, 0.0, 0.0, 0.0, 1.0;
  catheter.curves = { { 0, 1 } };
  catheter.pointArrays.push_back({ "radius", Eigen::Vector2d(5.0, 5.0) });
  catheter.pointArrays.push_back({ "balloonRadius", Eigen::Vector2d(0.0, 0.0) });
  const PolypCandidate        onTube = CandidateAt({ 7.9, 0.0, 1.0 }, 0.9, 1);
  const PolypCandidate        beside = CandidateAt({ 8.1, 0.0, 1.0 }, 0.5, 2);
  std::vector<PolypCandidate> candidates{ onTube, beside };
  std::vector<PolypCandidate> withBalloon = candidates;
  shapeton::RankCatheterLast(catheter, candidates);
  ASSERT_EQ(candidates.size(), 2U);
  EXPECT_EQ(candidates[0].position, beside.position);
  EXPECT_EQ(candidates[0].number, 1);
  EXPECT_EQ(candidates[0].score, 0.5);
  EXPECT_EQ(candidates[0].remark, "");
  EXPECT_EQ(candidates[1].number, 2);
  EXPECT_EQ(candidates[1].score, 0.0);
  EXPECT_EQ(candidates[1].remark, "the rectal catheter");

  catheter.pointArrays[1].values << 6.0, 0.0;
  shapeton::RankCatheterLast(catheter, withBalloon);
  EXPECT_EQ(withBalloon[0].remark, "the rectal catheter");
  EXPECT_EQ(withBalloon[1].remark, "the balloon of the rectal catheter");
  EXPECT_EQ(withBalloon[1].score, 0.0);
}

TEST(PolypCandidates, TheAnalCanalAndWhatMayBeACatheterAreKnownByPlace)
{
  shapeton::CurveSet line; // the lumen opens at 30 mm
  line.V = shapeton::VertexMatrix::Zero(4, 3);
  line.V.col(2) << 0.0, 20.0, 30.0, 200.0;
  line.curves = { { 0, 1, 2, 3 } };
  line.pointArrays = { { "arcLength", line.V.col(2) }, { "radius", Eigen::Vector4d(3.0, 4.0, 15.0, 20.0) } };
  std::vector<PolypCandidate> candidates(4); // the place of the last one is unknown
  candidates[0].arcLength = 33.0;
  candidates[1].arcLength = 128.0;
  candidates[2].arcLength = 12.0;
  shapeton::NoteAnalCanal(line, candidates);
  EXPECT_NE(candidates[0].remark.find("catheter"), std::string::npos);
  EXPECT_EQ(candidates[0].lookalike, shapeton::PolypLookalike::None);
  EXPECT_EQ(candidates[1].remark, "");
  EXPECT_EQ(candidates[2].remark, "anal canal");
  EXPECT_EQ(candidates[2].lookalike, shapeton::PolypLookalike::AnalCanal);
  EXPECT_EQ(candidates[3].remark, "");
}

TEST(PolypCandidates, TooSmallForTheResolutionIsNoted)
{
  std::vector<PolypCandidate> candidates(2);
  candidates[0].diameter = 8.9;
  candidates[0].remark = "tagged";
  candidates[1].diameter = 9.0;
  shapeton::NoteSmallerThan(9.0, candidates);
  EXPECT_EQ(candidates[0].remark, "tagged; not evaluable for polyps below 9 mm");
  EXPECT_EQ(candidates[1].remark, "");
}

TEST(PolypCandidates, TheOtherPositionWeighsWhatItShows)
{
  const auto weighed = [](double confidence, double score, double likeness, bool isExcluded = false) {
    std::vector<shapeton::PolypCandidate> one(1);
    one[0].number = 1;
    one[0].diameter = 8.0;
    one[0].height = 4.0;
    one[0].shapeScore = 0.9;
    one[0].score = score;
    one[0].other = shapeton::PolypInOtherPosition();
    one[0].other->isExcluded = isExcluded;
    one[0].other->isSeen = likeness >= 0.1;
    one[0].other->likeness = likeness;
    shapeton::WeighByOtherPosition(confidence, one);
    return one[0];
  };
  EXPECT_EQ(weighed(0.0, 0.9, 0.0).score, 0.9);       // a registration without evidence
  EXPECT_EQ(weighed(1.0, 0.9, 0.0, true).score, 0.9); // not visible
  EXPECT_TRUE(std::isnan(weighed(1.0, 0.9, 0.0, true).other->ownScore));
  EXPECT_LT(weighed(1.0, 0.9, 0.0).score, 0.25);
  EXPECT_GT(weighed(1.0, 0.9, 0.9).score, 0.9);
  EXPECT_NE(weighed(1.0, 0.9, 0.0).remark, "");
  EXPECT_EQ(weighed(1.0, 0.9, 0.9).remark, "");
  EXPECT_EQ(weighed(1.0, 0.9, 0.3).other->ownScore, 0.9);
  // The weights are the probabilities of a correct and of a wrong map.
  EXPECT_NEAR(weighed(0.75, 0.9, 0.0).score, 0.75 * weighed(1.0, 0.9, 0.0).score + 0.25 * 0.9, 1e-12);
  // The tissue factor (one half) is unchanged; a catheter remains a catheter.
  EXPECT_NEAR(weighed(1.0, 0.45, 0.5).score, 0.5 * weighed(1.0, 0.9, 0.5).score, 1e-12);
  EXPECT_EQ(weighed(1.0, 0.0, 1.0).score, 0.0);
  double last = 0.0;
  for (double likeness = 0.0; likeness <= 1.0; likeness += 0.125)
  {
    const double score = weighed(1.0, 0.9, likeness).score;
    EXPECT_GT(score, last);
    EXPECT_LT(score, 1.0);
    last = score;
  }
  std::vector<shapeton::PolypCandidate> none(1);
  EXPECT_THROW(shapeton::WeighByOtherPosition(1.5, none), shapeton::ParameterError);
}

TEST(PolypCandidates, WeighedCandidatesKeepTheirNumbers)
{
  std::vector<shapeton::PolypCandidate> candidates(2);
  for (int i = 0; i < 2; ++i)
  {
    candidates[i].number = i + 1;
    candidates[i].diameter = 8.0;
    candidates[i].height = 4.0;
    candidates[i].score = candidates[i].shapeScore = i == 0 ? 0.95 : 0.6;
    candidates[i].other = shapeton::PolypInOtherPosition();
    candidates[i].other->likeness = i;
  }
  shapeton::WeighByOtherPosition(0.9, candidates);
  EXPECT_EQ(candidates[0].number, 2); // visible in both positions
  EXPECT_EQ(candidates[1].number, 1);
  EXPECT_GT(candidates[0].score, candidates[1].score);
}

namespace
{
/** A head of this shape index at the origin, ranked by a valve there (confidence .95) and weighed by the other
 * position, where it has no match, and the same head 100 mm away. */
std::vector<PolypCandidate>
RankedByValve(double shapeIndex)
{
  std::vector<PolypCandidate> candidates(2);
  for (int i = 0; i < 2; ++i)
  {
    candidates[i].diameter = 22.0;
    candidates[i].height = 7.0;
    candidates[i].features.shapeIndex = shapeIndex;
    candidates[i].score = candidates[i].shapeScore = i == 0 ? 1.0 : 0.9;
    candidates[i].position = { 100.0 * i, 0.0, 0.0 };
    candidates[i].other = shapeton::PolypInOtherPosition();
    candidates[i].other->likeness = i;
  }
  shapeton::IleocecalValve valve;
  valve.length = 22.0;
  valve.confidence = 0.95;
  shapeton::RankValveLast(valve, candidates);
  shapeton::WeighByOtherPosition(1.0, candidates);
  EXPECT_EQ(candidates[1].remark, "the ileocecal valve");
  return candidates;
}
} // namespace

/** It is listed last for any valve confidence and any evidence from the other position. */
TEST(PolypCandidates, LargePolypThatIsTakenForTheValveStaysInTheList)
{
  const auto candidates = RankedByValve(0.95);
  EXPECT_EQ(candidates[1].score, 1.0 - shapeton::defaultPolypSensitivity);
  EXPECT_GT(candidates[0].score, candidates[1].score);
}

TEST(PolypCandidates, LipsOfTheValveAreWeighedByItsProbability)
{
  const auto candidates = RankedByValve(0.75);
  EXPECT_NEAR(candidates[1].score, 0.05 * (1.0 - shapeton::defaultPolypSensitivity), 1e-12);
  EXPECT_GT(candidates[0].score, 0.5);
}

TEST(PolypCandidates, AsWrittenAreThoseThatAreReadBack)
{
  shapeton::PolypCandidate one;
  one.number = 1;
  one.meanAttenuation = 40.496; // rounds to 40, but 40.5 in the table rounds to 41
  one.diameter = 10.49996;
  one.arcLength = 1234.56;
  const std::string path = (std::filesystem::temp_directory_path() / "shapeton-candidates-as-written.csv").string();
  shapeton::TableOfPolypCandidates({ one }).Write(path);
  const shapeton::PolypCandidate read = shapeton::ReadPolypCandidates(path).at(0);
  std::filesystem::remove(path);
  const shapeton::PolypCandidate written = shapeton::CandidatesAsWritten({ one }).at(0);
  EXPECT_EQ(written.meanAttenuation, read.meanAttenuation);
  EXPECT_EQ(written.diameter, read.diameter);
  EXPECT_EQ(written.arcLength, read.arcLength);
  EXPECT_EQ(std::round(written.meanAttenuation), 41.0);
}
