#include "shapetonChecks.h"

namespace shapeton
{
namespace
{
/** Marks the elements used by the path of a subdivided edge; rejects paths that leave the dummies or meet other paths.
 */
class PathCheck
{
public:
  PathCheck(const EmbeddingCertificate & certificate, const TracedMap & packed)
    : m_Certificate(certificate)
    , m_Packed(packed)
    , m_IsUsedNode(packed.nodes, false)
    , m_IsUsedEdge(packed.HalfEdges() / 2, false)
    , m_IsSubdivided(certificate.graph.edges.size(), false)
  {}

  void
  Check(const std::vector<int> & path)
  {
    const int edge = path.front() / 2;
    Require(!m_IsSubdivided[edge], edge, "is subdivided twice");
    m_IsSubdivided[edge] = true;
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
    {
      const int inner = m_Packed.Node(path[i] ^ 1);
      Require(inner == m_Packed.Node(path[i + 1]), edge, "is subdivided into half-edges that do not follow each other");
      Require(
        inner >= m_Certificate.graph.nodes && !m_IsUsedNode[inner], edge, "uses a node that is not reserved for it");
      m_IsUsedNode[inner] = true;
      const int more = path[i + 1] / 2;
      Require(static_cast<std::size_t>(more) >= m_Certificate.graph.edges.size() && !m_IsUsedEdge[more],
              edge,
              "uses an edge that is not reserved for it");
      m_IsUsedEdge[more] = true;
    }
    Require(m_Packed.Node(path.back() ^ 1) == m_Certificate.graph.edges[edge][1], edge, "does not end at its end node");
  }

  /** Checks that all edges that are not subdivided have the same ends as in the graph. */
  void
  CheckOthers() const
  {
    for (std::size_t e = 0; e < m_Certificate.graph.edges.size(); ++e)
    {
      const auto [first, second] = m_Certificate.graph.edges[e];
      const int edge = static_cast<int>(e);
      Require(m_Packed.Node(2 * edge) == first, edge, "starts at another node in the packed map");
      Require(
        m_IsSubdivided[e] || m_Packed.Node(2 * edge + 1) == second, edge, "ends at another node in the packed map");
    }
  }

private:
  static void
  Require(bool condition, int edge, const char * fault)
  {
    if (!condition)
    {
      throw Refusal("edge " + std::to_string(edge) + " of the graph " + fault);
    }
  }

  const EmbeddingCertificate & m_Certificate;
  const TracedMap &            m_Packed;
  std::vector<bool>            m_IsUsedNode;
  std::vector<bool>            m_IsUsedEdge;
  std::vector<bool>            m_IsSubdivided;
};

/** For each packed half-edge, the graph half-edge that starts with it; -1 for the others. */
std::vector<int>
StartsOfGraph(const EmbeddingCertificate & certificate, const TracedMap & packed)
{
  std::vector<int> starts(packed.HalfEdges(), -1);
  for (std::size_t h = 0; h < 2 * certificate.graph.edges.size(); ++h)
  {
    starts[h] = static_cast<int>(h);
  }
  for (const std::vector<int> & path : certificate.subdivided)
  {
    starts[path.front() ^ 1] = -1;
    starts[path.back() ^ 1] = path.front() ^ 1;
  }
  return starts;
}

/** Checks that the packed map has the half-edges of the graph around each node in the order of the graph's rotation. */
void
RequireSameRotation(const EmbeddingCertificate & certificate, const TracedMap & packed, const TracedMap & graph)
{
  const std::vector<int> starts = StartsOfGraph(certificate, packed);
  for (int h = 0; h < packed.HalfEdges(); ++h)
  {
    if (starts[h] < 0)
    {
      continue;
    }
    int after = packed.next[h];
    while (starts[after] < 0)
    {
      after = packed.next[after];
    }
    if (graph.next[starts[h]] != starts[after])
    {
      throw Refusal("the rotations of the graph and the packed map differ at node " + std::to_string(packed.Node(h)) +
                    ", half-edge " + std::to_string(starts[h]));
    }
  }
}

void
AppendSizes(const EmbeddingCertificate & certificate, const TracedMap & packed, Measures & measures)
{
  measures.emplace_back("genus", certificate.genus);
  measures.emplace_back("nodes", certificate.graph.nodes);
  measures.emplace_back("edges", static_cast<double>(certificate.graph.edges.size()));
  measures.emplace_back("dummyNodes", packed.nodes - certificate.graph.nodes);
  measures.emplace_back("packedEdges", packed.HalfEdges() / 2);
  measures.emplace_back("faces", static_cast<double>(packed.firstOfFace.size()));
}
} // namespace

void
CheckMap(const EmbeddingCertificate & certificate, const TracedMap & packed, Measures & measures)
{
  PathCheck paths(certificate, packed);
  for (const std::vector<int> & path : certificate.subdivided)
  {
    paths.Check(path);
  }
  paths.CheckOthers();
  if (packed.components != 1 || packed.isolatedNodes > 0)
  {
    throw Refusal("the packed map is not connected");
  }
  if (packed.firstOfFace.size() != certificate.faceRadii.size())
  {
    throw Refusal("the rotation has " + std::to_string(packed.firstOfFace.size()) + " faces, but the certificate " +
                  std::to_string(certificate.faceRadii.size()) + " face circles");
  }
  if (packed.Genus() != certificate.genus)
  {
    throw Refusal("by Euler's formula the packed map has genus " + std::to_string(packed.Genus()) + ", not " +
                  std::to_string(certificate.genus));
  }
  const TracedMap graph(certificate.graph, certificate.rotation, "the rotation of the graph");
  RequireSameRotation(certificate, packed, graph);
  // A submap keeps the genus only if the removed parts are inside its faces.
  if (graph.Genus() != certificate.genus)
  {
    throw Refusal("the rotation of the graph has genus " + std::to_string(graph.Genus()) + ", but the surface " +
                  std::to_string(certificate.genus) + ": dummies are outside the faces of the graph");
  }
  AppendSizes(certificate, packed, measures);
}
} // namespace shapeton
