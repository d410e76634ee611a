#ifndef shapetonSurfaceFormats_h
#define shapetonSurfaceFormats_h

#include "shapetonRemarks.h"
#include "shapetonCurveSet.h"
#include "shapetonSurfaceReader.h"

#include <array>
#include <cstdint>

namespace shapeton
{
/** The field data in which 3D Slicer looks for LPS or RAS. */
constexpr const char * VtpSpaceName = "SPACE";

/** What a reader of a format hands over: polygons of any number of corners, not checked. */
struct PolygonSurface
{
  /** Three for each vertex, in `unit`. */
  std::vector<double> points;
  /** Of all polygons, one after another; not checked, so wide enough for what a file may hold. */
  std::vector<std::int64_t> corners;
  /** Where the corners of each polygon end. */
  std::vector<std::size_t>  ends;
  std::vector<SurfaceArray> pointArrays;
  std::vector<SurfaceArray> cellArrays; ///< a row for each polygon
  std::vector<SurfaceArray> fieldArrays;
  /** In polygons. */
  std::vector<SurfacePart>                         parts;
  std::vector<std::pair<std::string, std::string>> facts;
  Remarks                                          notes;
  std::string                                      unit{ "mm" };
  /** Axes to the right, to the front, upwards, in place of LPS. */
  bool isRas{ false };
  /** Vertices at equal positions are one, because the format repeats them. */
  bool repeatsVertices{ false };

  void
  AddPoint(double x, double y, double z)
  {
    points.insert(points.end(), { x, y, z });
  }
  /** Ends a polygon whose corners have been appended. */
  void
  EndPolygon()
  {
    ends.push_back(corners.size());
  }
};

/** \name Readers of the formats: the bytes of a file, and its name for messages. All throw InputError. */
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
/** Both glTF and GLB; reads the files of its buffers. */
PolygonSurface
ReadGltf(const std::string & bytes, const std::string & path);
///@}

/** \name Writers of the formats. Throw OutputError. */
///@{
void
WriteVtp(const SurfaceMesh & mesh, const std::string & path);
/** The faces come after the curves. */
void
WriteVtp(const CurveSet & curves, const FaceMatrix & faces, const std::string & path);
void
WriteStl(const SurfaceMesh & mesh, const std::string & path);
void
WriteObj(const SurfaceMesh & mesh, const std::string & path);
void
WritePly(const SurfaceMesh & mesh, const std::string & path);
///@}

/** Checks the indices, cuts the polygons into triangles, turns RAS to LPS and scales to mm. */
SurfaceFile
SurfaceOfPolygons(PolygonSurface && polygons, const std::string & path);

/** The extension of a name in small letters, without the dot. */
std::string
SurfaceExtension(const std::string & path);

/** \name What soundness of surfaces and curves has in common; throw InputError with `what` in front. */
///@{
void
RequireFinite(const VertexMatrix & V, Eigen::Index vertex, const std::string & what);
void
RequireRows(const std::vector<SurfaceArray> & arrays, Eigen::Index rows, const std::string & what);
///@}

/** The lowest and the highest corner of the vertices that faces use; others may be anywhere. */
std::array<Eigen::RowVector3d, 2>
CornersOfFaces(const SurfaceMesh & mesh);

/** The arrays with some of their rows, in that order. */
std::vector<SurfaceArray>
RowsOfArrays(const std::vector<SurfaceArray> & arrays, const std::vector<int> & rows);

/** Throws InputError: path: fault; advice. */
[[noreturn]] void
RefuseSurface(const std::string & path, const std::string & fault, const std::string & advice = "write the file again");
} // namespace shapeton

#endif
