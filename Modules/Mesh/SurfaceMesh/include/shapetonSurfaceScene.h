#ifndef shapetonSurfaceScene_h
#define shapetonSurfaceScene_h

#include "shapetonSurfaceMesh.h"

#include <array>
#include <string>
#include <vector>

namespace shapeton
{
/** A named surface with a color. \ingroup ShapetonSurfaceMesh */
struct SurfaceOfScene
{
  std::string name;
  /** Red, green and blue (sRGB), each in [0, 1]. */
  std::array<double, 3> color{ { 1.0, 1.0, 1.0 } };
  SurfaceMesh           mesh; ///< LPS, mm
};

/** Writes surfaces to one GLB file (binary glTF 2.0), each as a node with its name, color and vertex normals; arrays
 * are not written. Positions are in single precision. A viewer shows superior up and anterior in front, as glTF
 * prescribes for models, in meters; ReadSurface() recognizes the file and returns LPS and mm. Output is deterministic.
 *
 * Throws OutputError if the file cannot be written or were larger than the 4 GB of the format, ParameterError for
 * another extension, and InputError as RequireSound() does, or if a surface has no face.
 * \ingroup ShapetonSurfaceMesh */
ShapetonSurfaceMesh_EXPORT void
WriteSurfaceScene(const std::vector<SurfaceOfScene> & surfaces, const std::string & path);
} // namespace shapeton

#endif
