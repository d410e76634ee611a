#ifndef shapetonFlatVertexValues_h
#define shapetonFlatVertexValues_h

#include "shapetonSurfaceMesh.h"

#include <vector>

namespace shapeton
{
/** Vertex values with the copies along the cut merged. Rows by source vertex. */
struct FlatVertexValues
{
  /** Unit vectors, area-weighted means of the face normals; zero without area. */
  VertexMatrix normals;
  /** Mean curvature, 1/mm, positive where the surface bulges to the side of the normals. */
  Eigen::VectorXd curvature;
  /** Square root of the ratio of surface area to map area of the adjacent faces. */
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
