#include "shapetonGraphOnMesh.h"

#include "shapetonExceptions.h"
#include "shapetonGraphEmbedding.h"
#include "shapetonGraphGenus.h"
#include "shapetonSurfaceLocator.h"
#include "shapetonTestSurfaces.h"
#include "shapetonTorusInSpace.h"

#include <gtest/gtest.h>

using namespace shapeton;

namespace
{
EmbeddingCertificate
CompleteGraph(int nodes)
{
  Graph graph;
  graph.nodes = nodes;
  for (int i = 0; i < nodes; ++i)
  {
    for (int j = i + 1; j < nodes; ++j)
    {
      graph.edges.push_back({ i, j });
    }
  }
  return EmbedGraph(graph, FindEmbedding(graph).map);
}

/** Points are on the surface; edges start and end at their nodes and have no long jumps. */
void
ExpectSound(const EmbeddingCertificate & certificate,
            const GraphOnMesh &          graph,
            const SurfaceMesh &          mesh,
            double                       longest)
{
  const SurfaceLocator locator(mesh.V, mesh.F);
  EXPECT_LT(graph.gap, 1e-9);
  ASSERT_EQ(graph.edges.size(), certificate.graph.edges.size());
  for (std::size_t e = 0; e < graph.edges.size(); ++e)
  {
    const auto & curve = graph.edges[e];
    EXPECT_LT((curve.front() - graph.nodes[certificate.graph.edges[e][0]]).norm(), 1e-7);
    EXPECT_LT((curve.back() - graph.nodes[certificate.graph.edges[e][1]]).norm(), 1e-7);
    for (std::size_t i = 0; i < curve.size(); ++i)
    {
      EXPECT_LT(locator.FindClosest(curve[i]).distance, 1e-9);
      EXPECT_LT(i == 0 ? 0.0 : (curve[i] - curve[i - 1]).norm(), longest);
    }
  }
}
} // namespace

TEST(GraphOnMesh, OnASphereItIsARotatedCopy)
{
  // An icosphere is in the conformal class of itself; the two normalizations agree up to a rotation.
  const EmbeddingCertificate certificate = CompleteGraph(4);
  const SurfaceMesh          mesh = testsurfaces::Icosphere(3, 1.0);
  const GraphOnMesh          graph = MapGraphOntoMesh(certificate, mesh, "the sphere");
  ExpectSound(certificate, graph, mesh, 0.2);
  for (int i = 0; i < 4; ++i)
  {
    for (int j = 0; j < i; ++j)
    {
      EXPECT_NEAR((graph.nodes[i] - graph.nodes[j]).norm(), std::sqrt(8.0 / 3.0), 0.01); // a regular tetrahedron
    }
  }
}

TEST(GraphOnMesh, OnATorusOfItsConformalTypeItIsConformal)
{
  // The torus in space that is nearest to the lattice of K7, and its known dilatation.
  const EmbeddingCertificate certificate = CompleteGraph(7);
  const TorusInSpace         torus(certificate);
  const double               r = torus.TubeRadius();
  const SurfaceMesh          mesh = testsurfaces::Torus(96, 64, 1.0, r);
  const GraphOnMesh          graph = MapGraphOntoMesh(certificate, mesh, "the torus");
  ExpectSound(certificate, graph, mesh, 0.3);
  EXPECT_LE(graph.dilatation, torus.Dilatation() * 1.01); // it may use another basis
  // The lattice of K7 is hexagonal.
  EXPECT_GT(graph.dilatation, 1.0);
}

TEST(GraphOnMesh, RejectsAnotherGenus)
{
  EXPECT_THROW(MapGraphOntoMesh(CompleteGraph(4), testsurfaces::Torus(20, 10, 2.0, 1.0), "it"), InputError);
  EXPECT_THROW(MapGraphOntoMesh(CompleteGraph(5), testsurfaces::Icosphere(2, 1.0), "it"), InputError);
  EXPECT_THROW(MapGraphOntoMesh(CompleteGraph(4), testsurfaces::Square(4, 1.0), "it"), InputError);
}
