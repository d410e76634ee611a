#include "shapetonDiffusionTestVolumes.h"
#include "shapetonExceptions.h"
#include "shapetonHeatClassification.h"
#include "shapetonHeatParameterChoice.h"
#include "shapetonTestThreads.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <tuple>

using namespace shapeton;
using namespace shapeton::test;

namespace
{
/** A body in air that contains a ball and a box, with all edges blurred over `blur` voxels, and noise. */
struct Body
{
  Volume           volume;
  std::vector<int> labels; // 0 air, 1 body, 2 ball, 3 box

  Body(double blur, double noise, double scale = 1.0, double offset = 0.0)
    : volume({ 64, 64, 64 }), labels(volume.values.size())
  {
    std::size_t i = 0;
    volume.Fill([&](double x, double y, double z) {
      const auto largest = [](double a, double b, double c) {
        return std::max({ std::abs(a), std::abs(b), std::abs(c) });
      };
      const std::array<double, 3> distances = { std::hypot(x - 31.5, y - 31.5, z - 31.5) - 26.0,
                                                std::hypot(x - 22.0, y - 28.0, z - 32.0) - 7.0,
                                                largest(x - 42.0, y - 36.0, z - 32.0) - 6.5 };
      const std::array<double, 3> intensities = { 50.0, 100.0, 160.0 };
      double                      value = 0.0;
      labels[i] = 0;
      for (int k = 0; k < 3; ++k)
      {
        const double share = std::clamp(0.5 - distances[k] / blur, 0.0, 1.0);
        value += share * (intensities[k] - value);
        labels[i] = distances[k] < 0.0 ? k + 1 : labels[i];
      }
      value += noise * Noise(static_cast<std::size_t>(x), static_cast<std::size_t>(y), static_cast<std::size_t>(z));
      ++i;
      return offset + scale * value;
    });
  }
};

/** The smallest fraction, over all objects, of an object's voxels in its main class; 0 if two objects share a main
 * class. */
double
Separation(const Body & body, const CumulativeHeatDiffusionSettings & settings)
{
  CumulativeHeatDiffusionSettings wanted = settings;
  wanted.wantComponents = true;
  std::vector<float>                           heat(body.labels.size());
  const auto                                   result = DiffuseCumulativeHeat(body.volume, wanted, heat.data());
  std::map<int, std::map<std::size_t, double>> counts;
  for (std::size_t i = 0; i < heat.size(); ++i)
  {
    std::size_t label = result.classes.size() - 1;
    while (label > 0 && heat[i] < result.classes[label].lowerHeat)
    {
      --label;
    }
    counts[body.labels[i]][label] += 1.0;
  }
  std::map<std::size_t, int> owners;
  double                     least = 1.0;
  for (const auto & [object, classes] : counts)
  {
    double      all = 0.0;
    double      most = 0.0;
    std::size_t main = 0;
    for (const auto & [label, count] : classes)
    {
      all += count;
      main = count > most ? label : main;
      most = std::max(most, count);
    }
    least = std::min(least, owners.emplace(main, object).second ? most / all : 0.0);
  }
  return least;
}

CumulativeHeatDiffusionSettings
With(const HeatParameterChoice & choice)
{
  CumulativeHeatDiffusionSettings settings;
  choice.ApplyTo(settings);
  return settings;
}

HeatParameterChoice
Choose(const Volume & volume, const GivenHeatParameters & given = {}, const std::string & modality = "MR")
{
  VolumeView view(volume);
  view.modality = modality;
  return ChooseHeatParameters(view, {}, given);
}
} // namespace

TEST(HeatParameterChoice, SeparatesWhatThePublishedParametersMerge)
{
  for (const double noise : { 0.0, 20.0, 40.0 })
  {
    const Body body(3.0, noise);
    const auto choice = Choose(body.volume);
    // Half of the ball's voxels are blurred.
    EXPECT_GT(Separation(body, With(choice)), 0.5) << noise << ": p = " << choice.p << ", " << choice.timeSteps;
    EXPECT_LT(Separation(body, {}), 0.1) << noise; // blurred edges leak with p = 7
    EXPECT_GT(choice.regions, 1.5);
    EXPECT_EQ(choice.smoothing > 0.0, noise > 0.0);
    for (const auto & reason : { choice.windowReason, choice.pReason, choice.smoothingReason, choice.timeReason })
    {
      EXPECT_FALSE(reason.empty());
    }
  }
}

