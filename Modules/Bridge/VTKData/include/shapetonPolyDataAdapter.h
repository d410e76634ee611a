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
 * PatientSpace::RAS positions are turned; arrays stay as they are, so that vectors in them are those of LPS. All values
 * are copied. */
///@{
/** Triangles are VTK's polys. \ingroup VTKData */
VTKData_EXPORT vtkSmartPointer<vtkPolyData>
               PolyDataOf(const SurfaceMesh & mesh, PatientSpace space = PatientSpace::LPS);
/** \pre Curves of one vertex stand first, as VTK numbers its cells. \ingroup VTKData */
VTKData_EXPORT vtkSmartPointer<vtkPolyData>
               PolyDataOf(const CurveSet & curves, PatientSpace space = PatientSpace::LPS);
///@}

/** \name And back, in LPS
 * `space` is that of the data where their field data state none (SPACE). Numeric arrays are kept, of integer type as
 * whole numbers; texts of the field data become facts, other arrays of texts are left out. */
///@{
/** Polygons and strips are cut into triangles (vtkTriangleFilter), each with the values of its polygon; points and
 * lines are left out. Throws InputError where there is no polygon, and as RequireSound(). \ingroup VTKData */
VTKData_EXPORT SurfaceMesh
SurfaceOf(vtkPolyData & data, PatientSpace space = PatientSpace::LPS);
/** Verts, each a curve of one vertex, and lines with their values; polygons are left out. Throws as RequireSound()
 * where there is neither. \ingroup VTKData */
VTKData_EXPORT CurveSet
CurvesOf(vtkPolyData & data, PatientSpace space = PatientSpace::LPS);
///@}
} // namespace shapeton

#endif
