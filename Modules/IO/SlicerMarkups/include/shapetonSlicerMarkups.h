#ifndef shapetonSlicerMarkups_h
#define shapetonSlicerMarkups_h

#include "SlicerMarkupsExport.h"

#include "shapetonCurveSet.h"

#include <array>
#include <string>
#include <vector>

namespace shapeton
{
/** \class Markup
 * \brief Points or a curve that 3D Slicer shows and lets a person move.
 * \ingroup SlicerMarkups */
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
  /** One for each point, or none: then they are NAME-1, NAME-2, ... */
  std::vector<std::string> labels{};
  /** One for each point, or none. */
  std::vector<std::string> descriptions{};
  /** Red, green and blue in [0, 1]. */
  std::array<double, 3> color{ 1.0, 0.5, 0.5 };
};

/** Writes markups of 3D Slicer, version 1.0.3 of their schema: one node of the scene for each, LPS, mm. Equal markups
 * give equal bytes. Throws ParameterError unless the path ends with .mrk.json, std::invalid_argument where labels or
 * descriptions are not one for each point, a colour is out of range or a coordinate is not finite; OutputError.
 * \ingroup SlicerMarkups */
SlicerMarkups_EXPORT void
WriteMarkups(const std::vector<Markup> & markups, const std::string & path);

/** Reads markups of 3D Slicer, versions 1.x: points (fiducials, lines, angles) and curves; planes and boxes are left
 * out. RAS becomes LPS, um become mm; points that were not placed are left out. Throws InputError that names the file
 * and the fault, also where no point is left. \ingroup SlicerMarkups */
SlicerMarkups_EXPORT std::vector<Markup>
                     ReadMarkups(const std::string & path);

/** A curve of a set as a markup with control points no further apart than `spacing` mm along it and both its ends:
 * Slicer is slow with thousands of them. Where kind is Points, all its vertices, as separate points. A closed curve may
 * repeat its first vertex at the end. Throws std::invalid_argument for a curve that is not there or a spacing that is
 * not positive. \ingroup SlicerMarkups */
SlicerMarkups_EXPORT Markup
MarkupOfCurve(const CurveSet & curves, std::size_t curve, Markup::Kind kind, double spacing = 5.0);
} // namespace shapeton

#endif