TEST(HeatParameterChoice, EmptyVolumesAndValuesThatAreNotFiniteAreRefused)
{
  for (const float wrong : { std::nanf(""), HUGE_VALF })
  {
    Volume volume({ 16, 16, 16 });
    volume.values[77] = wrong;
    EXPECT_THROW(ChooseHeatParameters(volume), InputError);
  }
  EXPECT_THROW(ChooseHeatParameters(VolumeView(itk::Image<float, 3>::New().GetPointer())), InputError);
}

TEST(HeatParameterChoice, WrongGivenValuesAreRefused)
{
  const auto expectRefused = [volume = Volume({ 16, 16, 16 })](const auto & spoil) {
    GivenHeatParameters given;
    spoil(given);
    EXPECT_THROW(ChooseHeatParameters(volume, {}, given), ParameterError);
  };
  expectRefused([](auto & given) { given.intensityWindow = { { 50.0, 20.0 } }; });
  expectRefused([](auto & given) { given.intensityWindow = { { std::nan(""), 20.0 } }; });
  expectRefused([](auto & given) { given.p = -1.0; });
  expectRefused([](auto & given) { given.smoothing = -1.0; });
  expectRefused([](auto & given) { given.timeSteps = 0; });
}

TEST(HeatParameterChoice, FollowsTheUnitOfIntensity)
{
  const auto one = Choose(Body(3.0, 20.0).volume);
  const auto ten = Choose(Body(3.0, 20.0, 10.0).volume);
  EXPECT_DOUBLE_EQ(ten.intensityWindow[0], 10.0 * one.intensityWindow[0]);
  EXPECT_DOUBLE_EQ(ten.intensityWindow[1], 10.0 * one.intensityWindow[1]);
  EXPECT_NEAR(ten.p, one.p, 0.011 * one.p); // rounded to three digits
  EXPECT_EQ(ten.timeSteps, one.timeSteps);
}

TEST(HeatParameterChoice, MeasuresNoiseWhereTheVolumeIsNotConstant)
{
  const Body body(4.0, 20.0);
  Volume     padded({ 96, 96, 96 });
  padded.Fill([&](double x, double y, double z) {
    const auto       voxel = static_cast<std::size_t>((z * 64.0 + y) * 64.0 + x);
    constexpr double padding = 70.0; // of 70 % of the volume
    return std::max({ x, y, z }) < 64.0 ? static_cast<double>(body.volume.values[voxel]) : padding;
  });
  EXPECT_GT(ChooseHeatParameters(body.volume).smoothing, 0.0);
  EXPECT_GT(ChooseHeatParameters(padded).smoothing, 0.0);
}

TEST(HeatParameterChoice, KeepsGivenValues)
{
  const Body          body(3.0, 20.0);
  GivenHeatParameters given;
  given.p = 9.0;
  given.timeSteps = 123;
  const auto both = Choose(body.volume, given); // p belongs to the whole range, as before
  EXPECT_EQ(both.p, 9.0);
  EXPECT_EQ(both.timeSteps, 123U);
  EXPECT_EQ(both.smoothing, 0.0);
  const auto ends = std::minmax_element(body.volume.values.begin(), body.volume.values.end());
  EXPECT_EQ(both.intensityWindow, (std::array<double, 2>{ { *ends.first, *ends.second } }));

  given.p.reset();
  given.intensityWindow = { { 20.0, 140.0 } };
  given.smoothing = 0.5;
  const auto others = Choose(body.volume, given);
  EXPECT_EQ(others.intensityWindow, *given.intensityWindow);
  EXPECT_EQ(others.smoothing, 0.5);
  EXPECT_EQ(others.timeSteps, 123U);
  EXPECT_TRUE(others.windowReason.empty());
  EXPECT_FALSE(others.pReason.empty());
}

