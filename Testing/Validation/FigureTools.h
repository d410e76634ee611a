#ifndef FigureTools_h
#define FigureTools_h

#include "ShapetonPictures.h"

#include "shapetonSurfaceConnectivity.h"
#include "shapetonSurfaceRendering.h"

/** Functions shared by figures of chapter 5. */

/** View of a surface that fills a panel of a sheet. */
shapeton::SurfaceRenderingOptions
ViewOf(const PictureSheet::Layout & layout);

/** Geodesic distances on the surface from a vertex (mm): first-order fast marching on triangles (Kimmel and Sethian,
 * 1998). */
Eigen::VectorXd
GeodesicDistances(const shapeton::SurfaceMesh & mesh, const shapeton::SurfaceConnectivity & connectivity, int source);

/** Descending path of edges from a vertex to distance 0, as a curve. */
shapeton::CurveSet
WayDown(const shapeton::SurfaceMesh &         mesh,
        const shapeton::SurfaceConnectivity & connectivity,
        const Eigen::VectorXd &               distances,
        int                                   from);

/** Rendering of a surface colored by a value per vertex, from blue at `lower` to red at `upper`. */
shapeton::Picture::Pointer
DrawValues(const shapeton::SurfaceMesh &             mesh,
           const Eigen::VectorXd &                   values,
           double                                    lower,
           double                                    upper,
           const shapeton::SurfaceRenderingOptions & options,
           const shapeton::CurveSet *                white = nullptr);

/** Root mean square of a - b divided by the root mean square of a. */
double
RelativeChange(const Eigen::VectorXd & a, const Eigen::VectorXd & b);

#endif
