#ifndef shapetonLoopHomology_h
#define shapetonLoopHomology_h

#include "shapetonSurfaceConnectivity.h"

#include <cstdint>
#include <vector>

namespace shapeton
{
/** \class LoopHomology
 * \brief Classes of closed paths of edges modulo 2, on a surface with a disc in each boundary.
 *
 * A basis of 2g dual loops (g is the genus) comes from a tree of edges and a tree of faces (Eppstein 2003). The class
 * of a closed path has a bit for each of them: the parity of the crossings. A simple path separates the surface if its
 * class is 0; disjoint ones together do so if their classes are linearly dependent. */
class LoopHomology
{
public:
  explicit LoopHomology(const SurfaceConnectivity & connectivity);

  /** Marks a path of vertices from boundary to boundary that loops around handles cross an even number of times. */
  void
  SetCut(const FaceMatrix & F, const std::vector<int> & path);

  /** Bits of an edge, to be combined by exclusive or along a path: the lowest one is the parity of its crossings of the
   * cut, the others are random bits for its class. */
  std::uint64_t
  KeyOfEdge(int edge) const
  {
    return m_Keys[edge];
  }

  /** Whether a closed path with this key has a class other than 0, with probability 1 - 2^-63, and crosses the cut an
   * even number of times. */
  static bool
  IsOfHandle(std::uint64_t key)
  {
    return (key >> 1) != 0 && (key & 1) == 0;
  }

  /** Numbers of the dual loops that a closed path crosses an odd number of times, ascending. */
  std::vector<int>
  ClassOf(const std::vector<int> & edges) const;

private:
  void
  CrossLoops(const std::vector<int> & parentEdges, const std::vector<int> & depths);
  void
  Cross(int edge, int loop);
  int
  NodeAcross(int edge, int node) const;

  const SurfaceConnectivity &     m_Connectivity;
  std::vector<std::array<int, 2>> m_NodesOfEdge; ///< faces, then boundaries
  std::vector<int>                m_Generators;  ///< edges in neither tree
  std::vector<std::uint64_t>      m_Keys;
  std::vector<std::array<int, 2>> m_Crossings; ///< edge and dual loop, ascending
};

/** Classes of LoopHomology added one by one; keeps those that do not depend on earlier ones. */
class IndependentClasses
{
public:
  /** Returns false, and does not add the class, if it is a sum of earlier ones. */
  bool
  Add(std::vector<int> loops);

private:
  std::vector<std::vector<int>> m_Reduced; ///< each lacks the first numbers of earlier ones
};
} // namespace shapeton

#endif
