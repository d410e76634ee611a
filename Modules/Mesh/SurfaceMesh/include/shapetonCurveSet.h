#ifndef shapetonCurveSet_h
#define shapetonCurveSet_h

#include "shapetonSurfaceMesh.h"

namespace shapeton
{
/** \class CurveSet
 * \brief Polylines in space, such as a centreline or taeniae, and single points: vertices V and arrays on them.
 * \ingroup SurfaceMesh
 */
struct CurveSet
{
  /** LPS, mm. */
  VertexMatrix V;
  /** The vertices of each curve in order; a curve of one vertex is a point. */
  std::vector<std::vector<int>> curves;
  /** A row for each vertex. */
  std::vector<SurfaceArray> pointArrays;
  /** A row for each curve. */
  std::vector<SurfaceArray> cellArrays;
  /** About the curves as a whole. */
  std::vector<SurfaceArray> fieldArrays;
  /** Facts in words, for example provenance. */
  std::vector<std::pair<std::string, std::string>> facts;
};

/** Throws InputError, with `what` in front, when there is no vertex, a curve is empty or names a vertex that is not
 * there, a coordinate is not finite, or an array lacks rows. \ingroup SurfaceMesh */
SurfaceMesh_EXPORT void
RequireSound(const CurveSet & curves, const std::string & what);

/** The values of a point array with one component, one for each vertex. Throws InputError, with `what` in front, where
 * the array is missing. \ingroup SurfaceMesh */
SurfaceMesh_EXPORT Eigen::VectorXd
                   PointValues(const CurveSet & curves, const std::string & array, const std::string & what);

/** Writes curves as VTP (.vtp) with LPS stated, points as VTK's verts, which come before the lines; reading them back
 * gives the curves in that order. Equal curves give equal bytes.
 * Throws OutputError when the file cannot be written, ParameterError for another extension, InputError as
 * RequireSound(), but a set of no curves is written. \ingroup SurfaceMesh */
SurfaceMesh_EXPORT void
WriteCurves(CurveSet curves, const std::string & path);

/** Writes curves as WriteCurves() does, and the triangles of a surface through their vertices as VTK's polys, which
 * come after the lines; cell arrays have rows for these, too. ReadCurves() of the file gives the curves, ReadSurface()
 * the surface. Throws as WriteCurves(). \ingroup SurfaceMesh */
SurfaceMesh_EXPORT void
WriteCurvesOnSurface(CurveSet curves, const FaceMatrix & faces, const std::string & path);

/** Reads the lines and verts of a VTP file, which may have none; faces are left out. Throws InputError that names the
 * file and the fault.
 * \ingroup SurfaceMesh */
SurfaceMesh_EXPORT CurveSet
ReadCurves(const std::string & path);
} // namespace shapeton

#endif
