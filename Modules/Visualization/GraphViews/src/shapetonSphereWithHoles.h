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
 * rim. Edges of the packed map are therefore paths of the mesh. */
struct SphereWithHoles
{
  std::vector<Eigen::Vector3d>    vertices; ///< nodes without holes come first, in order
  std::vector<std::array<int, 3>> triangles;
  std::vector<int>                rims; ///< for each vertex: the hole whose rim contains it, or -1
  /** Vertices of each edge of the graph from its start node to its end node; at a hole, from or to the rim. */
  std::vector<std::vector<int>> paths;
};

/** Bisects edges until none is longer than `longest`. New vertices are on the sphere, or on the rim if both ends are.
 */
SphereWithHoles
TriangulateSphere(const PackedMap &               packed,
                  const SphericalPacking &        packing,
                  const std::vector<SphereHole> & holes,
                  double                          longest);
} // namespace shapeton

#endif
