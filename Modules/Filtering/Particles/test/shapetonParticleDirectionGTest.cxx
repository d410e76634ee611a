#include "shapetonParticleDirection.h"
#include "shapetonParticleTestTools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

using namespace shapeton;
using namespace shapeton::test;

namespace
{
using Triple = std::array<double, 3>;

/** Various weights: random, zero, small, and of very different size. */
std::vector<Triple>
MakeWeights(int number)
{
  std::vector<Triple> all = {
    { 1, 1, 1 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 0 }, { 1, 0, 1 }, { 0, 1, 1 }
  };
  RandomNumbers random(7);
  for (int i = 0; i < number; ++i)
  {
    Triple weights{ random.Next(), random.Next(), random.Next() };
    for (double & weight : weights)
    {
      const double kind = random.Next();
      weight *= kind < 0.15 ? 0.0 : kind < 0.3 ? 1e-6 : kind < 0.4 ? 1e-3 : 1.0;
    }
    all.push_back(weights);
  }
  return all;
}

/** (8.3) and (8.4). */
double
Radius(const Triple & w, double theta, double phi)
{
  const double across = w[1] * (1.0 - phi / halfPi) + w[2] * phi / halfPi;
  return w[0] * (1.0 - theta / halfPi) + across * theta / halfPi;
}

double
VolumeByQuadrature(const Triple & w, double phi)
{
  return Gauss()(0.0, phi, [&](double f) {
    return Gauss()(0.0, halfPi, [&](double theta) { return std::pow(Radius(w, theta, f), 3) / 3.0 * std::sin(theta); });
  });
}

/** The published formula. */
double
Equation85(double w1, double w2, double w3, double phi)
{
  const double p2 = pi * pi, p3 = p2 * pi, p4 = p3 * pi, p5 = p4 * pi, p6 = p5 * pi;
  const double w11 = w1 * w1, w22 = w2 * w2, w33 = w3 * w3, w111 = w11 * w1, w222 = w22 * w2, w333 = w33 * w3;
  const double a = -(1.0 / 12.0) *
                   (384 * w333 + 1152 * w22 * w3 - 144 * w22 * p2 * w3 + 144 * w2 * p2 * w33 + 48 * w222 * p2 -
                    48 * w333 * p2 - 1152 * w2 * w33 - 384 * w222) /
                   p6;
  const double b = -(1.0 / 9.0) *
                   (576 * w2 * pi * w33 - 192 * w1 * p2 * w2 * w3 + 144 * w22 * p3 * w3 - 576 * w1 * pi * w33 -
                    48 * w1 * p3 * w2 * w3 - 72 * w222 * p3 + 24 * w1 * p3 * w33 + 96 * w1 * p2 * w22 -
                    1152 * w22 * pi * w3 - 576 * w1 * pi * w22 + 24 * w1 * p3 * w22 + 576 * w222 * pi -
                    72 * w2 * p3 * w33 + 96 * w1 * p2 * w33 + 1152 * w1 * pi * w2 * w3) /
                   p6;
  const double c =
    -(1.0 / 6.0) *
    (96 * w1 * p3 * w2 * w3 - 96 * w1 * p3 * w22 + 24 * w1 * p4 * w2 * w3 + 96 * w11 * p3 * w2 -
     576 * w1 * p2 * w2 * w3 + 36 * w222 * p4 - 288 * w11 * p2 * w2 - 36 * w22 * p4 * w3 - 24 * w1 * p4 * w22 -
     288 * w222 * p2 - 96 * w11 * p3 * w3 + 288 * w22 * p2 * w3 + 576 * w1 * p2 * w22 + 288 * w11 * p2 * w3) /
    p6;
  const double d = -(1.0 / 3.0) *
                   (144 * w11 * p3 * w2 + 48 * w222 * p3 + 24 * w111 * p4 - 48 * w111 * p3 - w111 * p6 -
                    48 * w11 * p4 * w2 - 6 * w222 * p5 + 6 * w1 * p5 * w22 + 24 * w1 * p4 * w22 - 144 * w1 * p3 * w22) /
                   p6;
  return (((a * phi + b) * phi + c) * phi + d) * phi;
}

/** The published formula. */
double
Equation86(double w1, double w2, double w3)
{
  const double p2 = pi * pi, p3 = p2 * pi;
  const double w11 = w1 * w1, w22 = w2 * w2, w33 = w3 * w3, w111 = w11 * w1, w222 = w22 * w2, w333 = w33 * w3;
  return (1.0 / 12.0) *
         (2 * w111 * p3 - 16 * w1 * pi * w22 + 48 * w11 * pi * w2 - 16 * w1 * pi * w33 - 48 * w111 * pi -
          16 * w1 * pi * w2 * w3 + 48 * w11 * pi * w3 - 24 * w2 * w33 - 4 * w1 * p2 * w22 + 3 * w22 * w3 * p2 +
          96 * w111 + 96 * w1 * w22 + 3 * w333 * p2 - 144 * w11 * w2 - 24 * w333 + 3 * w222 * p2 + 3 * w2 * w33 * p2 -
          144 * w3 * w11 - 24 * w22 * w3 + 96 * w1 * w33 - 4 * w3 * w1 * p2 * w2 - 24 * w222 + 96 * w1 * w2 * w3 -
          4 * w33 * w1 * p2) /
         p2;
}

/** The published formula. */
double
Equation87(double w1, double w2, double theta)
{
  return 2.0 / (3.0 * pi * pi) * (w2 - w1) * (w2 - w1) * std::pow(theta, 3) + w1 * (w2 - w1) * theta * theta / pi +
         0.5 * w1 * w1 * theta;
}

/** Mean and mean squared components of sampled directions. */
struct Moments
{
  Triple first{};
  Triple second{};
};

Moments
DrawMany(const EdgeWeights & weights, DirectionSampling sampling, int number)
{
  RandomNumbers random(11);
  Moments       moments;
  for (int i = 0; i < number; ++i)
  {
    const Triple numbers{ random.Next(), random.Next(), random.Next() };
    const Triple direction = DrawDirection(weights, sampling, numbers);
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      moments.first[axis] += direction[axis] / number;
      moments.second[axis] += direction[axis] * direction[axis] / number;
    }
  }
  return moments;
}

