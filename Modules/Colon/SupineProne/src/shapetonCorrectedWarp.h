#ifndef shapetonCorrectedWarp_h
#define shapetonCorrectedWarp_h

#include "shapetonColonPair.h"
#include "shapetonCylindricalWarping.h"
#include "shapetonFoldMatching.h"
#include "shapetonSmoothCorrection.h"

namespace shapeton
{
/** A row-wise map with a smooth correction. */
struct RowMap
{
  PiecewiseLine                           s;
  PiecewiseLine                           rotation;
  std::shared_ptr<const SmoothCorrection> correction;
  double                                  around{ 1.0 }; ///< circumference of the target, mm

  CylinderPlace
  operator()(const CylinderPlace & place) const;
};

/** A warp, the fold pairs matched under it, and the resulting correction. */
struct CorrectedWarp
{
  CylindricalWarp                         warp;
  FoldMatching                            matching;
  std::shared_ptr<const SmoothCorrection> correction;
  /** Standard deviation of the taenia constraints of the correction, mm. */
  double taeniaDeviation{ 3.0 };
  /** Stiffness of the correction, mm^2. */
  double stiffness{ 2.0 };
  /** Final weight of the center of each pair in the correction, 0 to 1. */
  std::vector<double> pairWeights;

  /** The map without the correction, and with it. */
  RowMap
  Warp(const ColonPair & pair) const;
  RowMap
  Map(const ColonPair & pair) const;
  /** Number of consistent pairs minus the number of inconsistent pairs. */
  double
  Support() const;
};

/** Matches folds under the warp, and again under the corrected warp. The correction is a thin plate through the centers
 * and ends of matched folds and along the taeniae. Used to rate a warp: taeniae are weighted like folds, and the
 * correction is too stiff to follow wrong pairs. */
CorrectedWarp
CorrectWarp(const ColonPair & pair, const CylindricalWarp & warp, FoldMatchingMethod method, const Progress & progress);

/** Repeats the correction with less stiffness for the selected warp. The weight of a taenia point is a quarter of the
 * weight of a fold, since taeniae are less accurate and errors of neighboring points are correlated. */
CorrectedWarp
CorrectChosenWarp(const ColonPair &       pair,
                  const CylindricalWarp & warp,
                  FoldMatchingMethod      method,
                  const Progress &        progress);

/** Refines the correction by Gauss-Newton on the fold pictures. */
void
RefineByPictures(const ColonPair & pair, CorrectedWarp & corrected, const Progress & progress);

/** Refits the correction to the matched folds, the taeniae, and further constraints. */
void
FitCorrection(const ColonPair &                pair,
              const RowMap &                   map,
              std::vector<DirectionConstraint> more,
              CorrectedWarp &                  corrected,
              const Progress &                 progress);
} // namespace shapeton

#endif
