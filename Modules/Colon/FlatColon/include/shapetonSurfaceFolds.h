#ifndef shapetonSurfaceFolds_h
#define shapetonSurfaceFolds_h

#include "ShapetonFlatColonExport.h"

#include "shapetonFlatColon.h"
#include "shapetonProgress.h"

#include <vector>

namespace shapeton
{
/** Curvature and size thresholds for folds on the surface. See FindSurfaceFolds().
 * \ingroup ShapetonFlatColon */
struct SurfaceFoldOptions
{
  /** Time of the heat diffusion that smooths the curvature, mm^2. */
  double smoothingTime{ 3.0 };
  /** Minimum mean curvature of the faces of a fold, 1/mm; positive where the wall bulges into the lumen. If 0, Otsu's
   * threshold (1979) between wall and folds is used. */
  double leastCurvature{ 0.0 };
  /** Minimum area, mm^2. */
  double leastArea{ 12.0 };
  /** Minimum bounding box diagonal of a fold, mm. */
  double leastExtent{ 7.0 };
};

/** Folds found on the surface itself rather than in a flat picture (dissertation 4.2.1). \ingroup ShapetonFlatColon */
struct SurfaceFolds
{
  /** Threshold used, 1/mm. */
  double leastCurvature{ 0.0 };
  /** Curvature of each point of the flat surface, 1/mm. */
  Eigen::VectorXd curvature;
  /** Fold number of each face, from 1 in the order of the lowest face index; 0 for wall. */
  std::vector<int> foldOfFace;
  int              number{ 0 };
  /** Total area of the folds, mm^2. */
  double area{ 0.0 };
};

/** Finds folds as sets of faces, connected by edges even across the cut, with a mean curvature (PerArea, smoothed by
 * heat diffusion) above the threshold. Small sets and bridged faces are excluded. Throws InputError for degenerate
 * faces.
 * \ingroup ShapetonFlatColon */
ShapetonFlatColon_EXPORT SurfaceFolds
FindSurfaceFolds(const FlatColon & flat, const SurfaceFoldOptions & options = {}, const Progress & progress = {});
} // namespace shapeton

#endif
