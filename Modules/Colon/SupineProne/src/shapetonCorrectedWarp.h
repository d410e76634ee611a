#ifndef shapetonCorrectedWarp_h
#define shapetonCorrectedWarp_h

#include "shapetonColonPair.h"
#include "shapetonCylindricalWarping.h"
#include "shapetonFoldMatching.h"
#include "shapetonSmoothCorrection.h"

namespace shapeton
{
/** A map that moves whole rows, with a smooth correction. */
struct RowMap
{
  PiecewiseLine                           s;
  PiecewiseLine                           rotation;
  std::shared_ptr<const SmoothCorrection> correction;
  double                                  around{ 1.0 }; ///< circumference of the target, mm

  CylinderPlace
  operator()(const CylinderPlace & place) const;
};

/** A warp with its matched pairs of folds, and the correction computed from them. */
struct CorrectedWarp
{
  CylindricalWarp                         warp;
  FoldMatching                            matching;
  std::shared_ptr<const SmoothCorrection> correction;
  /** Standard deviation of the taeniae as constraints of the correction, mm. */
  double taeniaDeviation{ 3.0 };
  /** Stiffness of the correction, mm^2. */
  double stiffness{ 2.0 };
  /** How much the correction follows the center of each pair, 0 to 1. */
  std::vector<double> pairWeights;

  /** The map without its correction, and with it. */
  RowMap
  Warp(const ColonPair & pair) const;
  RowMap
  Map(const ColonPair & pair) const;
  /** Number of pairs that the map follows minus the others. */
  double
  Support() const;
};

/** Matches folds about the warp, and again about the corrected one. The correction is a thin plate through the centers
 * and ends of matched folds and along the taeniae. Used to rate a warp: taeniae have the weight of folds, and the stiff
 * correction cannot follow wrong pairs. */
CorrectedWarp
CorrectWarp(const ColonPair & pair, const CylindricalWarp & warp, FoldMatchingMethod method, const Progress & progress);

/** Repeats it with less stiffness for the chosen warp. Taeniae are less accurate than folds, and errors of neighboring
 * points of one are correlated, so each has a quarter of the weight of a fold. */
CorrectedWarp
CorrectChosenWarp(const ColonPair &       pair,
                  const CylindricalWarp & warp,
                  FoldMatchingMethod      method,
                  const Progress &        progress);

/** Refines the correction by the fold pictures themselves (Gauss-Newton). */
void
RefineByPictures(const ColonPair & pair, CorrectedWarp & corrected, const Progress & progress);

/** Refits the correction to the matched folds, the taeniae under the map, and further constraints. */
void
FitCorrection(const ColonPair &                pair,
              const RowMap &                   map,
              std::vector<DirectionConstraint> more,
              CorrectedWarp &                  corrected,
              const Progress &                 progress);
} // namespace shapeton

#endif