/** The mean component along x of directions with density R^3. */
double
MeanAlongX(const EdgeWeights & w)
{
  double sum = 0.0;
  double whole = 0.0;
  for (unsigned int octant = 0; octant < 8; ++octant)
  {
    const Triple corner{ w[octant & 1], w[2 + (octant >> 1 & 1)], w[4 + (octant >> 2)] };
    const double sign = octant & 1 ? 1.0 : -1.0;
    whole += VolumeByQuadrature(corner, halfPi);
    sum += sign * Gauss()(0.0, halfPi, [&](double phi) {
             return Gauss()(0.0, halfPi, [&](double theta) {
               return std::pow(Radius(corner, theta, phi), 3) / 3.0 * std::sin(theta) * std::cos(theta);
             });
           });
  }
  return sum / whole;
}
} // namespace

TEST(ParticleDirection, VolumesEqualQuadrature)
{
  RandomNumbers random(1);
  for (const Triple & w : MakeWeights(400))
  {
    const double whole = VolumeByQuadrature(w, halfPi);
    const double phi = random.Next() * halfPi;
    EXPECT_NEAR(OctantVolume(w[0], w[1], w[2]), whole, 1e-12 * whole);
    EXPECT_NEAR(PartialOctantVolume(w[0], w[1], w[2], phi), VolumeByQuadrature(w, phi), 1e-12 * whole);
    EXPECT_EQ(PartialOctantVolume(w[0], w[1], w[2], 0.0), 0.0);
  }
  EXPECT_NEAR(OctantVolume(1.0, 1.0, 1.0), pi / 6.0, 1e-15);
}

TEST(ParticleDirection, SectorsEqualQuadrature)
{
  RandomNumbers random(2);
  for (const Triple & w : MakeWeights(400))
  {
    const Triple flat{ w[0], w[1], w[1] };
    const auto   area = [&](double theta) { return 0.5 * std::pow(Radius(flat, theta, 0.0), 2); };
    const auto   volume = [&](double theta) { return std::pow(Radius(flat, theta, 0.0), 3) / 3.0 * std::sin(theta); };
    for (const double theta : { random.Next() * halfPi, 0.01 * random.Next(), halfPi })
    {
      EXPECT_NEAR(SectorArea(w[0], w[1], theta), Gauss()(0.0, theta, area), 1e-12 * Gauss()(0.0, halfPi, area));
      EXPECT_NEAR(SectorVolume(w[0], w[1], theta), Gauss()(0.0, theta, volume), 1e-12 * Gauss()(0.0, halfPi, volume));
    }
  }
}

