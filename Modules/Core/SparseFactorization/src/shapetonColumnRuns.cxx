#include "shapetonEliminationTree.h"

#include "shapetonFrontKernels.h"

#include <algorithm>
#include <utility>

namespace shapeton
{
namespace
{
/** A supernode during merging: a node of the tree, with its columns as a list. */
struct Node
{
  int parent{ -1 };
  int firstChild{ -1 };
  int sibling{ -1 };
  int width{ 0 };
  int rows{ 0 };
  int firstColumn{ -1 };
  int lastColumn{ -1 };
};

/** Estimated time of a front, in vector products: overhead, transfer of rows x rows elements to and from its parent,
 * and dense products. The weights were fitted to measured times and affect only merging. */
double
CostOf(int width, int rows)
{
  const double     w = FrontKernels::PaddedRows(width);
  const double     r = FrontKernels::PaddedRows(rows);
  const double     front = w + r;
  constexpr double ofNode = 250.0, ofFront = 0.9, ofPivots = 0.2, ofRows = 0.75, ofUpdate = 0.4;
  return ofNode + ofFront * front * front + width * (ofPivots * w * w + ofRows * r * w + ofUpdate * r * r);
}

class Merging
{
public:
  Merging(const std::vector<int> & order, const EliminationTree & tree) : m_Order(order), m_NextColumn(order.size(), -1)
  {
    this->FindNodes(tree);
    for (int i = 0; i < static_cast<int>(m_Nodes.size()); ++i)
    {
      this->MergeChildren(i);
    }
  }

  ColumnRuns
  Runs() const
  {
    ColumnRuns runs;
    runs.order.reserve(m_Order.size());
    for (int i = static_cast<int>(m_Nodes.size()) - 1; i >= 0; --i)
    {
      if (m_Nodes[i].parent == -1 && m_Nodes[i].width > 0)
      {
        this->Append(i, runs);
      }
    }
    runs.firstColumn.push_back(static_cast<int>(runs.order.size()));
    return runs;
  }

private:
  /** Fundamental supernodes: each column has the structure of the next one plus that column itself. */
  void
  FindNodes(const EliminationTree & tree)
  {
    const int        n = static_cast<int>(m_Order.size());
    std::vector<int> nodeOfColumn(n);
    for (int column = 0; column < n; ++column)
    {
      const bool isNext =
        column > 0 && tree.parent[column - 1] == column && tree.count[column - 1] == tree.count[column] + 1;
      if (!isNext)
      {
        m_Nodes.emplace_back();
        m_Nodes.back().firstColumn = column;
      }
      else
      {
        m_NextColumn[column - 1] = column;
      }
      nodeOfColumn[column] = static_cast<int>(m_Nodes.size()) - 1;
      Node & node = m_Nodes.back();
      ++node.width;
      node.rows = tree.count[column];
      node.lastColumn = column;
    }
    for (int i = static_cast<int>(m_Nodes.size()) - 1; i >= 0; --i)
    {
      const int parentColumn = tree.parent[m_Nodes[i].lastColumn];
      if (parentColumn != -1)
      {
        this->AddChild(nodeOfColumn[parentColumn], i);
      }
    }
  }

  void
  AddChild(int parent, int child)
  {
    m_Nodes[child].parent = parent;
    m_Nodes[child].sibling = m_Nodes[parent].firstChild;
    m_Nodes[parent].firstChild = child;
  }

  double
  Saving(const Node & parent, const Node & child) const
  {
    return CostOf(parent.width, parent.rows) + CostOf(child.width, child.rows) -
           CostOf(parent.width + child.width, parent.rows);
  }

  /** Repeatedly merges the child with the largest saving until no merge saves time. */
  void
  MergeChildren(int parent)
  {
    std::vector<int> children;
    for (int child = m_Nodes[parent].firstChild; child != -1; child = m_Nodes[child].sibling)
    {
      children.push_back(child);
    }
    while (true)
    {
      int    best = -1;
      double bestSaving = 0.0;
      for (int i = 0; i < static_cast<int>(children.size()); ++i)
      {
        const double saving = this->Saving(m_Nodes[parent], m_Nodes[children[i]]);
        if (saving > bestSaving)
        {
          bestSaving = saving;
          best = i;
        }
      }
      if (best == -1)
      {
        break;
      }
      this->Merge(parent, children[best], children);
      children.erase(children.begin() + best);
    }
    m_Nodes[parent].firstChild = -1;
    for (auto child = children.rbegin(); child != children.rend(); ++child)
    {
      this->AddChild(parent, *child);
    }
  }

  void
  Merge(int parent, int child, std::vector<int> & children)
  {
    for (int grandchild = m_Nodes[child].firstChild; grandchild != -1; grandchild = m_Nodes[grandchild].sibling)
    {
      children.push_back(grandchild);
    }
    m_NextColumn[m_Nodes[child].lastColumn] = m_Nodes[parent].firstColumn;
    m_Nodes[parent].firstColumn = m_Nodes[child].firstColumn;
    m_Nodes[parent].width += m_Nodes[child].width;
    m_Nodes[child].width = 0;
  }

  /** The columns of a tree of nodes in postorder. */
  void
  Append(int root, ColumnRuns & runs) const
  {
    std::vector<std::pair<int, int>> stack{ { root, m_Nodes[root].firstChild } };
    while (!stack.empty())
    {
      auto & [node, child] = stack.back();
      if (child != -1)
      {
        const int next = child;
        child = m_Nodes[child].sibling;
        stack.emplace_back(next, m_Nodes[next].firstChild);
        continue;
      }
      runs.firstColumn.push_back(static_cast<int>(runs.order.size()));
      for (int column = m_Nodes[node].firstColumn; column != -1; column = m_NextColumn[column])
      {
        runs.order.push_back(m_Order[column]);
      }
      stack.pop_back();
    }
  }

  const std::vector<int> & m_Order;
  std::vector<int>         m_NextColumn;
  std::vector<Node>        m_Nodes;
};
} // namespace

ColumnRuns
MergeColumns(const std::vector<int> & order, const EliminationTree & tree)
{
  return Merging(order, tree).Runs();
}
} // namespace shapeton
