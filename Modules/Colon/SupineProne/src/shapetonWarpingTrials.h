#ifndef shapetonWarpingTrials_h
#define shapetonWarpingTrials_h

#include "shapetonCorrectedWarp.h"

namespace shapeton
{
/** The best warp of several trials. */
struct WarpingChoice
{
  CorrectedWarp best;
  /** Minimum energies near the warp and near the warp rotated by one third and by two thirds of a turn, to detect
   * confused taeniae. */
  std::vector<double> energies;
  /** Rotation of the flexure frame at the rows of the warp, according to the best correspondence of the taeniae. */
  std::vector<double> frameRotation;
};

/** Computes warps about several frames, free in rotation, with and without taeniae in the picture. Selects the warp
 * with the most fold pairs consistent with a smooth map, since the energy does not reveal whether a path is shifted by
 * one fold. */
WarpingChoice
WarpByTrials(const ColonPair & pair, FoldMatchingMethod method, const Progress & progress);
} // namespace shapeton

#endif
