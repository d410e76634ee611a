#ifndef NewtonFlattening_h
#define NewtonFlattening_h

#include "shapetonFlatDistortion.h"
#include "shapetonTubeEnds.h"

/** Peer of harmonic flattening: conformal equivalence of triangle meshes by Newton's method (Springborn, Schroeder and
 * Pinkall, 2008), whose flow is discrete Ricci flow. */
struct NewtonFlattening
{
  bool             hasConverged{ false };
  int              iterations{ 0 };
  double           modulus{ 0.0 }; ///< circumference over length of the flat cylinder
  Eigen::MatrixX2d uv;             ///< one row per vertex of the cut surface
};

/** Scales the lengths of the edges by exp((w_a + w_b) / 2) until all vertices inside are flat and all boundaries
 * straight, and lays out the faces of the cut surface. Elimination order and pattern are reused in all iterations.
 */
NewtonFlattening
FlattenByNewton(const shapeton::SurfaceConnectivity & connectivity,
                const shapeton::FaceMatrix &          F,
                const Eigen::VectorXd &               edgeLengths,
                const shapeton::TubeEnds &            ends,
                const shapeton::CutSurface &          cut);

#endif
