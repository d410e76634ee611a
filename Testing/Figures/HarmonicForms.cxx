#include "HarmonicForms.h"

#include "shapetonHarmonicSolver.h"

#include <algorithm>
#include <cmath>
#include <queue>

using namespace shapeton;

namespace
{
/** A step of a dual path: the edge crossed, and 1 if its lower vertex is on the left. */
struct Crossing
{
  int    edge;
  double sign;
};

/** Loops of faces, two per handle: an edge outside of a tree of edges and of a tree of faces, and the paths of its
 * faces in the latter (Eppstein 2003). Each boundary counts as a face. */
class DualLoops
{
public:
  DualLoops(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity)
    : m_Mesh(mesh), m_Connectivity(connectivity), m_DiscOfVertex(connectivity.NumberOfVertices(), -1)
  {
    m_Nodes = connectivity.NumberOfFaces();
    for (const std::vector<int> & loop : connectivity.BoundaryLoops())
    {
      for (const int vertex : loop)
      {
        m_DiscOfVertex[vertex] = m_Nodes;
      }
      ++m_Nodes;
    }
    this->GrowTreeOfEdges();
    this->GrowTreeOfFaces();
  }

  std::vector<std::vector<Crossing>>
  Loops() const
  {
    std::vector<std::vector<Crossing>> loops;
    for (int edge = 0; edge < m_Connectivity.NumberOfEdges(); ++edge)
    {
      if (!m_IsUsed[edge])
      {
        const auto [left, right] = this->SidesOf(edge);
        std::vector<Crossing> loop{ { edge, 1.0 } }; // from left to right, back through the tree
        this->AddPathToRoot(right, 1.0, loop);
        this->AddPathToRoot(left, -1.0, loop);
        loops.push_back(loop);
      }
    }
    return loops;
  }

private:
  /** The faces, or discs, left and right of an edge from its lower to its higher vertex. */
  std::array<int, 2>
  SidesOf(int edge) const
  {
    const std::array<int, 2> & ends = m_Connectivity.VerticesOfEdge(edge);
    std::array<int, 2>         sides{ { m_DiscOfVertex[ends[0]], m_DiscOfVertex[ends[0]] } };
    for (const int face : m_Connectivity.FacesOfEdge(edge))
    {
      for (int k = 0; k < 3; ++k)
      {
        if (m_Connectivity.EdgeOfFace(face, k) == edge)
        {
          sides[m_Mesh.F(face, k) == ends[0] ? 0 : 1] = face;
        }
      }
    }
    return sides;
  }

  void
  GrowTreeOfEdges()
  {
    m_IsUsed.assign(m_Connectivity.NumberOfEdges(), 0);
    std::vector<char> isReached(m_Connectivity.NumberOfVertices(), 0);
    std::queue<int>   queue;
    queue.push(m_Mesh.F(0, 0));
    isReached[m_Mesh.F(0, 0)] = 1;
    while (!queue.empty())
    {
      const int vertex = queue.front();
      queue.pop();
      for (const int next : m_Connectivity.NeighborsOfVertex(vertex))
      {
        if (!isReached[next])
        {
          isReached[next] = 1;
          m_IsUsed[m_Connectivity.FindEdge(vertex, next)] = 1;
          queue.push(next);
        }
      }
    }
  }

  void
  GrowTreeOfFaces()
  {
    std::vector<std::vector<int>> edgesOf(m_Nodes);
    for (int edge = 0; edge < m_Connectivity.NumberOfEdges(); ++edge)
    {
      for (const int node : this->SidesOf(edge))
      {
        edgesOf[node].push_back(edge);
      }
    }
    m_Parent.assign(m_Nodes, { -1, 0.0 });
    m_Up.assign(m_Nodes, -1);
    std::vector<char> isReached(m_Nodes, 0);
    std::queue<int>   queue;
    queue.push(0);
    isReached[0] = 1;
    while (!queue.empty())
    {
      const int node = queue.front();
      queue.pop();
      for (const int edge : edgesOf[node])
      {
        const auto [left, right] = this->SidesOf(edge);
        const int next = left == node ? right : left;
        if (!m_IsUsed[edge] && !isReached[next])
        {
          isReached[next] = 1;
          m_IsUsed[edge] = 1;
          m_Up[next] = node;
          m_Parent[next] = { edge, next == left ? 1.0 : -1.0 };
          queue.push(next);
        }
      }
    }
  }

