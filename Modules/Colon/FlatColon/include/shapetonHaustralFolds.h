#ifndef shapetonHaustralFolds_h
#define shapetonHaustralFolds_h

#include "ShapetonFlatColonExport.h"

#include "shapetonRemarks.h"
#include "shapetonColonAssessability.h"
#include "shapetonCurveSet.h"
#include "shapetonFlatColon.h"
#include "shapetonHaustralFoldOptions.h"
#include "shapetonProgress.h"

#include "itkImage.h"

#include <array>
#include <vector>

namespace shapeton
{
/** Settings of FindHaustralFolds(). \ingroup ShapetonFlatColon */
struct HaustralFoldSettings : HaustralFoldOptions
{
  /** Taeniae on the wall, which split merged folds; may be null. */
  const CurveSet * taeniae{ nullptr };
  /** May throw to abort. */
  Progress progress;
};

/** A haustral fold. \ingroup ShapetonFlatColon */
struct HaustralFold
{
  /** Value in the label picture, from 1, in the order of u. */
  int label{ 0 };
  /** Center and ends on the map, mm; v in [0, circumference). */
  Eigen::Vector2d                centerUv{ Eigen::Vector2d::Zero() };
  std::array<Eigen::Vector2d, 2> endUv;
  /** Center and ends on the surface, LPS, mm. */
  Eigen::Vector3d                center{ Eigen::Vector3d::Zero() };
  std::array<Eigen::Vector3d, 2> ends;
  /** Length along the crest, mm on the surface. */
  double length{ 0.0 };
  /** Area of the label, mm^2 on the surface. The minimum area applies before the label is extended along the crest. */
  double area{ 0.0 };
  /** Ratio of the long to the short axis of the ellipse with the same second moments on the map. */
  double elongation{ 1.0 };
  /** Angle between the long axis and u, degrees, in (-90, 90]; 90 is circumferential. */
  double angle{ 0.0 };
  /** Mean smoothed curvature, 1/mm; positive where the wall bulges into the lumen. */
  double meanCurvature{ 0.0 };
  /** Maximum height (mm) of the crest above the wall on both sides; NaN if the wall is not visible on one of them. */
  double height{ 0.0 };
  /** Certainty that this is a fold, 0 to 1. */
  double reliability{ 0.0 };
  /** Reliability of the ends as feature points, 0 to 1: the reliability of the fold, reduced to half of it far from the
   * map border (the cut) or, if taeniae are given, far from the nearest taenia. */
  std::array<double, 2> endReliability{ { 0.0, 0.0 } };
  /** mm along the centerline; NaN if the surface lacks arcLength. */
  double arcLength{ 0.0 };
  /** Whether the fold crosses the cut. */
  bool crossesCut{ false };
  /** Reason why the wall at the fold is not clearly visible; None if the surface lacks the cell array notAssessable. */
  ColonHindrance hindrance{ ColonHindrance::None };
};

/** The haustral folds on a flat map: a label image and a list. See FindHaustralFolds(). \ingroup ShapetonFlatColon */
struct HaustralFolds
{
  /** 0 for wall; on the grid and in the physical space of the coordinate map (FlatCoordinateMap). */
  itk::Image<unsigned short, 2>::Pointer labels;
  std::vector<HaustralFold>              folds;
  Remarks                                warnings;
};

/** Finds folds on the flat map of a colon (dissertation 4.3.1) on the grid of FlatColon. Bridged stretches are
 * excluded. Adds a warning if no folds are found. The result does not depend on the number of threads. Throws
 * ParameterError for options out of range, and InputError if vertices of the surface coincide.
 * \ingroup ShapetonFlatColon */
ShapetonFlatColon_EXPORT HaustralFolds
FindHaustralFolds(const FlatColon & flat, const HaustralFoldSettings & options = {});
} // namespace shapeton

#endif
