#include "shapetonSurfaceSimplification.h"
#include "shapetonCornerTable.h"
#include "shapetonInterruption.h"
#include "shapetonParallelFor.h"
#include "shapetonQuadric.h"
#include "shapetonSurfaceFormats.h"
#include "shapetonSurfaceRepair.h"
#include "shapetonExceptions.h"
#include "shapetonTriangleShape.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace shapeton
{
namespace
{
constexpr double PointWeight = 1e-3;          // weight of distances to old vertices, relative to planes
constexpr double LeastProductOfNormals = 0.3; // face normals before and after
constexpr double RadiansPerDegree = 0.017453292519943295769;
constexpr double StepOfAngles = 5.0; // degrees

/** Queue entry of an edge, with its state at insertion. */
struct Candidate
{
  double   cost;
  int      u, v; ///< u < v
  unsigned versionU, versionV;

  bool
  operator<(const Candidate & other) const // the queue pops the largest first
  {
    if (cost != other.cost)
    {
      return cost > other.cost;
    }
    return u != other.u ? u > other.u : v > other.v;
  }
};

/** Priority queue, cheapest candidate first. Candidates of similar cost share a bucket. Only the cheapest bucket is a
 * heap, which stays in the cache; a single large heap would access memory at random. */
class CandidateQueue
{
public:
  void
  Fill(const std::vector<Candidate> & candidates)
  {
    m_Buckets.assign(std::size_t{ 1 } << BitsOfBucket, {});
    m_Cheapest = 0;
    m_Size = 0;
    for (const Candidate & candidate : candidates)
    {
      this->Push(candidate);
    }
  }
  void
  Push(const Candidate & candidate)
  {
    const std::size_t        place = BucketOf(candidate.cost);
    std::vector<Candidate> & bucket = m_Buckets[place];
    bucket.push_back(candidate);
    m_Cheapest = std::min(m_Cheapest, place);
    ++m_Size;
    if (place == m_Cheapest)
    {
      std::push_heap(bucket.begin(), bucket.end());
    }
  }
  bool
  IsEmpty() const
  {
    return m_Size == 0;
  }
  Candidate
  Pop()
  {
    while (m_Buckets[m_Cheapest].empty())
    {
      std::vector<Candidate>().swap(m_Buckets[m_Cheapest]);
      ++m_Cheapest;
      std::make_heap(m_Buckets[m_Cheapest].begin(), m_Buckets[m_Cheapest].end());
    }
    std::vector<Candidate> & bucket = m_Buckets[m_Cheapest];
    std::pop_heap(bucket.begin(), bucket.end());
    const Candidate candidate = bucket.back();
    bucket.pop_back();
    --m_Size;
    return candidate;
  }

private:
  static constexpr int BitsOfBucket = 18; // sign, exponent and six of the mantissa

  /** Maps nonnegative numbers to their bits, which preserves the order. */
  static std::size_t
  BucketOf(double cost)
  {
    const double  positive = cost + 0.0; // turns -0 into 0
    std::uint64_t bits = 0;
    std::memcpy(&bits, &positive, sizeof(bits));
    return static_cast<std::size_t>(bits >> (64 - BitsOfBucket));
  }

  std::vector<std::vector<Candidate>> m_Buckets;
  std::size_t                         m_Cheapest{ 0 }; ///< all earlier buckets are empty
  std::size_t                         m_Size{ 0 };
};

class Simplifier
{
public:
  Simplifier(const SurfaceMesh &                   mesh,
             const SurfaceConnectivity &           connectivity,
             const SurfaceSimplificationSettings & options);
  SurfaceMesh
  Run(SurfaceSimplificationReport & report);

private:
  void
  AddQuadricsOfFace(int first);
  void
  AddQuadricsOfBoundary(int h, const Eigen::Vector3d & normal);
  double
  Place(int u, int v, Eigen::Vector3d & place) const;
  bool
  IsFar(int u, int v, const Eigen::Vector3d & place) const
  {
    const Eigen::Vector3d middle = 0.5 * (m_Positions[u] + m_Positions[v]);
    return !((place - middle).squaredNorm() <= 4.0 * (m_Positions[u] - m_Positions[v]).squaredNorm());
  }

  Candidate
  CandidateOf(int a, int b) const;
  void
  FillQueue();
  void
  CollapseQueue(SurfaceSimplificationReport & report);
  bool
  TryCollapse(int u, int v);
  template <typename TVisit>
  void
  ForEachFaceAt(int u, int v, const TVisit & visit) const;
  bool
  KeepsShape(int u, int v, const Eigen::Vector3d & place) const;
  void
  TellProgress(const SurfaceSimplificationReport & report) const;

  SurfaceSimplificationSettings m_Options;
  CornerTable                   m_Table;
  Eigen::Vector3d               m_Origin;
  std::vector<Eigen::Vector3d>  m_Positions;
  std::vector<Quadric>          m_Quadrics;
  std::vector<unsigned>         m_Version;
  CandidateQueue                m_Queue;
  double                        m_CosineLimit{ 1.0 };
};

Simplifier::Simplifier(const SurfaceMesh &                   mesh,
                       const SurfaceConnectivity &           connectivity,
                       const SurfaceSimplificationSettings & options)
  : m_Options(options), m_Table(mesh.F, connectivity), m_Version(mesh.V.rows(), 0)
{
  const auto corners = CornersOfFaces(mesh);
  m_Origin = 0.5 * (corners[0] + corners[1]).transpose();
  m_Positions.resize(mesh.V.rows());
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    m_Positions[v] = mesh.V.row(v).transpose() - m_Origin; // near 0, which reduces cancellation in the quadrics
  }
  m_Quadrics.resize(mesh.V.rows());
  for (int h = 0; h < m_Table.NumberOfHalfEdges(); h += 3)
  {
    this->AddQuadricsOfFace(h);
  }
}

SurfaceMesh
Simplifier::Run(SurfaceSimplificationReport & report)
{
  report.facesBefore = m_Table.NumberOfLiveFaces();
  double limit = m_Options.smallestAngle;
  for (;;)
  {
    report.smallestAngle = limit;
    m_CosineLimit = limit > 0.0 ? std::cos(limit * RadiansPerDegree) : 1.0;
    const int before = report.collapses;
    this->FillQueue();
    this->CollapseQueue(report);
    if (m_Table.NumberOfLiveFaces() <= m_Options.faces)
    {
      report.reachedTarget = true;
      break;
    }
    if (report.collapses > before)
    {
      continue; // rejected collapses may now be possible
    }
    if (limit <= 0.0)
    {
      report.reason = "every further collapse would fold the surface over or change its topology";
      break;
    }
    limit = std::max(limit - StepOfAngles, 0.0);
  }
  report.faces = m_Table.NumberOfLiveFaces();
  for (Eigen::Vector3d & position : m_Positions)
  {
    position += m_Origin;
  }
  return m_Table.ToSurface(m_Positions);
}

void
Simplifier::AddQuadricsOfFace(int first)
{
  const Eigen::Vector3d & a = m_Positions[m_Table.From(first)];
  const Eigen::Vector3d & b = m_Positions[m_Table.From(first + 1)];
  const Eigen::Vector3d & c = m_Positions[m_Table.From(first + 2)];
  const Eigen::Vector3d   doubleArea = DoubleAreaNormal(a, b, c);
  const double            length = doubleArea.norm();
  if (!(length > 0.0))
  {
    return;
  }
  const Eigen::Vector3d normal = doubleArea / length;
  for (int h = first; h < first + 3; ++h)
  {
    Quadric & own = m_Quadrics[m_Table.From(h)];
    own.AddPlane(a, normal, length / 6.0); // a third of the area
    own.AddPoint(m_Positions[m_Table.From(h)], PointWeight * length / 6.0);
    if (m_Table.Twin(h) < 0)
    {
      this->AddQuadricsOfBoundary(h, normal);
    }
  }
}

void
Simplifier::AddQuadricsOfBoundary(int h, const Eigen::Vector3d & normal)
{
  const Eigen::Vector3d & from = m_Positions[m_Table.From(h)];
  const Eigen::Vector3d   edge = m_Positions[m_Table.To(h)] - from;
  const Eigen::Vector3d   across = edge.cross(normal);
  const double            length = across.norm();
  if (length > 0.0)
  {
    Quadric boundary;
    boundary.AddPlane(from, across / length, m_Options.boundaryWeight * edge.squaredNorm());
    m_Quadrics[m_Table.From(h)] += boundary;
    m_Quadrics[m_Table.To(h)] += boundary;
  }
}

/** Merge position of the vertices of an edge, and its cost. */
double
Simplifier::Place(int u, int v, Eigen::Vector3d & place) const
{
  Quadric quadric = m_Quadrics[u];
  quadric += m_Quadrics[v];
  const bool isBoundaryU = m_Table.IsBoundary(u);
  if (isBoundaryU != m_Table.IsBoundary(v))
  {
    place = m_Positions[isBoundaryU ? u : v];
  }
  else if (!quadric.Minimize(place) || this->IsFar(u, v, place))
  {
    place = 0.5 * (m_Positions[u] + m_Positions[v]);
    for (const int w : { u, v })
    {
      place = quadric.At(m_Positions[w]) < quadric.At(place) ? m_Positions[w] : place;
    }
  }
  return std::max(quadric.At(place), 0.0); // rounding may make it negative
}

Candidate
Simplifier::CandidateOf(int a, int b) const
{
  const int       u = std::min(a, b);
  const int       v = std::max(a, b);
  Eigen::Vector3d place;
  const double    cost = this->Place(u, v, place);
  return { cost, u, v, m_Version[u], m_Version[v] };
}

void
Simplifier::FillQueue()
{
  std::vector<int> edges;
  edges.reserve(m_Table.NumberOfLiveFaces() * 3 / 2 + 1);
  for (int h = 0; h < m_Table.NumberOfHalfEdges(); ++h)
  {
    if (m_Table.StandsForEdge(h))
    {
      edges.push_back(h);
    }
  }
  std::vector<Candidate> candidates(edges.size());
  ParallelForBlocks(edges.size(), [&](std::size_t i) {
    candidates[i] = this->CandidateOf(m_Table.From(edges[i]), m_Table.To(edges[i]));
  });
  Interruption::Check();
  m_Queue.Fill(candidates);
}

void
Simplifier::CollapseQueue(SurfaceSimplificationReport & report)
{
  while (!m_Queue.IsEmpty() && m_Table.NumberOfLiveFaces() > m_Options.faces)
  {
    const Candidate candidate = m_Queue.Pop();
    if (!m_Table.IsLiveVertex(candidate.u) || !m_Table.IsLiveVertex(candidate.v) ||
        m_Version[candidate.u] != candidate.versionU || m_Version[candidate.v] != candidate.versionV)
    {
      continue; // the edge has a later entry or was removed
    }
    if (this->TryCollapse(candidate.u, candidate.v))
    {
      ++report.collapses;
      this->TellProgress(report);
    }
  }
}

bool
Simplifier::TryCollapse(int u, int v)
{
  const int       h = m_Table.FindHalfEdge(v, u);
  Eigen::Vector3d place;
  this->Place(u, v, place);
  if (!m_Table.CanCollapse(h) || !this->KeepsShape(u, v, place))
  {
    return false;
  }
  const int kept = m_Table.To(h);
  m_Quadrics[kept] += m_Quadrics[m_Table.From(h)];
  m_Positions[kept] = place;
  m_Table.Collapse(h);
  ++m_Version[kept];
  m_Table.ForEachNeighbor(kept, [&](int w) { m_Queue.Push(this->CandidateOf(kept, w)); });
  return true;
}

/** Calls visit(h, w) for the half-edges from both ends of an edge. */
template <typename TVisit>
void
Simplifier::ForEachFaceAt(int u, int v, const TVisit & visit) const
{
  for (const int w : { u, v })
  {
    m_Table.ForEachOutgoing(w, [&](int h) { visit(h, w); });
  }
}

/** Whether all remaining faces keep their orientation and satisfy the angle limit. */
bool
Simplifier::KeepsShape(int u, int v, const Eigen::Vector3d & place) const
{
  double worstAfter = -1.0;
  bool   turnsOver = false;
  this->ForEachFaceAt(u, v, [&](int h, int w) {
    const int other = w == u ? v : u;
    if (turnsOver || m_Table.To(h) == other || m_Table.Apex(h) == other)
    {
      return; // removed with the edge
    }
    const Eigen::Vector3d & b = m_Positions[m_Table.To(h)];
    const Eigen::Vector3d & c = m_Positions[m_Table.Apex(h)];
    const Eigen::Vector3d   before = DoubleAreaNormal(m_Positions[w], b, c);
    const Eigen::Vector3d   after = DoubleAreaNormal(place, b, c);
    turnsOver = !(before.dot(after) >= LeastProductOfNormals * before.norm() * after.norm());
    worstAfter = std::max(worstAfter, CosineOfSmallestAngle(place, b, c));
  });
  if (turnsOver || worstAfter <= m_CosineLimit)
  {
    return !turnsOver;
  }
  double worstBefore = m_CosineLimit; // an angle that is already small may stay small
  this->ForEachFaceAt(u, v, [&](int h, int w) {
    const double before =
      CosineOfSmallestAngle(m_Positions[w], m_Positions[m_Table.To(h)], m_Positions[m_Table.Apex(h)]);
    worstBefore = std::max(worstBefore, before);
  });
  return worstAfter <= worstBefore;
}

void
Simplifier::TellProgress(const SurfaceSimplificationReport & report) const
{
  if (report.collapses % 8192 == 0)
  {
    m_Options.progress(static_cast<double>(report.facesBefore - m_Table.NumberOfLiveFaces()) /
                       (report.facesBefore - m_Options.faces));
  }
}
} // namespace

SurfaceMesh
SimplifySurface(const SurfaceMesh &                   mesh,
                const SurfaceSimplificationSettings & options,
                SurfaceSimplificationReport *         report)
{
  CheckOptions(options);
  SurfaceSimplificationReport done;
  SurfaceMesh                 simplified;
  if (mesh.NumberOfFaces() <= options.faces)
  {
    RequireManifold(mesh, "the surface");
    simplified = mesh;
    done.facesBefore = done.faces = mesh.NumberOfFaces();
    done.smallestAngle = options.smallestAngle;
    done.reachedTarget = true;
  }
  else
  {
    Simplifier simplifier(mesh, RequireManifold(mesh, "the surface"), options);
    simplified = simplifier.Run(done);
    simplified.facts = mesh.facts;
  }
  if (report)
  {
    *report = done;
  }
  return simplified;
}
} // namespace shapeton
