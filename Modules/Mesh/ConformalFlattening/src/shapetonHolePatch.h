#ifndef shapetonHolePatch_h
#define shapetonHolePatch_h

#include "shapetonSurfaceMesh.h"

#include <array>
#include <functional>
#include <vector>

namespace shapeton
{
/** \class HolePatch
 * \brief A disk that closes a polygon with triangles as large as those around it.
 *
 * After Liepa, Filling holes in meshes (2003). Starts from the minimum-area triangulation (dynamic programming).
 * Triangles are split at their centers until edges are about as long as the surrounding ones; between splits, edges are
 * flipped until opposite angles sum to less than 180 degrees. */
class HolePatch
{
public:
  /** \param rim the polygon, counterclockwise as seen from the side that the faces point to.
   * \param scales target edge length at each rim vertex.
   * \param isTaken whether two rim vertices already share an edge outside, which must not be duplicated. */
  HolePatch(std::vector<Eigen::Vector3d>               rim,
            std::vector<double>                        scales,
            std::function<bool(int first, int second)> isTaken);

  /** False if every triangulation requires an edge that already exists outside. */
  bool
  Triangulate();

  void
  Refine();

  /** The rim vertices, followed by new ones. */
  const std::vector<Eigen::Vector3d> &
  Points() const
  {
    return m_Points;
  }
  std::vector<std::array<int, 3>>
  Faces() const;

private:
  /** Neighbor k shares the edge from corner k to the next; -1 at the rim. */
  struct Face
  {
    std::array<int, 3> corners;
    std::array<int, 3> neighbors;
  };

  double
  LeastArea(std::vector<int> & middles) const;
  void
  AddFaces(const std::vector<int> & middles, int first, int last);
  void
  Connect();
  bool
  IsTooLarge(const Face & face) const;
  void
  Split(int face);
  void
  ReplaceNeighbor(int face, int before, int after);
  bool
  HasEdge(int a, int b) const;
  bool
  FlipIfBetter(int face, int k);
  void
  FlipAll();

  int                           m_Rim;
  std::vector<Eigen::Vector3d>  m_Points;
  std::vector<double>           m_Scales;
  std::function<bool(int, int)> m_IsTaken;
  std::vector<Face>             m_Faces;
};
} // namespace shapeton

#endif
