#include "shapetonSurfaceLaplacian.h"

#include "shapetonExceptions.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
/** Tolerance of the triangle inequality, as a fraction of the longest side. */
constexpr double inequalitySlack = 1e-5;
constexpr double zeroHeight = 1e-12;

/** Side lengths of a triangle, side k opposite to corner k. */
struct Triangle
{
  std::array<double, 3> sides;
  std::array<double, 3> cotangents;
  double                area;
  bool                  isClamped{ false };
};

/** 16 times the squared area in Kahan's ordering, which is accurate for needles. */
double
HeronProduct(double longest, double middle, double shortest)
{
  return (longest + (middle + shortest)) * (shortest - (longest - middle)) * (shortest + (longest - middle)) *
         (longest + (middle - shortest));
}

std::string
FaceName(int face)
{
  return "face " + std::to_string(face);
}

/** Whether the longest side, the last one, exceeds the sum of the others by no more than rounding. */
bool
IsTriangle(const std::array<double, 3> & sorted)
{
  return sorted[2] - (sorted[1] + sorted[0]) <= inequalitySlack * sorted[2];
}

Triangle
SolveTriangle(int face, std::array<double, 3> sides, double leastHeight)
{
  std::array<double, 3> sorted = sides;
  std::sort(sorted.begin(), sorted.end());
  if (!IsTriangle(sorted))
  {
    throw InputError(FaceName(face) + ": its edges of length " + std::to_string(sorted[0]) + ", " +
                     std::to_string(sorted[1]) + " and " + std::to_string(sorted[2]) + " do not form a triangle");
  }
  if (sorted[2] > sorted[1] + sorted[0])
  {
    sorted[2] = sorted[1] + sorted[0];
    *std::max_element(sides.begin(), sides.end()) = sorted[2];
  }
  Triangle     triangle{ sides, {}, 0.0 };
  const double area = 0.25 * std::sqrt(std::max(0.0, HeronProduct(sorted[2], sorted[1], sorted[0])));
  const double leastArea = 0.5 * leastHeight * sorted[2] * sorted[2];
  triangle.isClamped = area < leastArea;
  triangle.area = std::max(area, leastArea);
  for (int k = 0; k < 3; ++k)
  {
    const double a = sides[k];
    const double b = sides[(k + 1) % 3];
    const double c = sides[(k + 2) % 3];
    triangle.cotangents[k] = (b * b + c * c - a * a) / (4.0 * triangle.area);
  }
  return triangle;
}

/** Area fraction of a corner of a triangle. */
double
MassOfCorner(const Triangle & triangle, int k, MassLumping lumping)
{
  if (lumping == MassLumping::Barycentric)
  {
    return triangle.area / 3.0;
  }
  const auto & cotangents = triangle.cotangents;
  const auto   obtuse = std::find_if(cotangents.begin(), cotangents.end(), [](double c) { return c < 0.0; });
  if (obtuse != cotangents.end())
  {
    return triangle.area * (obtuse - cotangents.begin() == k ? 0.5 : 0.25);
  }
  const int    next = (k + 1) % 3;
  const int    other = (k + 2) % 3;
  const double a = triangle.sides[next];
  const double b = triangle.sides[other];
  return 0.125 * (a * a * cotangents[next] + b * b * cotangents[other]);
}

void
CheckLengths(const SurfaceConnectivity & connectivity, const Eigen::VectorXd & lengths)
{
  if (connectivity.NumberOfFaces() == 0)
  {
    throw InputError("the surface has no faces");
  }
  if (lengths.size() != connectivity.NumberOfEdges())
  {
    throw InputError("there are " + std::to_string(lengths.size()) + " lengths for " +
                     std::to_string(connectivity.NumberOfEdges()) + " edges");
  }
  for (Eigen::Index edge = 0; edge < lengths.size(); ++edge)
  {
    if (!std::isfinite(lengths[edge]) || lengths[edge] <= 0.0)
    {
      const auto & ends = connectivity.VerticesOfEdge(static_cast<int>(edge));
      throw InputError("the edge between vertices " + std::to_string(ends[0]) + " and " + std::to_string(ends[1]) +
                       " has the length " + std::to_string(lengths[edge]) + "; repair the surface");
    }
  }
}

