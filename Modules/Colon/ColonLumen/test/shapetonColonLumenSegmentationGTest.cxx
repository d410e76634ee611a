#include "shapetonColonLumenSegmentation.h"

#include "shapetonColonTestScene.h"
#include "shapetonExceptions.h"
#include "shapetonVolumeReader.h"
#include "shapetonTestThreads.h"
#include "shapetonTestImages.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

namespace
{
using shapeton::At;
using shapeton::ColonTestScene;
using shapeton::Tube;
using Vec = ColonTestScene::Vec;
using ImageType = itk::Image<float, 3>;

/** Rotation about z and then about x, degrees. */
itk::Matrix<double, 3, 3>
Oblique(double aboutZ, double aboutX)
{
  return shapeton::TurnedAxes(aboutZ / 57.29578, aboutX / 57.29578);
}

/** A half-filled colon next to a thinner bowel that is behind a 3 mm wall and filled with equally bright fluid. */
ColonTestScene
ColonAndBowel(const Vec & gravity)
{
  // The bowel is beside the colon, perpendicular to gravity; they touch below the level.
  const Vec      aside = At(gravity[1], -gravity[0], 0) * 30.0 + gravity * 8.0;
  ColonTestScene scene({ { Tube(At(0, 0, 0), 2, 30, 18), 4.0, 700.0 }, { Tube(aside, 2, 30, 10), -1e9, 700.0 } });
  scene.gravity = gravity;
  return scene;
}

struct Overlap
{
  double dice{ 0.0 };
  double leakMl{ 0.0 };
  double wrongKindMl{ 0.0 };
};

Overlap
Compare(const ColonTestScene & scene, const shapeton::ColonLumen & lumen)
{
  Overlap      overlap;
  double       both = 0.0, sum = 0.0;
  const auto   spacing = lumen.labels->GetSpacing();
  const double ml = spacing[0] * spacing[1] * spacing[2] * 1e-3;
  basetest::ForVoxels(lumen.labels, [&](const auto & index, const auto & x) {
    const Vec  v = x.GetVectorFromOrigin();
    const bool truth = scene.IsLumen(0, v);
    const auto label = lumen.labels->GetPixel(index);
    both += truth && label;
    sum += truth + (label != 0);
    overlap.leakMl += label && scene.IsLumen(1, v) ? ml : 0.0;
    const double height = v * scene.gravity - scene.lumens[0].level;
    overlap.wrongKindMl += truth && ((height < -1.5 && label == 2) || (height > 1.5 && label == 1)) ? ml : 0.0;
  });
  overlap.dice = 2.0 * both / sum;
  return overlap;
}

shapeton::ColonLumen
Segment(const ImageType * image, const std::string & position = "")
{
  shapeton::ColonLumenSettings options;
  options.position = position;
  return shapeton::SegmentColonLumen(image, options);
}

/** A scene in voxels of 2 mm. */
ImageType::Pointer
Coarse(const ColonTestScene & scene, int slices = 50)
{
  return shapeton::SampledImage(scene, { 72, 72, slices }, { 2.0, 2.0, 2.0 });
}

unsigned char
LabelAt(const shapeton::ColonLumen & lumen, const Vec & place)
{
  const itk::Point<double, 3> point(place.GetDataPointer());
  return lumen.labels->GetPixel(lumen.labels->TransformPhysicalPointToIndex(point));
}

TEST(ColonLumenSegmentation, TakesGasAndFluidAndNoBowelOfEqualBrightness)
{
  const auto scene = ColonAndBowel(At(0, 1, 0));
  const auto lumen = Segment(shapeton::SampledImage(scene, { 110, 110, 80 }, { 1.3, 1.3, 1.3 }), "HFS");
  EXPECT_EQ(lumen.failure, "");
  EXPECT_TRUE(lumen.warnings.empty());
  const auto overlap = Compare(scene, lumen);
  EXPECT_GT(overlap.dice, 0.985);
  EXPECT_LT(overlap.leakMl, 0.2);
  EXPECT_LT(overlap.wrongKindMl, 0.01);
  EXPECT_NEAR(lumen.thresholds.fluid, 700.0, 15.0);
  EXPECT_NEAR(lumen.thresholds.gas, -1000.0, 5.0);
  EXPECT_NEAR(lumen.thresholds.tissue, 50.0, 5.0);
  ASSERT_EQ(lumen.pieces.size(), 1U);
  EXPECT_NEAR(lumen.pieces[0].inscribedRadius, 18.0, 1.5);
}

/** A pool of poorly mixed fluid with a slanting floor; the bowel 2 mm below it is as bright as well-mixed fluid. */
TEST(ColonLumenSegmentation, BrightBowelUnderAShallowFaintPoolStaysOut)
{
  const auto floor = [](const Vec & x) { return 12.5 + 0.25 * (x[0] - 28.0); };
  const auto tube = Tube(At(28, 0, 0), 2, 30, 17);
  const auto bowel = [=](const Vec & x) {
    const double below = x[1] - floor(x);
    return std::min({ 11.0 - std::abs(x[0] - 28.0), 30.0 - std::abs(x[2]), below - 2.06, 14.0 - below });
  };
  const auto           pool = [=](const Vec & x) { return std::min(tube(x), floor(x) - x[1]); };
  const ColonTestScene scene(
    { { Tube(At(-28, 0, 0), 2, 30, 18), 4.0, 700.0 }, { bowel, -1e9, 650.0 }, { pool, 10.5, 270.0 } }, 75.0);
  const auto image = shapeton::SampledImage(scene, { 116, 116, 76 }, { 1.4, 1.4, 1.4 });
  const auto lumen = Segment(image, "HFS");
  EXPECT_EQ(lumen.failure, "");
  EXPECT_LT(Compare(scene, lumen).leakMl, 0.2);
  EXPECT_EQ(LabelAt(lumen, At(28, 8, 0)), 1);
  EXPECT_EQ(LabelAt(lumen, At(34, 12, 0)), 2);
  EXPECT_EQ(LabelAt(lumen, At(-28, 10, 0)), 2);
}

/** With 2.8 mm voxels, the pool below is found for any subvoxel position of the level, even though an equally bright
 * bowel is connected to it through a barely visible 1 mm wall. */
TEST(ColonLumenSegmentation, APoolOfCoarseVoxelsIsFoundThoughABrightBowelHangsOnIt)
{
  for (const double level : { 3.0, 3.7, 4.4, 5.1 })
  {
    ColonTestScene scene = ColonAndBowel(At(0, 1, 0));
    scene.lumens[0].level = level;
    scene.lumens[1].depth = Tube(At(27.9, 8, 0), 2, 30, 10);
    const auto lumen = Segment(shapeton::SampledImage(scene, { 52, 52, 40 }, { 2.8, 2.8, 2.8 }), "HFS");
    ASSERT_EQ(lumen.failure, "") << level;
    const Overlap overlap = Compare(scene, lumen);
    EXPECT_GT(overlap.dice, 0.96) << level;
    EXPECT_LT(overlap.leakMl, 1.0) << level;
  }
}

/** Beside bright fluid, a fainter layer of 5 mm fades into tissue or is the rim of a brighter bowel. */
double
TakenOfLayer(double behind)
{
  const auto colon = Tube(At(0, 0, 0), 2, 25, 18);
  const auto beside = Tube(At(22, 8, 0), 2, 25, 12);
  const auto part = [=](double from, double to) {
    return [=](const Vec & x) { return std::min({ beside(x), x[0] - from, to - x[0] }); };
  };
  const ColonTestScene scene({ { [=](const Vec & x) { return std::min(colon(x), 14.0 - x[0]); }, 4.0, 1000.0 },
                               { part(14.0, 19.0), -1e9, 300.0 },
                               { part(19.0, 40.0), -1e9, behind } });
  const auto           lumen = Segment(shapeton::SampledImage(scene, { 140, 140, 80 }, { 1.0, 1.0, 1.0 }), "HFS");
  EXPECT_EQ(lumen.failure, "");
  return Compare(scene, lumen).leakMl;
}

TEST(ColonLumenSegmentation, AFaintLayerIsFluidUnlessItIsTheRimOfABrighterBowel)
{
  EXPECT_GT(TakenOfLayer(50.0), 2.0);
  EXPECT_LT(TakenOfLayer(450.0), 0.1);
}

TEST(ColonLumenSegmentation, GravityIsReadFromTheLevels)
{
  for (const Vec & gravity : { At(0, 1, 0), At(0, -1, 0), At(1, 0, 0), At(-1, 0, 0) })
  {
    const auto scene = ColonAndBowel(gravity);
    const auto lumen = Segment(Coarse(scene));
    EXPECT_EQ(lumen.gravitySource, shapeton::ColonGravitySource::Levels);
    EXPECT_EQ(lumen.gravity, gravity);
    EXPECT_GT(Compare(scene, lumen).dice, 0.97);
  }
}

TEST(ColonLumenSegmentation, TheGivenPositionWinsAndTheContradictionIsToldOf)
{
  const auto lumen = Segment(Coarse(ColonAndBowel(At(0, 1, 0))), "prone");
  EXPECT_EQ(lumen.gravity, At(0, -1, 0));
  ASSERT_EQ(lumen.warnings.size(), 1U);
  EXPECT_NE(lumen.warnings[0].find("indicate supine"), std::string::npos);
}

TEST(ColonLumenSegmentation, ObliqueAnisotropicAndPermutedAxes)
{
  const auto scene = ColonAndBowel(At(0, 1, 0));
  // Index axes: z, x, y of the patient, turned by 20 and 7 degrees; left-handed.
  itk::Matrix<double, 3, 3> permuted;
  permuted.Fill(0.0);
  permuted(2, 0) = permuted(0, 1) = 1.0;
  permuted(1, 2) = -1.0;
  const auto image = shapeton::SampledImage(scene, { 56, 130, 110 }, { 2.0, 1.1, 1.3 }, Oblique(20, 7) * permuted);
  const auto lumen = Segment(image, "FFS");
  EXPECT_EQ(lumen.failure, "");
  const auto overlap = Compare(scene, lumen);
  EXPECT_GT(overlap.dice, 0.97);
  EXPECT_LT(overlap.leakMl, 0.2);
  EXPECT_LT(overlap.wrongKindMl, 0.05);
}

TEST(ColonLumenSegmentation, SameBytesForAnyNumberOfThreads)
{
  const auto image = Coarse(ColonAndBowel(At(0, 1, 0)));
  basetest::ExpectSameWithAnyThreads(
    [&] {
      const auto lumen = Segment(image, "HFS");
      return std::make_tuple(basetest::BytesOf(lumen.labels), lumen.thresholds.fluid, lumen.noise);
    },
    { 5 });
}

TEST(ColonLumenSegmentation, ASeedPointTakesAPieceThatIsTooThin)
{
  const auto image = Coarse(
    ColonTestScene({ { Tube(At(-25, 0, 0), 2, 30, 18), 1e9, 0.0 }, { Tube(At(25, 0, 0), 2, 20, 6), 1e9, 0.0 } }));
  shapeton::ColonLumenSettings options;
  EXPECT_EQ(shapeton::SegmentColonLumen(image, options).pieces.size(), 1U);
  options.seedPoint.emplace_back(At(25, 1, -3).GetDataPointer());
  EXPECT_EQ(shapeton::SegmentColonLumen(image, options).pieces.size(), 2U);
  options.seedPoint[0][1] = 30.0; // soft tissue
  EXPECT_THROW(shapeton::SegmentColonLumen(image, options), shapeton::ParameterError);
  options.seedPoint[0][1] = 3000.0;
  EXPECT_THROW(shapeton::SegmentColonLumen(image, options), shapeton::ParameterError);
}

TEST(ColonLumenSegmentation, FluidWithoutGasIsColonWhereItIsWiderThanSmallBowel)
{
  ColonTestScene scene(
    { { Tube(At(-30, -20, 0), 2, 40, 18), -16.0, 700.0 }, { Tube(At(25, 30, 0), 2, 45, 16), -1e9, 700.0 } });
  const auto image = shapeton::SampledImage(scene, { 100, 100, 90 }, { 1.5, 1.5, 1.5 });
  const auto wide = Segment(image, "HFS");
  EXPECT_EQ(wide.pieces.size(), 2U);
  ASSERT_EQ(wide.warnings.size(), 1U);
  EXPECT_NE(wide.warnings[0].find("tagged fluid without gas"), std::string::npos) << wide.warnings[0];
  scene.lumens[1].depth = Tube(At(25, 30, 0), 2, 200, 16); // cut by the image border at both ends
  scene.Sample(image);
  EXPECT_EQ(Segment(image, "HFS").pieces.size(), 2U);
  scene.lumens[1].depth = Tube(At(25, 30, 0), 2, 45, 11);
  scene.Sample(image);
  const auto narrow = Segment(image, "HFS");
  EXPECT_EQ(narrow.pieces.size(), 1U);
  EXPECT_TRUE(narrow.warnings.empty());
}

/** Two half-filled loops of colon, and a narrow fluid-filled bowel between them; one opening connects it to the left
 * loop and, if `isOpenRight`, another one to the right loop. */
TEST(ColonLumenSegmentation, FluidBetweenTwoPiecesOfColonIsColonIfItIsOpenToBoth)
{
  for (const bool isOpenRight : { true, false })
  {
    const auto   bowel = Tube(At(0, 12, 0), 0, 12, 7);
    const double right = isOpenRight ? 28.0 : 0.0;
    const auto   slit = [=](const Vec & x) {
      return std::min({ 1.7 - std::abs(x[1] - 12.0), 5.0 - std::abs(x[2]), right - x[0], 28.0 + x[0] });
    };
    const ColonTestScene scene({ { Tube(At(-40, 0, 0), 2, 30, 18), 4.0, 700.0 },
                                 { Tube(At(40, 0, 0), 2, 30, 18), 4.0, 700.0 },
                                 { [=](const Vec & x) { return std::max(bowel(x), slit(x)); }, -1e9, 700.0 } },
                               75.0);
    const auto           lumen = Segment(shapeton::SampledImage(scene, { 108, 108, 76 }, { 1.5, 1.5, 1.5 }), "HFS");
    EXPECT_EQ(LabelAt(lumen, At(0, 12, 0)), isOpenRight ? 2 : 0);
    EXPECT_EQ(LabelAt(lumen, At(12, 12, 4)), isOpenRight ? 2 : 0);
    EXPECT_EQ(lumen.pieces.size(), isOpenRight ? 1U : 2U);
  }
}

/** A loop of colon whose gas and fluid meet in a plane with a slope of 0.25, or are separated by a wall `wall` mm
 * thick. */
TEST(ColonLumenSegmentation, ATiltedLevelIsALevelUnlessAWallIsInBetween)
{
  for (const double wall : { 0.0, 3.0 })
  {
    const auto           tube = Tube(At(36, 0, 0), 2, 30, 16);
    const auto           below = [](const Vec & x) { return x[1] - 2.0 - 0.25 * x[2]; };
    const ColonTestScene scene({ { Tube(At(-36, 0, 0), 2, 30, 18), 4.0, 700.0 },
                                 { [=](const Vec & x) { return std::min(tube(x), -below(x)); } },
                                 { [=](const Vec & x) { return std::min(tube(x), below(x) - wall); }, -1e9, 700.0 } },
                               75.0);
    const auto           lumen = Segment(shapeton::SampledImage(scene, { 108, 108, 76 }, { 1.5, 1.5, 1.5 }), "HFS");
    EXPECT_EQ(LabelAt(lumen, At(36, -6, 0)), 1);
    EXPECT_EQ(LabelAt(lumen, At(36, 10, 0)), wall > 0.0 ? 0 : 2);
    EXPECT_EQ(LabelAt(lumen, At(36, 12, 18)), wall > 0.0 ? 0 : 2);
  }
}

/** Half-filled ascending and descending colon, and another bowel, which is a longitudinal tube filled with fluid below
 * `level`. */
shapeton::ColonLumen
SegmentWithBowel(const Vec & middle, double halfLength, double radius, double level)
{
  const ColonTestScene scene({ { Tube(At(-36, 0, 40), 2, 30, 18), 4.0, 700.0 },
                               { Tube(At(36, 0, 40), 2, 30, 18), 4.0, 700.0 },
                               { Tube(middle, 2, halfLength, radius), level, 700.0 } });
  return Segment(shapeton::SampledImage(scene, { 88, 88, 124 }, { 1.5, 1.5, 1.5 }), "HFS");
}

TEST(ColonLumenSegmentation, BowelAtThePlaceOfTheRectumIsTakenThoughItIsThin)
{
  struct Bowel
  {
    double level;
    double radius;
    double tooThin;
  };
  const Bowel fullOfFluid{ -1e9, 11.0, 8.0 };
  const Bowel halfFull{ 30.0, 9.0, 6.0 };
  for (const auto & [level, radius, tooThin] : { fullOfFluid, halfFull })
  {
    const auto rectum = SegmentWithBowel(At(0, 30, -40), 34.0, radius, level);
    EXPECT_EQ(rectum.pieces.size(), 3U) << level;
    ASSERT_EQ(rectum.warnings.size(), 1U) << level;
    EXPECT_NE(rectum.warnings[0].find("classified as rectum or sigmoid"), std::string::npos) << rectum.warnings[0];
    const auto beside = SegmentWithBowel(At(0, 30, 50), 34.0, radius, level); // as close to the anus as the colon
    EXPECT_EQ(beside.pieces.size(), 2U) << level;
    EXPECT_TRUE(beside.warnings.empty()) << level;
    const auto thin = SegmentWithBowel(At(0, 30, -40), 34.0, tooThin, level);
    EXPECT_EQ(thin.pieces.size(), 2U) << level;
  }
}

/** Volume of the labeled voxels with low <= z < high, ml. */
double
LabeledMl(const shapeton::ColonLumen & lumen, double low, double high)
{
  const auto  spacing = lumen.labels->GetSpacing();
  std::size_t count = 0;
  basetest::ForVoxels(lumen.labels, [&](const auto & index, const auto & x) {
    count += lumen.labels->GetPixel(index) != 0 && x[2] >= low && x[2] < high;
  });
  return 1e-3 * spacing[0] * spacing[1] * spacing[2] * static_cast<double>(count);
}

/** The rectum ends at z = -18, the body at z = -45; a catheter with a radius of 4 mm passes through both and through
 * the canal between them. */
TEST(ColonLumenSegmentation, TheCatheterIsLumenDownToTheAnalVerge)
{
  const ColonTestScene scene({ { Tube(At(0, 2, -30), 2, 50, 3), 1e9, 0.0 },
                               { Tube(At(0, 2, -30), 2, 50, 4), -1e9, 280.0 },
                               { Tube(At(0, 0, 25), 2, 25, 18), 1e9, 0.0 },
                               { [](const Vec & x) { return -45.0 - x[2]; }, 1e9, 0.0 } });
  for (const double turn : { 0.0, 180.0 }) // about x: the slices run upwards and downwards
  {
    const auto image = shapeton::SampledImage(scene, { 110, 110, 96 }, { 1.3, 1.3, 1.3 }, Oblique(0.0, turn));
    const auto lumen = Segment(image);
    EXPECT_EQ(lumen.failure, "");
    const double canalMl = 1e-3 * 3.14159265 * 16.0 * 22.0;
    EXPECT_NEAR(LabeledMl(lumen, -42.0, -20.0), canalMl, 0.25 * canalMl) << turn;
    EXPECT_EQ(LabeledMl(lumen, -100.0, -48.0), 0.0) << turn;
  }
}

/** A cleft on a cushion: room air, shell, air, shell, air. */
TEST(ColonLumenSegmentation, AirThatOnlyThinShellsCoverIsOutside)
{
  const auto slab = [](double front, double back) {
    return [=](const Vec & x) {
      return std::min({ 14.0 - std::abs(x[0]), 40.0 - std::abs(x[2]), x[1] - front, back - x[1] });
    };
  };
  ColonTestScene scene(
    { { Tube(At(0, -20, 0), 2, 30, 18), 1e9, 0.0 }, { slab(20, 46), 1e9, 0.0 }, { slab(50, 60), 1e9, 0.0 } });
  EXPECT_EQ(Segment(Coarse(scene, 60)).pieces.size(), 1U);
  scene.lumens.pop_back(); // without the cushion, the wall is 18 mm thick
  EXPECT_EQ(Segment(Coarse(scene, 60)).pieces.size(), 2U);
}

TEST(ColonLumenSegmentation, LargeLevelsOverruleTheCodeOfAHeader)
{
  const ColonTestScene scene({ { Tube(At(-80, 0, 0), 2, 55, 32), 4.0, 500.0 },
                               { Tube(At(0, 0, 0), 2, 55, 32), 4.0, 500.0 },
                               { Tube(At(80, 0, 0), 2, 55, 32), 4.0, 500.0 } },
                             140.0);
  const auto           image = shapeton::SampledImage(scene, { 150, 150, 72 }, { 2.0, 2.0, 2.0 });
  const auto           lumen = Segment(image, "HFP");
  EXPECT_EQ(lumen.gravity, At(0, 1, 0));
  EXPECT_EQ(lumen.gravitySource, shapeton::ColonGravitySource::Levels);
  ASSERT_EQ(lumen.warnings.size(), 1U);
  EXPECT_NE(lumen.warnings[0].find("\"HFP\" contradicts"), std::string::npos);
  EXPECT_NE(lumen.warnings[0].find("supine was used"), std::string::npos);
  EXPECT_EQ(Segment(image, "prone").gravity, At(0, -1, 0));
}

/** At the caudal border, gas over fluid is elongated sideways, the natal cleft is oriented from front to back, and a
 * strip of air next to the table extends to the side of the image. */
TEST(ColonLumenSegmentation, AFlatLumenThatTheCaudalBorderCutsIsNoCleft)
{
  const auto flat = [](double across, double deep, double middle) {
    return [=](const Vec & x) {
      return std::min({ across - std::abs(x[0] - middle), deep - std::abs(x[1] - 25.0), -x[2] });
    };
  };
  const auto pieces = [&](double across, double deep, double middle) {
    const ColonTestScene scene(
      { { Tube(At(0, -30, 20), 2, 30, 18), 1e9, 0.0 }, { flat(across, deep, middle), 1e9, 0.0 } },
      90.0); // only the corners of the image are room air
    return Segment(Coarse(scene, 60)).pieces.size();
  };
  EXPECT_EQ(pieces(30.0, 12.0, 0.0), 2U);
  EXPECT_EQ(pieces(12.0, 30.0, 0.0), 1U);
  EXPECT_EQ(pieces(30.0, 12.0, 45.0), 1U);
}

/** The field of view is small: the front border cuts the body, and the back border is in room air. */
TEST(ColonLumenSegmentation, ABorderThatCutsTheBodyIsNoThinShell)
{
  const ColonTestScene scene({ { Tube(At(0, -25, 0), 2, 30, 15), 1e9, 0.0 } });
  for (const int width : { 46, 70 }) // the wider one shows air on both sides of the body
  {
    const auto image = shapeton::CenteredImage({ width, 60, 50 }, { 2.0, 2.0, 2.0 }, Oblique(0.0, 0.0));
    auto       origin = image->GetOrigin();
    origin[1] += 15.0; // from 5 mm before the gas to 10 mm behind the body
    image->SetOrigin(origin);
    scene.Sample(image);
    const auto lumen = Segment(image);
    EXPECT_EQ(lumen.failure, "") << width;
    EXPECT_EQ(lumen.pieces.size(), 1U) << width;
  }
}

TEST(ColonLumenSegmentation, UntaggedFluidIsNoLumen)
{
  const auto lumen = Segment(Coarse(ColonTestScene({ { Tube(At(0, 0, 0), 2, 30, 18), 4.0, 20.0 } })));
  EXPECT_FALSE(lumen.isTagged);
  EXPECT_EQ(lumen.gravitySource, shapeton::ColonGravitySource::Levels);
  ASSERT_EQ(lumen.pieces.size(), 1U);
  EXPECT_EQ(lumen.pieces[0].fluidMl, 0.0);
}

TEST(ColonLumenSegmentation, ABodyWithoutGasHasNoColon)
{
  EXPECT_EQ(Segment(Coarse(ColonTestScene(), 40)).failure.find("no colon found"), 0U);
}

TEST(ColonLumenSegmentation, ThinGasIsNoDistendedColon)
{
  const auto lumen = Segment(Coarse(ColonTestScene({ { Tube(At(0, 0, 0), 2, 30, 7), 1e9, 0.0 } })));
  EXPECT_EQ(lumen.failure.find("the colon is not distended or tagged enough"), 0U);
  ASSERT_FALSE(lumen.leftOut.empty());
  EXPECT_NEAR(lumen.leftOut[0].inscribedRadius, 7.0, 2.0);
}

/** Two lungs: parenchyma of the given HU, and vessels with a radius of 2 mm, 15 mm apart. */
ColonTestScene
Lungs(double parenchyma, bool hasVessels)
{
  ColonTestScene scene({ { Tube(At(-40, 0, 0), 2, 40, 32), 1e9, 0.0, parenchyma },
                         { Tube(At(40, 0, 0), 2, 40, 32), 1e9, 0.0, parenchyma } },
                       90.0);
  if (hasVessels)
  {
    scene.fold = [](const itk::Vector<double, 3> & x) {
      const double u = std::remainder(x[0] + 0.3 * x[2], 15.0);
      const double v = std::remainder(x[1] - 0.2 * x[2], 15.0);
      return 2.0 - std::hypot(u, v);
    };
  }
  return scene;
}

ImageType::Pointer
Chest(const ColonTestScene & scene)
{
  return shapeton::SampledImage(scene, { 100, 100, 60 }, { 2.0, 2.0, 2.5 });
}

TEST(ColonLumenSegmentation, LungOfAnyDensityIsNotColon)
{
  for (const double parenchyma : { -720.0, -810.0, -870.0, -945.0 })
  {
    const auto lumen = Segment(Chest(Lungs(parenchyma, true)));
    EXPECT_NE(lumen.failure, "") << parenchyma;
    if (parenchyma < -790.0) // denser lung is above the gas threshold
    {
      EXPECT_EQ(lumen.failure.find("no distended colon found: the largest gas is lung"), 0U) << lumen.failure;
    }
  }
}

TEST(ColonLumenSegmentation, GasIsColonWhereItHasTheDensityOfAirAndHoldsNoVessels)
{
  EXPECT_EQ(Segment(Chest(Lungs(-1000.0, false))).failure, "");
  EXPECT_EQ(Segment(Chest(Lungs(-960.0, false))).failure, ""); // typical of beam hardening
}

TEST(ColonLumenSegmentation, ColonBesideLungIsFound)
{
  ColonTestScene scene = Lungs(-870.0, true);
  scene.lumens[0].gas = -1000.0;
  const auto vessels = scene.fold;
  scene.fold = [vessels](const itk::Vector<double, 3> & x) { return x[0] > 0.0 ? vessels(x) : -1.0; };
  const auto lumen = Segment(Chest(scene));
  EXPECT_EQ(lumen.failure, "");
  ASSERT_EQ(lumen.pieces.size(), 1U);
  EXPECT_LT(lumen.pieces[0].center[0], -35.0);
  ASSERT_FALSE(lumen.leftOut.empty());
  EXPECT_EQ(lumen.leftOut[0].what, "lung");
}

TEST(ColonLumenSegmentation, NoSeedPointAndNoMaskMakeLungColon)
{
  const auto                   image = Chest(Lungs(-870.0, true));
  shapeton::ColonLumenSettings options;
  options.seedPoint.emplace_back(At(-40, 7, 0).GetDataPointer());
  EXPECT_THROW(shapeton::SegmentColonLumen(image, options), shapeton::ParameterError);
  const auto mask = shapeton::NewImageOn<itk::Image<unsigned char, 3>>(image, true);
  const auto paint = [&](double below) {
    for (std::size_t i = 0; i < image->GetBufferedRegion().GetNumberOfPixels(); ++i)
    {
      const float hu = image->GetBufferPointer()[i];
      mask->GetBufferPointer()[i] = hu > -990.0F && hu < below;
    }
  };
  paint(-500.0);
  EXPECT_EQ(shapeton::FailureOfMask(image, mask).find("no distended colon found: the mask is lung"), 0U);
  const auto colon = Chest(Lungs(-985.0, false));
  EXPECT_EQ(shapeton::FailureOfMask(colon, mask), "");
}

TEST(ColonLumenSegmentation, FaultyOptionsAndImages)
{
  const auto image = shapeton::CenteredImage({ 72, 72, 7 }, { 2.0, 2.0, 2.0 }, Oblique(0.0, 0.0));
  image->Allocate(true);
  EXPECT_THROW(Segment(image), shapeton::InputError);
  const auto other = shapeton::CenteredImage({ 12, 12, 12 }, { 2.0, 2.0, 2.0 }, Oblique(0.0, 0.0));
  other->Allocate(true);
  EXPECT_THROW(Segment(other, "upright"), shapeton::ParameterError);
  EXPECT_EQ(Segment(other).failure.find("no colon found"), 0U);
}

/** Volumes in the folder SHAPETON_TEST_DATA_DIR. */
class ColonLumenOfRealData : public testing::Test
{
protected:
  void
  SetUp() override
  {
    const char * folder = std::getenv("SHAPETON_TEST_DATA_DIR");
    m_Folder = folder ? folder : "";
    if (m_Folder.empty())
    {
      GTEST_SKIP() << "SHAPETON_TEST_DATA_DIR is not set";
    }
  }