  void
  AddPathToRoot(int node, double sign, std::vector<Crossing> & loop) const
  {
    for (; m_Up[node] >= 0; node = m_Up[node])
    {
      loop.push_back({ m_Parent[node].edge, sign * m_Parent[node].sign });
    }
  }

  const SurfaceMesh &         m_Mesh;
  const SurfaceConnectivity & m_Connectivity;
  std::vector<int>            m_DiscOfVertex;
  int                         m_Nodes{ 0 };
  std::vector<char>           m_IsUsed; ///< whether an edge is in one of the trees
  std::vector<Crossing>       m_Parent; ///< of each node, the step toward the root
  std::vector<int>            m_Up;     ///< of each node, the next one toward the root
};

/** Divergence of the forms at the vertices. */
Eigen::MatrixXd
DivergenceOf(const SurfaceLaplacian & laplacian, const Eigen::MatrixXd & forms)
{
  Eigen::MatrixXd divergence = Eigen::MatrixXd::Zero(laplacian.NumberOfVertices(), forms.cols());
  for (std::size_t edge = 0; edge < laplacian.edges.size(); ++edge)
  {
    const auto [a, b] = laplacian.edges[edge];
    divergence.row(b) += laplacian.weights[edge] * forms.row(edge);
    divergence.row(a) -= laplacian.weights[edge] * forms.row(edge);
  }
  return divergence;
}

double
LargestClosure(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity, const Eigen::MatrixXd & forms)
{
  double largest = 0.0;
  for (int face = 0; face < connectivity.NumberOfFaces(); ++face)
  {
    Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(forms.cols());
    for (int k = 0; k < 3; ++k)
    {
      const bool isForward = mesh.F(face, k) < mesh.F(face, (k + 1) % 3);
      sum += (isForward ? 1.0 : -1.0) * forms.row(connectivity.EdgeOfFace(face, k));
    }
    largest = std::max(largest, sum.cwiseAbs().maxCoeff());
  }
  return largest;
}
} // namespace

HarmonicForms
FindHarmonicForms(const SurfaceMesh &         mesh,
                  const SurfaceConnectivity & connectivity,
                  const SurfaceLaplacian &    laplacian)
{
  const auto    loops = DualLoops(mesh, connectivity).Loops();
  HarmonicForms result;
  result.forms = Eigen::MatrixXd::Zero(connectivity.NumberOfEdges(), static_cast<Eigen::Index>(loops.size()));
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    for (const Crossing & crossing : loops[i])
    {
      result.forms(crossing.edge, static_cast<Eigen::Index>(i)) += crossing.sign;
    }
  }
  if (loops.empty())
  {
    return result;
  }
  const HarmonicSolver  solver(laplacian, { 0 });
  const Eigen::MatrixXd source = DivergenceOf(laplacian, result.forms);
  const Eigen::MatrixXd f = solver.Solve(Eigen::MatrixXd::Zero(1, result.forms.cols()), source);
  for (std::size_t edge = 0; edge < laplacian.edges.size(); ++edge)
  {
    const auto [a, b] = laplacian.edges[edge];
    result.forms.row(edge) -= f.row(b) - f.row(a);
  }
  return result;
}

HarmonicErrors
ErrorsOf(const HarmonicForms &       forms,
         const SurfaceMesh &         mesh,
         const SurfaceConnectivity & connectivity,
         const SurfaceLaplacian &    laplacian)
{
  const double largest = forms.forms.cwiseAbs().maxCoeff();
  return { LargestClosure(mesh, connectivity, forms.forms) / largest,
           DivergenceOf(laplacian, forms.forms).cwiseAbs().maxCoeff() / largest };
}
