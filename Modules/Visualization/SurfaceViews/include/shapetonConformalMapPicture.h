#ifndef shapetonConformalMapPicture_h
#define shapetonConformalMapPicture_h

#include "SurfaceViewsExport.h"

#include "shapetonConformalMap.h"
#include "shapetonSurfaceRendering.h"

#include <functional>

namespace shapeton
{
/** \defgroup PlanePattern Patterns that a map takes from the plane to a surface
 * The colour of each place (u, v). \ingroup SurfaceViews */
///@{
using PlanePattern = std::function<RGBColor(double u, double v)>;

/** Squares of two colours with the given side. Throws std::invalid_argument unless it is positive. */
SurfaceViews_EXPORT PlanePattern
Checkerboard(double side);

/** `around` checks of equal angle about (0, 0), rings of the same aspect: squares for a conformal map of an annulus.
 * Throws std::invalid_argument unless `around` is even and positive. */
SurfaceViews_EXPORT PlanePattern
PolarCheckerboard(int around);

/** Bands of constant u of the given width, coloured from blue (`lower`) to red (`upper`) with a dark line between.
 * Throws std::invalid_argument unless the numbers ascend and the width is positive. */
SurfaceViews_EXPORT PlanePattern
LevelSets(double lower, double upper, double width);
///@}

/** The surface on the plane: its vertices at (u, 0, v), which a view from the patient's front shows with u to the right
 * and v up. \ingroup SurfaceViews */
SurfaceViews_EXPORT SurfaceMesh
PlaneOf(const SurfaceMesh & flat, const Eigen::MatrixX2d & uv);

/** Draws `shape` in the colours that the pattern has at `uv`, which has a row for each vertex; edges of the pattern are
 * finer than the faces. `boundaries` are drawn on top, each in a colour of its own (the first one yellow),
 * and may be empty. Options: as for RenderSurfaces(). \ingroup SurfaceViews */
SurfaceViews_EXPORT Picture::Pointer
                    DrawPattern(const SurfaceMesh &               shape,
                                const Eigen::MatrixX2d &          uv,
                                const PlanePattern &              pattern,
                                const std::vector<BoundaryLoop> & boundaries,
                                const SurfaceRenderingOptions &   options);

/** Sets azimuth and elevation so that a viewer faces most of an open surface, its mean normal; from the front where it
 * has none, as where it is closed. \ingroup SurfaceViews */
SurfaceViews_EXPORT void
LookAtSurface(const SurfaceMesh & mesh, PatientViewOptions & options);

/** Size and checks of a picture of a conformal map. \ingroup SurfaceViews */
struct ConformalMapPictureOptions
{
  /** Of the whole picture, pixels. */
  unsigned int width{ 1600 };
  unsigned int height{ 800 };
  /** Number of checks around an annulus, even, or along the longer side of a rectangle. */
  int checks{ 36 };
};

/** The surface in space on the left, the plane on the right, both with the checkerboard of the plane. Equal input gives
 * equal bytes for any number of threads. \ingroup SurfaceViews */
SurfaceViews_EXPORT Picture::Pointer
                    DrawConformalMap(const ConformalMap & map, const ConformalMapPictureOptions & options = {});

/** The holomorphic 1-forms of a surface, a row for each inner boundary (dissertation, Figure 5.3 d to f): level sets,
 * 20 from 0 to 1, of the harmonic function that is 1 on this boundary and 0 on the others, those of its conjugate at
 * the same distance, and both as a checkerboard. Throws as HolomorphicFormsOf() does. `panel`: side of one view,
 * pixels. \ingroup SurfaceViews */
SurfaceViews_EXPORT Picture::Pointer
                    DrawHolomorphicForms(const ConformalMap & map, unsigned int panel = 480);
} // namespace shapeton

#endif
