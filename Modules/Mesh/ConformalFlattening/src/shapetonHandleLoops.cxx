#include "shapetonHandleLoops.h"

#include "shapetonExceptions.h"
#include "shapetonFaceReplacement.h"
#include "shapetonLoopHomology.h"
#include "shapetonSurfaceCut.h"
#include "shapetonTubeCut.h"
#include "shapetonTubeEnds.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <unordered_map>

namespace shapeton
{
namespace
{
constexpr int mostShortenings = 50; // per loop
constexpr int placesOnLoop = 4;     // vertices of a loop whose trees shorten it
/** Radius of these trees, relative to the loop. One half is enough to reach all shorter loops through the vertex; a
 * larger radius also reaches loops next to it. */
constexpr double reach = 0.75;
/** Loops are shortened by at least this fraction of their length, so that rounding errors cannot cause endless
 * shortening. */
constexpr double leastGain = 1e-9;

/** Tree of shortest paths from a vertex, which avoids boundaries; reused for many vertices. */
class PathTree
{
public:
  PathTree(const SurfaceConnectivity & connectivity, const EdgeGraph & graph, const Eigen::VectorXd & lengths)
    : m_Graph(graph)
    , m_Lengths(lengths)
    , m_Distances(graph.NumberOfVertices(), infinity)
    , m_Parents(graph.NumberOfVertices(), { -1, -1 })
    , m_Keys(graph.NumberOfVertices(), 0)
    , m_IsBoundary(graph.NumberOfVertices(), 0)
  {
    for (const std::vector<int> & loop : connectivity.BoundaryLoops())
    {
      for (const int vertex : loop)
      {
        m_IsBoundary[vertex] = 1;
      }
    }
  }

  bool
  IsBoundary(int vertex) const
  {
    return m_IsBoundary[vertex] != 0;
  }

  /** Reaches the vertices within this distance. */
  void
  Grow(int root, double radius, const LoopHomology & homology)
  {
    this->Clear();
    this->Reach(root, 0.0, { -1, -1 }, 0);
    while (!m_Queue.empty())
    {
      const auto [distance, vertex] = m_Queue.top();
      m_Queue.pop();
      for (const EdgeGraph::Step * step = m_Graph.begin(vertex); step != m_Graph.end(vertex); ++step)
      {
        const double further = distance + m_Lengths[step->edge];
        if (distance <= m_Distances[vertex] && further <= radius && further < m_Distances[step->vertex] &&
            !m_IsBoundary[step->vertex])
        {
          this->Reach(step->vertex, further, { vertex, step->edge }, m_Keys[vertex] ^ homology.KeyOfEdge(step->edge));
        }
      }
    }
  }

  /** Calls `visit(edge, length, key)` for each edge between two branches: the length of the loop through the root that
   * it closes, and its key. */
  template <typename TVisit>
  void
  VisitLoops(const LoopHomology & homology, const TVisit & visit) const
  {
    for (const int vertex : m_Reached)
    {
      for (const EdgeGraph::Step * step = m_Graph.begin(vertex); step != m_Graph.end(vertex); ++step)
      {
        if (vertex < step->vertex && m_Distances[step->vertex] < infinity)
        {
          visit(step->edge,
                m_Distances[vertex] + m_Lengths[step->edge] + m_Distances[step->vertex],
                m_Keys[vertex] ^ homology.KeyOfEdge(step->edge) ^ m_Keys[step->vertex]);
        }
      }
    }
  }

  /** The loop closed by the edge between two vertices, without the common part of their paths to the root. */
  HandleLoop
  LoopOf(int a, int b, int edge) const
  {
    HandleLoop       loop{ {}, m_Lengths[edge] };
    std::vector<int> ofA{ a };
    std::vector<int> ofB{ b };
    this->FollowToMeeting(a, b, edge, [&](bool isOfA, int vertex, double length) {
      (isOfA ? ofA : ofB).push_back(vertex);
      loop.length = length;
      return true;
    });
    loop.vertices = std::move(ofA);
    loop.vertices.insert(loop.vertices.end(), ofB.rbegin() + 1, ofB.rend());
    return loop;
  }

