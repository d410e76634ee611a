#ifndef shapetonWarpingTrials_h
#define shapetonWarpingTrials_h

#include "shapetonCorrectedWarp.h"

namespace shapeton
{
/** The best warp of several trials. */
struct WarpingChoice
{
  CorrectedWarp best;
  /** Minimum energies near the warp and near the warp rotated by one and two thirds of a turn, to detect confused
   * taeniae. */
  std::vector<double> energies;
  /** Rotation of the frame of flexures at the rows of the warp, by the best correspondence of the taeniae. */
  std::vector<double> frameRotation;
};

/** Computes warps about several frames, free in rotation, with and without taeniae in the picture. Selects the warp
 * with the most fold pairs consistent with a smooth map, since the energy does not detect a path shifted by one
 * fold. */
WarpingChoice
WarpByTrials(const ColonPair & pair, FoldMatchingMethod method, const Progress & progress);
} // namespace shapeton

#endif
