#ifndef shapetonPolyDataAdapter_h
#define shapetonPolyDataAdapter_h

#include "shapetonPatientSpace.h"

#include "shapetonCurveSet.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace shapeton
{
/** \name Surfaces and curves as vtkPolyData
 * Positions in double precision; point, cell and field arrays and facts; SPACE in the field data. With
 * PatientSpace::RAS positions are converted; arrays are not, so vectors in them stay in LPS. All values are copied. */
///@{
/** Triangles become VTK polys. \ingroup ShapetonMeshBridge */
ShapetonMeshBridge_EXPORT vtkSmartPointer<vtkPolyData>
                          PolyDataOf(const SurfaceMesh & mesh, PatientSpace space = PatientSpace::LPS);
/** \pre Single-vertex curves come first, as in VTK cell order. \ingroup ShapetonMeshBridge */
ShapetonMeshBridge_EXPORT vtkSmartPointer<vtkPolyData>
                          PolyDataOf(const CurveSet & curves, PatientSpace space = PatientSpace::LPS);
///@}

/** \name Conversion back, in LPS
 * `space` is used unless the field data state a space (SPACE). Numeric arrays are kept, integer types as integers.
 * Strings of the field data become facts; other string arrays are dropped. */
///@{
/** Polygons and strips are triangulated (vtkTriangleFilter), and each triangle gets the values of its polygon; points
 * and lines are dropped. Throws InputError if there are no polygons, and the exceptions of RequireSound().
 * \ingroup ShapetonMeshBridge */
ShapetonMeshBridge_EXPORT SurfaceMesh
SurfaceOf(vtkPolyData & data, PatientSpace space = PatientSpace::LPS);
/** Converts verts (to single-vertex curves) and lines with their values; polygons are dropped. Throws as RequireSound()
 * does if there are none. \ingroup ShapetonMeshBridge */
ShapetonMeshBridge_EXPORT CurveSet
CurvesOf(vtkPolyData & data, PatientSpace space = PatientSpace::LPS);
///@}
} // namespace shapeton

#endif
