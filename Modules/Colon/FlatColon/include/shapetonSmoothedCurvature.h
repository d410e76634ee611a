#ifndef shapetonSmoothedCurvature_h
#define shapetonSmoothedCurvature_h

#include "ShapetonFlatColonExport.h"

#include "shapetonSurfaceMesh.h"

namespace shapeton
{
/** Normalization of the mean curvature of a vertex. \ingroup ShapetonFlatColon */
enum class CurvatureUnit
{
  /** Half the sum of the principal curvatures, 1/mm; independent of the mesh. */
  PerArea,
  /** Opposite in sign and not divided by vertex area (dissertation 4.3.1: normal component of the cotangent-weighted
   * edge sum), mm; increases with face size. */
  Published
};

/** Mean curvature of each vertex after heat diffusion over the surface for `time` mm^2 (two implicit steps; Neumann
 * boundaries). If faces are counterclockwise as seen from outside, inward bulges such as folds are positive with
 * PerArea and negative with Published. Before smoothing, values are 0 at boundary vertices, where curvature is
 * undefined, and clamped to +-1/mm to limit the effect of needle triangles. Throws InputError for degenerate faces as
 * MakeSurfaceLaplacian() does, and ParameterError for a negative time. \ingroup ShapetonFlatColon */
ShapetonFlatColon_EXPORT Eigen::VectorXd
                         SmoothedMeanCurvature(const VertexMatrix & V,
                                               const FaceMatrix &   F,
                                               double               time,
                                               CurvatureUnit        unit = CurvatureUnit::PerArea);
} // namespace shapeton

#endif
