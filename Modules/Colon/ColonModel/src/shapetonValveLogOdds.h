#ifndef shapetonValveLogOdds_h
#define shapetonValveLogOdds_h

#include "shapetonIleocecalValve.h"
#include "shapetonValveBulges.h"

#include <vector>

namespace shapeton
{
/** A candidate for the valve: a bulge, or several nearby bulges, such as lips. */
struct ValveEvidence
{
  /** The candidate; arcLength and confidence are not set. */
  IleocecalValve valve;
  /** Distance to the end of the line, mm. */
  double beforeEnd{ 0.0 };
  /** Total area of the bulges, mm^2. */
  double area{ 0.0 };
  /** Solid angle of the largest bulge, sr. */
  double solidAngle{ 0.0 };
  /** Whether two bulges are beside each other as the lips of a valve are. */
  bool hasTwoLips{ false };
};

/** Groups bulges with a larger one that is at most 18 mm away; tagged matter and gas cannot be lips of a valve. */
std::vector<ValveEvidence>
JoinLips(std::vector<ValveBulge> bulges);

/** Log-odds that a candidate is the valve rather than another bulge. */
double
ValveLogOdds(const ValveEvidence & evidence);
} // namespace shapeton

#endif
