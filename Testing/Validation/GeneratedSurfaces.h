#ifndef GeneratedSurfaces_h
#define GeneratedSurfaces_h

#include "shapetonSurfaceConnectivity.h"

#include <Eigen/Geometry>

#include <functional>

/** Generated surfaces for the figures of chapter 5; the models of the dissertation are not freely available. */

/** Signed distance of a solid, negative inside (mm). */
using SignedDistance = std::function<double(const Eigen::Vector3d &)>;

/** Rounded rod along a polyline. */
SignedDistance
Rod(const std::vector<Eigen::Vector3d> & line, double radius);

/** Union of solids with fillets of about this radius (mm). */
SignedDistance
Joined(const std::vector<SignedDistance> & solids, double fillet);

/** Surface of a solid inside a box, with nearly equilateral triangles of this edge length (mm). */
shapeton::SurfaceMesh
SurfaceOfSolid(const SignedDistance & solid, const Eigen::Vector3d & low, const Eigen::Vector3d & high, double edge);

/** Closed loop of edges along the intersection of the surface and a plane within a ball around `place`, first vertex =
 * last. Throws std::runtime_error if it is not a single loop. */
std::vector<int>
LoopAcross(const shapeton::SurfaceMesh & mesh,
           const Eigen::Vector3d &       place,
           const Eigen::Vector3d &       normal,
           double                        radius);

/** Vertex closest to a point. */
int
VertexAt(const shapeton::SurfaceMesh & mesh, const Eigen::Vector3d & place);

/** A surface before and after a cut along a loop of edges. The cut surface begins with the vertices of the uncut one.
 */
struct CutPair
{
  shapeton::SurfaceMesh whole;
  shapeton::SurfaceMesh cut;
};

/** Hand whose thumb touches the index finger, and the same hand separated at the contact. */
CutPair
MakeHand(double edge);

/** Tip of the little finger, and thumbnail. */
Eigen::Vector3d
LittleFingertip();
Eigen::Vector3d
ThumbNail();

/** Head with open eyes and mouth, cut off at the back: four boundaries; the longest is the outer one. */
shapeton::SurfaceMesh
MakeFace(double edge);

/** Patch of a pot with its handle, bounded by a rectangle on its wall, and the same patch with the handle cut. Genus 1
 * and 0. `corners` of the patch are counterclockwise, seen from outside. */
struct HandledPatch
{
  CutPair            surfaces;
  std::array<int, 4> corners;
};
HandledPatch
MakePotPatch(double edge);

#endif
