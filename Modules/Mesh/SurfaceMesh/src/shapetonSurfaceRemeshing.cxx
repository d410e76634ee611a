#include "shapetonSurfaceRemeshing.h"
#include "shapetonCornerTable.h"
#include "shapetonInterruption.h"
#include "shapetonSurfaceLocator.h"
#include "shapetonSurfaceQuality.h"
#include "shapetonSurfaceRepair.h"
#include "shapetonExceptions.h"
#include "shapetonTriangleShape.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <queue>
#include <tuple>

namespace shapeton
{
namespace
{
constexpr double LongestOfTarget = 4.0 / 3.0;      // longer edges are split (Botsch and Kobbelt 2004)
constexpr double ShortestOfTarget = 4.0 / 5.0;     // shorter edges are collapsed (Botsch and Kobbelt 2004)
constexpr double BoundaryDeviationOfTarget = 0.05; // of moved boundaries; chosen
constexpr double LeastNormalProduct = 0.5;         // cosine of 60 degrees: normals may not turn more
constexpr double MostCosine = 0.99;                // of the smallest angle after a flip
constexpr double MostFaces = 1e8;                  // chosen; bounds the memory

class Remesher
{
public:
  Remesher(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity, double target)
    : m_Table(mesh.F, connectivity), m_Locator(mesh.V, mesh.F), m_Target(target)
  {
    for (int v = 0; v < mesh.NumberOfVertices(); ++v)
    {
      m_Positions.emplace_back(mesh.V.row(v));
    }
  }

  void
  Iterate()
  {
    this->SplitLongEdges();
    this->CollapseShortEdges();
    this->FlipEdges();
    this->Smooth();
  }

  SurfaceMesh
  ToSurface() const
  {
    return m_Table.ToSurface(m_Positions);
  }

private:
  double
  LengthOf(int h) const
  {
    return (m_Positions[m_Table.From(h)] - m_Positions[m_Table.To(h)]).norm();
  }

  // Longest edges first: in any other order, the faces of a long edge become thinner and thinner before it is split.
  void
  SplitLongEdges()
  {
    using Entry = std::tuple<double, int, int>; // length and vertices: splits reassign half-edges to other edges
    std::priority_queue<Entry> queue;
    const auto                 add = [&](int h) {
      if (this->LengthOf(h) > LongestOfTarget * m_Target)
      {
        queue.push({ this->LengthOf(h), m_Table.From(h), m_Table.To(h) });
      }
    };
    for (int h = 0; h < m_Table.NumberOfHalfEdges(); ++h)
    {
      if (m_Table.StandsForEdge(h))
      {
        add(h);
      }
    }
    while (!queue.empty())
    {
      m_Interruption.Check();
      const int h = m_Table.FindHalfEdge(std::get<1>(queue.top()), std::get<2>(queue.top()));
      queue.pop(); // each edge occurs once
      const Eigen::Vector3d middle = 0.5 * (m_Positions[m_Table.From(h)] + m_Positions[m_Table.To(h)]);
      m_Positions.push_back(middle);
      m_Table.ForEachEdge(m_Table.Split(h), add);
    }
  }

  void
  CollapseShortEdges()
  {
    for (int h = 0; h < m_Table.NumberOfHalfEdges(); ++h)
    {
      m_Interruption.Check();
      if (m_Table.StandsForEdge(h) && this->LengthOf(h) < ShortestOfTarget * m_Target)
      {
        this->TryCollapse(h);
      }
    }
  }

  void
  TryCollapse(int h)
  {
    const bool      isFromBoundary = m_Table.IsBoundary(m_Table.From(h));
    const bool      isToBoundary = m_Table.IsBoundary(m_Table.To(h));
    Eigen::Vector3d place = 0.5 * (m_Positions[m_Table.From(h)] + m_Positions[m_Table.To(h)]);
    if (isFromBoundary && isToBoundary)
    {
      if (m_Table.Twin(h) >= 0 || !this->IsStraightAt(h))
      {
        return;
      }
      place = m_Positions[m_Table.To(h)];
    }
    else if (isFromBoundary || isToBoundary)
    {
      place = m_Positions[isFromBoundary ? m_Table.From(h) : m_Table.To(h)];
    }
    if (m_Table.CanCollapse(h) && this->KeepsShape(h, place))
    {
      m_Positions[m_Table.To(h)] = place;
      m_Table.Collapse(h);
    }
  }

  /** Whether the boundary is nearly straight at the start of the boundary half-edge h. */
  bool
  IsStraightAt(int h) const
  {
    const int u = m_Table.From(h);
    int       before = -1;
    m_Table.ForEachNeighbor(u, [&](int w) { before = w; }); // the last half-edge follows the boundary
    const Eigen::Vector3d & a = m_Positions[before];
    const Eigen::Vector3d   direction = m_Positions[m_Table.To(h)] - a;
    const Eigen::Vector3d   offset = m_Positions[u] - a;
    const double            length = direction.norm();
    return length > 0.0 && length <= LongestOfTarget * m_Target && offset.dot(direction) > 0.0 &&
           offset.cross(direction).norm() <= BoundaryDeviationOfTarget * m_Target * length;
  }

  /** Whether no face flips over and no edge becomes too long if both ends of h move to `place`. */
  bool
  KeepsShape(int h, const Eigen::Vector3d & place) const
  {
    bool keeps = true;
    for (const int w : { m_Table.From(h), m_Table.To(h) })
    {
      const int other = w == m_Table.From(h) ? m_Table.To(h) : m_Table.From(h);
      m_Table.ForEachNeighbor(w, [&](int n) {
        keeps = keeps && (n == other || (m_Positions[n] - place).norm() <= LongestOfTarget * m_Target);
      });
      keeps = keeps && this->NoFaceTurnsOver(w, place, other);
    }
    return keeps;
  }

