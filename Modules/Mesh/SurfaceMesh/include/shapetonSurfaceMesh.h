#ifndef shapetonSurfaceMesh_h
#define shapetonSurfaceMesh_h

#include "SurfaceMeshExport.h"

#include <Eigen/Core>

#include <string>
#include <utility>
#include <vector>

namespace shapeton
{
/** Positions, one vertex in each row: LPS, mm. \ingroup SurfaceMesh */
using VertexMatrix = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
/** Triangles, three indices of vertices in each row, counterclockwise where seen from outside. \ingroup SurfaceMesh */
using FaceMatrix = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>;

/** Values with a name, one row for each vertex, each face, or as many as it likes for the surface as a whole.
 * \ingroup SurfaceMesh */
struct SurfaceArray
{
  using ValueMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  std::string name;
  ValueMatrix values;
  /** Whole numbers, written as 32-bit integers. */
  bool areIntegers{ false };
};

/** \class SurfaceMesh
 * \brief A triangle surface: vertices V, faces F, and arrays on them.
 *
 * The algorithms of this module take V and F; other mesh classes exist only where files are read and written. Nothing
 * is promised about a SurfaceMesh but that its indices are in range once RequireSound() has passed: faces may be
 * degenerate or inconsistent, which InspectSurface() finds and RepairSurface() mends.
 *
 * \ingroup SurfaceMesh
 */
struct SurfaceMesh
{
  VertexMatrix V;
  FaceMatrix   F;
  /** A row for each vertex. */
  std::vector<SurfaceArray> pointArrays;
  /** A row for each face. */
  std::vector<SurfaceArray> cellArrays;
  /** About the surface as a whole, for example a list of vertices. */
  std::vector<SurfaceArray> fieldArrays;
  /** Facts in words, for example provenance; kept by VTP. */
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

/** The array of this name, or nullptr. \ingroup SurfaceMesh */
SurfaceMesh_EXPORT const SurfaceArray *
FindSurfaceArray(const std::vector<SurfaceArray> & arrays, const std::string & name);

/** Throws InputError that begins with `what` (a file, an argument) when there is no face, an index is out of range, a
 * coordinate of a vertex that a face uses is not finite, or an array has the wrong number of rows. Vertices that no
 * face uses may be anywhere. \ingroup SurfaceMesh */
SurfaceMesh_EXPORT void
RequireSound(const SurfaceMesh & mesh, const std::string & what);

/** The surface of these faces alone, in their order. Vertices that no face needs are left out, the others keep their
 * order; point and cell arrays come along, field arrays and facts are kept as they are. \ingroup SurfaceMesh */
SurfaceMesh_EXPORT SurfaceMesh
FacesOfSurface(const SurfaceMesh & mesh, const std::vector<int> & faces);
} // namespace shapeton

#endif
