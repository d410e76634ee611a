#ifndef shapetonSurfaceRicciFlow_h
#define shapetonSurfaceRicciFlow_h

#include "ShapetonSurfaceRicciFlowExport.h"

#include "shapetonFlatDistortion.h"
#include "shapetonJsonForward.h"
#include "shapetonProgress.h"
#include "shapetonRemarks.h"
#include "shapetonSurfaceRicciFlowOptions.h"

#include <complex>

namespace shapeton
{
/** Options of FlowSurface(), its other inputs and a progress callback. \ingroup ShapetonSurfaceRicciFlow */
struct SurfaceRicciFlowSettings : SurfaceRicciFlowOptions
{
  /** Curvature of each vertex in radians: 2 pi minus the angle sum, or pi minus the angle sum on a boundary. If empty,
   * the curvatures follow from the options; otherwise the options must not set cones or a boundary. The sum is 2 pi chi
   * in Euclidean geometry and larger in hyperbolic geometry. */
  Eigen::VectorXd targetCurvatures;
  /** Edge lengths in another metric; empty for straight lengths. */
  Eigen::VectorXd edgeLengths;
  /** May throw to abort. */
  Progress progress;
};

/** A surface with a metric of prescribed curvature. \ingroup ShapetonSurfaceRicciFlow */
struct SurfaceRicciFlow
{
  /** The surface in space, cut open, with the point array `sourcePointId` and
   * - Euclidean: `uv` in mm, as in shapetonFlatSurface.h; the total area is unchanged. For a tube with straight
   *   boundaries, u runs along it from the first boundary, v runs around it, and `circumference` and `length` are set.
   * - hyperbolic: `uv` in the unit disk (Poincare model; length 2 |dz| / (1 - |z|^2));
   * - spherical: `sphere`, three components on the unit sphere, with the weighted mean 0 (weights: area in space); not
   *   cut.
   * Faces are counterclockwise as seen from outside. */
  SurfaceMesh   flat;
  RicciScheme   scheme{ RicciScheme::VertexScaling };
  RicciGeometry geometry{ RicciGeometry::Euclidean };
  int           genus{ 0 };
  int           boundaries{ 0 };
  /** For each vertex of the surface, the target curvature and the final curvature (radians). */
  Eigen::VectorXd targetCurvatures;
  Eigen::VectorXd curvatures;
  /** Largest difference of the two. */
  double residual{ 0.0 };
  /** Newton steps. */
  int steps{ 0 };
  /** Number of flips before the flow, which make the triangulation of the surface (of its double, if it has boundaries)
   * Delaunay; and the number of flips during the flow, including those of rejected steps. */
  int delaunayFlips{ 0 };
  int flips{ 0 };
  /** Logarithm of the scale factor of lengths at each vertex: exp((u_a + u_b) / 2) is the factor of Penner coordinates;
   * for circles, the change in log r or log tanh(r / 2). In hyperbolic geometry, the surface in space is first scaled
   * to the area of the result. */
  Eigen::VectorXd logScales;
  /** Distance between the ends of each surface edge, along the geodesic that replaces the edge. */
  Eigen::VectorXd edgeLengths;
  /** Faces of the final triangulation, on the vertices of the surface, and their side lengths; a vertex may occur
   * several times in a face. Without flips these are the faces of the surface. */
  FaceMatrix  triangles;
  SideLengths sides;
  /** Area of the result, in mm^2 or in units of the curvature. */
  double area{ 0.0 };
  /** Largest distance between the places of a vertex in its faces (mm, or in the disk); rounding errors. */
  double layoutResidual{ 0.0 };
  /** Faces of the surface that are inverted in the plane or on the sphere: their edges are not edges of the final
   * triangulation. */
  int flippedFaces{ 0 };
  /** Generators of the periods of a flat torus (mm), reduced: the first is shortest; their quotient is `tau`, with
   * |Re tau| <= 1/2, |tau| >= 1, Im tau > 0. Empty for other surfaces. */
  std::vector<Eigen::Vector2d> periods;
  std::complex<double>         tau;
  /** Circumference over length of a flat tube with straight boundaries; 0 for other surfaces. */
  double  modulus{ 0.0 };
  Remarks warnings;
};

/** Conformal metric with prescribed curvatures: the limit of the discrete Ricci flow du/dt = target - K (dissertation
 * 6.2.4), by Newton's method.
 *
 * Vertex scaling: all Euclidean and hyperbolic metrics of a discrete conformal class share the Penner coordinates of
 * the Delaunay triangulation. The surface is made Delaunay first; in each step, chords scaled by exp((u_a + u_b) / 2)
 * are made Delaunay by Ptolemy flips. Then the energy is convex and twice differentiable for all u, and a solution
 * exists for curvatures below 2 pi with the required sum (Gu, Luo, Sun, Wu 2018; Gu, Guo, Luo, Sun, Wu 2018; Gillespie,
 * Springborn, Crane 2021). A surface with boundaries is doubled, and both halves have the same u; an obtuse angle
 * opposite to a boundary edge causes a flip across the boundary. Without flips the result is that of CETM (Springborn,
 * Schroeder, Pinkall 2008).
 *
 * Inversive distance: the published scheme, on the faces of the surface, without flips. Solutions are unique for
 * nonnegative distances (Guo 2011), but may not exist.
 *
 * Spherical: for closed surfaces of genus 0, vertex scaling. One vertex moves to infinity: its neighbors are placed at
 * equal distances from it, and the rest is flattened with the scales of these neighbors fixed (Bobenko, Pinkall,
 * Springborn 2015). Concave neighbors cause flips at the removed vertex and another flow; no proof of convergence is
 * known for this loop. Stereographic projection gives a polyhedron inscribed in the sphere; its curvatures in spherical
 * geometry are checked.
 *
 * Correspondence: vertices are exact. Flips are undone in the developed result: `flat` has the faces of the surface,
 * and is straight on each. This is exact without flips; where edges were flipped, points inside faces of the final
 * triangulation are not mapped exactly.
 *
 * Throws InputError with the prefix `what` if the surface is not a single oriented manifold component, the geometry
 * does not suit its topology, or the flow does not converge; ParameterError for unsuitable cones or curvatures.
 * \ingroup ShapetonSurfaceRicciFlow */
ShapetonSurfaceRicciFlow_EXPORT SurfaceRicciFlow
FlowSurface(const SurfaceMesh & mesh, const SurfaceRicciFlowSettings & options, const std::string & what);

/** The final triangulation in space, with the cell array `sides`: three lengths per face, side k from corner k to the
 * next. \ingroup ShapetonSurfaceRicciFlow */
ShapetonSurfaceRicciFlow_EXPORT SurfaceMesh
FinalTriangulation(const SurfaceMesh & mesh, const SurfaceRicciFlow & flow);

/** Statistics as JSON. The keys are stable: scheme, geometry, genus, boundaries, residual (rad), steps, delaunayFlips,
 * flips, flippedFaces, area, layoutResidual, smallestLogScale, largestLogScale, cones (a list of vertex and curvature
 * in rad, for vertices with curvature, including those on boundaries), periods and tau of a torus, modulus of a tube
 * (null for others). \ingroup ShapetonSurfaceRicciFlow */
ShapetonSurfaceRicciFlow_EXPORT Json
SurfaceRicciFlowToJson(const SurfaceRicciFlow & flow);
} // namespace shapeton

#endif
