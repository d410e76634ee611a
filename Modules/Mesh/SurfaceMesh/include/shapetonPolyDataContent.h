#ifndef shapetonPolyDataContent_h
#define shapetonPolyDataContent_h

#include "shapetonCurveSet.h"

class vtkPolyData;

namespace shapeton
{
/** \name Content of VTP files as VTK data
 * Replaces the content of the object with positions in double precision, arrays and facts, and the field data
 * SPACE=LPS. Integers are 32-bit. */
///@{
/** Triangles become VTK polys. \ingroup ShapetonSurfaceMesh */
ShapetonSurfaceMesh_EXPORT void
FillPolyData(const SurfaceMesh & mesh, vtkPolyData & data);
/** Points become VTK verts, curves become lines, and faces, if any, become polys, in this order.
 * \pre Single-vertex curves come first. \ingroup ShapetonSurfaceMesh */
ShapetonSurfaceMesh_EXPORT void
FillPolyData(const CurveSet & curves, const FaceMatrix & faces, vtkPolyData & data);
///@}
} // namespace shapeton

#endif
