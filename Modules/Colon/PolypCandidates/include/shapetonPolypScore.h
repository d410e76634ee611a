#ifndef shapetonPolypScore_h
#define shapetonPolypScore_h

#include "ShapetonPolypCandidatesExport.h"

#include <array>
#include <limits>

namespace shapeton
{
struct WallBulge;

/** Features that distinguish polyps from other parts of the wall. \ingroup ShapetonPolypCandidates */
struct PolypFeatures
{
  /** Mean shape index of the head, weighted by the smaller curvature: 1 for a cap, 0.5 for a ridge (Koenderink and van
   * Doorn 1992; Yoshida and Nappi 2001). */
  double shapeIndex{ 0.0 };
  /** Ratio of smallest to largest width perpendicular to the axis. */
  double roundness{ 0.0 };
  /** Concavity of the wall around the head: the negated smaller principal curvature of its foot
   * (WallBulge::footCurvature) times the largest width. 0.4 to 2.5 for phantom polyps; below 0.3 for three quarters of
   * the bumps on folds and on the wall. */
  double hollowness{ 0.0 };
  /** Mean curvedness of the head, 1/mm (Koenderink and van Doorn 1992): 2 / diameter for a ball, that is, 0.33 for 6
   * mm; 0.06 to 0.28 for phantom polyps of 5.5 mm or more. Sharper bulges are smaller heads, residue of fluid or of a
   * catheter, or edges of truncated walls. */
  double curvedness{ 0.0 };
  /** \name Reported, not in the score */
  ///@{
  /** Integral of the Gaussian curvature, sr. */
  double solidAngle{ 0.0 };
  /** Ratio of height to largest width. */
  double prominence{ 0.0 };
  ///@}
  /** \name Reported, not in the score: NaN unless MeasureShapeDiffusion() was run */
  ///@{
  /** Cumulative heat in the tissue of the head, 0 to 1. */
  double heat{ std::numeric_limits<double>::quiet_NaN() };
  /** Shapeton visits relative to the mean in the surrounding tissue. */
  double shapetonDensity{ std::numeric_limits<double>::quiet_NaN() };
  ///@}
};

/** Features of a bulge. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT PolypFeatures
FeaturesOf(const WallBulge & bulge);

/** Terms of the score: shape index, natural logarithms of roundness and of hollowness (clamped to at least 0.05), and
 * the logarithm of curvedness / (0.25 per mm), clamped to at least 0. \ingroup ShapetonPolypCandidates */
constexpr int                  numberOfPolypTerms = 4;
ShapetonPolypCandidates_EXPORT std::array<double, numberOfPolypTerms>
                               TermsOf(const PolypFeatures & features);

/** Logistic regression weights: those of the terms, then the constant. \ingroup ShapetonPolypCandidates */
using PolypWeights = std::array<double, numberOfPolypTerms + 1>;

/** The default weights; see the README for the training data. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT const PolypWeights &
FittedPolypWeights();

/** 1 / (1 + exp(-(w . terms + constant))), in (0, 1). \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT double
PolypScore(const PolypFeatures & features, const PolypWeights & weights = FittedPolypWeights());
} // namespace shapeton

#endif
