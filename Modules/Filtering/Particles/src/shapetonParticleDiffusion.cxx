#include "shapetonParticleDiffusion.h"
#include "shapetonExceptions.h"

#include "shapetonParticleWalk.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>

namespace shapeton
{
namespace
{
using namespace ParticleKernels;

/** Shapeton steps between two calls of the observer: a few hundredths of a second. */
constexpr std::uint64_t EndpointBlock = std::uint64_t{ 1 } << 20;
constexpr std::uint64_t TraversalBlock = std::uint64_t{ 1 } << 16;
/** Factor on a GPU, where the visits must be copied for the observer. */
constexpr std::uint64_t BlocksOnDevice = 128;
/** Window length of the steady rule, and number of steps in it that may fail. */
constexpr std::uint64_t HistoryLength = 50;
constexpr int           AllowedFailures = 5;
/** Mean number of visits of the reached voxels that satisfies the automatic rule. */
constexpr double WantedVisits = 100.0;

void
CheckSettings(const ParticleOptions & settings, const std::array<std::size_t, 3> & size)
{
  RequireParameter(settings.shapetons >= 1, "the parameter \"shapetons\" must be at least 1");
  RequireParameter(settings.distance > 0.0 && settings.distance <= 1.0,
                   "the parameter \"distance\" must be in (0, 1], in units of the longest side of the volume");
  constexpr std::size_t limit = std::size_t{ 1 } << 31;
  constexpr std::size_t longest = std::size_t{ 1 } << 24; // a position in single precision
  if (size[0] == 0 || size[1] == 0 || size[2] == 0)
  {
    throw InputError("the volume is empty; update the filter that makes it");
  }
  if (std::max({ size[0], size[1], size[2] }) >= longest || size[0] * size[1] >= limit ||
      size[0] * size[1] * size[2] >= limit)
  {
    throw InputError("the volume has 2^31 voxels or more, or 2^24 along an axis; crop it");
  }
}

using Facts = std::vector<std::pair<std::string, std::string>>;

/** The parameters among the facts that identify a run. */
const std::map<std::string, std::string> parametersOfIdentity = {
  { "p", "p" },
  { "intensity window", "intensityWindow" },
  { "smoothing", "smoothing" },
  { "number of shapetons", "shapetons" },
  { "distance", "distance" },
  { "direction sampling", "directionSampling" },
  { "path rule", "pathRule" },
  { "placement", "placement" },
  { "seed", "seed" },
};

/** Throws InputError that states the first difference of a saved run and this one, and how to continue it. */
void
RequireIdentity(const Facts & saved, const Facts & own)
{
  std::string difference;
  std::string remedy;
  bool        needsVolume = false; // no parameter repairs another size or content
  for (std::size_t i = 0; i < own.size(); ++i)
  {
    const auto & [name, value] = own[i];
    const bool isKnown = i < saved.size() && saved[i].first == name;
    if (isKnown && saved[i].second == value)
    {
      continue;
    }
    needsVolume = needsVolume || name == "size" || name == "spacing";
    std::string before = isKnown ? saved[i].second : "missing";
    if (difference.empty())
    {
      difference.append(name).append(" is ").append(before).append(", but this run has ").append(value);
    }
    const auto parameter = parametersOfIdentity.find(name);
    if (isKnown && parameter != parametersOfIdentity.end())
    {
      std::replace(before.begin(), before.end(), ' ', ',');
      remedy.append(remedy.empty() ? "" : " and ");
      remedy.append("the parameter \"").append(parameter->second).append("\" = ").append(before);
    }
  }
  if (!difference.empty())
  {
    throw InputError("the saved state belongs to another run: its " + difference + "; continue it with " +
                     (needsVolume ? "the volume and mask of that run" : remedy));
  }
}

std::string
Text(double value)
{
  std::ostringstream text;
  text.precision(std::numeric_limits<double>::max_digits10);
  text << value;
  return text.str();
}
} // namespace

const char *
NameOf(DirectionSampling sampling)
{
  return WordOf(&ParticleOptions::directionSampling, sampling);
}

const char *
NameOf(PathRule rule)
{
  return WordOf(&ParticleOptions::pathRule, rule);
}

const char *
NameOf(ParticlePlacement placement)
{
  return WordOf(&ParticleOptions::placement, placement);
}

/** The walk and its measures. */
struct ParticleDiffusion::Impl : ParticleWalk
{
  Impl(const EdgeVolume &               edges,
       const ParticleDiffusionOptions & given,
       const unsigned char *            mask,
       std::uint32_t *                  visitsOfVoxels,
       const std::function<void()> &    pollNowAndThen)
    : ParticleWalk(edges, given, mask, visitsOfVoxels, pollNowAndThen), poll(pollNowAndThen)
  {
    measures.objectVoxels = records.GetNumberOfObjectVoxels();
    CountTrapped();
  }

