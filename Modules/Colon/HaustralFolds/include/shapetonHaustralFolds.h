#ifndef shapetonHaustralFolds_h
#define shapetonHaustralFolds_h

#include "HaustralFoldsExport.h"

#include "shapetonRemarks.h"
#include "shapetonColonAssessability.h"
#include "shapetonCurveSet.h"
#include "shapetonFlatColon.h"
#include "shapetonProgress.h"

#include "itkImage.h"

#include <array>
#include <string>
#include <vector>

namespace shapeton
{
/** How pixels of the flat map become folds. \ingroup HaustralFolds */
enum class HaustralFoldScheme
{
  /** Least cut of a graph whose weights come from the surface itself. */
  GraphCut,
  /** A fixed interval of a curvature that is not divided by area (dissertation 4.2.1 and 4.3.1): it holds for one
   * density of the mesh. */
  Published
};

/** Scheme, least size and smoothing for FindHaustralFolds(). \ingroup HaustralFolds */
struct HaustralFoldOptions
{
  HaustralFoldScheme scheme{ HaustralFoldScheme::GraphCut };
  /** \name What is too small for a fold */
  ///@{
  /** Along the crest, mm on the surface. */
  double minimumLength{ 7.0 };
  /** mm^2 on the surface. */
  double minimumArea{ 12.0 };
  /** Long over short axis of the ellipse. */
  double minimumElongation{ 1.5 };
  /** Between the long axis and the tube, degrees, 0 to 90: folds run around, taeniae and what other loops of the bowel
   * press in run along. */
  double minimumAngle{ 30.0 };
  ///@}
  /** Time of the heat diffusion that smooths the curvature, mm^2; 0 for none. */
  double smoothingTime{ 2.0 };
  /** \name GraphCut */
  ///@{
  /** Cost of 1 mm of outline, over that of 1 mm^2 for which fold and wall are e times as probable. */
  double smoothness{ 1.0 };
  /** The outline costs less where curvature changes by more than this, 1/mm. */
  double contrast{ 0.02 };
  ///@}
  /** \name Published: folds lie between these, mm; negative where the wall bulges into the lumen */
  ///@{
  double publishedLow{ -4.5 };
  double publishedHigh{ -0.5 };
  ///@}
  /** Curves on the wall, along which folds that have grown together are split; may be null. */
  const CurveSet * taeniae{ nullptr };
  /** It may throw in order to abort. */
  Progress progress;
};

/** A haustral fold. \ingroup HaustralFolds */
struct HaustralFold
{
  /** Its value in the label picture, from 1 on, in the order of u. */
  int label{ 0 };
  /** Places on the map, mm; v in [0, circumference). */
  Eigen::Vector2d                centreUv{ Eigen::Vector2d::Zero() };
  std::array<Eigen::Vector2d, 2> endUv;
  /** The same on the surface, LPS, mm. */
  Eigen::Vector3d                centre{ Eigen::Vector3d::Zero() };
  std::array<Eigen::Vector3d, 2> ends;
  /** Along the crest, mm on the surface. */
  double length{ 0.0 };
  /** Of the label, mm^2 on the surface; the least area is asked of the cut alone, before its label is lengthened along
   * the crest. */
  double area{ 0.0 };
  /** Long over short axis of the ellipse with the same second moments on the map. */
  double elongation{ 1.0 };
  /** Of the long axis against u, degrees, in (-90, 90]; 90 runs around the tube. */
  double angle{ 0.0 };
  /** Over the fold, after smoothing, 1/mm; positive where the wall bulges into the lumen. */
  double meanCurvature{ 0.0 };
  /** The most that the crest stands above the wall on both sides, mm; not a number where a side cannot be seen. */
  double height{ 0.0 };
  /** How sure it is that this is a fold, 0 to 1. */
  double reliability{ 0.0 };
  /** Of the ends as feature points, 0 to 1: that of the fold, and half of it far from the border of the map (the cut)
   * or from the nearest taenia, where they are given. */
  std::array<double, 2> endReliability{ { 0.0, 0.0 } };
  /** mm along the centreline; not a number where the surface does not tell. */
  double arcLength{ 0.0 };
  /** Lies on both sides of the cut. */
  bool crossesCut{ false };
  /** Why the wall is not seen well there; None as well where the surface, by its cell array notAssessable, does not
   * tell. */
  ColonHindrance hindrance{ ColonHindrance::None };
};

/** The haustral folds on a flat map: a label image and a list. See FindHaustralFolds(). \ingroup HaustralFolds */
struct HaustralFolds
{
  /** 0 for wall; has the grid and the physical space of the coordinate map (FlatCoordinateMap). */
  itk::Image<unsigned short, 2>::Pointer labels;
  std::vector<HaustralFold>              folds;
  Remarks                                warnings;
};

/** Folds on the flat map of a colon (dissertation 4.3.1), in the pixels of its own grid. Stretches bridged over gaps
 * hold none. A surface without folds is no error: there is a warning. Equal input gives equal results for any number of
 * threads. Throws ParameterError for options out of range, InputError where vertices of the surface coincide.
 * \ingroup HaustralFolds */
HaustralFolds_EXPORT HaustralFolds
FindHaustralFolds(const FlatColon & flat, const HaustralFoldOptions & options = {});
} // namespace shapeton

#endif
