#include "shapetonParticleState.h"
#include "shapetonParticleTestRuns.h"
#include "shapetonTestErrors.h"

#include <gtest/gtest.h>

#include <optional>
#include <sstream>
#include <stdexcept>

using namespace shapeton;
using namespace shapeton::test;

namespace
{
std::string
Written(const ParticleState & state)
{
  std::ostringstream stream;
  WriteParticleState(state, stream);
  return stream.str();
}

ParticleState
ReadBack(const std::string & bytes)
{
  std::istringstream stream(bytes);
  return ReadParticleState(stream);
}

/** A small run; tests corrupt every byte of its state. */
std::string
MakeSmallState()
{
  const Volume volume = MakeScene({ 4, 3, 2 }, 0.3);
  ParticleRun  run(volume, MakeSettings(volume, 11, 0.3));
  run.diffusion.Run(60, SteadyRule());
  return Written(run.diffusion.GetState());
}

void
ExpectSame(const ParticleRun & a, const ParticleRun & b)
{
  EXPECT_EQ(a.visits, b.visits);
  EXPECT_EQ(a.Places(), b.Places());
  EXPECT_EQ(Tied(a.diffusion.GetMeasures()), Tied(b.diffusion.GetMeasures()));
}

/** Performs `first` steps, saves, continues in another object; compares with an uninterrupted run. */
void
ExpectToGoOn(const ParticleDiffusionOptions &  settings,
             const Volume &                    volume,
             std::uint64_t                     first,
             std::uint64_t                     last,
             const std::optional<SteadyRule> & rule)
{
  ParticleRun whole(volume, settings);
  whole.diffusion.Run(last, rule);
  ParticleRun begun(volume, settings);
  begun.diffusion.Run(first, rule);
  ParticleRun resumed(volume, settings);
  resumed.diffusion.SetState(ReadBack(Written(begun.diffusion.GetState())));
  ExpectSame(resumed, begun);
  resumed.diffusion.Run(last, rule);
  ExpectSame(resumed, whole);
}

/** Error message of SetState() for the state of a run with other settings. */
template <typename TSpoil>
std::string
Refusal(const TSpoil & spoil)
{
  Volume                     volume = MakeScene({ 6, 5, 4 }, 0.3);
  auto                       settings = MakeSettings(volume, 50, 0.2);
  std::vector<unsigned char> mask(volume.values.size(), 1);
  ParticleRun                run(volume, settings, mask);
  spoil(volume, settings, mask);
  ParticleRun other(volume, settings, mask);
  return basetest::ErrorOf<InputError>([&] { run.diffusion.SetState(other.diffusion.GetState()); });
}

/** A long file of zeros. */
class EndlessZeros : public std::streambuf
{
protected:
  int_type
  underflow() override
  {
    read += sizeof(m_Buffer);
    if (read > (std::size_t{ 1 } << 26))
    {
      ADD_FAILURE() << "reads beyond the header";
      return traits_type::eof();
    }
    setg(m_Buffer, m_Buffer, m_Buffer + sizeof(m_Buffer));
    return 0;
  }

private:
  char        m_Buffer[4096] = {};
  std::size_t read{ 0 };
};
} // namespace

TEST(ParticleState, ASavedRunGoesOnAsIfItHadNotStopped)
{
  const Volume volume = MakeScene({ 14, 13, 12 }, 0.3);
  for (const PathRule rule : { PathRule::Endpoint, PathRule::Traversal })
  {
    auto settings = MakeSettings(volume, 3007, 0.1);
    settings.pathRule = rule;
    ExpectToGoOn(settings, volume, 17, 60, std::nullopt);
    ExpectToGoOn(settings, volume, 1, 60, std::nullopt);
    ExpectToGoOn(settings, volume, 60, 60, std::nullopt);
    ExpectToGoOn(settings, volume, 0, 10, std::nullopt);
  }
}

TEST(ParticleState, TheSteadyRuleGoesOnAsIfTheRunHadNotStopped)
{
  const Volume     volume = MakeScene({ 8, 8, 8 }, 0.4);
  const auto       settings = MakeSettings(volume, 300, 0.2);
  const SteadyRule rule{ 0.01, false };
  ParticleRun      run(volume, settings);
  run.diffusion.Run(10000, rule);
  const std::uint64_t steady = run.diffusion.GetMeasures().step;
  ASSERT_LT(steady, 10000U);
  for (const std::uint64_t first : { std::uint64_t{ 5 }, steady - 20, steady - 1, steady, steady + 100 })
  {
    ExpectToGoOn(settings, volume, first, 10000, rule);
  }
}

TEST(ParticleState, ReadingGivesBackWhatWasWritten)
{
  const Volume volume = MakeScene({ 5, 6, 7 }, 0.3);
  ParticleRun  run(volume, MakeSettings(volume, 23, 0.3));
  run.diffusion.Run(60, SteadyRule());
  const ParticleState state = run.diffusion.GetState();
  const ParticleState read = ReadBack(Written(state));
  EXPECT_EQ(read.identity, state.identity);
  EXPECT_EQ(read.step, state.step);
  EXPECT_EQ(read.change, state.change);
  EXPECT_EQ(read.steadyHistory, state.steadyHistory);
  EXPECT_EQ(read.testedSteps, state.testedSteps);
  EXPECT_EQ(read.places, state.places);
  EXPECT_EQ(read.visits, state.visits);
  EXPECT_EQ(Written(read), Written(state));
}

TEST(ParticleState, ATruncatedStateIsRefused)
{
  const std::string bytes = MakeSmallState();
  EXPECT_NO_THROW(ReadBack(bytes));
  for (std::size_t length = 0; length < bytes.size(); ++length)
  {
    EXPECT_THROW(ReadBack(bytes.substr(0, length)), std::runtime_error) << length;
  }
}

