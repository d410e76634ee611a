#ifndef shapetonFlatVertexValues_h
#define shapetonFlatVertexValues_h

#include "shapetonSurfaceMesh.h"

#include <vector>

namespace shapeton
{
/** Vertex values with duplicates along the cut merged; one row per source vertex. */
struct FlatVertexValues
{
  /** Area-weighted means of the face normals, normalized; zero if the area is zero. */
  VertexMatrix normals;
  /** Mean curvature, 1/mm, positive where the surface bulges toward the normals. */
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
