#ifndef shapetonBallMap_h
#define shapetonBallMap_h

#include "shapetonCombinatorialMap.h"

#include <vector>

namespace shapeton
{
/** A planar map with a root and an outer face. */
class RootedMap
{
public:
  /** The outer face is the longest; ties go to the face farthest from the root. Root -1: the first of the nodes that
   * are farthest from the outer face. Throws InputError, see FindConformalType(). */
  RootedMap(const Graph & graph, int root);

  const CombinatorialMap &
  Map() const
  {
    return m_Map;
  }
  int
  Root() const
  {
    return m_Root;
  }
  int
  OuterFace() const
  {
    return m_OuterFace;
  }
  /** Edges from the root. */
  const std::vector<int> &
  Distances() const
  {
    return m_Distances;
  }
  /** Smallest distance from the root to a node of the outer face. */
  int
  DistanceOfOuterFace() const;

private:
  CombinatorialMap m_Map;
  int              m_Root;
  int              m_OuterFace{ 0 };
  std::vector<int> m_Distances;
};

/** A disk of a planar map, and an apex that replaces everything outside, joined to each corner of the boundary. */
struct BallMap
{
  CombinatorialMap map;
  int              root{ 0 };
  int              apex{ 0 };      ///< the last node
  int              radius{ 0 };    ///< smallest distance of the boundary from the root, edges
  int              diskEdges{ 0 }; ///< edges up to this number are in the disk, the others meet the apex
};

/** The ball of this radius or a larger one, see FindConformalType(): holes that it encloses are filled. \pre 1 <=
 * radius <= DistanceOfOuterFace(). */
BallMap
BallAround(const RootedMap & rooted, int radius);

/** All faces connected to the root across edges without entering the outer face, and those that they enclose. */
BallMap
WholeDisk(const RootedMap & rooted);
} // namespace shapeton

#endif
