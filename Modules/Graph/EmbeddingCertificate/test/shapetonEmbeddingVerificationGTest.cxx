#include "shapetonEmbeddingVerification.h"
#include "shapetonCertificateFixtures.h"
#include "shapetonTestGraphs.h"

#include "gtest/gtest.h"

#include <functional>
#include <map>

using namespace certificatetest;

namespace
{
std::string
RefusalOf(EmbeddingCertificate certificate, const std::function<void(EmbeddingCertificate &)> & change = {})
{
  if (change)
  {
    change(certificate);
  }
  return shapeton::VerifyEmbedding(certificate).refusal;
}

std::map<std::string, double>
MeasuresOf(const EmbeddingCertificate & certificate)
{
  const auto measures = shapeton::VerifyEmbedding(certificate).measures;
  return { measures.begin(), measures.end() };
}

void
ExpectRefused(const EmbeddingCertificate &                        certificate,
              const std::string &                                 message,
              const std::function<void(EmbeddingCertificate &)> & change)
{
  const std::string refusal = RefusalOf(certificate, change);
  EXPECT_NE(std::string::npos, refusal.find(message)) << "[" << refusal << "] instead of " << message;
}
} // namespace

TEST(EmbeddingVerification, ClosedFormsOnTheSphere)
{
  EXPECT_EQ("", RefusalOf(Tetrahedron()));
  EXPECT_EQ("", RefusalOf(Cube()));
  EXPECT_EQ("", RefusalOf(Octahedron()));
  const auto measures = MeasuresOf(Cube());
  EXPECT_EQ(6.0, measures.at("faces"));
  EXPECT_NEAR(0.5 * std::acos(1.0 / 3.0), measures.at("smallestRadius"), 1e-15);
  EXPECT_LT(measures.at("tangency"), 1e-14);
  EXPECT_LT(measures.at("orthogonality"), 1e-14);
  EXPECT_LT(measures.at("angleSum"), 1e-13);
}

TEST(EmbeddingVerification, ClosedFormsOnTorusAndDisk)
{
  EXPECT_EQ("", RefusalOf(TorusGrid(3, 3)));
  EXPECT_EQ("", RefusalOf(TorusGrid(4, 7)));
  EXPECT_EQ("", RefusalOf(Octagon()));
  EXPECT_LT(MeasuresOf(Octagon()).at("wordError"), 1e-10);
}

TEST(EmbeddingVerification, DummiesAreNoPartOfTheGraph)
{
  EXPECT_EQ("", RefusalOf(PathInTetrahedron()));
  EXPECT_EQ(1.0, MeasuresOf(PathInTetrahedron()).at("dummyNodes"));
}

/** Edge 0 of the octahedron as a path through a dummy: 0-4-1, where node 4 is the dummy. */
TEST(EmbeddingVerification, SubdividedEdges)
{
  EmbeddingCertificate certificate = Octahedron();
  const auto           edges = certificate.packed.edges; // 02 12 03 13 04 14 24 34 05 15 25 35
  ASSERT_EQ((std::array<int, 2>{ 0, 2 }), edges[0]);
  certificate.graph = { 2, {}, {} };
  certificate.graph.edges.push_back({ 0, 1 }); // via node 2: half-edge 0 from 0 to 2, half-edge 3 from 2 to 1
  certificate.subdivided = { { 0, 3 } };
  certificate.rotation = shapeton::RotationOfGraph(certificate);
  EXPECT_EQ("", RefusalOf(certificate));
  ExpectRefused(certificate, "do not follow each other", [](auto & c) { c.subdivided = { { 0, 2 } }; });
  ExpectRefused(certificate, "does not end at its end", [](auto & c) { c.subdivided = { { 0, 12 } }; });
  ExpectRefused(certificate, "ends at another node", [](auto & c) { c.subdivided.clear(); });
  ExpectRefused(certificate, "is subdivided twice", [](auto & c) { c.subdivided.push_back({ 0, 3 }); });
}

