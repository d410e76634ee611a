#ifndef shapetonSphereFlow_h
#define shapetonSphereFlow_h

#include "shapetonIntrinsicTriangulation.h"
#include "shapetonProgress.h"

namespace shapeton
{
/** A polyhedron inscribed in the unit sphere. */
struct SpherePolyhedron
{
  VertexMatrix    places;
  Eigen::VectorXd logScales; ///< chord of an edge = Penner coordinate times exp((u_a + u_b) / 2)
  Eigen::VectorXd chords;    ///< for each edge
  int             steps{ 0 };
  int             flips{ 0 };
};

/** Moves the vertices of a Delaunay triangulation of genus 0 to the sphere, see FlowSurface(). `triangulation` becomes
 * that of the polyhedron.
 * \param coordinates Penner coordinates of the edges.
 * \param weights of the vertices; the weighted mean of the places is 0. */
SpherePolyhedron
FlowToSphere(IntrinsicTriangulation & triangulation,
             Eigen::VectorXd          coordinates,
             const Eigen::VectorXd &  weights,
             const Progress &         progress);
} // namespace shapeton

#endif