  /** Whether the length of this loop is below a limit. */
  bool
  IsShorter(int a, int b, int edge, double limit) const
  {
    bool isShorter = m_Lengths[edge] < limit;
    this->FollowToMeeting(a, b, edge, [&](bool, int, double length) { return isShorter = length < limit; });
    return isShorter;
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  /** Follows the paths of the two ends of an edge to the root until they meet. Calls `step(isOfA, vertex, length)` for
   * each vertex reached, with the length of the loop so far, until it returns false. */
  template <typename TStep>
  void
  FollowToMeeting(int a, int b, int edge, const TStep & step) const
  {
    double length = m_Lengths[edge];
    for (bool isWanted = true; isWanted && a != b;)
    {
      const bool isFarther = m_Distances[a] > m_Distances[b] || (m_Distances[a] == m_Distances[b] && a > b);
      int &      farther = isFarther ? a : b;
      length += m_Lengths[m_Parents[farther].edge];
      farther = m_Parents[farther].vertex;
      isWanted = step(isFarther, farther, length);
    }
  }

  using Entry = std::pair<double, int>;

  void
  Clear()
  {
    for (const int vertex : m_Reached)
    {
      m_Distances[vertex] = infinity;
    }
    m_Reached.clear();
  }

  void
  Reach(int vertex, double distance, const EdgeGraph::Step & parent, std::uint64_t key)
  {
    if (m_Distances[vertex] == infinity)
    {
      m_Reached.push_back(vertex);
    }
    m_Distances[vertex] = distance;
    m_Parents[vertex] = parent;
    m_Keys[vertex] = key;
    m_Queue.emplace(distance, vertex);
  }

  const EdgeGraph &                                                   m_Graph;
  const Eigen::VectorXd &                                             m_Lengths;
  std::vector<double>                                                 m_Distances;
  std::vector<EdgeGraph::Step>                                        m_Parents;
  std::vector<std::uint64_t>                                          m_Keys;
  std::vector<char>                                                   m_IsBoundary;
  std::vector<int>                                                    m_Reached;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> m_Queue;
};

/** Finds loops of one surface. */
class LoopSearch
{
public:
  LoopSearch(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity)
    : m_Connectivity(connectivity)
    , m_Homology(connectivity)
    , m_Graph(connectivity)
    , m_Lengths(EdgeLengths(connectivity, mesh.V))
    , m_Tree(connectivity, m_Graph, m_Lengths)
    , m_IsTaken(connectivity.NumberOfVertices(), 0)
  {
    const std::vector<int> cut = this->CutOfTube(mesh);
    if (!cut.empty())
    {
      m_Homology.SetCut(mesh.F, cut);
    }
  }

  std::vector<HandleLoop>
  Run()
  {
    std::vector<HandleLoop> loops;
    for (HandleLoop & loop : this->LoopsOfClasses())
    {
      if (this->IsFree(loop))
      {
        this->Shorten(loop);
        if (this->IsFree(loop) && m_Classes.Add(m_Homology.ClassOf(this->EdgesOf(loop))))
        {
          this->Take(loop);
          loops.push_back(std::move(loop));
        }
      }
    }
    std::stable_sort(
      loops.begin(), loops.end(), [](const HandleLoop & a, const HandleLoop & b) { return a.length < b.length; });
    return loops;
  }

private:
  /** The shortest path between the two boundaries that takes no shortcut through a handle; empty if unknown. */
  std::vector<int>
  CutOfTube(const SurfaceMesh & mesh) const
  {
    const auto & boundaries = m_Connectivity.BoundaryLoops();
    if (boundaries.size() != 2 || FindSurfaceArray(mesh.pointArrays, "arcLength") == nullptr)
    {
      return {};
    }
    TubeEnds ends;
    ends.first = boundaries[0];
    ends.second = boundaries[1];
    Eigen::VectorXd costs = m_Lengths;
    AvoidShortcuts(mesh, m_Connectivity, m_Lengths, costs);
    return CheapestPath(m_Graph, ends, costs);
  }

  /** The shortest loop of each class through one vertex, without its tail, shortest first. */
  std::vector<HandleLoop>
  LoopsOfClasses()
  {
    int root = 0;
    while (root + 1 < m_Graph.NumberOfVertices() &&
           (m_Tree.IsBoundary(root) || m_Graph.begin(root) == m_Graph.end(root)))
    {
      ++root;
    }
    m_Tree.Grow(root, std::numeric_limits<double>::infinity(), m_Homology);
    std::unordered_map<std::uint64_t, std::pair<double, int>> bestOfClass;
    m_Tree.VisitLoops(m_Homology, [&](int edge, double length, std::uint64_t key) {
      if (LoopHomology::IsOfHandle(key))
      {
        const std::pair<double, int> here(length, edge);
        const auto [best, isNew] = bestOfClass.emplace(key, here);
        best->second = isNew ? here : std::min(best->second, here);
      }
    });
    std::vector<std::pair<double, int>> edges;
    for (const auto & best : bestOfClass)
    {
      edges.push_back(best.second);
    }
    std::sort(edges.begin(), edges.end()); // the order of the map is unspecified
    std::vector<HandleLoop> loops;
    for (const auto & best : edges)
    {
      const auto & [a, b] = m_Connectivity.VerticesOfEdge(best.second);
      loops.push_back(m_Tree.LoopOf(a, b, best.second));
    }
    std::stable_sort(
      loops.begin(), loops.end(), [](const HandleLoop & a, const HandleLoop & b) { return a.length < b.length; });
    return loops;
  }

