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

  /** The faces whose vertices are all within `radius` of the pole, measured along edges, including enclosed islands and
   * faces that would protrude into the opening; in ascending order. Empty if they do not form a topological disc or
   * touch excluded faces. The part with the vertex `outside` is never an island. */
  std::vector<int>
  FindDisc(int pole, double radius, int outside) const;

  /** Excludes faces and their neighbors from later discs. */
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
  /** The face on the other side of an edge of a face. */
  int
  FaceAcross(int face, int k) const;

  const SurfaceMesh & m_Mesh;
  SurfaceConnectivity m_Connectivity;
  std::vector<char>   m_IsForbidden;
};

/** Adds the field arrays `rectumLoop` and `cecumLoop`, assigned by distance to the ends of the centerline, and returns
 * the genus. Throws InputError unless the surface is one manifold component with two loops. */
int
SetLoops(SurfaceMesh &               mesh,
         const SurfaceConnectivity & connectivity,
         const Eigen::Vector3d &     rectum,
         const Eigen::Vector3d &     cecum);

/** Smooths the rims by moving boundary vertices, except where an adjacent face would degenerate or flip. */
void
SmoothRims(SurfaceMesh & mesh, const SurfaceConnectivity & connectivity);
} // namespace shapeton

#endif
