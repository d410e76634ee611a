#ifndef shapetonPolyDataContent_h
#define shapetonPolyDataContent_h

#include "shapetonCurveSet.h"

class vtkPolyData;

namespace shapeton
{
/** \name What VTP files hold, as data of VTK
 * Positions in double precision, arrays and facts, and the field data SPACE=LPS, in place of what the object held.
 * Whole numbers are 32-bit integers. */
///@{
/** Triangles are VTK's polys. \ingroup SurfaceMesh */
SurfaceMesh_EXPORT void
FillPolyData(const SurfaceMesh & mesh, vtkPolyData & data);
/** Points are VTK's verts, which come first, curves its lines, and the faces, if any, its polys.
 * \pre Curves of one vertex stand first. \ingroup SurfaceMesh */
SurfaceMesh_EXPORT void
FillPolyData(const CurveSet & curves, const FaceMatrix & faces, vtkPolyData & data);
///@}
} // namespace shapeton

#endif
