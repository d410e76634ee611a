#ifndef shapetonConformalMapPicture_h
#define shapetonConformalMapPicture_h

#include "ShapetonColonViewsExport.h"

#include "shapetonConformalMap.h"
#include "shapetonSurfaceRendering.h"

#include <functional>
#include <string>

namespace shapeton
{
/** \defgroup PlanePattern Patterns mapped from the plane to a surface
 * A pattern gives the color of each point (u, v). \ingroup ShapetonColonViews */
///@{
using PlanePattern = std::function<RGBColor(double u, double v)>;

/** Two-color checkerboard; `side` is the side length of a check. Throws std::invalid_argument unless it is positive. */
ShapetonColonViews_EXPORT PlanePattern
Checkerboard(double side);

/** Polar checkerboard: `around` checks of equal angle around (0, 0), and rings of the same aspect ratio; squares for a
 * conformal map of an annulus. Throws std::invalid_argument unless `around` is even and positive. */
ShapetonColonViews_EXPORT PlanePattern
PolarCheckerboard(int around);

/** Bands of constant u of the given width, colored from blue (`lower`) to red (`upper`), separated by dark lines.
 * Throws std::invalid_argument unless the numbers ascend and the width is positive. */
ShapetonColonViews_EXPORT PlanePattern
LevelSets(double lower, double upper, double width);
///@}

/** The surface mapped to the plane: vertices at (u, 0, v); a view from the patient's front shows u to the right
 * and v up. \ingroup ShapetonColonViews */
ShapetonColonViews_EXPORT SurfaceMesh
PlaneOf(const SurfaceMesh & flat, const Eigen::MatrixX2d & uv);

/** Draws `shape` in the colors of the pattern at `uv`, which has one row per vertex; the pattern is resolved more
 * finely than the faces. `boundaries` may be empty; they are drawn on top, each in a different color (the first one
 * yellow). Options: as for RenderSurfaces(). \ingroup ShapetonColonViews */
ShapetonColonViews_EXPORT Picture::Pointer
                          DrawPattern(const SurfaceMesh &               shape,
                                      const Eigen::MatrixX2d &          uv,
                                      const PlanePattern &              pattern,
                                      const std::vector<BoundaryLoop> & boundaries,
                                      const SurfaceRenderingOptions &   options);

/** Sets azimuth and elevation to view an open surface along its mean normal; from the front if that normal is zero, for
 * example for a closed surface. \ingroup ShapetonColonViews */
ShapetonColonViews_EXPORT void
LookAtSurface(const SurfaceMesh & mesh, PatientViewOptions & options);

/** Size and number of checks of a picture of a conformal map. \ingroup ShapetonColonViews */
struct ConformalMapPictureOptions
{
  /** Width of the whole picture, pixels. */
  unsigned int width{ 1600 };
  unsigned int height{ 800 };
  /** Number of checks around an annulus (even), or along the longer side of a rectangle. */
  int checks{ 36 };
};

/** The surface in space on the left, the plane on the right, both with the checkerboard of the plane. Identical input
 * yields identical bytes for any number of threads. \ingroup ShapetonColonViews */
ShapetonColonViews_EXPORT Picture::Pointer
                          DrawConformalMap(const ConformalMap & map, const ConformalMapPictureOptions & options = {});

/** The same for any surface with the point array `uv`, for example of a Ricci flow; options.checks is the number of
 * checks along the longer side of the plane. Throws InputError with the prefix `what` if the surface has no such array.
 * \ingroup ShapetonColonViews */
ShapetonColonViews_EXPORT Picture::Pointer
DrawFlatSurface(const SurfaceMesh & flat, const std::string & what, const ConformalMapPictureOptions & options = {});

/** Draws the holomorphic 1-forms of a surface, one row per inner boundary (dissertation, Figure 5.3 d to f): 20
 * level sets from 0 to 1 of the harmonic function that is 1 on this boundary and 0 on the others, equally spaced level
 * sets of its conjugate, and both as a checkerboard. Throws the exceptions of HolomorphicFormsOf(). `panel`: side of
 * one view, pixels. \ingroup ShapetonColonViews */
ShapetonColonViews_EXPORT Picture::Pointer
                          DrawHolomorphicForms(const ConformalMap & map, unsigned int panel = 480);
} // namespace shapeton

#endif
