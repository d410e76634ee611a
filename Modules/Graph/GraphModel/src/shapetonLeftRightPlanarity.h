#ifndef shapetonLeftRightPlanarity_h
#define shapetonLeftRightPlanarity_h

#include "shapetonGraph.h"

#include <vector>

namespace shapeton
{
/** \class LeftRightPlanarity
 * \brief The left-right planarity test and embedding (de Fraysseix and Rosenstiehl; Brandes, The Left-Right Planarity
 * Test, 2009), in linear time except for sorting the edges of each node, without recursion.
 *
 * A depth-first search orients all edges: tree edges away from the root, back edges toward it. Two back edges with
 * crossing paths must be on the same side, or on different sides, of the tree. The graph is planar if all these
 * constraints can be satisfied. They are stored as a stack of pairs of intervals of back edges.
 *
 * \ingroup ShapetonGraphModel */
class LeftRightPlanarity
{
public:
  /** Uses only edges with `isUsed`, which are neither loops nor parallel. */
  LeftRightPlanarity(const Graph & graph, const std::vector<bool> & isUsed);

  bool
  IsPlanar() const
  {
    return m_IsPlanar;
  }

  /** Writes the successor of each used half-edge. \pre The graph is planar; called once. */
  void
  WriteNextAround(std::vector<int> & next);

private:
  class EdgeOrders;
  /** Back edges from the lowest to the highest return point; -1 and -1 when empty. */
  struct Interval
  {
    int low{ -1 };
    int high{ -1 };
    bool
    IsEmpty() const
    {
      return low < 0 && high < 0;
    }
  };
  struct ConflictPair
  {
    Interval left;
    Interval right;
  };

  void
  Orient();
  void
  OrientFrom(int root);
  void
  FinishOriented(int edge);
  void
  SortLeaving();
  bool
  TestFrom(int root);
  bool
  FinishTested(int edge, int position);
  bool
  AddConstraints(int edge, int parent);
  bool
  MergeReturnEdges(int edge, int parent, ConflictPair & merged);
  bool
  MergeConflicting(int edge, ConflictPair & merged);
  void
  RemoveBackEdges(int edge);
  void
  Trim(Interval & trimmed, const Interval & other, int node);
  bool
  IsConflicting(const Interval & interval, int edge) const;
  int
  LowestOf(const ConflictPair & pair) const;
  int
  SideOf(int edge);
  int
  LeavingHalfEdge(int edge) const;
  void
  LinkLeaving(EdgeOrders & orders) const;
  void
  EmbedFrom(int root, EdgeOrders & orders);

  const Graph &    m_Graph;
  std::vector<int> m_Start;  // start of each node in m_Edges
  std::vector<int> m_Edges;  // edges of each node: first all, then only outgoing ones
  std::vector<int> m_End;    // end of the outgoing edges of each node
  std::vector<int> m_From;   // start node of each edge
  std::vector<int> m_To;     // end node of each edge
  std::vector<int> m_Height; // depth of each node, -1 before the search
  std::vector<int> m_Parent; // the tree edge to each node
  std::vector<int> m_Low;    // lowest return point of each edge
  std::vector<int> m_SecondLow;
  std::vector<int> m_Nesting;
  std::vector<int> m_Reference;
  std::vector<int> m_Side;
  std::vector<int> m_LowEdge;
  std::vector<int> m_StackBottom;
  std::vector<int> m_Roots;
  std::vector<int> m_LeftOf;  // per node: the outermost half-edge on the left of its last tree edge
  std::vector<int> m_RightOf; // per node: its last tree edge
  std::vector<int> m_Place;   // per node: search position in m_Edges

  std::vector<ConflictPair> m_Stack;
  bool                      m_IsPlanar{ true };
};
} // namespace shapeton

#endif