void
CheckMass(const Eigen::VectorXd & mass)
{
  for (Eigen::Index vertex = 0; vertex < mass.size(); ++vertex)
  {
    if (!(mass[vertex] > 0.0))
    {
      throw InputError("vertex " + std::to_string(vertex) + " does not belong to any face; repair the surface");
    }
  }
}

/** The side opposite to corner k is the edge that starts at the next corner. */
std::array<double, 3>
SidesOfFace(const SurfaceConnectivity & connectivity, const Eigen::VectorXd & lengths, int face)
{
  std::array<double, 3> sides;
  for (int k = 0; k < 3; ++k)
  {
    const int edge = connectivity.EdgeOfFace(face, (k + 1) % 3);
    if (edge == -1)
    {
      throw InputError(FaceName(face) + " has a repeated vertex; repair the surface");
    }
    sides[k] = lengths[edge];
  }
  return sides;
}

/** Corner of a face opposite to the edge that starts at the next corner. */
int
CornerOf(const SurfaceConnectivity & connectivity, int face, int k)
{
  const auto & before = connectivity.VerticesOfEdge(connectivity.EdgeOfFace(face, (k + 2) % 3));
  const auto & after = connectivity.VerticesOfEdge(connectivity.EdgeOfFace(face, k));
  return before[0] == after[0] || before[0] == after[1] ? before[0] : before[1];
}
} // namespace

Eigen::VectorXd
EdgeLengths(const SurfaceConnectivity & connectivity, const VertexMatrix & V)
{
  Eigen::VectorXd lengths(connectivity.NumberOfEdges());
  for (int edge = 0; edge < connectivity.NumberOfEdges(); ++edge)
  {
    const auto & ends = connectivity.VerticesOfEdge(edge);
    lengths[edge] = (V.row(ends[0]) - V.row(ends[1])).norm();
  }
  return lengths;
}

bool
AreTriangles(const SurfaceConnectivity & connectivity, const Eigen::VectorXd & edgeLengths)
{
  CheckLengths(connectivity, edgeLengths);
  for (int face = 0; face < connectivity.NumberOfFaces(); ++face)
  {
    std::array<double, 3> sides = SidesOfFace(connectivity, edgeLengths, face);
    std::sort(sides.begin(), sides.end());
    if (!IsTriangle(sides))
    {
      return false;
    }
  }
  return true;
}

std::set<int>
LengthenShortestSides(const SurfaceConnectivity & connectivity, Eigen::VectorXd & edgeLengths)
{
  constexpr int mostSweeps = 100; // a lengthened side may be too long for the adjacent face
  std::set<int> lengthened;
  for (int sweep = 0; sweep < mostSweeps && !AreTriangles(connectivity, edgeLengths); ++sweep)
  {
    for (int face = 0; face < connectivity.NumberOfFaces(); ++face)
    {
      const auto            sides = SidesOfFace(connectivity, edgeLengths, face);
      std::array<double, 3> sorted = sides;
      std::sort(sorted.begin(), sorted.end());
      if (!IsTriangle(sorted))
      {
        const auto k = std::min_element(sides.begin(), sides.end()) - sides.begin();
        const int  shortest = connectivity.EdgeOfFace(face, static_cast<int>(k + 1) % 3);
        edgeLengths[shortest] = sorted[2] - sorted[1];
        lengthened.insert(shortest);
      }
    }
  }
  return lengthened;
}

/** \equation{5.2} on triangles, by cotangents (Definition 5.2.2). */
SurfaceLaplacian
MakeSurfaceLaplacian(const SurfaceConnectivity &     connectivity,
                     const Eigen::VectorXd &         edgeLengths,
                     const SurfaceLaplacianOptions & options)
{
  CheckLengths(connectivity, edgeLengths);
  SurfaceLaplacian laplacian;
  laplacian.weights = Eigen::VectorXd::Zero(connectivity.NumberOfEdges());
  laplacian.mass = Eigen::VectorXd::Zero(connectivity.NumberOfVertices());
  for (int edge = 0; edge < connectivity.NumberOfEdges(); ++edge)
  {
    laplacian.edges.push_back(connectivity.VerticesOfEdge(edge));
  }
  for (int face = 0; face < connectivity.NumberOfFaces(); ++face)
  {
    const Triangle triangle = SolveTriangle(face, SidesOfFace(connectivity, edgeLengths, face), options.leastHeight);
    for (int k = 0; k < 3; ++k)
    {
      laplacian.weights[connectivity.EdgeOfFace(face, (k + 1) % 3)] += 0.5 * triangle.cotangents[k];
      laplacian.mass[CornerOf(connectivity, face, k)] += MassOfCorner(triangle, k, options.lumping);
    }
    if (triangle.isClamped)
    {
      laplacian.clampedFaces.push_back(face);
    }
  }
  CheckMass(laplacian.mass);
  return laplacian;
}

