#ifndef shapetonSurfaceWithHandles_h
#define shapetonSurfaceWithHandles_h

#include "GraphViewsExport.h"
#include "shapetonCombinatorialMap.h"

#include <array>
#include <vector>

namespace shapeton
{
/** \brief A map of genus g on a template surface in space: the unit sphere with g handles, as triangles.
 *
 * The map is cut along g closed curves (HandleCut). The circle packing of the map of the sphere that is left says where
 * on the sphere its nodes and edges lie, and where the handles stand: each is a tube between small holes around both
 * hubs of its cut. Edges that were cut run along the tube, side by side with the least twist.
 *
 * This keeps the map: the edges are disjoint but for their ends, stand around each node in the order of the rotation,
 * and the surface has the genus of the map. Outside of the tubes the circles of nodes and faces are round and touch,
 * those of the cut map. The conformal type of the surface of the map is not kept; the tiles of the Poincare disk show
 * it. \ingroup GraphViews */
class GraphViews_EXPORT SurfaceWithHandles
{
public:
  using Point = std::array<double, 3>;

  /** `longest` is about the longest edge of a triangle, in radii of the sphere. Throws InputError as PackOnSphere()
   * does, and where the handles are too crowded. */
  explicit SurfaceWithHandles(const CombinatorialMap & map, double longest = 0.06);

  /** Node i of the map is vertex i. */
  const std::vector<Point> &
  Vertices() const
  {
    return m_Vertices;
  }
  /** Counter-clockwise, seen from outside. */
  const std::vector<std::array<int, 3>> &
  Triangles() const
  {
    return m_Triangles;
  }
  /** Of each edge of the map the vertices from its start node to its end node, neighbours in the mesh. */
  const std::vector<std::vector<int>> &
  Edges() const
  {
    return m_Edges;
  }
  /** Of each handle: how often its edges wind around the tube, relative to the plane of its axes. */
  const std::vector<double> &
  Twists() const
  {
    return m_Twists;
  }

private:
  std::vector<Point>              m_Vertices;
  std::vector<std::array<int, 3>> m_Triangles;
  std::vector<std::vector<int>>   m_Edges;
  std::vector<double>             m_Twists;
};
} // namespace shapeton

#endif