  std::uint64_t
  BlockLength() const
  {
    return settings.pathRule == PathRule::Traversal ? TraversalBlock : EndpointBlock;
  }

  void
  CountTrapped()
  {
    measures.trappedShapetons = SumOverShapetons().trapped;
  }

  void
  Note(const ParticleTally & tally, std::uint64_t number)
  {
    // The square of a count `old` grows by 2 old + 1 if the count grows by one.
    sumOfSquares += 2.0 * static_cast<double>(tally.sumOfOld) + static_cast<double>(number);
    measures.maximumVisits = std::max(measures.maximumVisits, tally.maximum);
    measures.voxelsReached += tally.reached;
    measures.objectVoxelsReached += tally.objectsReached;
  }

  /** Performs steps up to `end`, measuring the last one. Steps of many shapetons are divided so that `poll` can
   * abort. */
  void
  Advance(std::uint64_t end)
  {
    const std::uint64_t begin = measures.step + 1;
    const std::uint64_t number = settings.shapetons;
    if (measures.maximumVisits + number * (end - begin + 1) > std::numeric_limits<std::uint32_t>::max())
    {
      throw InputError("the visits of a voxel exceed 32 bits; use fewer steps or shapetons");
    }
    if (end > begin)
    {
      Note(TakeSteps(0, number, begin, end), number * (end - begin));
    }
    const double        squaresBefore = sumOfSquares;
    const std::uint32_t maximumBefore = measures.maximumVisits;
    ParticleTally       tally;
    const std::uint64_t longest = deviceUse.gpu ? number : BlockLength() / 4; // a multiple of the group size
    for (std::uint64_t first = 0; first < number; first += longest)
    {
      const std::uint64_t part = std::min(longest, number - first);
      tally.Add(TakeSteps(first, part, end, end + 1));
      if (first + part < number)
      {
        poll();
      }
    }
    Note(tally, number);
    measures.step = end;
    const ParticleSum sum = SumOverShapetons();
    measures.trappedShapetons = sum.trapped;
    Measure(tally, sum.visits, squaresBefore, maximumBefore);
  }

  /** Computes the change during the step covered by the tally. With S the counts before, c those of the step, and n
   * shapetons: sumOfOld = sum S c + (sum c^2 - n) / 2, and `sumAfter` = sum (S + c) c.
   *
   * \equation{3.10} for densities with a maximum of 1; as printed, with raw counts, it is never below n. */
  void
  Measure(const ParticleTally & tally, std::uint64_t sumAfter, double squaresBefore, std::uint32_t maximumBefore)
  {
    const double n = settings.shapetons;
    const double squares = 2.0 * static_cast<double>(sumAfter - tally.sumOfOld) - n; // sum c^2
    const double products = static_cast<double>(sumAfter) - squares;                 // sum S c
    const double maximum = measures.maximumVisits;
    // The density was S / maximumBefore and is (S + c) / maximum.
    const double shrinking = maximumBefore == 0 ? 0.0 : 1.0 / maximum - 1.0 / maximumBefore;
    measures.change =
      shrinking * shrinking * squaresBefore + 2.0 * shrinking * products / maximum + squares / (maximum * maximum);
    SuggestEpsilon();
  }

