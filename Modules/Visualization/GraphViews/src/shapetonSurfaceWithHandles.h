#ifndef shapetonSurfaceWithHandles_h
#define shapetonSurfaceWithHandles_h

#include "ShapetonGraphViewsExport.h"
#include "shapetonCombinatorialMap.h"

#include <array>
#include <vector>

namespace shapeton
{
/** \brief A map of genus g on a template surface in space: the unit sphere with g handles, as triangles.
 *
 * The map is cut along g closed curves (HandleCut). The circle packing of the remaining map on the sphere gives the
 * positions of nodes, edges and handles: each handle is a tube between small holes around both hubs of its cut. Cut
 * edges run along the tube in parallel, with the least twist.
 *
 * The embedding is preserved: edges meet only at their ends and keep the rotation around each node, and the surface has
 * the genus of the map. Outside the tubes, the circles of nodes and faces are the round, tangent circles of the cut
 * map. The conformal type of the surface is not preserved; the tiles of the Poincare disk show it.
 * \ingroup ShapetonGraphViews */
class ShapetonGraphViews_EXPORT SurfaceWithHandles
{
public:
  using Point = std::array<double, 3>;

  /** `longest` is the approximate maximum edge length of a triangle, in radii of the sphere. Throws InputError as
   * PackOnSphere() does, and if the handles are too crowded. */
  explicit SurfaceWithHandles(const CombinatorialMap & map, double longest = 0.06);

  /** Vertices; node i of the map is vertex i. */
  const std::vector<Point> &
  Vertices() const
  {
    return m_Vertices;
  }
  /** Triangles, counterclockwise as seen from outside. */
  const std::vector<std::array<int, 3>> &
  Triangles() const
  {
    return m_Triangles;
  }
  /** For each edge of the map, the vertices from its start node to its end node; consecutive ones are mesh
   * neighbors. */
  const std::vector<std::vector<int>> &
  Edges() const
  {
    return m_Edges;
  }
  /** For each handle: turns of its edges around the tube, relative to the plane of its axes. */
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
