#ifndef shapetonSurfaceFolds_h
#define shapetonSurfaceFolds_h

#include "HaustralFoldsExport.h"

#include "shapetonFlatColon.h"
#include "shapetonProgress.h"

#include <vector>

namespace shapeton
{
/** From which curvature and which size on a patch of the wall is a fold. See FindSurfaceFolds().
 * \ingroup HaustralFolds */
struct SurfaceFoldOptions
{
  /** Of the heat diffusion that smooths the curvature, mm^2. */
  double smoothingTime{ 3.0 };
  /** Mean curvature from which a face belongs to a fold, 1/mm; positive where the wall bulges into the lumen. 0 takes
   * the value that parts the areas of wall and folds best (Otsu, 1979). */
  double leastCurvature{ 0.0 };
  /** mm^2. */
  double leastArea{ 12.0 };
  /** Diagonal of the box of a fold, mm. */
  double leastExtent{ 7.0 };
};

/** Folds found on the surface itself, without the flat picture (dissertation 4.2.1). \ingroup HaustralFolds */
struct SurfaceFolds
{
  /** That was used, 1/mm. */
  double leastCurvature{ 0.0 };
  /** For each point of the flat surface, 1/mm. */
  Eigen::VectorXd curvature;
  /** For each face the number of its fold from 1 on, by the least face; 0 for wall. */
  std::vector<int> foldOfFace;
  int              number{ 0 };
  /** Of all folds, mm^2. */
  double area{ 0.0 };
};

/** Faces whose mean curvature, divided by area and smoothed by heat diffusion, exceeds the threshold; what hangs
 * together by edges, also across the cut, is a fold where it is large enough. Bridged faces hold no folds. Throws
 * InputError where a face has no area. \ingroup HaustralFolds */
HaustralFolds_EXPORT SurfaceFolds
FindSurfaceFolds(const FlatColon & flat, const SurfaceFoldOptions & options = {}, const Progress & progress = {});
} // namespace shapeton

#endif
