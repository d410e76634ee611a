#include "shapetonStartFrame.h"

#include "shapetonFlatColonLocator.h"
#include "shapetonPi.h"
#include "shapetonQuantiles.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
/** Ratio of lengths. Chosen: larger ratios indicate a wrong flexure. */
constexpr double greatestStretch = 3.0;

/** Whether each section is stretched or compressed by at most `greatestStretch` relative to the whole colon. */
bool
IsPlausible(const PiecewiseLine & frame)
{
  const double whole = (frame.to.back() - frame.to.front()) / (frame.from.back() - frame.from.front());
  for (std::size_t i = 1; i < frame.from.size(); ++i)
  {
    const double     from = (frame.from[i] - frame.from[i - 1]) * whole;
    const double     to = frame.to[i] - frame.to[i - 1];
    constexpr double slack = 15.0; // mm; allows for the error of a flexure in short sections
    if (!(from > 0.0 && to > 0.0) || to > greatestStretch * from + slack || from > greatestStretch * to + slack)
    {
      return false;
    }
  }
  return true;
}

PiecewiseLine
FrameOf(const ColonPosition &    source,
        const ColonCylinder &    sourceCylinder,
        const ColonPosition &    target,
        const ColonCylinder &    targetCylinder,
        const std::vector<int> & flexures)
{
  PiecewiseLine frame{ { sourceCylinder.Begin() }, { targetCylinder.Begin() } };
  for (const int flexure : flexures)
  {
    frame.from.push_back(source.flexures[flexure]);
    frame.to.push_back(target.flexures[flexure]);
  }
  frame.from.push_back(sourceCylinder.End());
  frame.to.push_back(targetCylinder.End());
  return frame;
}

/** Standard deviation (mm) of an error that is within 30 mm with this probability (inverse error function after
 * Winitzki 2008). */
double
DeviationOf(double confidence)
{
  constexpr double within = 30.0; // mm; the tolerance of the confidences of flexures
  constexpr double a = 0.147;     // Winitzki's constant
  const double     x = std::clamp(confidence, 0.1, 0.98);
  const double     logarithm = std::log(1.0 - x * x);
  const double     b = 2.0 / (Pi * a) + 0.5 * logarithm;
  return within / std::sqrt(2.0 * (std::sqrt(b * b - logarithm / a) - b));
}

/** Confidence of the flexure at this position. */
double
ConfidenceOfFlexure(const ColonPosition & position, double arcLength)
{
  for (std::size_t i = 0; i < position.flexures.size(); ++i)
  {
    if (position.flexures[i] == arcLength)
    {
      return position.flexureConfidence[i];
    }
  }
  return 0.0;
}

struct AngleSample
{
  double s;
  double turn;
};

/** Samples along one taenia, sorted by s. */
std::vector<AngleSample>
SamplesOfTaenia(const CurveSet &         curves,
                const std::vector<int> & curve,
                const ColonCylinder &    cylinder,
                const FlatColonLocator & locator)
{
  constexpr double         greatestDistance = 10.0; // mm from the wall; chosen
  std::vector<AngleSample> samples;
  for (const int vertex : curve)
  {
    const FlatPlace place = locator.Find(curves.V.row(vertex));
    if (place.distance <= greatestDistance)
    {
      const CylinderPlace on = cylinder.PlaceOfUv(place.uv);
      samples.push_back({ on.s, on.turn });
    }
  }
  std::stable_sort(
    samples.begin(), samples.end(), [](const AngleSample & a, const AngleSample & b) { return a.s < b.s; });
  for (std::size_t i = 1; i < samples.size(); ++i)
  {
    samples[i].turn = samples[i - 1].turn + TurnDifference(samples[i].turn, samples[i - 1].turn);
  }
  return samples;
}

/** Linear interpolation between samples, constant beyond them. */
std::vector<double>
Resampled(const std::vector<AngleSample> & samples, double begin, double step, int number)
{
  std::vector<double> turns(number);
  std::size_t         next = 0;
  for (int i = 0; i < number; ++i)
  {
    const double s = begin + i * step;
    while (next < samples.size() && samples[next].s <= s)
    {
      ++next;
    }
    if (next == 0 || next == samples.size())
    {
      turns[i] = next == 0 ? samples.front().turn : samples.back().turn;
      continue;
    }
    const AngleSample & a = samples[next - 1];
    const AngleSample & b = samples[next];
    turns[i] = a.turn + (s - a.s) / (b.s - a.s) * (b.turn - a.turn);
  }
  return turns;
}

/** Median angle around the tube between the first taenia and another one, turns in [0, 1). */
double
MedianOffset(const std::vector<double> & turns, const std::vector<double> & first)
{
  std::vector<double> offsets;
  for (std::size_t i = 0; i < turns.size(); ++i)
  {
    offsets.push_back(turns[i] - first[i] - std::floor(turns[i] - first[i]));
  }
  return UpperMedian(std::move(offsets));
}
} // namespace

double
PiecewiseLine::operator()(double value) const
{
  const int after = static_cast<int>(std::upper_bound(from.begin(), from.end(), value) - from.begin());
  const int i = std::clamp(after - 1, 0, static_cast<int>(from.size()) - 2);
  return to[i] + (value - from[i]) / (from[i + 1] - from[i]) * (to[i + 1] - to[i]);
}

