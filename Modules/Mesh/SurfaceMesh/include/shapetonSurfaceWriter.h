#ifndef shapetonSurfaceWriter_h
#define shapetonSurfaceWriter_h

#include "shapetonProvenance.h"
#include "shapetonSurfaceMesh.h"

namespace shapeton
{
/** Writes a surface as VTP, STL (binary), PLY (binary) or OBJ, by the extension of the name. LPS in mm is stated where
 * 3D Slicer looks for it: field data SPACE of VTP, a comment of the others.
 *
 * VTP keeps positions in double precision, all arrays, and facts as strings of field data. PLY keeps positions in
 * double precision and arrays with one component whose names have no blank; OBJ positions in double precision; STL
 * positions in single precision. Equal surfaces give equal bytes.
 *
 * Throws OutputError when the file cannot be written, ParameterError for another extension, InputError as
 * RequireSound(). \ingroup SurfaceMesh */
SurfaceMesh_EXPORT void
WriteSurface(const SurfaceMesh & mesh, const std::string & path);

/** WriteSurface() with ProvenanceMetadata() in place of the facts. \ingroup SurfaceMesh */
SurfaceMesh_EXPORT void
WriteSurface(SurfaceMesh mesh, const Provenance & provenance, const std::string & path);
} // namespace shapeton

#endif
