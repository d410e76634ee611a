#ifndef shapetonSurfaceReader_h
#define shapetonSurfaceReader_h

#include "shapetonRemarks.h"
#include "shapetonSurfaceMesh.h"
#include "shapetonSurfaceReadOptions.h"

namespace shapeton
{
/** A named group of faces of a file. \ingroup ShapetonSurfaceMesh */
struct SurfacePart
{
  std::string name;
  int         firstFace{ 0 };
  int         numberOfFaces{ 0 };
};

/** Complete content of a surface file, before selection. \ingroup ShapetonSurfaceMesh */
struct SurfaceFile
{
  /** Surface in mm (converted from the unit of the format), LPS. */
  SurfaceMesh mesh;
  /** glTF: one part per node with a mesh, named after the node or, if unnamed, the mesh. OBJ: one per object or group.
   * Empty for other formats. Repeated names get " #2", " #3", ... */
  std::vector<SurfacePart> parts;
  /** Conversions that were applied, for example "12 polygons were cut into 30 triangles". */
  Remarks notes;
  /** Meter for glTF, millimeter for the other formats. */
  SurfaceUnit unit{ SurfaceUnit::Millimeter };
};

/** Reads VTP, STL (text and binary), OBJ, PLY (text and binary), OFF, glTF 2.0 and GLB. The format is chosen by the
 * file extension, case-insensitively.
 *
 * - Polygons are triangulated (ear clipping), and triangle strips and fans are split; points and lines are skipped with
 *   a note.
 * - STL stores corners only, and glTF repeats vertices along seams: vertices at equal positions (within 1e-9 of the
 *   largest extent, the rounding of transforms) are merged. Other formats keep their vertices.
 * - glTF: the unit is the meter, as its standard requires. Node transforms are applied. Axes are kept (y is NOT rotated
 *   to z), as is the corner order, unless a transform mirrors the mesh. Skinned and morphed meshes are read in their
 *   rest pose. Draco and meshopt compression and sparse accessors are rejected.
 * - Files marked SPACE=RAS, as written by 3D Slicer (field data of VTP, a comment of PLY, OBJ and STL), are converted
 *   to LPS.
 * - Point and cell arrays: VTP with its field data, and scalar properties of PLY. Colors, normals and texture
 *   coordinates of other formats are dropped.
 *
 * Throws InputError with the file, the error, its location and the remedy for missing, empty, truncated or
 * unsupported files, indices out of range, nonfinite coordinates, and files without faces. Sizes stated in a file are
 * checked against its length before memory is allocated. \ingroup ShapetonSurfaceMesh */
ShapetonSurfaceMesh_EXPORT SurfaceFile
ReadSurfaceFile(const std::string & path);

/** A selected surface with its remarks. \ingroup ShapetonSurfaceMesh */
struct Surface
{
  SurfaceMesh mesh;
  /** "sha256:..." hash of the file. */
  std::string identity;
  /** Remarks on the file and on doubtful input. */
  Remarks notes;
  /** Repairs made by ReadRepairedSurface(), one line per kind of change. */
  Remarks repairs;
};

/** Reads a file and selects one part and component. Components of equal size are numbered in the order of their first
 * faces, and counted as in the result of RepairSurface(): pieces joined along a seam (two boundaries of coincident
 * vertices) are one, and surfaces are cut at edges with more than two faces. Throws InputError as ReadSurfaceFile()
 * does. Also throws InputError, listing the choices, if the part or component is unknown, or if several exist and none
 * was chosen. Throws ParameterError for a component below -1. \ingroup ShapetonSurfaceMesh */
ShapetonSurfaceMesh_EXPORT Surface
ReadSurface(const std::string & path, const SurfaceReadOptions & options = {});

/** ReadSurface() followed by RepairSurface(), for computations. Throws InputError with the file name for defects that
 * cannot be repaired: an invalid surface, zero-area faces, a nonorientable part; and if several components remain and
 * none was chosen. \ingroup ShapetonSurfaceMesh */
ShapetonSurfaceMesh_EXPORT Surface
ReadRepairedSurface(const std::string & path, const SurfaceReadOptions & options = {});
} // namespace shapeton

#endif