PiecewiseLine
FlexureFrame(const ColonPosition &      source,
             const ColonCylinder &      sourceCylinder,
             const ColonPosition &      target,
             const ColonCylinder &      targetCylinder,
             std::vector<std::string> & warnings)
{
  static const std::array<const char *, 4> names{ { "rectosigmoid", "descending-sigmoid", "splenic", "hepatic" } };
  std::vector<int>                         used;
  for (int flexure = 0; flexure < 4; ++flexure)
  {
    if (!std::isfinite(source.flexures[flexure]) || !std::isfinite(target.flexures[flexure]))
    {
      warnings.push_back(std::string("the ") + names[flexure] + " flexure is not known in both positions");
      continue;
    }
    used.push_back(flexure);
    if (!IsPlausible(FrameOf(source, sourceCylinder, target, targetCylinder, used)))
    {
      used.pop_back();
      warnings.push_back(std::string("the ") + names[flexure] +
                         " flexure is ignored: its locations in the two positions differ too much");
    }
  }
  return FrameOf(source, sourceCylinder, target, targetCylinder, used);
}

PiecewiseLine
EndFrame(const PiecewiseLine & frame)
{
  return { { frame.from.front(), frame.from.back() }, { frame.to.front(), frame.to.back() } };
}

PiecewiseLine
CautiousFrame(const PiecewiseLine & frame, const ColonPosition & source, const ColonPosition & target)
{
  constexpr double    expected = 40.0; // mm; see the header
  const PiecewiseLine proportional = EndFrame(frame);
  PiecewiseLine       cautious = frame;
  for (std::size_t i = 1; i + 1 < frame.from.size(); ++i)
  {
    const double ofSource = DeviationOf(ConfidenceOfFlexure(source, frame.from[i]));
    const double ofTarget = DeviationOf(ConfidenceOfFlexure(target, frame.to[i]));
    const double share = expected * expected / (expected * expected + ofSource * ofSource + ofTarget * ofTarget);
    const double plain = proportional(frame.from[i]);
    cautious.to[i] = plain + share * (frame.to[i] - plain);
  }
  return IsPlausible(cautious) ? cautious : frame;
}

double
TaeniaAngles::At(int taenia, double s) const
{
  const std::vector<double> & values = turns[taenia];
  const double                place = std::clamp((s - begin) / step, 0.0, values.size() - 1.0);
  const std::size_t           i = std::min(static_cast<std::size_t>(place), values.size() - 2);
  return values[i] + (place - i) * (values[i + 1] - values[i]);
}

TaeniaAngles
AnglesOfTaeniae(const ColonPosition & position, const ColonCylinder & cylinder, std::vector<std::string> & warnings)
{
  TaeniaAngles angles;
  angles.begin = cylinder.Begin();
  const int number = std::max(2, static_cast<int>((cylinder.End() - cylinder.Begin()) / angles.step) + 1);
  if (position.taeniae.curves.size() != 3)
  {
    warnings.push_back(position.name + ": three taeniae are required, found " +
                       std::to_string(position.taeniae.curves.size()));
    return angles;
  }
  const FlatColonLocator           locator(position.flat->Grid());
  std::vector<std::vector<double>> turns;
  for (const std::vector<int> & curve : position.taeniae.curves)
  {
    const std::vector<AngleSample> samples = SamplesOfTaenia(position.taeniae, curve, cylinder, locator);
    if (samples.size() < 2)
    {
      warnings.push_back(position.name + ": a taenia is not on the wall");
      return angles;
    }
    turns.push_back(Resampled(samples, angles.begin, angles.step, number));
  }
  const bool isSwapped = MedianOffset(turns[2], turns[0]) < MedianOffset(turns[1], turns[0]);
  angles.curves = { 0, isSwapped ? 2 : 1, isSwapped ? 1 : 2 };
  angles.turns = { turns[0], turns[angles.curves[1]], turns[angles.curves[2]] };
  angles.isKnown = true;
  return angles;
}

std::vector<double>
RotationOfTaeniae(const TaeniaAngles &        source,
                  const TaeniaAngles &        target,
                  const PiecewiseLine &       frame,
                  int                         shift,
                  const std::vector<double> & s)
{
  Eigen::MatrixX2d directions(s.size(), 2);
  for (std::size_t i = 0; i < s.size(); ++i)
  {
    directions.row(i).setZero();
    for (int taenia = 0; taenia < 3; ++taenia)
    {
      const double turn = target.At((taenia + shift) % 3, frame(s[i])) - source.At(taenia, s[i]);
      directions.row(i) += Eigen::RowVector2d(std::cos(2.0 * Pi * turn), std::sin(2.0 * Pi * turn));
    }
  }
  constexpr double    smoothing = 15.0; // mm, to avoid a jump at a local error of a taenia
  const double        step = s.size() > 1 ? (s.back() - s.front()) / (s.size() - 1.0) : 1.0;
  std::vector<double> rotation;
  for (std::size_t i = 0; i < s.size(); ++i)
  {
    Eigen::RowVector2d mean = Eigen::RowVector2d::Zero();
    const int          reach = static_cast<int>(3.0 * smoothing / step);
    for (int k = -reach; k <= reach; ++k)
    {
      const int    at = std::clamp(static_cast<int>(i) + k, 0, static_cast<int>(s.size()) - 1);
      const double t = k * step / smoothing;
      mean += std::exp(-0.5 * t * t) * directions.row(at);
    }
    const double turn = std::atan2(mean[1], mean[0]) / (2.0 * Pi);
    rotation.push_back(rotation.empty() ? turn : rotation.back() + TurnDifference(turn, rotation.back()));
  }
  return rotation;
}
} // namespace shapeton