  /** Replaces a loop by the shortest essential one near its vertices until there is no shorter one. */
  void
  Shorten(HandleLoop & loop)
  {
    for (int time = 0, place = 0; time < mostShortenings && place < placesOnLoop; ++time)
    {
      const std::size_t index = loop.vertices.size() * static_cast<std::size_t>(place) / placesOnLoop;
      HandleLoop        shorter = this->ShortestNear(loop.vertices[index], reach * loop.length);
      ++place;
      if (!shorter.vertices.empty() && shorter.length < (1.0 - leastGain) * loop.length)
      {
        loop = std::move(shorter);
        place = 0;
      }
    }
  }

  /** The shortest essential loop that the tree of this vertex closes, without its tail. */
  HandleLoop
  ShortestNear(int vertex, double radius)
  {
    m_Tree.Grow(vertex, radius, m_Homology);
    HandleLoop best{ {}, std::numeric_limits<double>::infinity() };
    m_Tree.VisitLoops(m_Homology, [&](int edge, double, std::uint64_t key) {
      const auto & [a, b] = m_Connectivity.VerticesOfEdge(edge);
      if (LoopHomology::IsOfHandle(key) && m_Tree.IsShorter(a, b, edge, best.length))
      {
        best = m_Tree.LoopOf(a, b, edge);
      }
    });
    return best;
  }

  std::vector<int>
  EdgesOf(const HandleLoop & loop) const
  {
    std::vector<int> edges;
    for (std::size_t i = 0; i < loop.vertices.size(); ++i)
    {
      edges.push_back(m_Connectivity.FindEdge(loop.vertices[i], loop.vertices[(i + 1) % loop.vertices.size()]));
    }
    return edges;
  }

  bool
  IsFree(const HandleLoop & loop) const
  {
    return std::none_of(loop.vertices.begin(), loop.vertices.end(), [this](int v) { return m_IsTaken[v] != 0; });
  }

  void
  Take(const HandleLoop & loop)
  {
    for (const int vertex : loop.vertices)
    {
      m_IsTaken[vertex] = 1;
    }
  }

  const SurfaceConnectivity & m_Connectivity;
  LoopHomology                m_Homology;
  const EdgeGraph             m_Graph;
  const Eigen::VectorXd       m_Lengths;
  PathTree                    m_Tree;
  IndependentClasses          m_Classes;
  std::vector<char>           m_IsTaken; ///< vertices of the loops so far
};

SurfaceHandle
HandleOfLoop(const SurfaceMesh & mesh, const HandleLoop & loop)
{
  SurfaceHandle handle;
  handle.genus = 1;
  handle.vertices = loop.vertices;
  std::sort(handle.vertices.begin(), handle.vertices.end());
  for (const int v : handle.vertices)
  {
    handle.place += mesh.V.row(v).transpose() / static_cast<double>(handle.vertices.size());
  }
  for (const int v : handle.vertices)
  {
    handle.radius = std::max(handle.radius, (mesh.V.row(v).transpose() - handle.place).norm());
  }
  return handle;
}

/** Cuts a surface along loops and closes the rims. Returns the number of new faces. */
int
CutAndClose(SurfaceMesh & mesh, const SurfaceConnectivity & connectivity, const std::vector<HandleLoop> & loops)
{
  std::vector<std::vector<int>> paths;
  for (const HandleLoop & loop : loops)
  {
    paths.push_back(loop.vertices);
    paths.back().push_back(loop.vertices.front());
  }
  mesh = CutAlongPaths(mesh, connectivity, paths).mesh;
  const SurfaceConnectivity     open(mesh);
  std::vector<std::vector<int>> rims;
  for (const std::vector<int> & rim : open.BoundaryLoops())
  {
    const bool isOld = rim.front() < connectivity.NumberOfVertices() && connectivity.IsBoundaryVertex(rim.front());
    if (!isOld)
    {
      rims.push_back(rim);
    }
  }
  return NumberOfFilledFaces(FillHoles(mesh, open, rims, filledName));
}
} // namespace

std::vector<HandleLoop>
FindHandleLoops(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity)
{
  RequireOneManifold(connectivity, "the surface with handles");
  return connectivity.Components().front().genus == 0 ? std::vector<HandleLoop>()
                                                      : LoopSearch(mesh, connectivity).Run();
}

HandleCuts
CutHandles(SurfaceMesh mesh)
{
  HandleCuts result;
  for (;;)
  {
    const SurfaceConnectivity     connectivity(mesh);
    const std::vector<HandleLoop> loops = FindHandleLoops(mesh, connectivity);
    result.genus = connectivity.Components().front().genus.value_or(0);
    if (loops.empty())
    {
      break;
    }
    for (const HandleLoop & loop : loops)
    {
      result.handles.push_back(HandleOfLoop(mesh, loop));
      result.longestLoop = std::max(result.longestLoop, loop.length);
    }
    result.filledFaces += CutAndClose(mesh, connectivity, loops);
  }
  result.mesh = std::move(mesh);
  return result;
}
} // namespace shapeton
