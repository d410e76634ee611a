#ifndef shapetonCertificateFixtures_h
#define shapetonCertificateFixtures_h

#include "shapetonEmbeddingCertificate.h"

#include <algorithm>
#include <array>
#include <cmath>

/** Certificates with closed-form solutions. */
namespace certificatetest
{
using shapeton::EmbeddingCertificate;
using Point = std::array<double, 3>;

const double Pi = std::acos(-1.0);

inline double
Dot(const Point & a, const Point & b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Point
Unit(Point a)
{
  const double length = std::sqrt(Dot(a, a));
  for (double & x : a)
  {
    x /= length;
  }
  return a;
}

/** Half-edges around a node, counter-clockwise as seen from outside the sphere. */
inline std::vector<int>
Around(int node, const std::vector<Point> & places, const std::vector<std::array<int, 2>> & edges)
{
  const Point & z = places[node];
  const Point   x = Unit(std::abs(z[0]) < 0.7 ? Point{ 1 - z[0] * z[0], -z[0] * z[1], -z[0] * z[2] }
                                            : Point{ -z[1] * z[0], 1 - z[1] * z[1], -z[1] * z[2] });
  const Point   y{ z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2], z[0] * x[1] - z[1] * x[0] };
  std::vector<std::pair<double, int>> around;
  for (int h = 0; h < static_cast<int>(2 * edges.size()); ++h)
  {
    if (edges[h / 2][h % 2] == node)
    {
      const Point & other = places[edges[h / 2][1 - h % 2]];
      around.emplace_back(std::atan2(Dot(other, y), Dot(other, x)), h);
    }
  }
  std::sort(around.begin(), around.end());
  std::vector<int> halfEdges;
  for (const auto & [angle, halfEdge] : around)
  {
    halfEdges.push_back(halfEdge);
  }
  return halfEdges;
}

/** Sets a packed map without dummies: the graph itself. */
inline void
PackAsIs(EmbeddingCertificate & certificate)
{
  certificate.packed = certificate.graph;
  certificate.packed.names.clear();
  certificate.packedRotation = certificate.rotation;
}

/** A regular polyhedron with these corners; nearest nodes are neighbors. */
inline EmbeddingCertificate
Polyhedron(std::vector<Point> corners)
{
  EmbeddingCertificate certificate;
  certificate.graph.nodes = static_cast<int>(corners.size());
  double cosine = -1.0;
  for (Point & corner : corners)
  {
    corner = Unit(corner);
    certificate.nodePositions.insert(certificate.nodePositions.end(), corner.begin(), corner.end());
    for (const Point * other = corners.data(); other != &corner; ++other)
    {
      cosine = std::max(cosine, Dot(*other, corner));
    }
  }
  for (int b = 0; b < certificate.graph.nodes; ++b)
  {
    for (int a = 0; a < b; ++a)
    {
      if (Dot(corners[a], corners[b]) > cosine - 1e-9)
      {
        certificate.graph.edges.push_back({ a, b });
      }
    }
  }
  for (int node = 0; node < certificate.graph.nodes; ++node)
  {
    const std::vector<int> around = Around(node, corners, certificate.graph.edges);
    certificate.rotation.insert(certificate.rotation.end(), around.begin(), around.end());
  }
  PackAsIs(certificate);
  const double radius = 0.5 * std::acos(cosine);
  certificate.nodeRadii.assign(corners.size(), radius);
  const shapeton::CombinatorialMap map = shapeton::MapOfRotation(certificate.graph, certificate.rotation);
  for (int face = 0; face < map.Faces(); ++face)
  {
    Point center{ 0, 0, 0 };
    for (const int halfEdge : map.Boundary(face))
    {
      for (int k = 0; k < 3; ++k)
      {
        center[k] += corners[map.Node(halfEdge)][k];
      }
    }
    center = Unit(center);
    certificate.facePositions.insert(certificate.facePositions.end(), center.begin(), center.end());
    certificate.faceRadii.push_back(
      std::acos(Dot(center, corners[map.Node(map.FirstOfFace(face))]) / std::cos(radius)));
  }
  return certificate;
}

inline EmbeddingCertificate
Tetrahedron()
{
  return Polyhedron({ { 1, 1, 1 }, { 1, -1, -1 }, { -1, 1, -1 }, { -1, -1, 1 } });
}

inline EmbeddingCertificate
Cube()
{
  std::vector<Point> corners;
  for (int i = 0; i < 8; ++i)
  {
    corners.push_back({ i % 2 - 0.5, i / 2 % 2 - 0.5, i / 4 - 0.5 });
  }
  return Polyhedron(corners);
}

inline EmbeddingCertificate
Octahedron()
{
  return Polyhedron({ { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } });
}

/** The square grid of width x height nodes on the torus: all radii 1/2. */
inline EmbeddingCertificate
TorusGrid(int width, int height)
{
  EmbeddingCertificate certificate;
  certificate.genus = 1;
  certificate.geometry = shapeton::EmbeddingGeometry::Euclidean;
  certificate.graph.nodes = width * height;
  const auto nodeOf = [&](int column, int row) { return row % height * width + column % width; };
  for (int row = 0; row < height; ++row)
  {
    for (int column = 0; column < width; ++column)
    {
      const int node = nodeOf(column, row); // its edges to the right and upwards are 2 node and 2 node + 1
      certificate.graph.edges.push_back({ node, nodeOf(column + 1, row) });
      certificate.graph.edges.push_back({ node, nodeOf(column, row + 1) });
      const int left = nodeOf(column + width - 1, row);
      const int below = nodeOf(column, row + height - 1);
      certificate.rotation.insert(certificate.rotation.end(), { 4 * node, 4 * node + 2, 4 * left + 1, 4 * below + 3 });
      certificate.nodePositions.insert(certificate.nodePositions.end(), { 1.0 * column, 1.0 * row });
      const int parent = column > 0 ? 4 * left : row > 0 ? 4 * below + 2 : -1;
      certificate.tree.push_back(parent);
    }
  }
  PackAsIs(certificate);
  const std::size_t nodes = certificate.graph.nodes;
  certificate.nodeRadii.assign(nodes, 0.5);
  certificate.nodeAngles.assign(nodes, 0.0);
  certificate.faceRadii.assign(nodes, 0.5);
  const shapeton::CombinatorialMap map = shapeton::MapOfRotation(certificate.graph, certificate.rotation);
  for (int face = 0; face < map.Faces(); ++face)
  {
    const int                               h = map.FirstOfFace(face);
    const std::size_t                       v = map.Node(h);
    const std::array<std::array<int, 2>, 4> corner = { { { 1, 1 }, { -1, -1 }, { -1, 1 }, { 1, -1 } } };
    certificate.facePositions.push_back(certificate.nodePositions[2 * v] + 0.5 * corner[h % 4][0]);
    certificate.facePositions.push_back(certificate.nodePositions[2 * v + 1] + 0.5 * corner[h % 4][1]);
  }
  certificate.periods = { 1.0 * width, 0.0, 0.0, 1.0 * height };
  const int right = 4 * nodeOf(width - 1, 0);
  const int up = 4 * nodeOf(0, height - 1) + 2;
  certificate.generators = { { right, 1.0, 1.0 * width }, { up, 1.0, { 0.0, 1.0 * height } } };
  certificate.word = { 1, 2, -1, -2 };
  certificate.canonicalWords = { { 1 }, { 2 } };
  return certificate;
}

/** z -> (a z + b) / (conj(b) z + conj(a)) as a pair. */
using Isometry = std::array<std::complex<double>, 2>;

inline Isometry
Product(const Isometry & f, const Isometry & g)
{
  return { f[0] * g[0] + f[1] * std::conj(g[1]), f[0] * g[1] + f[1] * std::conj(g[0]) };
}

/** Genus 2 from the regular octagon with angles pi/4: one node with four loops, one face. */
inline EmbeddingCertificate
Octagon()
{
  EmbeddingCertificate certificate;
  certificate.genus = 2;
  certificate.geometry = shapeton::EmbeddingGeometry::Hyperbolic;
  certificate.graph.nodes = 1;
  certificate.graph.edges.assign(4, { 0, 0 });
  const std::vector<int> boundary{ 0, 2, 1, 3, 4, 6, 5, 7 }; // a b a^-1 b^-1 c d c^-1 d^-1
  std::vector<int>       next(8);
  for (int i = 0; i < 8; ++i)
  {
    next[boundary[(i + 1) % 8]] = boundary[i] ^ 1;
  }
  std::vector<double> direction(8);
  for (int h = 0, i = 0; i < 8; h = next[h], ++i)
  {
    certificate.rotation.push_back(h);
    direction[h] = i * Pi / 4.0;
  }
  PackAsIs(certificate);
  const double radius = std::acosh(1.0 / std::tan(Pi / 8.0)); // 8 half kites of pi/8 on each side of pi
  const double diagonal = std::tanh(0.5 * std::acosh(std::cosh(radius) * std::cosh(radius)));
  certificate.nodeRadii = { radius };
  certificate.faceRadii = { radius };
  certificate.nodePositions = { 0.0, 0.0 };
  certificate.nodeAngles = { 0.0 };
  certificate.facePositions = { diagonal * std::cos(Pi / 8.0), diagonal * std::sin(Pi / 8.0) };
  certificate.tree = { -1 };
  for (int h = 0; h < 8; h += 2)
  {
    const Isometry there{ std::polar(1.0, 0.5 * direction[h]), 0.0 };
    const Isometry walk{ std::cosh(radius), std::sinh(radius) };
    const Isometry back{ std::polar(1.0, 0.5 * (Pi - direction[h + 1])), 0.0 };
    const Isometry all = Product(Product(there, walk), back);
    certificate.generators.push_back({ h, all[0], all[1] });
  }
  certificate.word = { 1, 2, -1, -2, 3, 4, -3, -4 };
  certificate.canonicalWords = { { 1 }, { 2 }, { 3 }, { 4 } };
  return certificate;
}

/** K4 on the sphere as the packed map; the graph is a path of three nodes inside the tetrahedron, and all other
 * elements are dummies. */
inline EmbeddingCertificate
PathInTetrahedron()
{
  EmbeddingCertificate certificate = Tetrahedron(); // edges 01 02 12 03 13 23
  certificate.graph = { 3, { { 0, 1 }, { 0, 2 } }, { "left", "middle", "right" } };
  certificate.rotation = shapeton::RotationOfGraph(certificate);
  return certificate;
}
} // namespace certificatetest

#endif
