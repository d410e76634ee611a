#ifndef shapetonSurfaceWriter_h
#define shapetonSurfaceWriter_h

#include "shapetonProvenance.h"
#include "shapetonSurfaceMesh.h"

namespace shapeton
{
/** Formats of surfaces that can be written; see WriteSurface(). \ingroup ShapetonSurfaceMesh */
enum class SurfaceFormat
{
  Vtp,
  Stl,
  Ply,
  Obj,
  Glb
};

/** Writes a surface as VTP, STL (binary), PLY (binary), OBJ or GLB, by file extension. Files are marked as LPS for 3D
 * Slicer: field data SPACE in VTP, a comment in STL, PLY and OBJ. Positions are in mm; for GLB see
 * WriteSurfaceScene().
 *
 * VTP keeps positions in double precision, all arrays, and facts as field data strings. PLY keeps positions in double
 * precision and single-component arrays with names without blanks; OBJ positions in double precision; STL and GLB
 * positions in single precision. Output is deterministic.
 *
 * Throws OutputError if the file cannot be written, ParameterError for another extension, and InputError as
 * RequireSound() does.
 * \ingroup ShapetonSurfaceMesh */
ShapetonSurfaceMesh_EXPORT void
WriteSurface(const SurfaceMesh & mesh, const std::string & path);

/** WriteSurface() with ProvenanceMetadata() as facts. \ingroup ShapetonSurfaceMesh */
ShapetonSurfaceMesh_EXPORT void
WriteSurface(SurfaceMesh mesh, const Provenance & provenance, const std::string & path);
} // namespace shapeton

#endif