SurfaceLaplacian
MakeSurfaceLaplacian(const SurfaceConnectivity &     connectivity,
                     const VertexMatrix &            V,
                     const SurfaceLaplacianOptions & options)
{
  const Eigen::VectorXd lengths = EdgeLengths(connectivity, V);
  CheckLengths(connectivity, lengths);
  for (int face = 0; face < connectivity.NumberOfFaces(); ++face)
  {
    const auto            sides = SidesOfFace(connectivity, lengths, face);
    const Eigen::Vector3d a = V.row(CornerOf(connectivity, face, 0));
    const Eigen::Vector3d b = V.row(CornerOf(connectivity, face, 1));
    const Eigen::Vector3d c = V.row(CornerOf(connectivity, face, 2));
    const double          longest = *std::max_element(sides.begin(), sides.end());
    if ((b - a).cross(c - a).norm() < zeroHeight * longest * longest)
    {
      throw InputError(FaceName(face) + " has no area; remesh or simplify the surface");
    }
  }
  return MakeSurfaceLaplacian(connectivity, lengths, options);
}

Eigen::VectorXd
StiffnessDiagonal(const SurfaceLaplacian & laplacian)
{
  Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(laplacian.NumberOfVertices());
  for (std::size_t edge = 0; edge < laplacian.edges.size(); ++edge)
  {
    const double weight = laplacian.weights[static_cast<Eigen::Index>(edge)];
    diagonal[laplacian.edges[edge][0]] += weight;
    diagonal[laplacian.edges[edge][1]] += weight;
  }
  return diagonal;
}

Eigen::SparseMatrix<double>
StiffnessMatrix(const SurfaceLaplacian & laplacian)
{
  const Eigen::VectorXd               diagonal = StiffnessDiagonal(laplacian);
  std::vector<Eigen::Triplet<double>> triplets;
  triplets.reserve(laplacian.edges.size() * 2 + diagonal.size());
  for (Eigen::Index i = 0; i < diagonal.size(); ++i)
  {
    triplets.emplace_back(i, i, diagonal[i]);
  }
  for (std::size_t edge = 0; edge < laplacian.edges.size(); ++edge)
  {
    const double weight = laplacian.weights[static_cast<Eigen::Index>(edge)];
    const auto & [a, b] = laplacian.edges[edge];
    triplets.emplace_back(a, b, -weight);
    triplets.emplace_back(b, a, -weight);
  }
  Eigen::SparseMatrix<double> matrix(diagonal.size(), diagonal.size());
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  return matrix;
}

double
GradientEnergy(const SurfaceLaplacian & laplacian, const Eigen::VectorXd & u)
{
  double energy = 0.0;
  for (std::size_t edge = 0; edge < laplacian.edges.size(); ++edge)
  {
    const double step = u[laplacian.edges[edge][0]] - u[laplacian.edges[edge][1]];
    energy += laplacian.weights[static_cast<Eigen::Index>(edge)] * step * step;
  }
  return energy;
}

void
RequireOneManifold(const SurfaceConnectivity & connectivity, const std::string & what)
{
  if (connectivity.Components().empty())
  {
    throw InputError(what + " has no faces");
  }
  for (int face = 0; face < connectivity.NumberOfFaces(); ++face)
  {
    if (connectivity.ComponentOfFaces()[face] == -1)
    {
      throw InputError(what + ": " + FaceName(face) + " has a repeated vertex; repair the surface");
    }
  }
  if (!connectivity.IsManifold())
  {
    throw InputError(what + " is not manifold; repair the surface");
  }
  if (connectivity.Components().size() > 1)
  {
    throw InputError(
      what + " has " + std::to_string(connectivity.Components().size()) +
      " components instead of one; choose one of them, or repair the surface if its triangles share no vertices");
  }
}
} // namespace shapeton
