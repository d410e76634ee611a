#include "shapetonWarpingTrials.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shapeton
{
namespace
{
/** A trial frame, and the allowed deviation of the path from it. */
struct Trial
{
  PiecewiseLine frame;
  double        band;
  double        deviation;
  /** Weights of slope, rotation and taeniae. */
  double slope;
  double rotation;
  double taeniae;
};

/** Band of the path about the first frame (mm) and its allowed deviation (mm), and the increase of both for each
 * further frame, since these are less certain. On hard phantoms (seeds 1 to 10), other deviations and taenia weights
 * change the error by less than 0.1 mm. */
constexpr double firstBand = 60.0;
constexpr double moreBand = 15.0;
constexpr double firstDeviation = 25.0;
constexpr double moreDeviation = 12.0;
/** Weights of slope (stiff or soft), rotation and taeniae. If there are no taeniae, both slope and rotation may be
 * free. */
constexpr double stiffSlope = 2.0;
constexpr double softSlope = 0.8;
constexpr double freeSlope = 0.3;
constexpr double stiffRotation = 1.0;
constexpr double freeRotation = 0.4;
constexpr double taeniaWeight = 0.3;
constexpr double bandOfThirds = 30.0; // mm, to compare a path with the same path turned by a third

/** Trials with several frames, since flexures have errors of centimeters and lengths are not exactly proportional.
 * Segment-wise registration requires the frame of the flexures. */
std::vector<Trial>
Trials(const ColonPair & pair)
{
  std::vector<Trial>         trials;
  std::vector<PiecewiseLine> frames{ pair.frame };
  if (pair.breaks.empty())
  {
    frames.push_back(CautiousFrame(pair.frame, pair.source, pair.target));
    frames.push_back(EndFrame(pair.frame));
  }
  for (std::size_t i = 0; i < frames.size(); ++i)
  {
    const double band = firstBand + moreBand * static_cast<double>(i);
    const double deviation = firstDeviation + moreDeviation * static_cast<double>(i);
    trials.push_back({ frames[i], band, deviation, stiffSlope, stiffRotation, 0.0 });
    if (pair.AreTaeniaeKnown())
    {
      trials.push_back({ frames[i], band, deviation, softSlope, stiffRotation, taeniaWeight });
      trials.push_back({ frames[i], band, deviation, stiffSlope, stiffRotation, taeniaWeight });
    }
    else
    {
      trials.push_back({ frames[i], band, deviation, freeSlope, freeRotation, 0.0 });
    }
  }
  return trials;
}

/** Bands along the taeniae at these distances along a colon. */
Eigen::MatrixXd
BandsOf(const TaeniaAngles & taeniae, const std::vector<double> & s, int angles)
{
  constexpr double deviation = 0.04; // turns; chosen: 5 mm at a radius of 20 mm
  Eigen::MatrixXd  bands = Eigen::MatrixXd::Zero(s.size(), angles);
  for (Eigen::Index row = 0; row < bands.rows(); ++row)
  {
    for (int angle = 0; angle < angles; ++angle)
    {
      for (int taenia = 0; taenia < 3; ++taenia)
      {
        const double away = TurnDifference((angle + 0.5) / angles, taeniae.At(taenia, s[row])) / deviation;
        bands(row, angle) += std::exp(-0.5 * away * away);
      }
    }
    bands.row(row).array() -= bands.row(row).mean();
    bands.row(row) *= std::sqrt(angles / bands.row(row).squaredNorm());
  }
  return bands;
}

/** Picture with the rows of the warping in the coordinate of the source. `frame` is null for the source itself. */
CylinderPicture
PictureOf(const ColonPair & pair, const PiecewiseLine * frame)
{
  constexpr double    smoothing = 0.8; // rows; the target has twice as many
  CylinderPictureForm form;
  form.begin = pair.sourceCylinder->Begin() + 0.5 * WarpRowStep;
  form.step = frame ? 0.5 * WarpRowStep : WarpRowStep;
  form.rows = std::max(2, static_cast<int>((pair.sourceCylinder->End() - pair.sourceCylinder->Begin()) / form.step));
  form.angles = WarpAngles;
  form.smoothRows = frame ? 2.0 * smoothing : smoothing;
  const PiecewiseLine there = frame ? *frame : PiecewiseLine{ { 0.0, 1.0 }, { 0.0, 1.0 } };
  form.coordinate = [back = there.Inverse()](double s) { return back(s); };
  CylinderPicture picture = frame ? MakeCylinderPicture(pair.target, *pair.targetCylinder, pair.targetFolds, form)
                                  : MakeCylinderPicture(pair.source, *pair.sourceCylinder, pair.sourceFolds, form);
  if (pair.AreTaeniaeKnown())
  {
    std::vector<double> places;
    for (int row = 0; row < form.rows; ++row)
    {
      places.push_back(there(form.begin + row * form.step));
    }
    picture.taeniae = BandsOf(frame ? pair.targetTaeniae : pair.sourceTaeniae, places, form.angles);
  }
  return picture;
}

CylindricalWarp
WarpAbout(const ColonPair & pair, const Trial & trial, const CylinderPicture & source, const Progress & progress)
{
  CylindricalWarpingOptions options;
  options.breaks = pair.breaks;
  options.band = trial.band;
  options.frameDeviation = trial.deviation;
  options.slopeWeight = trial.slope;
  options.rotationWeight = trial.rotation;
  options.taeniaWeight = trial.taeniae;
  options.progress = progress;
  return WarpCylinder(source, PictureOf(pair, &trial.frame), trial.frame, {}, options);
}

/** The path along the colon, converted to an increasing frame. */
PiecewiseLine
FrameOf(const CylindricalWarp & warp)
{
  constexpr double least = 0.1; // slope; chosen: keeps the frame increasing
  PiecewiseLine    frame{ warp.s, warp.targetS };
  for (std::size_t i = 1; i < frame.to.size(); ++i)
  {
    frame.to[i] = std::max(frame.to[i], frame.to[i - 1] + least * (frame.from[i] - frame.from[i - 1]));
  }
  return frame;
}

/** Minimum energies near the warp and near the warp rotated by one third and by two thirds of a turn. */
std::vector<double>
EnergiesOfThirds(const ColonPair &       pair,
                 const CylindricalWarp & warp,
                 const CylinderPicture & source,
                 const Progress &        progress)
{
  const PiecewiseLine       frame = FrameOf(warp);
  const CylinderPicture     target = PictureOf(pair, &frame);
  CylindricalWarpingOptions options;
  options.breaks = pair.breaks;
  options.band = bandOfThirds;
  options.slopeWeight = stiffSlope;
  options.rotationWeight = stiffRotation;
  std::vector<double> energies;
  for (int third = 0; third < 3; ++third)
  {
    std::vector<double> rotation = warp.rotation;
    std::transform(rotation.begin(), rotation.end(), rotation.begin(), [third](double t) { return t + third / 3.0; });
    options.progress = progress.Part("", third / 3.0, (third + 1) / 3.0);
    energies.push_back(WarpCylinder(source, target, frame, rotation, options).energy);
  }
  return energies;
}

/** Rotation of the flexure frame according to the taeniae, for the one of the three correspondences that is closest to
 * the warp. */
std::vector<double>
RotationOfFrame(const ColonPair & pair, const CylindricalWarp & warp)
{
  std::vector<double> best;
  double              most = -std::numeric_limits<double>::infinity();
  for (int way = 0; way < 3; ++way)
  {
    const std::vector<double> rotation =
      RotationOfTaeniae(pair.sourceTaeniae, pair.targetTaeniae, pair.frame, way, warp.s);
    double agreement = 0.0;
    for (std::size_t i = 0; i < rotation.size(); ++i)
    {
      agreement -= std::abs(TurnDifference(rotation[i], warp.rotation[i]));
    }
    if (agreement > most)
    {
      most = agreement;
      best = rotation;
    }
  }
  return best;
}
} // namespace

WarpingChoice
WarpByTrials(const ColonPair & pair, FoldMatchingMethod method, const Progress & progress)
{
  const CylinderPicture    source = PictureOf(pair, nullptr);
  const std::vector<Trial> trials = Trials(pair);
  const double             shareOfTrial = 0.8 / static_cast<double>(trials.size());
  WarpingChoice            choice;
  for (std::size_t i = 0; i < trials.size(); ++i)
  {
    const double          begin = shareOfTrial * static_cast<double>(i);
    const double          middle = begin + 0.7 * shareOfTrial;
    const CylindricalWarp warp = WarpAbout(pair, trials[i], source, progress.Part("", begin, middle));
    CorrectedWarp         corrected = CorrectWarp(pair, warp, method, progress.Part("", middle, begin + shareOfTrial));
    if (choice.best.warp.s.empty() || corrected.Support() > choice.best.Support())
    {
      choice.best = std::move(corrected);
    }
  }
  choice.best = CorrectChosenWarp(pair, choice.best.warp, method, progress.Part("", 0.8, 0.9));
  choice.energies = EnergiesOfThirds(pair, choice.best.warp, source, progress.Part("", 0.9, 1.0));
  choice.frameRotation = pair.AreTaeniaeKnown() ? RotationOfFrame(pair, choice.best.warp) : choice.best.warp.rotation;
  return choice;
}
} // namespace shapeton