TEST(HeatParameterChoice, UsesTheSoftTissueWindowForCtOnly)
{
  const std::array<double, 2> softTissue = { { -160.0, 240.0 } };
  const Body                  body(3.0, 20.0, 7.0, -1000.0); // air -1000, body -650: no tissue
  EXPECT_NE(Choose(body.volume, {}, "CT").intensityWindow, softTissue) << "nothing to see in it";
  Body patient(3.0, 20.0, 2.0, -100.0); // body 0, ball 100, box 220 HU
  for (std::size_t i = 0; i < patient.labels.size(); ++i)
  {
    patient.volume.values[i] = patient.labels[i] == 0 ? -1000.0F : patient.volume.values[i];
  }
  EXPECT_EQ(Choose(patient.volume, {}, "CT").intensityWindow, softTissue);
  EXPECT_EQ(Choose(patient.volume, {}, "").intensityWindow, softTissue);
  EXPECT_NE(Choose(patient.volume, {}, "MR").intensityWindow, softTissue);
}

TEST(HeatParameterChoice, IsTheSameForAnyNumberOfThreads)
{
  const Body body(3.0, 40.0);
  basetest::ExpectSameWithAnyThreads([&] {
    const auto choice = Choose(body.volume);
    return std::make_tuple(choice.regions, choice.p, choice.intensityWindow, choice.timeSteps);
  });
}

TEST(HeatParameterChoice, TakesAnyVolume)
{
  const auto constant = Choose(Volume({ 5, 4, 3 }, 2.0F));
  EXPECT_NE(constant.windowReason.find("constant"), std::string::npos);
  EXPECT_GE(constant.timeSteps, 1U);
  Volume pair({ 2, 1, 1 });
  pair.values = { 0.0F, 1.0F };
  EXPECT_GE(Choose(pair).p, 0.0);
}

TEST(ClassCoherence, OfACubeIsTheShareOfItsInnerFaces)
{
  constexpr std::size_t side = 10;
  Volume                volume({ 20, 20, 20 });
  volume.Fill([](std::size_t x, std::size_t y, std::size_t z) {
    return x >= 4 && x < 4 + side && y >= 4 && y < 4 + side && z >= 4 && z < 4 + side ? 1.0 : 0.0;
  });
  const VolumeGradientOperator volumeGradient(volume);
  std::vector<HeatClass>       classes(2);
  classes[1].label = 1;
  classes[1].lowerHeat = 0.5;
  classes[1].voxels = side * side * side;
  classes[0].voxels = volume.values.size() - classes[1].voxels;
  const double regions = MeasureCoherence(volumeGradient, volume.values.data(), classes); // heat = intensity
  EXPECT_NEAR(*classes[1].coherence, (side - 1.0) / side, 1e-12);
  const double outer = 2.0 * (3.0 * 20 * 20 * 19 - 3.0 * side * side * (side - 1) - 6.0 * side * side);
  EXPECT_NEAR(*classes[0].coherence, outer / (6.0 * classes[0].voxels), 1e-12);
  EXPECT_NEAR(regions, *classes[0].coherence + *classes[1].coherence, 1e-12);
}

TEST(ClassCoherence, CountsBandsAsOneRegionAndSpeckleAsNone)
{
  Volume flat({ 16, 16, 16 }, 3.0F);
  Volume heat({ 16, 16, 16 });
  heat.Fill([](std::size_t x, std::size_t, std::size_t) { return x < 8 ? 0.2 : 0.8; });
  std::vector<HeatClass> classes(2);
  classes[0].voxels = classes[1].voxels = heat.values.size() / 2;
  classes[1].label = 1;
  classes[1].lowerHeat = 0.5;
  const VolumeGradientOperator free(flat);
  EXPECT_LT(MeasureCoherence(free, heat.values.data(), classes), 1.0);

  Volume board({ 16, 16, 16 });
  board.Fill([](std::size_t x, std::size_t y, std::size_t z) { return (x + y + z) % 2; });
  const VolumeGradientOperator closed(board);
  EXPECT_EQ(MeasureCoherence(closed, board.values.data(), classes), 0.0);
}
