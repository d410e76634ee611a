#include "shapetonColonSegments.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <unordered_map>

namespace shapeton
{
namespace
{
/** Finds loops around the tube as paths in its covering space; a node is a vertex together with a number of turns. */
constexpr int sheets = 5;
constexpr int middleSheet = 2;

class LoopSearch
{
public:
  LoopSearch(const ColonWallTube &   tube,
             const Eigen::Vector3d & point,
             const Eigen::Vector3d & normal,
             double                  arcLength,
             double                  reach)
    : m_Tube(tube), m_Distance(tube.NumberOfVertices(), -1.0)
  {
    for (int vertex = 0; vertex < tube.NumberOfVertices(); ++vertex)
    {
      if (std::abs(tube.ArcLength(vertex) - arcLength) <= reach)
      {
        m_Distance[vertex] = std::abs((tube.Points().row(vertex).transpose() - point).dot(normal));
        if (tube.IsOnCut(vertex))
        {
          m_Starts.push_back(vertex);
        }
      }
    }
  }

  /** Starts at the cut, since every loop around the tube contains a vertex on the cut. */
  SurfaceWalk
  Best(const Progress & progress) const
  {
    SurfaceWalk best;
    double      least = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < m_Starts.size(); ++i)
    {
      this->ImproveFrom(m_Starts[i], least, best);
      progress((i + 1.0) / static_cast<double>(m_Starts.size()));
    }
    for (std::size_t i = 0; i < best.vertices.size(); ++i)
    {
      const auto next = best.vertices[(i + 1) % best.vertices.size()];
      best.length += (m_Tube.Points().row(best.vertices[i]) - m_Tube.Points().row(next)).norm();
    }
    return best;
  }

private:
  using Entry = std::pair<double, int>; // cost, place

  double
  Cost(int a, int b) const
  {
    constexpr double width = 5.0; // mm
    const double     distance = 0.5 * (m_Distance[a] + m_Distance[b]) / width;
    return (m_Tube.Points().row(a) - m_Tube.Points().row(b)).norm() * (1.0 + distance * distance);
  }

  void
  Relax(int                                                              place,
        double                                                           cost,
        std::priority_queue<Entry, std::vector<Entry>, std::greater<>> & queue,
        std::unordered_map<int, Entry> &                                 reached) const
  {
    const int vertex = place / sheets;
    for (const int next : m_Tube.Connectivity().NeighborsOfVertex(vertex))
    {
      const int sheet = place % sheets + m_Tube.Turns(vertex, next);
      if (m_Distance[next] < 0.0 || sheet < 0 || sheet >= sheets)
      {
        continue;
      }
      const double total = cost + this->Cost(vertex, next);
      const auto [found, isNew] = reached.try_emplace(next * sheets + sheet, total, place);
      if (isNew || total < found->second.first)
      {
        found->second = { total, place };
        queue.emplace(total, next * sheets + sheet);
      }
    }
  }

  void
  ImproveFrom(int start, double & least, SurfaceWalk & best) const
  {
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    std::unordered_map<int, Entry>                                 reached; // cost and predecessor
    const int                                                      from = start * sheets + middleSheet;
    const int                                                      goal = from + 1;
    reached[from] = { 0.0, from };
    queue.emplace(0.0, from);
    while (!queue.empty())
    {
      const auto [cost, place] = queue.top();
      queue.pop();
      if (cost >= least)
      {
        return;
      }
      if (place == goal)
      {
        least = cost;
        best.vertices.clear();
        for (int at = goal; at != from; at = reached[at].second)
        {
          best.vertices.push_back(at / sheets);
        }
        return;
      }
      if (cost <= reached[place].first)
      {
        this->Relax(place, cost, queue, reached);
      }
    }
  }

  const ColonWallTube & m_Tube;
  std::vector<double>   m_Distance; ///< from the plane; negative outside the window
  std::vector<int>      m_Starts;
};
} // namespace

SurfaceWalk
FindLoop(const ColonWallTube &   tube,
         const Eigen::Vector3d & point,
         const Eigen::Vector3d & normal,
         double                  arcLength,
         const Progress &        progress)
{
  SurfaceWalk loop = LoopSearch(tube, point, normal, arcLength, 70.0).Best(progress.Part("", 0.0, 0.5));
  return loop.vertices.empty() ? LoopSearch(tube, point, normal, arcLength, 140.0).Best(progress.Part("", 0.5, 1.0))
                               : loop;
}
} // namespace shapeton
