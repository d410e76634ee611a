#include "shapetonTubeCut.h"

#include "shapetonQuantiles.h"
#include "shapetonSurfaceLocator.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>

namespace shapeton
{
namespace
{
constexpr double farFromSurface = 10.0; // mm

using Entry = std::pair<double, int>;
using Queue = std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>>;

/** Points on a curve at most `step` apart. */
std::vector<Eigen::Vector3d>
Sampled(const std::vector<Eigen::Vector3d> & curve, double step)
{
  std::vector<Eigen::Vector3d> samples{ curve.front() };
  for (std::size_t i = 0; i + 1 < curve.size(); ++i)
  {
    const Eigen::Vector3d along = curve[i + 1] - curve[i];
    const int             parts = std::max(1, static_cast<int>(std::ceil(along.norm() / step)));
    for (int k = 1; k <= parts; ++k)
    {
      samples.push_back(curve[i] + along * k / parts);
    }
  }
  return samples;
}
} // namespace

EdgeGraph::EdgeGraph(const SurfaceConnectivity & connectivity)
  : m_Begin(connectivity.NumberOfVertices() + 1, 0), m_Steps(2 * static_cast<std::size_t>(connectivity.NumberOfEdges()))
{
  for (int edge = 0; edge < connectivity.NumberOfEdges(); ++edge)
  {
    ++m_Begin[connectivity.VerticesOfEdge(edge)[0] + 1];
    ++m_Begin[connectivity.VerticesOfEdge(edge)[1] + 1];
  }
  std::partial_sum(m_Begin.begin(), m_Begin.end(), m_Begin.begin());
  std::vector<int> next(m_Begin.begin(), m_Begin.end() - 1);
  for (int edge = 0; edge < connectivity.NumberOfEdges(); ++edge)
  {
    const auto & [a, b] = connectivity.VerticesOfEdge(edge);
    m_Steps[next[a]++] = { b, edge };
    m_Steps[next[b]++] = { a, edge };
  }
}

std::vector<int>
CheapestPath(const EdgeGraph & graph, const TubeEnds & ends, const Eigen::VectorXd & costs)
{
  constexpr double    infinity = std::numeric_limits<double>::infinity();
  std::vector<double> best(graph.NumberOfVertices(), infinity);
  std::vector<int>    before(graph.NumberOfVertices(), -1);
  std::vector<char>   isEnd(graph.NumberOfVertices(), 0);
  Queue               queue;
  for (const int vertex : ends.second)
  {
    isEnd[vertex] = 1;
  }
  for (const int vertex : ends.first)
  {
    best[vertex] = 0.0;
    queue.emplace(0.0, vertex);
  }
  while (!queue.empty())
  {
    const auto [cost, vertex] = queue.top();
    queue.pop();
    if (isEnd[vertex])
    {
      std::vector<int> path;
      for (int v = vertex; v != -1; v = before[v])
      {
        path.push_back(v);
      }
      std::reverse(path.begin(), path.end());
      return path;
    }
    for (const EdgeGraph::Step * step = graph.begin(vertex); step != graph.end(vertex); ++step)
    {
      const double further = cost + costs[step->edge];
      if (cost <= best[vertex] && further < best[step->vertex])
      {
        best[step->vertex] = further;
        before[step->vertex] = vertex;
        queue.emplace(further, step->vertex);
      }
    }
  }
  return {};
}

std::vector<int>
AscendingPath(const EdgeGraph & graph, const TubeEnds & ends, const Eigen::VectorXd & u)
{
  std::vector<char> isEnd(graph.NumberOfVertices(), 0);
  for (const int vertex : ends.second)
  {
    isEnd[vertex] = 1;
  }
  std::vector<int> path{ ends.first.front() };
  while (!isEnd[path.back()])
  {
    int best = path.back();
    for (const EdgeGraph::Step *step = graph.begin(best), *end = graph.end(best); step != end; ++step)
    {
      best = u[step->vertex] > u[best] ? step->vertex : best;
    }
    if (best == path.back())
    {
      return {};
    }
    path.push_back(best);
  }
  return path;
}

Eigen::VectorXd
DistancesAlongEdges(const EdgeGraph & graph, const Eigen::VectorXd & lengths, const std::vector<int> & sources)
{
  Eigen::VectorXd best = Eigen::VectorXd::Constant(graph.NumberOfVertices(), std::numeric_limits<double>::infinity());
  Queue           queue;
  for (const int vertex : sources)
  {
    best[vertex] = 0.0;
    queue.emplace(0.0, vertex);
  }
  while (!queue.empty())
  {
    const auto [distance, vertex] = queue.top();
    queue.pop();
    for (const EdgeGraph::Step * step = graph.begin(vertex); step != graph.end(vertex); ++step)
    {
      const double further = distance + lengths[step->edge];
      if (distance <= best[vertex] && further < best[step->vertex])
      {
        best[step->vertex] = further;
        queue.emplace(further, step->vertex);
      }
    }
  }
  return best;
}

void
Dilate(const EdgeGraph & graph, std::vector<char> & isMarked, int rings)
{
  std::vector<int> front;
  for (int v = 0; v < graph.NumberOfVertices(); ++v)
  {
    if (isMarked[v])
    {
      front.push_back(v);
    }
  }
  for (int ring = 0; ring < rings; ++ring)
  {
    std::vector<int> next;
    for (const int v : front)
    {
      for (const EdgeGraph::Step * step = graph.begin(v); step != graph.end(v); ++step)
      {
        if (!isMarked[step->vertex])
        {
          isMarked[step->vertex] = 1;
          next.push_back(step->vertex);
        }
      }
    }
    front = std::move(next);
  }
}

std::vector<int>
SaddleMultiplicities(const FaceMatrix & F, const SurfaceConnectivity & connectivity, const Eigen::VectorXd & u)
{
  const auto       isLess = [&](int a, int b) { return u[a] < u[b] || (u[a] == u[b] && a < b); };
  std::vector<int> changes(connectivity.NumberOfVertices(), 0);
  for (Eigen::Index f = 0; f < F.rows(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int vertex = F(f, k);
      changes[vertex] += isLess(F(f, (k + 1) % 3), vertex) != isLess(F(f, (k + 2) % 3), vertex) ? 1 : 0;
    }
  }
  for (int & number : changes)
  {
    number = number / 2 - 1;
  }
  for (const std::vector<int> & loop : connectivity.BoundaryLoops())
  {
    for (const int vertex : loop)
    {
      changes[vertex] = 0;
    }
  }
  return changes;
}

void
AvoidShortcuts(const SurfaceMesh &         mesh,
               const SurfaceConnectivity & connectivity,
               const Eigen::VectorXd &     lengths,
               Eigen::VectorXd &           costs)
{
  constexpr double           mostAdvance = 10.0;
  constexpr double           costOfShortcut = 1e6;
  const SurfaceArray * const arcLength = FindSurfaceArray(mesh.pointArrays, "arcLength");
  for (int edge = 0; arcLength != nullptr && edge < connectivity.NumberOfEdges(); ++edge)
  {
    const auto & [a, b] = connectivity.VerticesOfEdge(edge);
    if (std::abs(arcLength->values(a, 0) - arcLength->values(b, 0)) > mostAdvance * lengths[edge])
    {
      costs[edge] *= costOfShortcut;
    }
  }
}

Eigen::VectorXd
DistancesFromCurve(const SurfaceMesh &                  mesh,
                   const EdgeGraph &                    graph,
                   const Eigen::VectorXd &              lengths,
                   const std::vector<Eigen::Vector3d> & curve)
{
  const SurfaceLocator locator(mesh.V, mesh.F);
  std::vector<int>     sources;
  std::vector<double>  distances;
  for (const Eigen::Vector3d & point : Sampled(curve, 0.5 * lengths.mean()))
  {
    const SurfaceLocator::Closest closest = locator.FindClosest(point);
    distances.push_back(closest.distance);
    int nearest = mesh.F(closest.face, 0);
    for (int k = 1; k < 3; ++k)
    {
      const int  vertex = mesh.F(closest.face, k);
      const auto squareTo = [&](int v) { return (mesh.V.row(v).transpose() - closest.point).squaredNorm(); };
      nearest = squareTo(vertex) < squareTo(nearest) ? vertex : nearest;
    }
    sources.push_back(nearest);
  }
  const double median = UpperMedian(std::move(distances));
  if (!(median <= farFromSurface))
  {
    throw InputError("most of the curve to cut along is " + std::to_string(median) +
                     " mm or more from the surface; use a curve on the surface, in LPS and mm");
  }
  return DistancesAlongEdges(graph, lengths, sources);
}
} // namespace shapeton
