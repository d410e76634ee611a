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
  Eigen::Vector3d center; ///< unit vector
  double          angle;  ///< from the center to the rim
};

/** \brief Triangulation of the unit sphere along a circle packing, with holes around some nodes.
 *
 * Before refinement, each triangle is formed by a node, a tangency point and a face; at a hole the triangle ends at the
 * rim. Edges of the packed map are therefore paths of the mesh. Edges are bisected until none is longer than `longest`.
 * New vertices are on the sphere, or on the rim if both ends are. */
class SphereWithHoles
{
public:
  /** Nodes without holes come first, in order. The references are used only by the constructor. */
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
  /** For each vertex: the hole whose rim contains it, or -1. */
  const std::vector<int> &
  Rims() const
  {
    return m_Rims;
  }
  /** Vertices of each edge of the graph from its start node to its end node; at a hole, from or to the rim. */
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

  /** \name Vertices of the packing. Half-edges at a node with a hole have rim vertices, in the directions of tangency
   * point and face.
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