  /** See ParticleMeasures::automaticEpsilon. */
  void
  SuggestEpsilon()
  {
    const double n = settings.shapetons;
    const double reached = static_cast<double>(measures.voxelsReached);
    const double mean = n * static_cast<double>(measures.step) / reached;
    const double wanted = WantedVisits * measures.maximumVisits / mean;
    measures.automaticEpsilon = measures.voxelsReached == 0 ? 0.0 : n * (1.0 + n / reached) / (wanted * wanted);
  }

  void
  Test(const SteadyRule & rule)
  {
    const double   epsilon = rule.automatic ? measures.automaticEpsilon : rule.epsilon;
    constexpr auto mask = (std::uint64_t{ 1 } << HistoryLength) - 1;
    history = (history << 1 | (measures.change <= epsilon ? 1U : 0U)) & mask;
    tested = std::min(tested + 1, HistoryLength);
    measures.steady = IsSteady();
  }

  bool
  IsSteady() const
  {
    return tested == HistoryLength &&
           __builtin_popcountll(history) >= static_cast<int>(HistoryLength) - AllowedFailures;
  }

  std::vector<std::pair<std::string, std::string>>
  Identity() const
  {
    const auto & [lower, upper] = window;
    return { { "size", std::to_string(size[0]) + " " + std::to_string(size[1]) + " " + std::to_string(size[2]) },
             { "spacing", Text(spacing[0]) + " " + Text(spacing[1]) + " " + Text(spacing[2]) },
             { "p", Text(settings.p) },
             { "intensity window", Text(lower) + " " + Text(upper) },
             { "smoothing", Text(settings.smoothing) },
             { "number of shapetons", std::to_string(settings.shapetons) },
             { "distance", Text(settings.distance) },
             { "direction sampling", NameOf(settings.directionSampling) },
             { "path rule", NameOf(settings.pathRule) },
             { "placement", NameOf(settings.placement) },
             { "seed", std::to_string(settings.seed) },
             { "volume or mask (checksum of the edge weights)", std::to_string(records.GetChecksum()) } };
  }

  /** Sums over all voxels at the time a state was saved. */
  void
  MeasureAgain()
  {
    sumOfSquares = 0.0;
    measures.maximumVisits = 0;
    measures.voxelsReached = 0;
    measures.objectVoxelsReached = 0;
    for (std::size_t voxel = 0; voxel < NumberOfVoxels(); ++voxel)
    {
      if (const std::uint32_t count = visits[voxel])
      {
        sumOfSquares += static_cast<double>(count) * count;
        measures.maximumVisits = std::max(measures.maximumVisits, count);
        ++measures.voxelsReached;
        measures.objectVoxelsReached += records.GetRecord(voxel)[MarksOfRecord] & ObjectMark;
      }
    }
    measures.steady = IsSteady();
    SuggestEpsilon();
  }

