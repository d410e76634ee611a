#ifndef shapetonStartFrame_h
#define shapetonStartFrame_h

#include "shapetonColonCylinder.h"
#include "shapetonColonPosition.h"

#include <string>

namespace shapeton
{
/** An increasing, piecewise linear function between the distances along two colons, extrapolated linearly. */
struct PiecewiseLine
{
  std::vector<double> from;
  std::vector<double> to;

  double
  operator()(double value) const;
  PiecewiseLine
  Inverse() const
  {
    return { to, from };
  }
};

/** Frame from the ends and the flexures found in both colons. A flexure that would stretch the adjacent colon more than
 * three times as much as the rest is skipped, with a warning. */
PiecewiseLine
FlexureFrame(const ColonPosition &      source,
             const ColonCylinder &      sourceCylinder,
             const ColonPosition &      target,
             const ColonCylinder &      targetCylinder,
             std::vector<std::string> & warnings);

/** Frame from the ends only. */
PiecewiseLine
EndFrame(const PiecewiseLine & frame);

/** Weighted mean of EndFrame() and FlexureFrame(): flexures are weighted by their confidence in both positions; the
 * expected deviation from proportional lengths is 40 mm. */
PiecewiseLine
CautiousFrame(const PiecewiseLine & frame, const ColonPosition & source, const ColonPosition & target);

/** Angles of the three taeniae in unwrapped turns, every `step` mm from the start of the colon. The taeniae are in
 * order around the tube. */
struct TaeniaAngles
{
  double                             begin{ 0.0 };
  double                             step{ 3.0 };
  std::array<std::vector<double>, 3> turns;
  /** Index of each in ColonPosition::taeniae. */
  std::array<int, 3> curves{ { 0, 1, 2 } };
  bool               isKnown{ false };

  double
  At(int taenia, double s) const;
};

/** Empty, with a warning, unless there are three taeniae. */
TaeniaAngles
AnglesOfTaeniae(const ColonPosition & position, const ColonCylinder & cylinder, std::vector<std::string> & warnings);

/** Unwrapped rotation (turns) of the target relative to the source at each position `s` of the source, if taenia i of
 * the source corresponds to taenia i + shift of the target. */
std::vector<double>
RotationOfTaeniae(const TaeniaAngles &        source,
                  const TaeniaAngles &        target,
                  const PiecewiseLine &       frame,
                  int                         shift,
                  const std::vector<double> & s);
} // namespace shapeton

#endif
