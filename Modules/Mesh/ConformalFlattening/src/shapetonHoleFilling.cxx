#include "shapetonHoleFilling.h"

#include "shapetonExceptions.h"
#include "shapetonHolePatch.h"
#include "shapetonSparseCholesky.h"

#include <numeric>

namespace shapeton
{
namespace
{
/** Rings with at most this many vertices get a single center vertex. */
constexpr int smallRing = 8;
/** Longer rims are filled by rings because patch triangulation has cubic complexity. */
constexpr int longRim = 400;
constexpr int ringStep = 6; // as in a plane of equilateral triangles

/** Triangles between a ring and the next inner one. */
void
JoinRings(const std::vector<int> & outer, const std::vector<int> & inner, std::vector<std::array<int, 3>> & faces)
{
  const auto n = static_cast<long>(outer.size());
  const auto m = static_cast<long>(inner.size());
  long       i = 0;
  long       j = 0;
  while (i < n || j < m)
  {
    // Advance on the side whose next edge has the earlier midpoint.
    const bool isOuter = j == m || (i < n && (2 * i + 1) * m <= (2 * j + 1) * n);
    if (isOuter)
    {
      faces.push_back({ outer[(i + 1) % n], outer[i], inner[j % m] });
      ++i;
    }
    else
    {
      faces.push_back({ outer[i % n], inner[j], inner[(j + 1) % m] });
      ++j;
    }
  }
}

HoleFilling
TriangulateByRings(const std::vector<int> & loop, int firstVertex)
{
  HoleFilling      filling{ loop, firstVertex, 0, {} };
  std::vector<int> ring = loop;
  while (static_cast<int>(ring.size()) > smallRing)
  {
    std::vector<int> inner(ring.size() - ringStep);
    std::iota(inner.begin(), inner.end(), firstVertex + filling.numberOfVertices);
    filling.numberOfVertices += static_cast<int>(inner.size());
    JoinRings(ring, inner, filling.faces);
    ring = std::move(inner);
  }
  if (ring.size() == 3)
  {
    filling.faces.push_back({ ring[2], ring[1], ring[0] });
    return filling;
  }
  const int center = firstVertex + filling.numberOfVertices++;
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    filling.faces.push_back({ ring[(i + 1) % ring.size()], ring[i], center });
  }
  return filling;
}

/** Mean length of the edges of a vertex. */
double
EdgeScale(const SurfaceConnectivity & connectivity, const VertexMatrix & V, int vertex)
{
  const std::vector<int> neighbors = connectivity.NeighborsOfVertex(vertex);
  double                 sum = 0.0;
  for (const int other : neighbors)
  {
    sum += (V.row(other) - V.row(vertex)).norm();
  }
  return sum / static_cast<double>(neighbors.size());
}
} // namespace

HoleFilling
TriangulateHole(const std::vector<int> &    loop,
                const VertexMatrix &        V,
                const SurfaceConnectivity & connectivity,
                int                         firstVertex)
{
  // Surface faces follow the loop direction; filling faces run in the opposite direction.
  const std::vector<int>       rim(loop.rbegin(), loop.rend());
  std::vector<Eigen::Vector3d> points;
  std::vector<double>          scales;
  for (const int v : rim)
  {
    points.emplace_back(V.row(v).transpose());
    scales.push_back(EdgeScale(connectivity, V, v));
  }
  HolePatch patch(points, scales, [&](int a, int b) { return connectivity.FindEdge(rim[a], rim[b]) != -1; });
  if (static_cast<int>(rim.size()) > longRim || !patch.Triangulate())
  {
    return TriangulateByRings(loop, firstVertex);
  }
  patch.Refine();
  const auto  onRim = static_cast<int>(rim.size());
  HoleFilling filling{ loop, firstVertex, static_cast<int>(patch.Points().size()) - onRim, patch.Faces() };
  for (auto & face : filling.faces)
  {
    for (int & v : face)
    {
      v = v < onRim ? rim[v] : firstVertex + v - onRim;
    }
  }
  return filling;
}

void
SmoothFilling(const HoleFilling & filling, const SurfaceConnectivity & connectivity, VertexMatrix & V)
{
  const int n = filling.numberOfVertices;
  if (n == 0)
  {
    return;
  }
  std::vector<int> rows = filling.rim;
  for (int i = 0; i < n; ++i)
  {
    rows.push_back(filling.firstVertex + i);
  }
  std::vector<Eigen::Triplet<double>>      triplets;
  Eigen::Matrix<double, Eigen::Dynamic, 3> known =
    Eigen::Matrix<double, Eigen::Dynamic, 3>::Zero(static_cast<Eigen::Index>(rows.size()), 3);
  const auto add = [&](Eigen::Index row, int vertex, double weight) {
    const int column = vertex - filling.firstVertex;
    if (column >= 0 && column < n)
    {
      triplets.emplace_back(row, column, weight);
    }
    else
    {
      known.row(row) -= weight * V.row(vertex);
    }
  };
  for (Eigen::Index row = 0; row < known.rows(); ++row)
  {
    const std::vector<int> neighbors = connectivity.NeighborsOfVertex(rows[row]);
    add(row, rows[row], -1.0);
    for (const int neighbor : neighbors)
    {
      add(row, neighbor, 1.0 / static_cast<double>(neighbors.size()));
    }
  }
  Eigen::SparseMatrix<double> laplacian(known.rows(), n);
  laplacian.setFromTriplets(triplets.begin(), triplets.end());
  Eigen::MatrixXd places = laplacian.transpose() * known;
  if (!SolvePositiveDefinite(laplacian.transpose() * laplacian, places) || !places.allFinite())
  {
    throw InputError("a hole with " + std::to_string(filling.rim.size()) +
                     " edges cannot be filled; repair the surface");
  }
  V.middleRows(filling.firstVertex, n) = places;
}
} // namespace shapeton
