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
 * Edges are put in one by one. Then a random edge is taken out and put in anew between two
 * corners of one face, so the genus never rises; it falls where the edge had one face on both sides and finds one to
 * divide. Among the pairs of corners that are there the edge draws one by heat bath: a map has the weight of the
 * product of length^-c over its faces. It favours many short faces beside few long ones, which edges leave for a place
 * elsewhere. The exponent c rises while the search goes on. A move is never rejected, and none makes a handle: both
 * would cost time without leading to a smaller genus.
 *
 * \ingroup GraphGenus */
class GenusAnnealing
{
public:
  /** How edges are put in at first. */
  enum class Growth
  {
    Tree,   ///< a random spanning tree, then the others in random order
    Breadth ///< node by node, each with all its edges to nodes before it: finds surfaces that short faces tile
  };

  GenusAnnealing(const Graph & graph, PhiloxStream random, Growth growth);

  /** Moves `moves` edges while the exponent rises from half of `lastExponent` to all of it; ends early at genus `goal`,
   * or when `isInVain`, which is asked now and then, says so. */
  void
  Anneal(std::int64_t moves, int lastExponent, int goal, const std::function<bool()> & isInVain);

  int
  BestGenus() const
  {
    return m_BestGenus;
  }
  /** The half-edge after each one, of the best map. */
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
  std::vector<Corners> m_Corners; // where an edge would divide a face
  std::vector<double>  m_Weights;
  std::vector<int>     m_FirstOfFace; // a list of the corners of one node for each face
  std::vector<int>     m_NextInFace;
  std::vector<int>     m_Best;
  int                  m_BestGenus;
};
} // namespace shapeton

#endif
