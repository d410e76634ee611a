#ifndef shapetonFlatSurface_h
#define shapetonFlatSurface_h

#include "shapetonSurfaceCut.h"

namespace shapeton
{
/** \defgroup FlatSurface A surface with a map to the plane
 * A SurfaceMesh with vertices V in space (LPS, mm); vertices along the cut are duplicated.
 * - point array `uv`: two components, the position in the plane. For a tube, in mm at the mean circumference: u starts
 *   at the first boundary loop (the rectum), v is in [0, circumference]. With u to the right and v up, the surface is
 *   seen from inside and faces are clockwise.
 * - point array `sourcePointId`: integers, the vertex of the uncut surface.
 * - field arrays `circumference` and `length` of a tube: one value each, mm. The mean circumference is the integral of
 *   |grad u| over the surface in space for u from 0 to 1, the mean length of its level sets by the coarea formula.
 * All other arrays and facts of the source are kept; these four are replaced.
 * \ingroup ShapetonConformalFlattening */
///@{

/** Builds a flat surface from a cut surface and its plane coordinates, one row per vertex. Throws InputError if a
 * coordinate is not finite or a row is missing. */
ShapetonConformalFlattening_EXPORT SurfaceMesh
MakeFlatSurface(CutSurface cut, const Eigen::MatrixX2d & uv);

/** Sets `circumference` and `length` of a flat surface (mm). */
ShapetonConformalFlattening_EXPORT void
SetFlatExtent(SurfaceMesh & flat, double circumference, double length);

/** Returns `uv`, one row per vertex. If it is missing, throws InputError with the prefix `what` and the tool to run. */
ShapetonConformalFlattening_EXPORT Eigen::MatrixX2d
                                   FlatCoordinates(const SurfaceMesh & flat, const std::string & what);

/** Returns `circumference` (mm). Throws InputError with the prefix `what` if it is missing or not positive. */
ShapetonConformalFlattening_EXPORT double
FlatCircumference(const SurfaceMesh & flat, const std::string & what);

/** Returns `length` (mm). Throws as FlatCircumference() does. */
ShapetonConformalFlattening_EXPORT double
FlatLength(const SurfaceMesh & flat, const std::string & what);

/** Returns `sourcePointId`. Throws InputError with the prefix `what` if it is missing. */
ShapetonConformalFlattening_EXPORT std::vector<int>
                                   FlatSourcePoints(const SurfaceMesh & flat, const std::string & what);
///@}
} // namespace shapeton

#endif
