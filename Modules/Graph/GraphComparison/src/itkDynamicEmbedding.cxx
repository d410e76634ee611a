#include "itkDynamicEmbedding.h"

#include "itkBlockArrangement.h"
#include "itkCarriedPacking.h"
#include "itkCarriedRotation.h"
#include "itkSphereAlignment.h"

#include <algorithm>
#include <limits>

namespace itk
{
namespace
{
bool
AreSpheres(const EmbeddingCertificate & a, const EmbeddingCertificate & b)
{
  return a.geometry == EmbeddingGeometry::Spherical && b.geometry == EmbeddingGeometry::Spherical;
}

std::vector<int>
Inverse(const std::vector<int> & image, int size)
{
  std::vector<int> inverse(size, -1);
  for (std::size_t i = 0; i < image.size(); ++i)
  {
    if (image[i] >= 0)
    {
      inverse[image[i]] = static_cast<int>(i);
    }
  }
  return inverse;
}

std::vector<int>
IndicesOf(const std::vector<int> & values, int value)
{
  std::vector<int> indices;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    if (values[i] == value)
    {
      indices.push_back(static_cast<int>(i));
    }
  }
  return indices;
}

std::array<double, 3>
Turned(const std::array<double, 9> & turn, const std::array<double, 3> & p)
{
  std::array<double, 3> result{};
  for (int row = 0; row < 3; ++row)
  {
    result[row] = turn[3 * row] * p[0] + turn[3 * row + 1] * p[1] + turn[3 * row + 2] * p[2];
  }
  return result;
}

void
FindChangedNodes(const Graph & a, const Graph & b, const std::vector<int> & image, GraphChanges & changes)
{
  changes.changedNodes = changes.addedNodes;
  const auto add = [&changes](int node) {
    if (node >= 0)
    {
      changes.changedNodes.push_back(node);
    }
  };
  for (const int e : changes.addedEdges)
  {
    add(b.edges[e][0]);
    add(b.edges[e][1]);
  }
  for (const int e : changes.removedEdges)
  {
    add(image[a.edges[e][0]]);
    add(image[a.edges[e][1]]);
  }
  std::sort(changes.changedNodes.begin(), changes.changedNodes.end());
  changes.changedNodes.erase(std::unique(changes.changedNodes.begin(), changes.changedNodes.end()),
                             changes.changedNodes.end());
}

void
MeasureDisplacements(const EmbeddingCertificate & a,
                     const EmbeddingCertificate & b,
                     const std::vector<int> &     image,
                     GraphChanges &               changes)
{
  const std::array<double, 9> turn = RotationTo(a, b, image);
  double                      sum = 0.0;
  double                      largest = 0.0;
  for (int v = 0; v < a.graph.nodes; ++v)
  {
    const int partner = image[v];
    if (partner >= 0 && !std::binary_search(changes.changedNodes.begin(), changes.changedNodes.end(), partner))
    {
      ++changes.unchangedNodes;
      if (AreSpheres(a, b))
      {
        const double angle = AngleBetween(PlaceOnSphere(a, v), Turned(turn, PlaceOnSphere(b, partner)));
        sum += angle;
        largest = std::max(largest, angle);
      }
    }
  }
  const bool measured = AreSpheres(a, b) && changes.unchangedNodes > 0;
  changes.meanDisplacement = measured ? sum / changes.unchangedNodes : std::numeric_limits<double>::quiet_NaN();
  changes.largestDisplacement = measured ? largest : std::numeric_limits<double>::quiet_NaN();
}
} // namespace

std::array<double, 9>
RotationTo(const EmbeddingCertificate & a, const EmbeddingCertificate & b, const std::vector<int> & image)
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<double, 3>> images;
  for (int v = 0; v < a.graph.nodes && AreSpheres(a, b); ++v)
  {
    if (image[v] >= 0)
    {
      points.push_back(PlaceOnSphere(b, image[v]));
      images.push_back(PlaceOnSphere(a, v));
    }
  }
  return BestRotation(points, images);
}

GraphChanges
ChangesBetween(const EmbeddingCertificate & a, const EmbeddingCertificate & b, const std::vector<int> & image)
{
  const std::vector<int> edgeImage = EdgesOfSameEnds(a.graph, b.graph, image);
  GraphChanges           changes;
  changes.removedNodes = IndicesOf(image, -1);
  changes.addedNodes = IndicesOf(Inverse(image, b.graph.nodes), -1);
  changes.removedEdges = IndicesOf(edgeImage, -1);
  changes.addedEdges = IndicesOf(Inverse(edgeImage, static_cast<int>(b.graph.edges.size())), -1);
  FindChangedNodes(a.graph, b.graph, image, changes);
  MeasureDisplacements(a, b, image, changes);
  return changes;
}

GraphChanges
ChangesBetween(const EmbeddingCertificate & a, const EmbeddingCertificate & b)
{
  return ChangesBetween(a, b, NodesOfSameName(a.graph, b.graph));
}

DynamicEmbedding::DynamicEmbedding(GenusOptions genus, GraphEmbeddingOptions embedding)
  : m_Genus(genus), m_Embedding(embedding)
{}

PackedMap
DynamicEmbedding::PackAnew(const Graph & graph) const
{
  AugmentationOptions options(m_Embedding.augmentation);
  options.names = graph.names;
  return MakePackedMap(m_Map, options);
}

DynamicStep
DynamicEmbedding::Add(const Graph & graph)
{
  DynamicStep step;
  if (m_IsFirst)
  {
    m_Map = ArrangeBlocks(FindEmbedding(graph, m_Genus).map);
    m_Packed = this->PackAnew(graph);
    step.certificate = EmbedPackedGraph(graph, m_Map, m_Packed, m_Embedding.infinity);
  }
  else
  {
    CarriedRotation carried = CarryRotation(m_Last.graph, m_Map, graph, m_Genus);
    m_Map = std::move(carried.map);
    m_Packed = m_Embedding.augmentation == Augmentation::Ring ? CarryPackedMap(m_Last.graph, m_Packed, graph, m_Map)
                                                              : this->PackAnew(graph);
    step.embeddedAnew = carried.embeddedAnew;
    step.certificate = EmbedPackedGraph(graph, m_Map, m_Packed, m_Embedding.infinity);
    const std::vector<int> image = NodesOfSameName(m_Last.graph, graph);
    if (AreSpheres(m_Last, step.certificate))
    {
      MoveEmbedding(step.certificate, BestMotion(m_Last, step.certificate, image));
    }
    step.changes = ChangesBetween(m_Last, step.certificate, image);
  }
  m_IsFirst = false;
  m_Last = step.certificate;
  return step;
}
} // namespace itk
