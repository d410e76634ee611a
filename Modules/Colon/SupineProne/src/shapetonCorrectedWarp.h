#ifndef shapetonCorrectedWarp_h
#define shapetonCorrectedWarp_h

#include "shapetonColonPair.h"
#include "shapetonCylindricalWarping.h"
#include "shapetonFoldMatching.h"
#include "shapetonSmoothCorrection.h"

namespace shapeton
{
/** A map that moves rows as a whole, with a smooth correction. */
struct RowMap
{
  PiecewiseLine                           s;
  PiecewiseLine                           rotation;
  std::shared_ptr<const SmoothCorrection> correction;
  double                                  around{ 1.0 }; ///< of the target, mm

  CylinderPlace
  operator()(const CylinderPlace & place) const;
};

/** A warp with the pairs of folds that were taken about it, and the correction that they ask for. */
struct CorrectedWarp
{
  CylindricalWarp                         warp;
  FoldMatching                            matching;
  std::shared_ptr<const SmoothCorrection> correction;
  /** Standard deviation of the taeniae as constraints of the correction, mm. */
  double taeniaDeviation{ 3.0 };
  /** Of the correction, mm^2. */
  double stiffness{ 2.0 };
  /** How much the correction follows the middle of each pair, 0 to 1. */
  std::vector<double> pairWeights;

  /** The map without its correction, and with it. */
  RowMap
  Warp(const ColonPair & pair) const;
  RowMap
  Map(const ColonPair & pair) const;
  /** Pairs that the map follows, less those that it does not. */
  double
  Support() const;
};

/** Matches folds about the warp, and again about the corrected one; the correction is a thin plate through the middles
 * and ends of matched folds and along the taeniae. To judge a warp: taeniae count as much as folds, and the stiff
 * correction cannot follow wrong pairs. */
CorrectedWarp
CorrectWarp(const ColonPair & pair, const CylindricalWarp & warp, FoldMatchingMethod method, const Progress & progress);

/** The same once more and softer, for the warp that was chosen. Taeniae are found less exactly than folds, and
 * neighbouring points of one err together, so that each counts for a quarter of a fold. */
CorrectedWarp
CorrectChosenWarp(const ColonPair &       pair,
                  const CylindricalWarp & warp,
                  FoldMatchingMethod      method,
                  const Progress &        progress);

/** Corrects it further by the pictures of folds themselves (Gauss-Newton). */
void
RefineByPictures(const ColonPair & pair, CorrectedWarp & corrected, const Progress & progress);

/** Fits the correction anew through the matched folds, the taeniae as the map takes them, and what else is known. */
void
FitCorrection(const ColonPair &                pair,
              const RowMap &                   map,
              std::vector<DirectionConstraint> more,
              CorrectedWarp &                  corrected,
              const Progress &                 progress);
} // namespace shapeton

#endif
