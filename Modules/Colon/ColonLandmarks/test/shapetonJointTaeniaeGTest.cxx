#include "shapetonTaeniaEvidence.h"

#include <gtest/gtest.h>

#include <random>

using shapeton::anglesAround;
using shapeton::EnergyOfTaeniae;
using shapeton::JointTaeniae;
using shapeton::TaeniaAngles;
using shapeton::TaeniaEvidence;
using shapeton::TaeniaTracks;

namespace
{
TaeniaEvidence
RandomEvidence(int rows, unsigned int seed)
{
  std::mt19937                          random(seed);
  std::uniform_real_distribution<float> cost(-1.0F, 1.0F);
  TaeniaEvidence                        evidence;
  evidence.rows = rows;
  for (int i = 0; i < rows * anglesAround; ++i)
  {
    evidence.cost.push_back(cost(random));
  }
  return evidence;
}

TaeniaEvidence
Mirrored(TaeniaEvidence evidence)
{
  for (int row = 0; row < evidence.rows; ++row)
  {
    std::reverse(&evidence.cost[row * anglesAround], &evidence.cost[row * anglesAround] + anglesAround);
  }
  for (shapeton::TaeniaMark & mark : evidence.marks)
  {
    mark.angle = 1.0 - mark.angle;
  }
  return evidence;
}

std::array<int, 3>
CellsOf(const TaeniaAngles & angles)
{
  std::array<int, 3> cells{};
  std::transform(angles.begin(), angles.end(), cells.begin(), TaeniaEvidence::CellOf);
  std::sort(cells.begin(), cells.end());
  return cells;
}

/** The three tracks are limited to these cells and their successors. */
constexpr std::array<int, 3> freeCells{ 5, 29, 50 };

bool
IsFree(int cell)
{
  return std::any_of(
    freeCells.begin(), freeCells.end(), [cell](int first) { return cell == first || cell == first + 1; });
}

/** Minimum energy over all tracks within the allowed cells. */
double
LeastEnergyOfAll(const TaeniaEvidence & evidence)
{
  double    least = std::numeric_limits<double>::infinity();
  const int all = 1 << 3 * evidence.rows;
  for (int choice = 0; choice < all; ++choice)
  {
    TaeniaTracks tracks;
    for (int row = 0; row < evidence.rows; ++row)
    {
      const auto angle = [&](int track) {
        return (freeCells[track] + (choice >> (3 * row + track) & 1) + 0.5) / anglesAround;
      };
      tracks.push_back({ angle(0), angle(1), angle(2) });
    }
    least = std::min(least, EnergyOfTaeniae(evidence, tracks));
  }
  return least;
}

void
ExpectMirroredTracks(const TaeniaEvidence & evidence)
{
  const TaeniaTracks tracks = JointTaeniae(evidence, {});
  const TaeniaTracks mirrored = JointTaeniae(Mirrored(evidence), {});
  ASSERT_EQ(tracks.size(), mirrored.size());
  EXPECT_NEAR(EnergyOfTaeniae(evidence, tracks), EnergyOfTaeniae(Mirrored(evidence), mirrored), 1e-5);
  for (std::size_t row = 0; row < tracks.size(); ++row)
  {
    std::array<int, 3> expected = CellsOf(tracks[row]);
    for (int & cell : expected)
    {
      cell = anglesAround - 1 - cell;
    }
    std::reverse(expected.begin(), expected.end());
    EXPECT_EQ(CellsOf(mirrored[row]), expected) << "row " << row;
  }
}
} // namespace

TEST(JointTaeniae, HaveTheLeastEnergy)
{
  for (const unsigned int seed : { 1, 2, 3, 4 })
  {
    TaeniaEvidence evidence = RandomEvidence(5, seed);
    for (int i = 0; i < evidence.rows * anglesAround; ++i)
    {
      evidence.cost[i] += IsFree(i % anglesAround) ? 0.0F : 100.0F;
    }
    EXPECT_NEAR(EnergyOfTaeniae(evidence, JointTaeniae(evidence, {})), LeastEnergyOfAll(evidence), 1e-5)
      << "seed " << seed;
  }
}

// The result must not depend on which track is first, or on the direction.
TEST(JointTaeniae, OfAMirroredWallAreMirrored)
{
  for (const unsigned int seed : { 1, 2, 3 })
  {
    TaeniaEvidence evidence = RandomEvidence(30, seed);
    ExpectMirroredTracks(evidence);
    evidence.marks = { { 10, 0.1 }, { 11, 0.4 }, { 11, 0.81 } };
    ExpectMirroredTracks(evidence);
  }
}

TEST(JointTaeniae, PassThroughMarks)
{
  TaeniaEvidence evidence = RandomEvidence(60, 5);
  evidence.marks = { { 20, 0.1 }, { 20, 0.4 }, { 21, 0.81 } };
  const TaeniaTracks tracks = JointTaeniae(evidence, {});
  for (const shapeton::TaeniaMark & mark : evidence.marks)
  {
    double least = 1.0;
    for (const double angle : tracks[mark.row])
    {
      least = std::min(least, std::abs(shapeton::TurnsBetween(angle, mark.angle)));
    }
    EXPECT_LE(least, 0.5 / anglesAround);
  }
}
