#include "shapetonConjugateFunction.h"

#include <cmath>
#include <deque>
#include <limits>

namespace shapeton
{
namespace
{
/** The integral along side k of the gradient of u turned clockwise, for sides e_k with sum 0 in a face of area A:
 * (<e_k, e_k+1> du_k+2 - <e_k, e_k+2> du_k+1) / 2A. */
double
StarAlongSide(const SideLengths & sides, Eigen::Index face, const std::array<double, 3> & steps, int k)
{
  const int    next = (k + 1) % 3;
  const int    last = (k + 2) % 3;
  const double a = sides(face, k) * sides(face, k);
  const double b = sides(face, next) * sides(face, next);
  const double c = sides(face, last) * sides(face, last);
  const double withNext = 0.5 * (c - a - b);
  const double withLast = 0.5 * (b - a - c);
  const double square = std::max(0.0, a * b - withNext * withNext); // (2A)^2
  const double doubleArea = std::max(std::sqrt(square), 1e-12 * std::max({ a, b, c }));
  return (withNext * steps[last] - withLast * steps[next]) / doubleArea;
}

/** Corner of a face at a vertex, or -1. */
int
CornerOf(const FaceMatrix & F, int face, int vertex)
{
  return F(face, 0) == vertex ? 0 : F(face, 1) == vertex ? 1 : F(face, 2) == vertex ? 2 : -1;
}
} // namespace

CornerValues
LiftedValues(const FaceMatrix & F, const Eigen::VectorXd & values, const std::vector<int> & leftCorners)
{
  CornerValues lifted(static_cast<std::size_t>(F.size()));
  for (Eigen::Index corner = 0; corner < F.size(); ++corner)
  {
    lifted[corner] = values[F.data()[corner]];
  }
  for (const int corner : leftCorners)
  {
    lifted[corner] += 1.0;
  }
  return lifted;
}

Eigen::VectorXd
SolveWithUnitJump(const SurfaceLaplacian &    laplacian,
                  const HarmonicSolver &      solver,
                  const FaceMatrix &          F,
                  const SurfaceConnectivity & connectivity,
                  const std::vector<int> &    leftCorners)
{
  Eigen::VectorXd   jumps = Eigen::VectorXd::Zero(laplacian.NumberOfVertices());
  std::vector<char> isDone(laplacian.edges.size(), 0);
  CornerValues      lifted(static_cast<std::size_t>(F.size()), 0.0);
  for (const int corner : leftCorners)
  {
    lifted[corner] = 1.0;
  }
  Eigen::MatrixXd source = Eigen::MatrixXd::Zero(laplacian.NumberOfVertices(), 1);
  for (const int corner : leftCorners)
  {
    const int face = corner / 3;
    for (const int k : { corner % 3, (corner + 2) % 3 })
    {
      const int edge = connectivity.EdgeOfFace(face, k);
      if (!isDone[edge])
      {
        isDone[edge] = 1;
        const int    next = (k + 1) % 3;
        const double flow = laplacian.weights[edge] * (lifted[3 * face + k] - lifted[3 * face + next]);
        source(F(face, k), 0) -= flow;
        source(F(face, next), 0) += flow;
      }
    }
  }
  return solver.Solve(Eigen::MatrixXd::Zero(1, 1), source).col(0);
}

double
EnergyOfCorners(const SurfaceLaplacian &    laplacian,
                const SurfaceConnectivity & connectivity,
                const FaceMatrix &          F,
                const CornerValues &        values)
{
  // Each edge counts once, in the first of its faces.
  double energy = 0.0;
  for (int f = 0; f < static_cast<int>(F.rows()); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int edge = connectivity.EdgeOfFace(f, k);
      if (connectivity.FacesOfEdge(edge)[0] == f)
      {
        const double step = values[3 * f + (k + 1) % 3] - values[3 * f + k];
        energy += laplacian.weights[edge] * step * step;
      }
    }
  }
  return energy;
}

/** \equation{5.11} in each face, averaged over the faces of an edge.
 *
 * \equation{5.15} as `steps`. */
Eigen::VectorXd
AveragedHodgeStar(const FaceMatrix &          F,
                  const SurfaceConnectivity & connectivity,
                  const SideLengths &         sides,
                  const Eigen::VectorXd &     u)
{
  Eigen::VectorXd differences = Eigen::VectorXd::Zero(connectivity.NumberOfEdges());
  for (int f = 0; f < static_cast<int>(F.rows()); ++f)
  {
    const std::array<double, 3> steps{ u[F(f, 1)] - u[F(f, 0)], u[F(f, 2)] - u[F(f, 1)], u[F(f, 0)] - u[F(f, 2)] };
    for (int k = 0; k < 3; ++k)
    {
      const int    edge = connectivity.EdgeOfFace(f, k);
      const double sign = F(f, k) < F(f, (k + 1) % 3) ? 1.0 : -1.0;
      differences[edge] += sign * StarAlongSide(sides, f, steps, k) / connectivity.FacesOfEdge(edge).size();
    }
  }
  return differences;
}

bool
TurnsOfFaces(const FaceMatrix &          F,
             const SurfaceConnectivity & connectivity,
             const CutSurface &          cut,
             const CornerValues &        values,
             std::vector<int> &          turns)
{
  constexpr int    unknown = std::numeric_limits<int>::min();
  std::vector<int> queue{ 0 };
  turns.assign(static_cast<std::size_t>(F.rows()), unknown);
  turns[0] = 0;
  bool isContinuous = true;
  for (std::size_t done = 0; done < queue.size(); ++done)
  {
    const int face = queue[done];
    for (int k = 0; k < 3; ++k)
    {
      for (const int other : connectivity.FacesOfEdge(connectivity.EdgeOfFace(face, k)))
      {
        const int next = CornerOf(cut.mesh.F, other, cut.mesh.F(face, k));
        const int last = CornerOf(cut.mesh.F, other, cut.mesh.F(face, (k + 1) % 3));
        if (other == face || next == -1 || last == -1)
        {
          continue; // the cut is between them
        }
        const int atFirst =
          turns[face] + static_cast<int>(std::lround(values[3 * face + k] - values[3 * other + next]));
        const int atSecond =
          turns[face] + static_cast<int>(std::lround(values[3 * face + (k + 1) % 3] - values[3 * other + last]));
        if (turns[other] == unknown)
        {
          turns[other] = atFirst;
          queue.push_back(other);
        }
        isContinuous = isContinuous && turns[other] == atFirst && atFirst == atSecond;
      }
    }
  }
  return isContinuous;
}

Eigen::VectorXd
IntegrateAlongTree(const CutSurface &          cut,
                   const SurfaceConnectivity & connectivity,
                   const Eigen::VectorXd &     differences)
{
  const SurfaceConnectivity after(cut.mesh);
  const double              unknown = std::numeric_limits<double>::quiet_NaN();
  Eigen::VectorXd           sums = Eigen::VectorXd::Constant(cut.mesh.V.rows(), unknown);
  std::deque<int>           queue{ 0 };
  sums[0] = 0.0;
  while (!queue.empty())
  {
    const int vertex = queue.front();
    queue.pop_front();
    for (const int neighbor : after.NeighborsOfVertex(vertex))
    {
      if (std::isnan(sums[neighbor]))
      {
        const int    from = cut.sourcePointId[vertex];
        const int    to = cut.sourcePointId[neighbor];
        const double step = differences[connectivity.FindEdge(from, to)];
        sums[neighbor] = sums[vertex] + (from < to ? step : -step);
        queue.push_back(neighbor);
      }
    }
  }
  return sums;
}
} // namespace shapeton
