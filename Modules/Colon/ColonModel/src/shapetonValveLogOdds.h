#ifndef shapetonValveLogOdds_h
#define shapetonValveLogOdds_h

#include "shapetonIleocecalValve.h"
#include "shapetonValveBulges.h"

#include <vector>

namespace shapeton
{
/** A place that may be the valve: a bulge, or several nearby ones, such as lips. */
struct ValveEvidence
{
  /** Without arcLength and confidence. */
  IleocecalValve valve;
  /** Distance before the end of the line, mm. */
  double beforeEnd{ 0.0 };
  /** Total area of the bulges, mm^2. */
  double area{ 0.0 };
  /** Solid angle of the largest bulge, sr. */
  double solidAngle{ 0.0 };
};

/** Groups bulges within 18 mm of a larger one with it. */
std::vector<ValveEvidence>
JoinLips(std::vector<ValveBulge> bulges);

/** Log-odds that a place is the valve rather than no place. */
double
ValveLogOdds(const ValveEvidence & evidence);
} // namespace shapeton

#endif