TEST(ParticleDirection, VolumesAndAreasEqualThePrintedEquations)
{
  // Cancellation error of the printed formulas: up to 8e-16 of volumes up to 0.5, for any weights.
  RandomNumbers random(3);
  for (const Triple & w : MakeWeights(2000))
  {
    const double angle = random.Next() * halfPi;
    EXPECT_NEAR(PartialOctantVolume(w[0], w[1], w[2], angle), Equation85(w[0], w[1], w[2], angle), 1e-15);
    EXPECT_NEAR(OctantVolume(w[0], w[1], w[2]), Equation86(w[0], w[1], w[2]), 1e-15);
    EXPECT_NEAR(SectorArea(w[0], w[1], angle), Equation87(w[0], w[1], angle), 1e-15);
  }
}

TEST(ParticleDirection, InversesGiveBackTheVolumeOrArea)
{
  RandomNumbers random(4);
  for (const Triple & w : MakeWeights(3000))
  {
    const double octant = OctantVolume(w[0], w[1], w[2]);
    const double area = SectorArea(w[0], w[1], halfPi);
    const double sector = SectorVolume(w[0], w[1], halfPi);
    for (const double share : { random.Next(), 1e-9 * random.Next(), 1.0 - 1e-9 * random.Next(), 0.0, 1.0 })
    {
      const double phi = PhiOfPartialVolume(w[0], w[1], w[2], share * octant);
      const double byArea = ThetaOfSectorArea(w[0], w[1], share * area);
      const double byVolume = ThetaOfSectorVolume(w[0], w[1], share * sector);
      for (const double angle : { phi, byArea, byVolume })
      {
        EXPECT_GE(angle, 0.0);
        EXPECT_LE(angle, halfPi);
      }
      EXPECT_NEAR(PartialOctantVolume(w[0], w[1], w[2], phi), share * octant, 1e-12 * octant);
      EXPECT_NEAR(SectorArea(w[0], w[1], byArea), share * area, 1e-12 * area);
      EXPECT_NEAR(SectorVolume(w[0], w[1], byVolume), share * sector, 1e-12 * sector);
    }
  }
}

TEST(ParticleDirection, InversesOfTheEndsAreTheEnds)
{
  for (const Triple & w : MakeWeights(200))
  {
    if (OctantVolume(w[0], w[1], w[2]) > 0.0)
    {
      EXPECT_EQ(PhiOfPartialVolume(w[0], w[1], w[2], 0.0), 0.0);
      EXPECT_EQ(PhiOfPartialVolume(w[0], w[1], w[2], OctantVolume(w[0], w[1], w[2])), halfPi);
      EXPECT_EQ(PhiOfPartialVolume(w[0], w[1], w[2], 1e9), halfPi);
      EXPECT_EQ(PhiOfPartialVolume(w[0], w[1], w[2], -1.0), 0.0);
    }
    if (w[0] + w[1] > 0.0)
    {
      EXPECT_EQ(ThetaOfSectorArea(w[0], w[1], 0.0), 0.0);
      EXPECT_NEAR(ThetaOfSectorArea(w[0], w[1], 1e9), halfPi, 1e-15);
      EXPECT_EQ(ThetaOfSectorVolume(w[0], w[1], 0.0), 0.0);
      EXPECT_EQ(ThetaOfSectorVolume(w[0], w[1], 1e9), halfPi);
    }
  }
  EXPECT_EQ(PhiOfPartialVolume(0.0, 0.0, 0.0, 0.5), 0.25 * pi);
  EXPECT_EQ(ThetaOfSectorArea(0.0, 0.0, 0.5), 0.25 * pi);
  EXPECT_EQ(ThetaOfSectorVolume(0.0, 0.0, 0.5), 0.25 * pi);
}

TEST(ParticleDirection, InversesRise)
{
  for (const Triple & w : MakeWeights(60))
  {
    const double octant = OctantVolume(w[0], w[1], w[2]);
    const double area = SectorArea(w[0], w[1], halfPi);
    const double sector = SectorVolume(w[0], w[1], halfPi);
    Triple       last{};
    for (int i = 0; i <= 500; ++i)
    {
      const Triple angles{ PhiOfPartialVolume(w[0], w[1], w[2], octant * i / 500.0),
                           ThetaOfSectorArea(w[0], w[1], area * i / 500.0),
                           ThetaOfSectorVolume(w[0], w[1], sector * i / 500.0) };
      for (unsigned int k = 0; k < 3; ++k)
      {
        EXPECT_GE(angles[k], last[k]);
      }
      last = angles;
    }
  }
}