  /** Whether the faces at w, except those with the vertex `leftOut`, keep their orientation if w moves. */
  bool
  NoFaceTurnsOver(int w, const Eigen::Vector3d & place, int leftOut) const
  {
    bool keeps = true;
    m_Table.ForEachOutgoing(w, [&](int h) {
      const int b = m_Table.To(h);
      const int c = m_Table.Apex(h);
      if (b != leftOut && c != leftOut)
      {
        const Eigen::Vector3d before = DoubleAreaNormal(m_Positions[w], m_Positions[b], m_Positions[c]);
        const Eigen::Vector3d after = DoubleAreaNormal(place, m_Positions[b], m_Positions[c]);
        keeps = keeps && before.dot(after) >= LeastNormalProduct * before.norm() * after.norm();
      }
    });
    return keeps;
  }

  int
  ValenceError(int v, int change) const
  {
    const int error = m_Table.Valence(v) + change - (m_Table.IsBoundary(v) ? 4 : 6);
    return error * error;
  }

  void
  FlipEdges()
  {
    for (int h = 0; h < m_Table.NumberOfHalfEdges(); ++h)
    {
      m_Interruption.Check();
      if (m_Table.StandsForEdge(h) && m_Table.CanFlip(h) && this->ShouldFlip(h))
      {
        m_Table.Flip(h);
      }
    }
  }

  bool
  ShouldFlip(int h) const
  {
    const int u = m_Table.From(h);
    const int v = m_Table.To(h);
    const int w = m_Table.Apex(h);
    const int x = m_Table.Apex(m_Table.Twin(h));
    const int before =
      this->ValenceError(u, 0) + this->ValenceError(v, 0) + this->ValenceError(w, 0) + this->ValenceError(x, 0);
    const int after =
      this->ValenceError(u, -1) + this->ValenceError(v, -1) + this->ValenceError(w, 1) + this->ValenceError(x, 1);
    if (after >= before || m_Table.Valence(u) <= 3 || m_Table.Valence(v) <= 3)
    {
      return false;
    }
    const Eigen::Vector3d & a = m_Positions[u];
    const Eigen::Vector3d & b = m_Positions[v];
    const Eigen::Vector3d & c = m_Positions[w];
    const Eigen::Vector3d & d = m_Positions[x];
    const Eigen::Vector3d   normal = DoubleAreaNormal(a, b, c) + DoubleAreaNormal(b, a, d);
    const auto              looksAlong = [&](const Eigen::Vector3d & other) {
      return normal.dot(other) > LeastNormalProduct * normal.norm() * other.norm();
    };
    return looksAlong(DoubleAreaNormal(a, d, c)) && looksAlong(DoubleAreaNormal(b, c, d)) &&
           std::max(CosineOfSmallestAngle(a, d, c), CosineOfSmallestAngle(b, c, d)) < MostCosine;
  }

  void
  Smooth()
  {
    std::vector<Eigen::Vector3d> goals = m_Positions; // all computed from the old positions
    for (int v = 0; v < m_Table.NumberOfVertices(); ++v)
    {
      m_Interruption.Check();
      if (m_Table.IsLiveVertex(v) && !m_Table.IsBoundary(v))
      {
        goals[v] = this->GoalOf(v);
      }
    }
    for (int v = 0; v < m_Table.NumberOfVertices(); ++v)
    {
      if (m_Table.IsLiveVertex(v) && !m_Table.IsBoundary(v) && this->NoFaceTurnsOver(v, goals[v], -1))
      {
        m_Positions[v] = goals[v];
      }
    }
  }

  /** Area-weighted center of the faces around v, projected into the tangent plane and onto the surface. */
  Eigen::Vector3d
  GoalOf(int v) const
  {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    double          area = 0.0;
    m_Table.ForEachOutgoing(v, [&](int h) {
      const Eigen::Vector3d & b = m_Positions[m_Table.To(h)];
      const Eigen::Vector3d & c = m_Positions[m_Table.Apex(h)];
      const Eigen::Vector3d   own = DoubleAreaNormal(m_Positions[v], b, c);
      normal += own;
      area += own.norm();
      center += own.norm() * (m_Positions[v] + b + c) / 3.0;
    });
    const double length = normal.norm();
    if (!(area > 0.0) || !(length > 0.0))
    {
      return m_Positions[v];
    }
    normal /= length;
    const Eigen::Vector3d step = center / area - m_Positions[v];
    return m_Locator.FindClosest(m_Positions[v] + step - normal.dot(step) * normal).point;
  }

  CornerTable                  m_Table;
  RareInterruption             m_Interruption;
  SurfaceLocator               m_Locator;
  double                       m_Target;
  std::vector<Eigen::Vector3d> m_Positions;
};
} // namespace

SurfaceMesh
RemeshSurface(const SurfaceMesh & mesh, const SurfaceRemeshingSettings & options)
{
  CheckOptions(options);
  const SurfaceConnectivity connectivity = RequireManifold(mesh, "the surface");
  const double              faces = SurfaceArea(mesh.V, mesh.F) / (0.433 * options.edgeLength * options.edgeLength);
  if (!(faces <= MostFaces))
  {
    throw InputError("the surface would have more than 100 million faces; use a longer target edge length");
  }
  Remesher remesher(mesh, connectivity, options.edgeLength);
  for (int i = 0; i < options.iterations; ++i)
  {
    remesher.Iterate();
    options.progress((i + 1.0) / options.iterations);
  }
  SurfaceMesh remeshed = remesher.ToSurface();
  remeshed.facts = mesh.facts;
  return remeshed;
}
} // namespace shapeton