  shapeton::ColonLumen
  SegmentFile(const std::string & name) const
  {
    const shapeton::Volume volume = shapeton::ReadVolume(m_Folder + "/" + name);
    return Segment(volume.image, volume.patientPosition);
  }

  std::string m_Folder;
};

TEST_F(ColonLumenOfRealData, AnklesHoldNoColon)
{
  EXPECT_EQ(SegmentFile("ct/visible-female-ankle").failure.find("no colon found"), 0U);
}

TEST_F(ColonLumenOfRealData, AnUnpreparedColonIsRefused)
{
  const auto lumen = SegmentFile("ct/totalsegmentator/example_ct.nii.gz");
  EXPECT_EQ(lumen.failure.find("the colon is not distended or tagged enough"), 0U);
  EXPECT_FALSE(lumen.pieces.empty());
}

TEST_F(ColonLumenOfRealData, ACropOfARealColonographyIsUsable)
{
  std::ifstream      file(m_Folder + "/ctc/colonography-crop-1.npy", std::ios::binary);
  std::vector<short> values(1000000); // behind a NumPy header of 128 bytes
  ASSERT_TRUE(file.seekg(128).read(reinterpret_cast<char *>(values.data()), 2000000));
  const auto image = ImageType::New();
  image->SetRegions(ImageType::SizeType::Filled(100));
  image->Allocate();
  std::copy(values.begin(), values.end(), image->GetBufferPointer());
  const auto lumen = Segment(image);
  EXPECT_EQ(lumen.failure, "");
  ASSERT_FALSE(lumen.pieces.empty());
  EXPECT_NEAR(lumen.pieces[0].gasMl, 198.0, 4.0);
}
} // namespace
