#include "shapetonDynamicEmbedding.h"

#include "shapetonCarriedPacking.h"
#include "shapetonCarriedRotation.h"
#include "shapetonSphereAlignment.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <exception>
#include <limits>

namespace shapeton
{
namespace
{
/** Imperceptible mean displacement (radians). */
constexpr double steadyEnough = 1e-3;
/** Minimum gain required to accept another arrangement. */
constexpr double worthwhileGain = 10.0;

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

DynamicEmbedding::DynamicEmbedding(GenusSettings genus, GraphEmbeddingSettings embedding)
  : m_Genus(genus), m_Embedding(embedding)
{}

EmbeddingCertificate
DynamicEmbedding::EmbedAnew(const Graph & graph, const CombinatorialMap & map) const
{
  GraphEmbeddingSettings options = m_Embedding;
  options.isRotationFree = true;
  options.isSideFree = m_IsFirst;
  options.longestFace = FilledFaces().longestFace;
  return EmbedGraph(graph, map, options);
}

/** Aligns with the previous step by a rotation and computes the changes since then. */
DynamicStep
DynamicEmbedding::StepTo(EmbeddingCertificate certificate) const
{
  DynamicStep            step;
  const std::vector<int> image = NodesOfSameName(m_Last.graph, certificate.graph);
  if (AreSpheres(m_Last, certificate))
  {
    MoveEmbedding(certificate, BestMotion(m_Last, certificate, image));
  }
  step.changes = ChangesBetween(m_Last, certificate, image);
  step.certificate = std::move(certificate);
  return step;
}

/** The first sufficiently stable candidate, or the most stable one. If none has a packing, rethrows the error of the
 * first one. */
DynamicStep
DynamicEmbedding::StepBy(const Graph &                  graph,
                         const CombinatorialMap &       map,
                         const std::vector<PackedMap> & choices) const
{
  DynamicStep        best;
  bool               isFound = false;
  std::exception_ptr failure;
  for (const PackedMap & packed : choices)
  {
    try
    {
      DynamicStep step = this->StepTo(EmbedPackedGraph(graph, map, packed, m_Embedding.infinity));
      if (!isFound || step.changes.meanDisplacement < best.changes.meanDisplacement)
      {
        best = std::move(step);
      }
      isFound = true;
      if (best.changes.meanDisplacement <= steadyEnough)
      {
        break;
      }
    }
    catch (const InputError &)
    {
      failure = failure ? failure : std::current_exception();
    }
  }
  if (!isFound)
  {
    std::rethrow_exception(failure);
  }
  return best;
}

DynamicStep
DynamicEmbedding::NextStep(const Graph & graph) const
{
  const CombinatorialMap before = MapOfRotation(m_Last.graph, m_Last.rotation);
  const CarriedRotation  carried = CarryRotation(m_Last.graph, before, graph, m_Genus);
  DynamicStep            step;
  if (m_Embedding.augmentation == Augmentation::None)
  {
    step = this->StepTo(EmbedGraph(graph, carried.map, m_Embedding));
    step.embeddedAnew = carried.embeddedAnew;
    return step;
  }
  std::vector<PackedMap> choices{ CarryPackedMap(m_Last.graph, PackedMapOf(m_Last), graph, carried.map) };
  if (carried.map.Genus() == 0)
  {
    choices.push_back(MakePackedMap(carried.map, FilledFaces()));
  }
  step = this->StepBy(graph, carried.map, choices);
  step.embeddedAnew = carried.embeddedAnew;
  if (const double smallest = SmallestCircle(step.certificate); smallest < smallestLegibleRadius)
  {
    EmbeddingCertificate anew = this->EmbedAnew(graph, carried.map);
    if (SmallestCircle(anew) > worthwhileGain * smallest)
    {
      step = this->StepTo(std::move(anew));
      step.embeddedAnew = true;
    }
  }
  return step;
}

DynamicStep
DynamicEmbedding::Add(const Graph & graph)
{
  DynamicStep step;
  if (m_IsFirst)
  {
    step.certificate = this->EmbedAnew(graph, FindEmbedding(graph, m_Genus).map);
    m_IsFirst = false;
  }
  else
  {
    step = this->NextStep(graph);
  }
  m_Last = step.certificate;
  return step;
}
} // namespace shapeton