TEST(EmbeddingVerification, PerturbedCirclesOfTheSphere)
{
  ExpectRefused(Cube(), "nodes 0 and 1 are not tangent", [](auto & c) { c.nodeRadii[0] *= 1.0 + 1e-8; });
  ExpectRefused(Cube(), "are not tangent", [](auto & c) { c.faceRadii[3] *= 1.0 + 1e-8; });
  ExpectRefused(Cube(), "is not on the unit sphere", [](auto & c) { c.nodePositions[4] *= 1.001; });
  ExpectRefused(Cube(), "are not tangent", [](auto & c) {
    const double angle = 1e-7; // a rotation of one node about the z axis
    const double x = c.nodePositions[0];
    c.nodePositions[0] = std::cos(angle) * x - std::sin(angle) * c.nodePositions[1];
    c.nodePositions[1] = std::sin(angle) * x + std::cos(angle) * c.nodePositions[1];
  });
  ExpectRefused(Cube(), "the radius of node 2 is 0", [](auto & c) { c.nodeRadii[2] = 0.0; });
  ExpectRefused(Cube(), "the radius of face 2 is -0.1", [](auto & c) { c.faceRadii[2] = -0.1; });
}

/** A mirror image keeps tangency and orthogonality but reverses the orientation of the map. */
TEST(EmbeddingVerification, MirroredPlacesAreNotPositivelyOriented)
{
  ExpectRefused(Cube(), "is not positively oriented", [](auto & c) {
    for (std::size_t i = 0; i < c.nodePositions.size(); i += 3)
    {
      c.nodePositions[i] *= -1.0;
    }
    for (std::size_t i = 0; i < c.facePositions.size(); i += 3)
    {
      c.facePositions[i] *= -1.0;
    }
  });
}

TEST(EmbeddingVerification, SwappedRotations)
{
  const auto swapGraph = [](auto & c) { std::swap(c.rotation[0], c.rotation[1]); };
  const auto swapBoth = [](auto & c) {
    std::swap(c.rotation[0], c.rotation[1]);
    std::swap(c.packedRotation[0], c.packedRotation[1]);
  };
  ExpectRefused(Octahedron(), "the rotations of the graph and the packed map differ", swapGraph);
  ExpectRefused(Octahedron(), "the rotation has 6 faces, but the certificate 8", swapBoth);
  ExpectRefused(
    Octahedron(), "are not consecutive", [](auto & c) { std::swap(c.packedRotation[0], c.packedRotation[5]); });
  ExpectRefused(Octahedron(), "is listed twice", [](auto & c) { c.packedRotation[0] = c.packedRotation[1]; });
}

TEST(EmbeddingVerification, WrongTopology)
{
  ExpectRefused(Cube(), "a surface of genus 1 is euclidean, not spherical", [](auto & c) { c.genus = 1; });
  ExpectRefused(TorusGrid(3, 3), "the packed map has genus 1, not 2", [](auto & c) {
    c.genus = 2;
    c.geometry = shapeton::EmbeddingGeometry::Hyperbolic;
  });
  ExpectRefused(TorusGrid(3, 3), "dummies are outside the faces of the graph", [](auto & c) {
    c.graph.edges.resize(1); // all other elements are dummies, so the graph has genus 0
    c.rotation = shapeton::RotationOfGraph(c);
  });
  ExpectRefused(
    Cube(), "starts at another node", [](auto & c) { std::swap(c.graph.edges[0][0], c.graph.edges[0][1]); });
}

