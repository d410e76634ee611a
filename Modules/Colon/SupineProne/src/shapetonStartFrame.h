#ifndef shapetonStartFrame_h
#define shapetonStartFrame_h

#include "shapetonColonCylinder.h"
#include "shapetonColonPosition.h"

#include <string>

namespace shapeton
{
/** An ascending function of the distance along one colon to that along the other, straight between its nodes and
 * beyond them. */
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

/** The ends of both colons, and the flexures that were found in both. A flexure that would stretch the colon beside it
 * more than three times against the rest is left out, with a warning. */
PiecewiseLine
FlexureFrame(const ColonPosition &      source,
             const ColonCylinder &      sourceCylinder,
             const ColonPosition &      target,
             const ColonCylinder &      targetCylinder,
             std::vector<std::string> & warnings);

/** The frame of the ends alone. */
PiecewiseLine
EndFrame(const PiecewiseLine & frame);

/** Between EndFrame() and FlexureFrame(): each flexure moves the frame as far as its confidence in both positions
 * supports, against a deviation from proportional lengths of 40 mm that is expected of colons anyway. */
PiecewiseLine
CautiousFrame(const PiecewiseLine & frame, const ColonPosition & source, const ColonPosition & target);

/** Angles of the three taeniae in turns, without jumps, every `step` mm from the beginning of the colon; in the order
 * in which they follow each other around the tube. */
struct TaeniaAngles
{
  double                             begin{ 0.0 };
  double                             step{ 3.0 };
  std::array<std::vector<double>, 3> turns;
  bool                               isKnown{ false };

  double
  At(int taenia, double s) const;
};

/** Not known, with a warning, where there are not three taeniae. */
TaeniaAngles
AnglesOfTaeniae(const ColonPosition & position, const ColonCylinder & cylinder, std::vector<std::string> & warnings);

/** By how many turns the target is turned against the source, at places `s` of the source, when taenia i of the source
 * is taenia i + shift of the target. Without jumps. */
std::vector<double>
RotationOfTaeniae(const TaeniaAngles &        source,
                  const TaeniaAngles &        target,
                  const PiecewiseLine &       frame,
                  int                         shift,
                  const std::vector<double> & s);
} // namespace shapeton

#endif
