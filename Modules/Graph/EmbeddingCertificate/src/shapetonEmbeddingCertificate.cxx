#include "shapetonEmbeddingCertificate.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
/** For each packed half-edge, the graph half-edge that starts with it; -1 for dummies and inner parts of paths. */
std::vector<int>
GraphHalfEdges(const EmbeddingCertificate & certificate)
{
  const std::size_t edges = certificate.graph.edges.size();
  if (certificate.packed.edges.size() < edges)
  {
    throw InputError("the packed map of the certificate has fewer edges than its graph; compute the certificate again");
  }
  std::vector<int> image(2 * certificate.packed.edges.size(), -1);
  for (std::size_t h = 0; h < 2 * edges; ++h)
  {
    image[h] = static_cast<int>(h);
  }
  for (const std::vector<int> & path : certificate.subdivided)
  {
    if (path.empty() || path.front() % 2 != 0 || static_cast<std::size_t>(path.front()) >= 2 * edges)
    {
      throw InputError(
        "a path of the certificate's list subdivided does not start with an edge of the graph; compute the "
        "certificate again");
    }
    image[path.front() + 1] = -1;
  }
  for (const std::vector<int> & path : certificate.subdivided)
  {
    image[path.back() ^ 1] = path.front() + 1;
  }
  return image;
}
} // namespace

double
UnitOfSurface(const EmbeddingCertificate & certificate)
{
  return certificate.geometry == EmbeddingGeometry::Euclidean
           ? std::hypot(certificate.periods[0], certificate.periods[1])
           : 1.0;
}

double
SmallestCircle(const EmbeddingCertificate & certificate)
{
  const auto first = certificate.nodeRadii.begin();
  return *std::min_element(first, first + certificate.graph.nodes) / UnitOfSurface(certificate);
}

std::string
NameOf(EmbeddingGeometry geometry)
{
  switch (geometry)
  {
    case EmbeddingGeometry::Spherical:
      return "spherical";
    case EmbeddingGeometry::Euclidean:
      return "euclidean";
    default:
      return "hyperbolic";
  }
}

std::vector<int>
RotationOfGraph(const EmbeddingCertificate & certificate)
{
  const std::vector<int> image = GraphHalfEdges(certificate);
  std::vector<int>       rotation;
  rotation.reserve(2 * certificate.graph.edges.size());
  for (const int halfEdge : certificate.packedRotation)
  {
    if (image.at(halfEdge) >= 0)
    {
      rotation.push_back(image[halfEdge]);
    }
  }
  return rotation;
}

std::vector<int>
FlatRotation(const CombinatorialMap & map)
{
  std::vector<int> rotation;
  rotation.reserve(map.HalfEdges());
  for (int node = 0; node < map.Nodes(); ++node)
  {
    const int first = map.FirstAround(node);
    for (int halfEdge = first; halfEdge >= 0;
         halfEdge = map.NextAround(halfEdge) == first ? -1 : map.NextAround(halfEdge))
    {
      rotation.push_back(halfEdge);
    }
  }
  return rotation;
}

CombinatorialMap
MapOfRotation(const Graph & graph, const std::vector<int> & rotation)
{
  const auto nodeOf = [&](int halfEdge) { return graph.edges[halfEdge / 2][halfEdge % 2]; };
  const auto halfEdges = static_cast<int>(2 * graph.edges.size());
  Rotation   lists(graph.nodes);
  for (const int halfEdge : rotation)
  {
    if (halfEdge < 0 || halfEdge >= halfEdges)
    {
      throw InputError("a rotation names half-edge " + std::to_string(halfEdge) + ", but the graph has " +
                       std::to_string(halfEdges) + "; use the rotation of this graph");
    }
    lists[nodeOf(halfEdge)].push_back(halfEdge);
  }
  return CombinatorialMap(graph, lists);
}
} // namespace shapeton
