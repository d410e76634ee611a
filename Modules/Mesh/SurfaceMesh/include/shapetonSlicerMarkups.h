#ifndef shapetonSlicerMarkups_h
#define shapetonSlicerMarkups_h

#include "ShapetonSurfaceMeshExport.h"

#include "shapetonCurveSet.h"

#include <array>
#include <string>
#include <vector>

namespace shapeton
{
/** \class Markup
 * \brief Points or a curve that 3D Slicer displays and lets the user edit.
 * \ingroup ShapetonSurfaceMesh */
struct Markup
{
  enum class Kind
  {
    /** Separate points, "Fiducial" in Slicer. */
    Points,
    Curve,
    /** The last point is joined to the first, which is not repeated. */
    ClosedCurve
  };
  Kind        kind{ Kind::Points };
  std::string name;
  /** LPS, mm. */
  std::vector<Eigen::Vector3d> points;
  /** One for each point, or empty: then the labels are NAME-1, NAME-2, ... */
  std::vector<std::string> labels{};
  /** One for each point, or empty. */
  std::vector<std::string> descriptions{};
  /** Red, green and blue in [0, 1]. */
  std::array<double, 3> color{ 1.0, 0.5, 0.5 };
};

/** Writes 3D Slicer markups, schema version 1.0.3: one scene node per markup, LPS, mm. Output is deterministic.
 * Throws ParameterError unless the path ends with .mrk.json. Throws std::invalid_argument if the number of labels or
 * descriptions differs from the number of points, a color is out of range or a coordinate is not finite. Throws
 * OutputError.
 * \ingroup ShapetonSurfaceMesh */
ShapetonSurfaceMesh_EXPORT void
WriteMarkups(const std::vector<Markup> & markups, const std::string & path);

/** Reads markups of 3D Slicer, versions 1.x: points (fiducials, lines, angles) and curves; planes and boxes are
 * skipped. RAS is converted to LPS, and um to mm; points that were not placed are skipped. Throws InputError with the
 * file name and the error, also if no point remains. \ingroup ShapetonSurfaceMesh */
ShapetonSurfaceMesh_EXPORT std::vector<Markup>
                           ReadMarkups(const std::string & path);

/** Converts a curve of a set to a markup with control points at most `spacing` mm apart along it, including both
 * ends: Slicer is slow with thousands of them. For Kind::Points, all vertices become separate points. A closed
 * curve may repeat its first vertex at the end. Throws std::invalid_argument if the curve does not exist or the
 * spacing is not positive. \ingroup ShapetonSurfaceMesh */
ShapetonSurfaceMesh_EXPORT Markup
MarkupOfCurve(const CurveSet & curves, std::size_t curve, Markup::Kind kind, double spacing = 5.0);
} // namespace shapeton

#endif
