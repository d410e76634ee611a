#ifndef shapetonGenusAnnealing_h
#define shapetonGenusAnnealing_h

#include "shapetonIncrementalMap.h"
#include "shapetonGraphStructure.h"
#include "shapetonPhiloxStream.h"

#include <functional>
#include <vector>

namespace shapeton
{
/** \class GenusAnnealing
 * \brief Searches for a rotation system of small genus of a connected graph without loops.
 *
 * Edges are inserted one by one. Then a random edge is removed and reinserted between two corners of one face, so the
 * genus never rises. It decreases if the edge had the same face on both sides and now splits a face. The pair of
 * corners is drawn by heat bath: the weight of a map is the product of length^-c over its faces. This favors many short
 * faces and a few long ones, which then lose edges. The exponent c increases during the search. Moves are not rejected
 * and do not add handles, because both would cost time without reducing the genus.
 *
 * \ingroup ShapetonGraphModel */
class GenusAnnealing
{
public:
  /** Initial insertion order of the edges. */
  enum class Growth
  {
    Tree,   ///< a random spanning tree, then the other edges in random order
    Breadth ///< node by node, with all edges to earlier nodes: finds surfaces tiled by short faces
  };

  GenusAnnealing(const Graph & graph, PhiloxStream random, Growth growth);

  /** Moves `moves` edges while the exponent increases from half of `lastExponent` to its full value. Ends early at
   * genus `goal`, or if `isInVain`, called periodically, returns true. */
  void
  Anneal(std::int64_t moves, int lastExponent, int goal, const std::function<bool()> & isInVain);

  int
  BestGenus() const
  {
    return m_BestGenus;
  }
  /** Successor of each half-edge in the best map. */
  const std::vector<int> &
  BestNextAround() const
  {
    return m_Best;
  }

private:
  struct Corners
  {
    int after0;
    int after1;
  };

  void
  GrowTree();
  void
  GrowByBreadth();
  void
  PlaceNode(int node, int root, const Incidence & incidence);
  int
  CornerForNode(const std::vector<int> & corners);
  void
  InsertRest();
  int
  CornerOfLongestFace(int node) const;
  void
  KeepBest();
  int
  Genus() const;
  int
  RandomCorner(int node);
  void
  CollectCorners(int edge);
  int
  ShorterPart(int a, int b) const;
  double
  WeightOf(const Corners & corners, int exponent) const;
  Corners
  DrawCorners(int exponent);
  void
  Reinsert(int edge, int exponent);

  const Graph &        m_Graph;
  PhiloxStream         m_Random;
  IncrementalMap       m_Map;
  std::vector<Corners> m_Corners; // where an edge would split a face
  std::vector<double>  m_Weights;
  std::vector<int>     m_FirstOfFace; // per face, a list of the corners of one node
  std::vector<int>     m_NextInFace;
  std::vector<int>     m_Best;
  int                  m_BestGenus;
};
} // namespace shapeton

#endif
