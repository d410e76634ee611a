#ifndef shapetonFlatVertexValues_h
#define shapetonFlatVertexValues_h

#include "shapetonSurfaceMesh.h"

#include <vector>

namespace shapeton
{
/** Values of vertices, in which the copies of a vertex along the cut are one. Rows by source vertex. */
struct FlatVertexValues
{
  /** Unit vectors, means of the faces' normals by area; zero where there is no area. */
  VertexMatrix normals;
  /** Mean curvature, 1/mm, positive where the surface bulges towards the side that the normals look to. */
  Eigen::VectorXd curvature;
  /** The root of area on the surface over area of the map, of the faces around. */
  Eigen::VectorXd scale;
};

/** `curvatureLength` and `normalLength` as in FlatColonGridOptions. */
FlatVertexValues
MakeFlatVertexValues(const VertexMatrix &     V,
                     const FaceMatrix &       F,
                     const Eigen::MatrixX2d & uv,
                     const std::vector<int> & sourceOfVertex,
                     double                   curvatureLength,
                     double                   normalLength);
} // namespace shapeton

#endif
