#ifndef itkWarpingTrials_h
#define itkWarpingTrials_h

#include "itkCorrectedWarp.h"

namespace itk
{
/** The warp that was chosen of many, and what the others tell. */
struct WarpingChoice
{
  CorrectedWarp best;
  /** Least energies for the three ways in which the taeniae may correspond; empty where they are not known. */
  std::vector<double> energies;
  /** Of the frame of flexures, at the rows of the warp: from the taeniae, in the way with the least energy. */
  std::vector<double> frameRotation;
};

/** Warps about several frames: of each trial the warp with the least energy, with the taeniae in each of the three ways
 * they may correspond, or with any rotation, in case they were lost somewhere. Energy does not tell a path that is one
 * fold too far from the right one; how many pairs of folds a smooth map can follow does, so that decides between the
 * trials. */
WarpingChoice
WarpByTrials(const ColonPair & pair, FoldMatchingMethod method);
} // namespace itk

#endif
