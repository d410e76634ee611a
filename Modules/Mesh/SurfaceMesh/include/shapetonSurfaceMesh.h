#ifndef shapetonSurfaceMesh_h
#define shapetonSurfaceMesh_h

#include "ShapetonSurfaceMeshExport.h"

#include <Eigen/Core>

#include <string>
#include <utility>
#include <vector>

namespace shapeton
{
/** Vertex positions, one per row (LPS, mm). \ingroup ShapetonSurfaceMesh */
using VertexMatrix = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
/** Triangles, three vertex indices per row, counterclockwise as seen from outside. \ingroup ShapetonSurfaceMesh */
using FaceMatrix = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>;

/** Named values: one row for each vertex or face, or any number of rows for the surface as a whole.
 * \ingroup ShapetonSurfaceMesh */
struct SurfaceArray
{
  using ValueMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  std::string name;
  ValueMatrix values;
  /** Integer values, written as 32-bit integers. */
  bool areIntegers{ false };
};

/** \class SurfaceMesh
 * \brief A triangle surface: vertices V, faces F, and arrays on them.
 *
 * The algorithms of this module use V and F; other mesh classes are used only in file readers and writers.
 * RequireSound() guarantees valid indices only: faces may be degenerate or inconsistent. InspectSurface() finds such
 * defects and RepairSurface() repairs them.
 *
 * \ingroup ShapetonSurfaceMesh
 */
struct SurfaceMesh
{
  VertexMatrix V;
  FaceMatrix   F;
  /** One row for each vertex. */
  std::vector<SurfaceArray> pointArrays;
  /** One row for each face. */
  std::vector<SurfaceArray> cellArrays;
  /** Arrays for the surface as a whole, for example a vertex list. */
  std::vector<SurfaceArray> fieldArrays;
  /** Key-value metadata as text, for example provenance; kept by VTP. */
  std::vector<std::pair<std::string, std::string>> facts;

  int
  NumberOfVertices() const
  {
    return static_cast<int>(V.rows());
  }
  int
  NumberOfFaces() const
  {
    return static_cast<int>(F.rows());
  }
};

/** The array of this name, or nullptr. \ingroup ShapetonSurfaceMesh */
ShapetonSurfaceMesh_EXPORT const SurfaceArray *
FindSurfaceArray(const std::vector<SurfaceArray> & arrays, const std::string & name);

/** Throws InputError with the prefix `what` (a file, an argument) if there are no faces, an index is out of range, a
 * coordinate of a used vertex is not finite, or an array has the wrong number of rows. Unused vertices may have any
 * coordinates. \ingroup ShapetonSurfaceMesh */
ShapetonSurfaceMesh_EXPORT void
RequireSound(const SurfaceMesh & mesh, const std::string & what);

/** Extracts the given faces, in their order. Unused vertices are dropped, and the others keep their order. Point and
 * cell arrays are reduced accordingly; field arrays and facts are kept unchanged. \ingroup ShapetonSurfaceMesh */
ShapetonSurfaceMesh_EXPORT SurfaceMesh
FacesOfSurface(const SurfaceMesh & mesh, const std::vector<int> & faces);
} // namespace shapeton

#endif
