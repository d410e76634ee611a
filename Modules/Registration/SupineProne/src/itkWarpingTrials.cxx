#include "itkWarpingTrials.h"

#include <algorithm>
#include <limits>

namespace itk
{
namespace
{
/** A frame to try, and how far the path may leave it. */
struct Trial
{
  PiecewiseLine frame;
  double        band;
  double        deviation;
  /** Weights of slope and rotation. */
  double slope;
  double rotation;
  /** Any rotation, in case taeniae were lost somewhere. */
  bool isFree;
};

/** Flexures are found with errors of centimetres, and lengths are not quite proportional: neither is a frame that can
 * be trusted alone. Segments need the flexures themselves. */
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
    const double band = 60.0 + 15.0 * static_cast<double>(i);
    const double deviation = 25.0 + 12.0 * static_cast<double>(i);
    trials.push_back({ frames[i], band, deviation, 0.3, 0.4, !pair.AreTaeniaeKnown() });
    trials.push_back({ frames[i], band, deviation, 2.0, 1.0, !pair.AreTaeniaeKnown() });
    if (pair.AreTaeniaeKnown())
    {
      trials.push_back({ frames[i], band, deviation, 2.0, 1.0, true });
    }
  }
  return trials;
}

/** Rows of the warping lie in the coordinate of the source. The source without a frame. */
CylinderPicture
PictureOf(const ColonPair & pair, const PiecewiseLine * frame)
{
  CylinderPictureForm form;
  form.begin = pair.sourceCylinder->Begin() + 0.5 * WarpRowStep;
  form.step = frame ? 0.5 * WarpRowStep : WarpRowStep;
  form.rows = std::max(2, static_cast<int>((pair.sourceCylinder->End() - pair.sourceCylinder->Begin()) / form.step));
  form.angles = WarpAngles;
  form.smoothRows = frame ? 1.6 : 0.8;
  const PiecewiseLine back = frame ? frame->Inverse() : PiecewiseLine{ { 0.0, 1.0 }, { 0.0, 1.0 } };
  form.coordinate = [back](double s) { return back(s); };
  return frame ? MakeCylinderPicture(pair.target, *pair.targetCylinder, pair.targetFolds, form)
               : MakeCylinderPicture(pair.source, *pair.sourceCylinder, pair.sourceFolds, form);
}

/** Lowers the energies of the ways in which the taeniae may correspond. */
CylindricalWarp
BestWarp(const ColonPair &           pair,
         const Trial &               trial,
         const CylinderPicture &     source,
         const std::vector<double> & s,
         std::vector<double> &       energies)
{
  const CylinderPicture     target = PictureOf(pair, &trial.frame);
  CylindricalWarpingOptions options;
  options.breaks = pair.breaks;
  options.band = trial.band;
  options.frameDeviation = trial.deviation;
  options.slopeWeight = trial.slope;
  options.rotationWeight = trial.rotation;
  CylindricalWarp best;
  best.energy = std::numeric_limits<double>::infinity();
  if (trial.isFree)
  {
    return WarpCylinder(source, target, trial.frame, {}, options);
  }
  for (int way = 0; way < static_cast<int>(energies.size()); ++way)
  {
    const std::vector<double> rotation = RotationOfTaeniae(pair.sourceTaeniae, pair.targetTaeniae, trial.frame, way, s);
    const CylindricalWarp     warp = WarpCylinder(source, target, trial.frame, rotation, options);
    energies[way] = std::min(energies[way], warp.energy);
    best = warp.energy < best.energy ? warp : best;
  }
  return best;
}
} // namespace

WarpingChoice
WarpByTrials(const ColonPair & pair, FoldMatchingMethod method)
{
  const CylinderPicture source = PictureOf(pair, nullptr);
  std::vector<double>   s;
  for (int row = 0; row < source.Rows(); ++row)
  {
    s.push_back(source.begin + row * source.step);
  }
  WarpingChoice choice;
  choice.energies.assign(pair.AreTaeniaeKnown() ? 3 : 0, std::numeric_limits<double>::infinity());
  for (const Trial & trial : Trials(pair))
  {
    CorrectedWarp corrected = CorrectWarp(pair, BestWarp(pair, trial, source, s, choice.energies), method);
    if (choice.best.warp.s.empty() || corrected.Support() > choice.best.Support())
    {
      choice.best = std::move(corrected);
    }
  }
  choice.best = CorrectChosenWarp(pair, choice.best.warp, method);
  choice.frameRotation = choice.best.warp.rotation;
  if (!choice.energies.empty())
  {
    const auto least = std::min_element(choice.energies.begin(), choice.energies.end());
    const int  way = static_cast<int>(least - choice.energies.begin());
    choice.frameRotation = RotationOfTaeniae(pair.sourceTaeniae, pair.targetTaeniae, pair.frame, way, s);
  }
  return choice;
}
} // namespace itk
