#ifndef shapetonSurfaceUnit_h
#define shapetonSurfaceUnit_h

namespace shapeton
{
/** Unit of the coordinates of a surface file; File stands for the unit of its format. \ingroup ShapetonSurfaceMesh */
enum class SurfaceUnit
{
  File,
  Meter,
  Millimeter,
  Micrometer
};
} // namespace shapeton

#endif
