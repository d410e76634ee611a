#ifndef shapetonSphereWithHoles_h
#define shapetonSphereWithHoles_h

#include "shapetonPackedMap.h"
#include "shapetonSphericalPacking.h"

#include <Eigen/Core>

namespace shapeton
{
/** A round hole of the sphere, inside the circle of a node. */
struct SphereHole
{
  int             node;
  Eigen::Vector3d centre; ///< a unit vector
  double          angle;  ///< from the centre to the rim
};

/** \brief The unit sphere as triangles along a circle packing, with holes around some nodes.
 *
 * Before refinement the triangles are those of node, touching point and face; at a hole they end on its rim. So edges
 * of the packed map are paths of the mesh. Edges are halved until none is longer than `longest`, new vertices lie on
 * the sphere, or on the rim between two of the rim. */
class SphereWithHoles
{
public:
  /** Nodes come first, in their order, those with holes left out. The references must outlive the constructor only. */
  SphereWithHoles(const PackedMap &               packed,
                  const SphericalPacking &        packing,
                  const std::vector<SphereHole> & holes,
                  double                          longest);

  const std::vector<Eigen::Vector3d> &
  Vertices() const
  {
    return m_Vertices;
  }
  const std::vector<std::array<int, 3>> &
  Triangles() const
  {
    return m_Triangles;
  }
  /** Of each vertex: on the rim of which hole it is, or -1. */
  const std::vector<int> &
  Rims() const
  {
    return m_Rims;
  }
  /** The vertices of each edge of the graph from its start node to its end node; from and to the rim, where there is a
   * hole. */
  const std::vector<std::vector<int>> &
  Paths() const
  {
    return m_Paths;
  }

private:
  class EdgeMiddles;

  int
  Add(const Eigen::Vector3d & vertex, int rim = -1);
  int
  AddRim(int hole, const Eigen::Vector3d & towards);
  void
  AddVertices(const SphericalPacking & packing);
  void
  AddTriangles();
  void
  AddPaths(const PackedMap & packed);
  bool
  IsTooLong(int i, int j) const;
  int
  Middle(int i, int j);
  bool
  Refine();
  void
  AddParts(std::array<int, 3> triangle, const EdgeMiddles & middles);
  static std::vector<int>
  Halved(const std::vector<int> & path, const EdgeMiddles & middles);

  const CombinatorialMap &        m_Map;
  const std::vector<SphereHole> & m_Holes;
  double                          m_Longest;

  std::vector<Eigen::Vector3d>    m_Vertices;
  std::vector<int>                m_Rims;
  std::vector<std::array<int, 3>> m_Triangles;
  std::vector<std::vector<int>>   m_Paths;

  /** \name Vertices of the packing; of half-edges that leave a hole's node: on the rim, towards touching point and face
   */
  ///@{
  std::vector<int> m_HoleOfNode;
  std::vector<int> m_OfNode;
  std::vector<int> m_OfFace;
  std::vector<int> m_OfTouch;
  std::vector<int> m_RimAtTouch;
  std::vector<int> m_RimAtFace;
  ///@}
};
} // namespace shapeton

#endif