TEST(ParticleState, EveryFlippedBitIsFound)
{
  const std::string bytes = MakeSmallState();
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit)
  {
    std::string damaged = bytes;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ 1 << bit % 8);
    EXPECT_THROW(ReadBack(damaged), std::runtime_error) << bit;
  }
}

TEST(ParticleState, OtherFilesAreRefused)
{
  EXPECT_THROW(ReadBack(""), std::runtime_error);
  EXPECT_THROW(ReadBack("\n"), std::runtime_error);
  EXPECT_THROW(ReadBack("SHAPETON STATE 2" + MakeSmallState().substr(16)), std::runtime_error);
  EXPECT_THROW(ReadBack("SHAPETON STATE 1"), std::runtime_error);
  EXPECT_THROW(ReadBack("SHAPETON STATE 1\nstep: many\n\n"), std::runtime_error);
  EXPECT_THROW(ReadBack("SHAPETON STATE 1\nlength: 5\n\n"), std::runtime_error);
  EXPECT_THROW(ReadBack(std::string(100000, 'a')), std::runtime_error);
  EXPECT_THROW(ReadBack("SHAPETON STATE 1\n" + std::string(100000, 'a')), std::runtime_error);
  EndlessZeros zeros;
  std::istream stream(&zeros);
  EXPECT_THROW(ReadParticleState(stream), std::runtime_error);
}

TEST(ParticleState, AnAbsurdLengthIsRefused)
{
  for (const char * const length : { "1000000000000", "18446744073709551615", "99999999999999999999999", "-1" })
  {
    for (const char * const name : { "shapetons", "voxels" })
    {
      const std::string header = std::string("SHAPETON STATE 1\n") + name + ": " + length + "\n\n";
      EXPECT_THROW(ReadBack(header), std::runtime_error);
      EXPECT_THROW(ReadBack(header + std::string(1000, 'x')), std::runtime_error);
    }
  }
}

TEST(ParticleState, AStateOfAnotherRunIsRefusedByName)
{
  using Mask = std::vector<unsigned char>;
  using Settings = ParticleDiffusionOptions;
  const auto settingsAlone = [](const auto & spoil) {
    return Refusal([&](Volume &, Settings & settings, Mask &) { spoil(settings); });
  };
  const auto contains = [](const std::string & text, const std::string & part) {
    return text.find("its " + part + " is") != std::string::npos;
  };
  EXPECT_EQ(settingsAlone([](Settings &) {}), "");
  EXPECT_TRUE(contains(settingsAlone([](Settings & s) { s.seed = 2; }), "seed"));
  EXPECT_TRUE(contains(settingsAlone([](Settings & s) { s.p = 7.5; }), "p"));
  EXPECT_TRUE(contains(settingsAlone([](Settings & s) { (*s.intensityWindow)[1] += 1.0; }), "intensity window"));
  EXPECT_TRUE(contains(Refusal([](Volume & volume, Settings &, Mask &) { volume.spacing[2] = 1.1; }), "spacing"));
  EXPECT_TRUE(contains(settingsAlone([](Settings & s) { s.shapetons = 51; }), "number of shapetons"));
  EXPECT_TRUE(contains(settingsAlone([](Settings & s) { s.distance = 0.21; }), "distance"));
  EXPECT_TRUE(contains(settingsAlone([](Settings & s) { s.pathRule = PathRule::Traversal; }), "path rule"));
  EXPECT_TRUE(contains(settingsAlone([](Settings & s) { s.placement = ParticlePlacement::InitialHeat; }), "placement"));
  EXPECT_TRUE(contains(settingsAlone([](Settings & s) { s.directionSampling = DirectionSampling::SectorArea; }),
                       "direction sampling"));
  const std::string ofTheWeights = "volume or mask (checksum of the edge weights)";
  EXPECT_TRUE(contains(Refusal([](Volume &, Settings &, Mask & mask) { mask[3] = 0; }), ofTheWeights));
  EXPECT_TRUE(contains(Refusal([](Volume & volume, Settings &, Mask &) { volume.values[60] += 0.01F; }), ofTheWeights));
  EXPECT_TRUE(contains(Refusal([](Volume & volume, Settings &, Mask &) { volume.size = { 5, 6, 4 }; }), "size"));
}

TEST(ParticleState, ADamagedStateIsRefused)
{
  const Volume        volume = MakeScene({ 6, 5, 4 }, 0.3);
  ParticleRun         run(volume, MakeSettings(volume, 50, 0.2));
  const ParticleState state = run.diffusion.GetState();
  const auto          expectRefused = [&](const auto & spoil) {
    ParticleState damaged = state;
    spoil(damaged);
    EXPECT_THROW(run.diffusion.SetState(damaged), InputError);
  };
  EXPECT_NO_THROW(run.diffusion.SetState(state));
  expectRefused([](ParticleState & s) { s.identity.clear(); });
  expectRefused([](ParticleState & s) { s.identity.pop_back(); });
  expectRefused([](ParticleState & s) { s.visits.pop_back(); });
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    expectRefused([axis](ParticleState & s) { s.places[axis].pop_back(); });
    expectRefused([axis](ParticleState & s) { s.places[axis].resize(5000, 0.0F); });
    expectRefused([axis](ParticleState & s) { s.places[axis][7] = 6.0F; });
    expectRefused([axis](ParticleState & s) { s.places[axis][7] = -0.1F; });
    expectRefused([axis](ParticleState & s) { s.places[axis][7] = std::numeric_limits<float>::quiet_NaN(); });
  }
}