TEST(ParticleDirection, SixEqualWeightsGiveTheUniformDistributionBySolidAngle)
{
  for (const double weight : { 1.0, 1e-6 })
  {
    const EdgeWeights weights{ weight, weight, weight, weight, weight, weight };
    for (const DirectionSampling sampling : { DirectionSampling::SolidAngle, DirectionSampling::Uniform })
    {
      const Moments moments = DrawMany(weights, sampling, 400000);
      for (unsigned int axis = 0; axis < 3; ++axis)
      {
        EXPECT_NEAR(moments.second[axis], 1.0 / 3.0, 0.003);
        EXPECT_NEAR(moments.first[axis], 0.0, 0.005);
      }
    }
  }
}

TEST(ParticleDirection, SixEqualWeightsFavorTheFirstAxisBySectorArea)
{
  const Moments moments = DrawMany({ 1, 1, 1, 1, 1, 1 }, DirectionSampling::SectorArea, 400000);
  EXPECT_NEAR(moments.second[0], 0.50, 0.003);
  EXPECT_NEAR(moments.second[1], 0.25, 0.003);
  EXPECT_NEAR(moments.second[2], 0.25, 0.003);
}

TEST(ParticleDirection, OneDominantFaceDrawsTheDirections)
{
  const EdgeWeights weights{ 0.05, 1.0, 0.05, 0.05, 0.05, 0.05 };
  const double      expected = MeanAlongX(weights);
  EXPECT_GT(expected, 0.75);
  const Moments moments = DrawMany(weights, DirectionSampling::SolidAngle, 400000);
  EXPECT_NEAR(moments.first[0], expected, 0.002);
  EXPECT_NEAR(moments.first[1], 0.0, 0.003);
  EXPECT_NEAR(moments.first[2], 0.0, 0.003);
  // The weights do not affect the uniform distribution.
  EXPECT_NEAR(DrawMany(weights, DirectionSampling::Uniform, 400000).first[0], 0.0, 0.005);
}

TEST(ParticleDirection, WithoutWeightsThereIsNoDirection)
{
  for (const auto sampling :
       { DirectionSampling::SolidAngle, DirectionSampling::SectorArea, DirectionSampling::Uniform })
  {
    EXPECT_EQ(DrawDirection({}, sampling, { 0.3, 0.6, 0.9 }), (Triple{ 0.0, 0.0, 0.0 }));
  }
}

TEST(ParticleDirection, DirectionsAreUnitVectors)
{
  RandomNumbers random(5);
  for (int i = 0; i < 20000; ++i)
  {
    EdgeWeights weights{};
    for (double & weight : weights)
    {
      weight = random.Next() < 0.3 ? 0.0 : random.Next();
    }
    weights[i % 6] = 1.0;
    const auto   sampling = i % 2 ? DirectionSampling::SolidAngle : DirectionSampling::SectorArea;
    const Triple d = DrawDirection(weights, sampling, { random.Next(), random.Next(), random.Next() });
    EXPECT_NEAR(d[0] * d[0] + d[1] * d[1] + d[2] * d[2], 1.0, 1e-14);
  }
}

TEST(ParticleDirection, AnOctantWithoutWeightsIsNeverDrawn)
{
  // Also with random numbers at the limits, where the sum of the volumes is rounded.
  RandomNumbers random(6);
  for (int i = 0; i < 40000; ++i)
  {
    const unsigned int empty = i % 8;
    EdgeWeights        weights{};
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      weights[2 * axis + 1 - (empty >> axis & 1)] = random.Next() < 0.2 ? 0.0 : random.Next();
    }
    weights[2 * (i % 3) + 1 - (empty >> (i % 3) & 1)] = 1.0;
    const double first = i % 5 == 0 ? 1.0 : i % 5 == 1 ? 0x1p-53 : random.Next();
    const auto   sampling = i % 2 ? DirectionSampling::SolidAngle : DirectionSampling::SectorArea;
    const Triple direction = DrawDirection(weights, sampling, { first, random.Next(), random.Next() });
    unsigned int octant = 0;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      octant |= std::signbit(direction[axis]) ? 0U : 1U << axis;
    }
    EXPECT_NE(octant, empty);
  }
}
