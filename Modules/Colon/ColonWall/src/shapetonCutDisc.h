#ifndef shapetonCutDisc_h
#define shapetonCutDisc_h

#include "shapetonSurfaceConnectivity.h"

namespace shapeton
{
/** Finds geodesic discs on a closed surface. */
class DiscCutter
{
public:
  explicit DiscCutter(const SurfaceMesh & mesh)
    : m_Mesh(mesh), m_Connectivity(mesh), m_IsForbidden(static_cast<std::size_t>(mesh.NumberOfFaces()), 0)
  {}

  const SurfaceConnectivity &
  Connectivity() const
  {
    return m_Connectivity;
  }

  /** The faces whose vertices all lie within `radius` of the pole, measured along edges, with the islands they enclose
   * and without teeth on their boundary; in ascending order. Empty where they are no disc by their topology, or touch
   * what is forbidden. The vertex `outside` lies on no island. */
  std::vector<int>
  FindDisc(int pole, double radius, int outside) const;

  /** Later discs keep away from these faces and their neighbours. */
  void
  Forbid(const std::vector<int> & faces);

private:
  std::vector<int>
  FacesWithin(int pole, double radius) const;
  void
  FillIslands(std::vector<int> & faces, int outsideVertex) const;
  bool
  HasVertex(int face, int vertex) const;
  void
  FillTeeth(std::vector<int> & faces) const;
  bool
  IsDisc(const std::vector<int> & faces) const;
  /** The face at the other side of an edge of a face. */
  int
  FaceAcross(int face, int k) const;

  const SurfaceMesh & m_Mesh;
  SurfaceConnectivity m_Connectivity;
  std::vector<char>   m_IsForbidden;
};

/** Writes field arrays `rectumLoop` and `caecumLoop` by the distance of the loops to the ends of the centreline, and
 * gives the genus. Throws InputError unless the surface is one manifold component with two loops. */
int
SetLoops(SurfaceMesh &               mesh,
         const SurfaceConnectivity & connectivity,
         const Eigen::Vector3d &     rectum,
         const Eigen::Vector3d &     caecum);

/** Moves the vertices of the boundary along, so that the rims are smooth, as far as no face next to them gets
 * needle-shaped or turns over. */
void
SmoothRims(SurfaceMesh & mesh, const SurfaceConnectivity & connectivity);
} // namespace shapeton

#endif
