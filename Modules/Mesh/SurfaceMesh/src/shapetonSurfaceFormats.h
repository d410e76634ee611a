#ifndef shapetonSurfaceFormats_h
#define shapetonSurfaceFormats_h

#include "shapetonRemarks.h"
#include "shapetonCurveSet.h"
#include "shapetonSurfaceReader.h"

#include <array>
#include <cstdint>

namespace shapeton
{
/** Field data in which 3D Slicer stores LPS or RAS. */
constexpr const char * VtpSpaceName = "SPACE";

/** Unchecked output of a reader: polygons with any number of corners. */
struct PolygonSurface
{
  /** Three coordinates per vertex, in `unit`. */
  std::vector<double> points;
  /** Corners of all polygons, concatenated. Not yet validated, so 64-bit to hold any index in a file. */
  std::vector<std::int64_t> corners;
  /** End of each polygon in the corner list. */
  std::vector<std::size_t>  ends;
  std::vector<SurfaceArray> pointArrays;
  std::vector<SurfaceArray> cellArrays; ///< one row for each polygon
  std::vector<SurfaceArray> fieldArrays;
  /** Parts, as polygon indices. */
  std::vector<SurfacePart>                         parts;
  std::vector<std::pair<std::string, std::string>> facts;
  Remarks                                          notes;
  SurfaceUnit                                      unit{ SurfaceUnit::Millimeter };
  /** Whether the axes are RAS instead of LPS. */
  bool isRas{ false };
  /** Whether to merge vertices at equal positions, because the format repeats them. */
  bool repeatsVertices{ false };

  void
  AddPoint(double x, double y, double z)
  {
    points.insert(points.end(), { x, y, z });
  }
  /** Ends a polygon after its corners were appended. */
  void
  EndPolygon()
  {
    ends.push_back(corners.size());
  }
};

/** \name Readers of the formats: the bytes of a file, and its name for messages. All throw InputError. VTK's readers
 * (9.1) round to single precision (STL, OBJ, PLY, glTF), drop properties (PLY) and accept indices out of range. */
///@{
PolygonSurface
ReadVtp(const std::string & bytes, const std::string & path);
/** Lines and points, each as a "polygon" of its vertices. */
PolygonSurface
ReadVtpCurves(const std::string & bytes, const std::string & path);
PolygonSurface
ReadStl(const std::string & bytes, const std::string & path);
PolygonSurface
ReadObj(const std::string & bytes, const std::string & path);
PolygonSurface
ReadPly(const std::string & bytes, const std::string & path);
PolygonSurface
ReadOff(const std::string & bytes, const std::string & path);
/** Reads glTF and GLB, including their buffer files. */
PolygonSurface
ReadGltf(const std::string & bytes, const std::string & path);
///@}

/** \name Writers of the formats. Throw OutputError. */
///@{
void
WriteVtp(const SurfaceMesh & mesh, const std::string & path);
/** Writes the faces after the curves. */
void
WriteVtp(const CurveSet & curves, const FaceMatrix & faces, const std::string & path);
void
WriteStl(const SurfaceMesh & mesh, const std::string & path);
void
WriteObj(const SurfaceMesh & mesh, const std::string & path);
void
WritePly(const SurfaceMesh & mesh, const std::string & path);
void
WriteGlb(const SurfaceMesh & mesh, const std::string & path);
///@}

/** Checks indices, triangulates polygons, converts RAS to LPS and scales to mm. */
SurfaceFile
SurfaceOfPolygons(PolygonSurface && polygons, const std::string & path);

/** Lower-case extension of a name, without the dot. */
std::string
SurfaceExtension(const std::string & path);

/** \name Common checks of surfaces and curves; throw InputError with the prefix `what`. */
///@{
void
RequireFinite(const VertexMatrix & V, Eigen::Index vertex, const std::string & what);
void
RequireRows(const std::vector<SurfaceArray> & arrays, Eigen::Index rows, const std::string & what);
///@}

/** Bounding box corners of the vertices used by faces; other vertices are ignored. */
std::array<Eigen::RowVector3d, 2>
CornersOfFaces(const SurfaceMesh & mesh);

/** Selects rows of the arrays, in the given order. */
std::vector<SurfaceArray>
RowsOfArrays(const std::vector<SurfaceArray> & arrays, const std::vector<int> & rows);

/** Throws InputError "path: fault; advice". */
[[noreturn]] void
RefuseSurface(const std::string & path, const std::string & fault, const std::string & advice = "write the file again");
} // namespace shapeton

#endif