  const std::function<void()> poll;
  ParticleMeasures            measures;
  double                      sumOfSquares{ 0.0 };
  std::uint64_t               history{ 0 };
  std::uint64_t               tested{ 0 };
};

ParticleDiffusion::ParticleDiffusion(const VolumeView &               volume,
                                     const ParticleDiffusionOptions & options,
                                     const unsigned char *            mask,
                                     std::uint32_t *                  visits,
                                     const std::function<void()> &    poll)
{
  CheckSettings(options, volume.size);
  m_Impl = std::make_unique<Impl>(
    EdgeVolume(volume, options), options, mask, visits, poll ? poll : [] {});
}

ParticleDiffusion::~ParticleDiffusion() = default;

void
ParticleDiffusion::Run(std::uint64_t lastStep, const std::optional<SteadyRule> & rule, const Observer & observer)
{
  Impl &              impl = *m_Impl;
  const std::uint64_t stride = rule ? 1 : std::max<std::uint64_t>(1, impl.BlockLength() / impl.settings.shapetons);
  std::uint64_t       unreported = 0;
  while (impl.measures.step < lastStep && !(rule && impl.measures.steady))
  {
    const std::uint64_t before = impl.measures.step;
    impl.Advance(std::min(lastStep, (before / stride + 1) * stride));
    if (rule)
    {
      impl.Test(*rule);
    }
    unreported += (impl.measures.step - before) * impl.settings.shapetons;
    if (observer && unreported >= impl.BlockLength() / 2 * (impl.deviceUse.gpu ? BlocksOnDevice : 1))
    {
      impl.FetchFromDevice();
      observer(impl.measures);
      unreported = 0;
    }
  }
  impl.FetchFromDevice();
  if (observer)
  {
    observer(impl.measures);
  }
}

const ParticleMeasures &
ParticleDiffusion::GetMeasures() const
{
  return m_Impl->measures;
}

const DeviceUse &
ParticleDiffusion::GetDeviceUse() const
{
  return m_Impl->deviceUse;
}

const float *
ParticleDiffusion::GetPlaces(unsigned int axis) const
{
  return m_Impl->places[axis].data();
}

ParticleState
ParticleDiffusion::GetState() const
{
  ParticleState state;
  state.identity = m_Impl->Identity();
  state.step = m_Impl->measures.step;
  state.change = m_Impl->measures.change;
  state.steadyHistory = m_Impl->history;
  state.testedSteps = m_Impl->tested;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    state.places[axis].assign(m_Impl->places[axis].begin(), m_Impl->places[axis].begin() + m_Impl->settings.shapetons);
  }
  state.visits.assign(m_Impl->visits, m_Impl->visits + m_Impl->NumberOfVoxels());
  return state;
}

void
ParticleDiffusion::SetState(const ParticleState & state)
{
  Impl &     impl = *m_Impl;
  const auto own = impl.Identity();
  RequireIdentity(state.identity, own);
  const auto incomplete = [&](const std::vector<float> & places) { return places.size() != impl.settings.shapetons; };
  if (state.visits.size() != impl.NumberOfVoxels() || std::any_of(state.places.begin(), state.places.end(), incomplete))
  {
    throw InputError("the saved state is incomplete");
  }
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const auto & places = state.places[axis];
    const auto   outside = [&](float place) { return !(place >= 0.0F && place < static_cast<float>(impl.size[axis])); };
    if (std::any_of(places.begin(), places.end(), outside))
    {
      throw InputError("the saved state has shapetons outside the volume");
    }
    std::copy(places.begin(), places.end(), impl.places[axis].begin());
  }
  for (std::size_t i = 0; i < impl.settings.shapetons; ++i)
  {
    const auto index = [&](unsigned int axis) { return static_cast<std::size_t>(impl.places[axis][i]); };
    impl.voxels[i] = static_cast<std::uint32_t>((index(2) * impl.size[1] + index(1)) * impl.size[0] + index(0));
  }
  std::copy(state.visits.begin(), state.visits.end(), impl.visits);
  impl.measures.step = state.step;
  impl.measures.change = state.change;
  impl.history = state.steadyHistory;
  impl.tested = state.testedSteps;
  impl.SendToDevice();
  impl.MeasureAgain();
  impl.CountTrapped();
}

double
EquivalentHeatTimeSteps(double steps, double stepInVoxels, double timeStepLength)
{
  if (!(stepInVoxels > 0.0))
  {
    return 0.0;
  }
  // Along an axis a step covers m voxels, with m uniform in [0, a]. From a uniform position in its voxel, the
  // displacement is an integer number of voxels with a mean square of m^2 + g (1 - g), g the fractional part of m.
  const double a = stepInVoxels;
  const double whole = std::floor(a);
  const double part = a - whole;
  const double variance = a * a / 3.0 + (whole / 6.0 + part * part * (0.5 - part / 3.0)) / a;
  return steps * variance / (2.0 * timeStepLength);
}
} // namespace shapeton
