#ifndef FigureTools_h
#define FigureTools_h

#include "shapetonSurfaceConnectivity.h"
#include "shapetonSurfaceRendering.h"

/** What several figures of chapter 5 need. */

/** Lengths of shortest ways on the surface from a vertex: fast marching from triangle to triangle (Kimmel and Sethian,
 * 1998), first order, mm. */
Eigen::VectorXd
GeodesicDistances(const shapeton::SurfaceMesh & mesh, const shapeton::SurfaceConnectivity & connectivity, int source);

/** A way of edges from a vertex down to where the distance is 0, as a curve. */
shapeton::CurveSet
WayDown(const shapeton::SurfaceMesh &         mesh,
        const shapeton::SurfaceConnectivity & connectivity,
        const Eigen::VectorXd &               distances,
        int                                   from);

/** A view of a surface coloured by a value of each vertex, blue at `lower` to red at `upper`. */
shapeton::Picture::Pointer
DrawValues(const shapeton::SurfaceMesh &             mesh,
           const Eigen::VectorXd &                   values,
           double                                    lower,
           double                                    upper,
           const shapeton::SurfaceRenderingOptions & options,
           const shapeton::CurveSet *                white = nullptr);

/** Root of the mean square of a - b over that of a. */
double
RelativeChange(const Eigen::VectorXd & a, const Eigen::VectorXd & b);

#endif
