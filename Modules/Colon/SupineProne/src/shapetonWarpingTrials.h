#ifndef shapetonWarpingTrials_h
#define shapetonWarpingTrials_h

#include "shapetonCorrectedWarp.h"

namespace shapeton
{
/** The best warp of several trials, and measures from the others. */
struct WarpingChoice
{
  CorrectedWarp best;
  /** Least energies near it, and near it rotated by one and two thirds, to detect confused taeniae. */
  std::vector<double> energies;
  /** Rotation of the frame of flexures at the rows of the warp: from the taeniae, in the correspondence that agrees
   * best. */
  std::vector<double> frameRotation;
};

/** Computes warps about several frames, free in rotation, with and without taeniae in the picture. The energy does not
 * detect a path shifted by one fold, but the number of fold pairs that a smooth map can follow does, so that number
 * selects the trial. */
WarpingChoice
WarpByTrials(const ColonPair & pair, FoldMatchingMethod method, const Progress & progress);
} // namespace shapeton

#endif
