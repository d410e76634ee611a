#ifndef shapetonSurfaceFolds_h
#define shapetonSurfaceFolds_h

#include "ShapetonFlatColonExport.h"

#include "shapetonFlatColon.h"
#include "shapetonProgress.h"

#include <vector>

namespace shapeton
{
/** Thresholds of curvature and size for folds on the surface. See FindSurfaceFolds().
 * \ingroup ShapetonFlatColon */
struct SurfaceFoldOptions
{
  /** Time of the heat diffusion that smooths the curvature, mm^2. */
  double smoothingTime{ 3.0 };
  /** Minimum mean curvature of the faces of a fold, 1/mm; positive where the wall bulges into the lumen. 0 uses the
   * value that best separates the areas of wall and folds (Otsu, 1979). */
  double leastCurvature{ 0.0 };
  /** Minimum area, mm^2. */
  double leastArea{ 12.0 };
  /** Minimum diagonal of the box of a fold, mm. */
  double leastExtent{ 7.0 };
};

/** Folds found on the surface itself, without the flat picture (dissertation 4.2.1). \ingroup ShapetonFlatColon */
struct SurfaceFolds
{
  /** Threshold used, 1/mm. */
  double leastCurvature{ 0.0 };
  /** Curvature of each point of the flat surface, 1/mm. */
  Eigen::VectorXd curvature;
  /** For each face the number of its fold from 1, ordered by lowest face index; 0 for wall. */
  std::vector<int> foldOfFace;
  int              number{ 0 };
  /** Total area of the folds, mm^2. */
  double area{ 0.0 };
};

/** Finds folds as edge-connected sets of faces, also across the cut, whose mean curvature, divided by area and smoothed
 * by heat diffusion, exceeds the threshold. Small sets are dropped. Bridged faces contain no folds. Throws InputError
 * for degenerate faces. \ingroup ShapetonFlatColon */
ShapetonFlatColon_EXPORT SurfaceFolds
FindSurfaceFolds(const FlatColon & flat, const SurfaceFoldOptions & options = {}, const Progress & progress = {});
} // namespace shapeton

#endif
