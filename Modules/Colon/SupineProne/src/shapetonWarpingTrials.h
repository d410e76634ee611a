#ifndef shapetonWarpingTrials_h
#define shapetonWarpingTrials_h

#include "shapetonCorrectedWarp.h"

namespace shapeton
{
/** The warp that was chosen of many, and what the others tell. */
struct WarpingChoice
{
  CorrectedWarp best;
  /** Least energies near it, and near it turned by one and two thirds, which is how taeniae may be confused. */
  std::vector<double> energies;
  /** Of the frame of flexures, at the rows of the warp: from the taeniae, in the way that agrees best with it. */
  std::vector<double> frameRotation;
};

/** Warps about several frames, free in rotation, with and without taeniae in the picture. Energy does not tell a path
 * that is one fold too far from the right one; how many pairs of folds a smooth map can follow does, so that decides
 * between the trials. */
WarpingChoice
WarpByTrials(const ColonPair & pair, FoldMatchingMethod method, const Progress & progress);
} // namespace shapeton

#endif
