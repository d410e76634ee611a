#ifndef GeneratedSurfaces_h
#define GeneratedSurfaces_h

#include "shapetonSurfaceConnectivity.h"

#include <Eigen/Geometry>

#include <functional>

/** Surfaces for the figures of chapter 5, made by formula: the models of the dissertation are not free to use. */

/** Of a solid: less than 0 inside; mm. */
using SignedDistance = std::function<double(const Eigen::Vector3d &)>;

/** A rounded rod along a polyline. */
SignedDistance
Rod(const std::vector<Eigen::Vector3d> & line, double radius);

/** Solids joined with fillets of about this radius, mm. */
SignedDistance
Joined(const std::vector<SignedDistance> & solids, double fillet);

/** The surface of a solid inside a box, of nearly equilateral triangles with this edge, mm. */
shapeton::SurfaceMesh
SurfaceOfSolid(const SignedDistance & solid, const Eigen::Vector3d & low, const Eigen::Vector3d & high, double edge);

/** The closed loop of edges along which the surface crosses a plane within a ball around `place`, first vertex = last.
 * Throws std::runtime_error where it is no single loop. */
std::vector<int>
LoopAcross(const shapeton::SurfaceMesh & mesh,
           const Eigen::Vector3d &       place,
           const Eigen::Vector3d &       normal,
           double                        radius);

/** The vertex next to a place. */
int
VertexAt(const shapeton::SurfaceMesh & mesh, const Eigen::Vector3d & place);

/** A surface before and after a cut along a loop of edges: the vertices of the first are the first ones of the second.
 */
struct CutPair
{
  shapeton::SurfaceMesh whole;
  shapeton::SurfaceMesh cut;
};

/** A hand whose thumb touches the index finger, and the same cut apart there. */
CutPair
MakeHand(double edge);

/** The tip of the little finger, and the thumb's nail. */
Eigen::Vector3d
LittleFingertip();
Eigen::Vector3d
ThumbNail();

/** A head with open eyes and mouth, cut off at the back: four boundaries, the longest is the outer one. */
shapeton::SurfaceMesh
MakeFace(double edge);

/** A patch of a pot with its handle, bounded by a rectangle on its wall, and the same with the handle cut through.
 * Genus 1 and 0. `corners` of the patch, counterclockwise from outside. */
struct HandledPatch
{
  CutPair            surfaces;
  std::array<int, 4> corners;
};
HandledPatch
MakePotPatch(double edge);

#endif
