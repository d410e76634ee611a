#ifndef shapetonCurveSet_h
#define shapetonCurveSet_h

#include "shapetonSurfaceMesh.h"

namespace shapeton
{
/** \class CurveSet
 * \brief Polylines in space, such as a centerline or taeniae, and single points: vertices V with data arrays.
 * \ingroup ShapetonSurfaceMesh
 */
struct CurveSet
{
  /** Vertex positions (LPS, mm). */
  VertexMatrix V;
  /** The vertices of each curve in order; a curve of one vertex is a point. */
  std::vector<std::vector<int>> curves;
  /** One row for each vertex. */
  std::vector<SurfaceArray> pointArrays;
  /** One row for each curve. */
  std::vector<SurfaceArray> cellArrays;
  /** Arrays for the curve set as a whole. */
  std::vector<SurfaceArray> fieldArrays;
  /** Key-value metadata as text, for example provenance. */
  std::vector<std::pair<std::string, std::string>> facts;
};

/** Throws InputError with the prefix `what` if there are no vertices, a curve is empty or has an invalid vertex index,
 * a coordinate is not finite, or an array has too few rows. \ingroup ShapetonSurfaceMesh */
ShapetonSurfaceMesh_EXPORT void
RequireSound(const CurveSet & curves, const std::string & what);

/** Values of a single-component point array, one per vertex. Throws InputError with the prefix `what` if the array is
 * missing. \ingroup ShapetonSurfaceMesh */
ShapetonSurfaceMesh_EXPORT Eigen::VectorXd
                           PointValues(const CurveSet & curves, const std::string & array, const std::string & what);

/** Writes curves as VTP (.vtp), marked as LPS. Points are written as VTK verts, before the lines; reading restores the
 * curves in that order. Output is deterministic. Throws OutputError if the file cannot be written, ParameterError for
 * another extension, and InputError as RequireSound() does, except that an empty set is allowed.
 * \ingroup ShapetonSurfaceMesh */
ShapetonSurfaceMesh_EXPORT void
WriteCurves(CurveSet curves, const std::string & path);

/** Like WriteCurves(), and then writes the triangles of a surface on the same vertices, as VTK polys. Cell arrays
 * include rows for these faces. ReadCurves() returns the curves of the file, ReadSurface() the surface. Throws as
 * WriteCurves() does. \ingroup ShapetonSurfaceMesh */
ShapetonSurfaceMesh_EXPORT void
WriteCurvesOnSurface(CurveSet curves, const FaceMatrix & faces, const std::string & path);

/** Reads the lines and verts of a VTP file (possibly none); faces are ignored. Throws InputError with the file name and
 * the error. \ingroup ShapetonSurfaceMesh */
ShapetonSurfaceMesh_EXPORT CurveSet
ReadCurves(const std::string & path);
} // namespace shapeton

#endif
