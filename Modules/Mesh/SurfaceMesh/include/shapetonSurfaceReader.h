#ifndef shapetonSurfaceReader_h
#define shapetonSurfaceReader_h

#include "shapetonRemarks.h"
#include "shapetonSurfaceMesh.h"

namespace shapeton
{
/** Some faces of a file that belong together under a name. \ingroup SurfaceMesh */
struct SurfacePart
{
  std::string name;
  int         firstFace{ 0 };
  int         numberOfFaces{ 0 };
};

/** What a file of a surface holds, before anything is chosen. \ingroup SurfaceMesh */
struct SurfaceFile
{
  /** In mm by the unit of the format, LPS. */
  SurfaceMesh mesh;
  /** glTF: a node that has a mesh, by its name or else that of the mesh. OBJ: an object or group. None otherwise. Equal
   * names get " #2", " #3", ... */
  std::vector<SurfacePart> parts;
  /** What was changed, for example "12 polygons were cut into 30 triangles". */
  Remarks notes;
  /** "m" for glTF, "mm" for the other formats. */
  std::string unit{ "mm" };
};

/** Reads VTP, STL (text and binary), OBJ, PLY (text and binary), OFF, glTF 2.0 and GLB. The format is that of the
 * name's extension, in any case of letters.
 *
 * - Polygons are cut into triangles (ears), triangle strips and fans are resolved; points and lines are left out with a
 *   note.
 * - STL has no vertices but corners, and glTF repeats vertices along seams: those at equal positions are merged. The
 *   other formats keep their vertices.
 * - glTF: unit metre by its standard; transforms of nodes are applied; its axes are kept as they are (y is NOT turned
 * to z), and so is the order of the corners unless a transform mirrors. Positions of meshes with a skin or a morph are
 *   those at rest. Draco and meshopt compression and sparse accessors are refused.
 * - A file that says SPACE=RAS, as 3D Slicer writes it (field data of VTP, a comment of PLY, OBJ and STL), is turned to
 *   LPS.
 * - Point and cell arrays: VTP with its field data, and scalar properties of PLY. Colours, normals and texture
 *   coordinates of other formats are left out.
 *
 * Throws InputError that names the file, the fault and its place, and what to do: files that are missing, empty, text
 * instead of a surface, truncated or of another format, indices out of range, coordinates that are not finite, no
 * faces. Sizes that a file states are checked against its length before memory is taken.
 * \ingroup SurfaceMesh */
SurfaceMesh_EXPORT SurfaceFile
ReadSurfaceFile(const std::string & path);

/** What to take of a file. \ingroup SurfaceMesh */
struct SurfaceReadOptions
{
  /** The name of a part; empty for all of them. */
  std::string part;
  /** From 1: the component with this rank by number of faces (the one of the earlier face where equal); 0: the surface
   * must have one component; -1: all together. Components are counted as RepairSurface() leaves them: pieces that meet
   * along a seam, which is two boundaries of coincident vertices, are one; a surface is cut at edges of more than two
   * faces. */
  int component{ 0 };
  /** "m", "mm" or "um" in place of the unit of the format; empty keeps that, and refuses a surface whose largest extent
   * is not between 5 mm and 5 m. */
  std::string unit;
  /** A surface of another extent is taken with a note, for what does not depend on its size. */
  bool isAnyExtentPlausible{ false };
  /** One component must be left after repair; the advice in messages does not offer all of them. Without it
   * ReadSurface() accepts a surface whose faces are all connected with a note where it is to be cut. */
  bool takesOneComponent{ false };
};

/** A surface with what is to be told about it. \ingroup SurfaceMesh */
struct Surface
{
  SurfaceMesh mesh;
  /** "sha256:..." of the file. */
  std::string identity;
  /** What its file said besides, or what was taken with doubt. */
  Remarks notes;
  /** What ReadRepairedSurface() has mended, in words for each kind of change. */
  Remarks repairs;
};

/** Reads a file and takes one part and component. Throws InputError as ReadSurfaceFile() does, and with the list of
 * what there is when the part or component is unknown, or when there are several and none was chosen; ParameterError
 * for another unit, or a component less than -1. \ingroup SurfaceMesh */
SurfaceMesh_EXPORT Surface
ReadSurface(const std::string & path, const SurfaceReadOptions & options = {});

/** ReadSurface() of what is to be computed on: what RepairSurface() mends is mended. Throws InputError, which names the
 * file, for what it cannot mend: no sound surface, faces without area, a part that is not orientable; and where several
 * components are left and none was chosen. \ingroup SurfaceMesh */
SurfaceMesh_EXPORT Surface
ReadRepairedSurface(const std::string & path, const SurfaceReadOptions & options = {});
} // namespace shapeton

#endif