/** K4 minus an edge, and K2,3, which have no circle packing. */
TEST(EmbeddingVerification, DegenerateMapsAreRefused)
{
  const auto without = [](const EmbeddingCertificate & whole, const std::vector<int> & removed) {
    const auto map = graphtest::MapOfEdges(shapeton::MapOfRotation(whole.graph, whole.rotation), [&removed](int edge) {
      return std::find(removed.begin(), removed.end(), edge) == removed.end();
    });
    EmbeddingCertificate certificate;
    certificate.graph = map.ToGraph();
    for (const std::vector<int> & around : map.GetRotation())
    {
      certificate.rotation.insert(certificate.rotation.end(), around.begin(), around.end());
    }
    PackAsIs(certificate);
    const int faces = map.Faces();
    certificate.nodeRadii.assign(whole.graph.nodes, 0.3);
    certificate.nodePositions = whole.nodePositions;
    certificate.faceRadii.assign(faces, 0.3);
    certificate.facePositions.assign(whole.facePositions.begin(), whole.facePositions.begin() + 3 * faces);
    return certificate;
  };
  EXPECT_NE(std::string::npos, RefusalOf(without(Tetrahedron(), { 0 })).find("is not 3-connected"));
  EXPECT_NE(std::string::npos, RefusalOf(without(Tetrahedron(), { 0, 1 })).find("is not 3-connected"));
  EXPECT_NE(std::string::npos, RefusalOf(without(Cube(), { 0 })).find("is not 3-connected"));
  // K2,4 is the octahedron without its equator; K2,3 has one face fewer.
  EXPECT_NE(std::string::npos, RefusalOf(without(Octahedron(), { 0, 1, 2, 3 })).find("is not 3-connected"));
}

TEST(EmbeddingVerification, PerturbedTorus)
{
  const auto grid = TorusGrid(3, 4);
  ExpectRefused(grid, "the angles at node 5 sum to", [](auto & c) { c.nodeRadii[5] *= 1.0 + 1e-9; });
  ExpectRefused(grid, "are not tangent", [](auto & c) { c.nodePositions[6] += 1e-7; });
  ExpectRefused(grid, "the directions at the ends", [](auto & c) { c.nodeAngles[2] += 1e-7; });
  ExpectRefused(grid, "from its expected position", [](auto & c) { c.facePositions[6] += 1e-7; });
  ExpectRefused(grid, "cover", [](auto & c) {
    c.periods[0] *= 2.0;
    std::swap(c.periods[0], c.periods[3]);
  });
  ExpectRefused(grid, "not a reduced basis", [](auto & c) { c.periods[2] += 4.0; });
  ExpectRefused(grid, "is not its translation", [](auto & c) { c.generators[1].b += 1e-6; });
  ExpectRefused(grid, "the word does not match", [](auto & c) { c.word = { 1, -2, -1, 2 }; });
  ExpectRefused(grid, "commutators", [](auto & c) { c.canonicalWords = { { 1 }, { 1 } }; });
  ExpectRefused(grid, "the tree", [](auto & c) { c.tree[3] = -1; });
  ExpectRefused(grid, "the tree does not reach node 5", [](auto & c) { c.tree[5] ^= 1; });
  ExpectRefused(grid, "belongs to the tree", [](auto & c) { c.generators[0].halfEdge = c.tree[5]; });
  EXPECT_EQ("", RefusalOf(grid, [](auto & c) { c.canonicalWords = { { 1, 2 }, { 2 } }; }));
}

TEST(EmbeddingVerification, PerturbedOctagon)
{
  ExpectRefused(Octagon(), "the angles at node 0 sum to", [](auto & c) { c.nodeRadii[0] *= 1.0 + 1e-9; });
  ExpectRefused(Octagon(), "is not its deck transformation", [](auto & c) { c.generators[2].b *= 1.0 + 1e-6; });
  ExpectRefused(Octagon(), "from its expected position", [](auto & c) { c.facePositions[0] += 1e-7; });
  ExpectRefused(Octagon(), "outside the disk", [](auto & c) { c.nodePositions[0] = 1.0; });
  ExpectRefused(Octagon(), "the word does not match", [](auto & c) { std::swap(c.word[0], c.word[1]); });
  // The check is invariant under translation and rotation.
  EXPECT_EQ("", RefusalOf(Octagon(), [](auto & c) { c.word = { -2, 3, 4, -3, -4, 1, 2, -1 }; }));
}
