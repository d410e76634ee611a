#ifndef shapetonSmoothedCurvature_h
#define shapetonSmoothedCurvature_h

#include "FlatColonExport.h"

#include "shapetonSurfaceMesh.h"

namespace shapeton
{
/** What the mean curvature of a vertex is divided by. \ingroup FlatColon */
enum class CurvatureUnit
{
  /** Half the sum of the principal curvatures, 1/mm: does not depend on the mesh. */
  PerArea,
  /** Not divided by the area of the vertex, with the sign turned (dissertation 4.3.1, sum of cotangent weights times
   * the edges along the normal), mm: grows with the faces. */
  Published
};

/** Mean curvature of each vertex after diffusion of heat over the surface for `time` mm^2 (two implicit steps; Neumann
 * boundaries). A surface whose faces are counterclockwise from outside has positive values PerArea, and negative
 * Published ones, where it bulges inwards, as at folds. 0 at boundary vertices before smoothing, where curvature is
 * not defined; cut to +-1/mm, so that needles do no harm. Throws InputError as MakeSurfaceLaplacian() with lengths
 * does, ParameterError for a negative time. \ingroup FlatColon */
FlatColon_EXPORT Eigen::VectorXd
                 SmoothedMeanCurvature(const VertexMatrix & V,
                                       const FaceMatrix &   F,
                                       double               time,
                                       CurvatureUnit        unit = CurvatureUnit::PerArea);
} // namespace shapeton

#endif
