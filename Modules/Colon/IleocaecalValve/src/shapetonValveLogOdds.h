#ifndef shapetonValveLogOdds_h
#define shapetonValveLogOdds_h

#include "shapetonIleocaecalValve.h"
#include "shapetonValveBulges.h"

#include <vector>

namespace shapeton
{
/** A place that may be the valve: a bulge, or several that are near each other, as lips are. */
struct ValveEvidence
{
  /** But for arcLength and confidence. */
  IleocaecalValve valve;
  /** mm before the end of the line. */
  double beforeEnd{ 0.0 };
  /** Of all bulges, mm^2. */
  double area{ 0.0 };
  /** Of the greatest bulge, sr. */
  double solidAngle{ 0.0 };
};

/** The bulges, those within 18 mm of a greater one with that. */
std::vector<ValveEvidence>
JoinLips(std::vector<ValveBulge> bulges);

/** Of a place being the valve, against there being none. */
double
ValveLogOdds(const ValveEvidence & evidence);
} // namespace shapeton

#endif
