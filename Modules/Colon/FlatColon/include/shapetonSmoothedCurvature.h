#ifndef shapetonSmoothedCurvature_h
#define shapetonSmoothedCurvature_h

#include "ShapetonFlatColonExport.h"

#include "shapetonSurfaceMesh.h"

namespace shapeton
{
/** Normalization of the mean curvature of a vertex. \ingroup ShapetonFlatColon */
enum class CurvatureUnit
{
  /** Half the sum of the principal curvatures, 1/mm: independent of the mesh. */
  PerArea,
  /** Not divided by the area of the vertex and with the opposite sign (dissertation 4.3.1, sum of cotangent weights
   * times the edges along the normal), mm: increases with the size of the faces. */
  Published
};

/** Mean curvature of each vertex after heat diffusion over the surface for `time` mm^2 (two implicit steps; Neumann
 * boundaries). If faces are counterclockwise from outside, inward bulges such as folds are positive PerArea and
 * negative Published. Before smoothing it is 0 at boundary vertices, where curvature is undefined, and clamped to
 * +-1/mm against needle triangles. Throws the InputError of MakeSurfaceLaplacian() with lengths, and ParameterError for
 * a negative time. \ingroup ShapetonFlatColon */
ShapetonFlatColon_EXPORT Eigen::VectorXd
                 SmoothedMeanCurvature(const VertexMatrix & V,
                                       const FaceMatrix &   F,
                                       double               time,
                                       CurvatureUnit        unit = CurvatureUnit::PerArea);
} // namespace shapeton

#endif
