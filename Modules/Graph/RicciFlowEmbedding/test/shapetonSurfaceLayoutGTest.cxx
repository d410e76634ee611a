#include "shapetonSurfaceLayout.h"

#include "shapetonGraphFamilies.h"
#include "shapetonPackedMap.h"
#include "shapetonTestGraphs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
const double pi = std::acos(-1.0);

shapeton::PackedMap
AnyPackedMap(const shapeton::Graph & graph)
{
  return shapeton::MakePackedMap(graphtest::AnyMap(graph), shapeton::Augmentation::Ring);
}

std::vector<shapeton::PlaneMotion>
GeneratorsOf(const shapeton::SurfaceLayout & layout)
{
  std::vector<shapeton::PlaneMotion> generators;
  for (const int h : layout.CutHalfEdges())
  {
    generators.push_back(layout.DeckTransformationOf(h));
  }
  return generators;
}

std::vector<int>
FreelyReduced(const std::vector<int> & word)
{
  std::vector<int> reduced;
  for (const int letter : word)
  {
    if (!reduced.empty() && reduced.back() == -letter)
    {
      reduced.pop_back();
    }
    else
    {
      reduced.push_back(letter);
    }
  }
  return reduced;
}

std::vector<int>
Commutators(const std::vector<std::vector<int>> & words)
{
  std::vector<int> product;
  const auto       append = [&product](std::vector<int> word, bool isInverse) {
    if (isInverse)
    {
      std::reverse(word.begin(), word.end());
    }
    for (const int letter : word)
    {
      product.push_back(isInverse ? -letter : letter);
    }
  };
  for (std::size_t i = 0; i < words.size(); i += 2)
  {
    append(words[i], false);
    append(words[i + 1], false);
    append(words[i], true);
    append(words[i + 1], true);
  }
  return product;
}
} // namespace

TEST(SurfaceLayout, AGridOfSquaresOnTheTorusHasEqualCirclesAndARectangularLattice)
{
  const shapeton::CombinatorialMap map = shapeton::TorusGridMap(5, 7);
  const shapeton::CirclePacking    packing = shapeton::PackCircles(map, shapeton::FlowGeometry::Euclidean);
  EXPECT_LE(packing.residual, 1e-12);
  for (const double radius : packing.nodeRadii)
  {
    EXPECT_NEAR(radius, 1.0, 1e-12);
  }
  const shapeton::SurfaceLayout layout(map, packing);
  const auto                    generators = GeneratorsOf(layout);
  ASSERT_EQ(generators.size(), 2U);
  const auto lattice = shapeton::ReducedLattice(generators[0].b, generators[1].b);
  EXPECT_NEAR(std::abs(lattice[0]), 10.0, 1e-11);
  EXPECT_NEAR(std::abs(lattice[1]), 14.0, 1e-11);
  EXPECT_NEAR((std::conj(lattice[0]) * lattice[1]).real(), 0.0, 1e-10);
  EXPECT_LE(shapeton::WordResidual(generators, layout.Word()), 1e-11);
}

TEST(SurfaceLayout, AGridOfTrianglesOnTheTorusHasTheHexagonalPacking)
{
  const shapeton::CombinatorialMap map = shapeton::TorusGridMap(6, 6, true);
  const shapeton::CirclePacking    packing = shapeton::PackCircles(map, shapeton::FlowGeometry::Euclidean);
  const shapeton::SurfaceLayout    layout(map, packing);
  const auto                       generators = GeneratorsOf(layout);
  const auto                       lattice = shapeton::ReducedLattice(generators[0].b, generators[1].b);
  const std::complex<double>       ratio = lattice[1] / lattice[0];
  EXPECT_NEAR(std::abs(ratio), 1.0, 1e-12);
  EXPECT_NEAR(std::abs(ratio.real()), 0.5, 1e-12);
  for (const double radius : packing.faceRadii)
  {
    EXPECT_NEAR(radius, packing.nodeRadii[0] / std::sqrt(3.0), 1e-12); // the incircle of three equal circles
  }
}

TEST(SurfaceLayout, DeckTransformationsOfHyperbolicSurfacesObeyTheirRelation)
{
  for (const shapeton::Graph & graph :
       { shapeton::CompleteGraph(6), shapeton::GeneralizedPetersenGraph(5, 2), shapeton::HypercubeGraph(4) })
  {
    const shapeton::PackedMap packed = AnyPackedMap(graph);
    const int                 genus = packed.map.Genus();
    ASSERT_GE(genus, 2);
    const shapeton::CirclePacking packing = shapeton::PackCircles(packed.map, shapeton::FlowGeometry::Hyperbolic);
    EXPECT_LE(packing.residual, 1e-12);
    double area = 0.0;
    for (int h = 0; h < packed.map.HalfEdges(); ++h)
    {
      const double node = packing.nodeRadii[packed.map.Node(h)];
      const double face = packing.faceRadii[packed.map.Face(h)];
      area += pi - 2.0 * shapeton::HalfKiteAngle(packing.geometry, node, face) -
              2.0 * shapeton::HalfKiteAngle(packing.geometry, face, node);
    }
    EXPECT_NEAR(area, 4.0 * pi * (genus - 1), 1e-9);
    const shapeton::SurfaceLayout layout(packed.map, packing);
    EXPECT_EQ(layout.CutHalfEdges().size(), 2U * genus);
    EXPECT_EQ(layout.Word().size(), 4U * genus);
    const auto words = shapeton::CanonicalWords(layout.Word());
    EXPECT_EQ(words.size(), 2U * genus);
    EXPECT_EQ(FreelyReduced(Commutators(words)), layout.Word());
    const shapeton::DeckRelation relation = shapeton::RefineDeckRelation(GeneratorsOf(layout), layout.Word(), words);
    EXPECT_LE(relation.givenResidual, 1e-8);
    const std::vector<int> centered = shapeton::CenteredWord(GeneratorsOf(layout), layout.Word());
    EXPECT_TRUE(std::is_permutation(centered.begin(), centered.end(), layout.Word().begin()));
    EXPECT_LE(shapeton::WordResidual(GeneratorsOf(layout), centered), 1e-8);
    EXPECT_LE(relation.residual, 1e-8);
    EXPECT_LE(relation.canonicalResidual, 1e-100);
    for (std::size_t k = 0; k < relation.generators.size(); ++k)
    {
      const shapeton::PlaneMotion given = layout.DeckTransformationOf(layout.CutHalfEdges()[k]);
      EXPECT_NEAR(std::min(std::abs(given.a - relation.generators[k].a), std::abs(given.a + relation.generators[k].a)),
                  0.0,
                  1e-10 * std::abs(given.a));
    }
  }
}

TEST(SurfaceLayout, FarDeckTransformationsStayWhatTheyAre)
{
  // After rounding, |a|^2 - |b|^2 is no longer 1.
  for (const double length : { 1.0, 30.0, 60.0 })
  {
    for (const double angle : { 0.3, 1.1, 2.9 })
    {
      const shapeton::PlaneMotion far = shapeton::PlaneMotion::Rotation(shapeton::FlowGeometry::Hyperbolic, angle) *
                                        shapeton::PlaneMotion::Translation(shapeton::FlowGeometry::Hyperbolic, length);
      const shapeton::DeckRelation relation = shapeton::RefineDeckRelation({ far }, { 1 }, {}); // no relation to refine
      ASSERT_EQ(relation.generators.size(), 1U);
      EXPECT_LE(std::abs(relation.generators[0].a - far.a), 1e-15 * std::abs(far.a));
      EXPECT_LE(std::abs(relation.generators[0].b - far.b), 1e-15 * std::abs(far.b));
      EXPECT_FALSE(relation.isRefined);
    }
  }
}

TEST(SurfaceLayout, TheUniversalCoverIsMadeOfDifferentCopies)
{
  const shapeton::PackedMap     packed = AnyPackedMap(shapeton::CompleteGraph(6));
  const shapeton::CirclePacking packing = shapeton::PackCircles(packed.map, shapeton::FlowGeometry::Hyperbolic);
  const shapeton::SurfaceLayout layout(packed.map, packing);
  const std::vector<shapeton::PlaneMotion> copies = shapeton::UniversalCover(GeneratorsOf(layout), 40);
  ASSERT_EQ(copies.size(), 40U);
  EXPECT_NEAR(std::abs(copies[0](0.0)), 0.0, 1e-15);
  const double radius = packing.nodeRadii[packed.map.Node(layout.CutHalfEdges()[0])];
  for (std::size_t i = 0; i < copies.size(); ++i)
  {
    EXPECT_GE(i == 0 ? 0.0 : std::abs(copies[i](0.0)), i == 0 ? 0.0 : std::abs(copies[i - 1](0.0)) - 1e-12);
    for (std::size_t j = 0; j < i; ++j)
    {
      EXPECT_GT(std::abs((copies[i].Inverse() * copies[j])(0.0)), std::tanh(0.1 * radius));
    }
  }
}

TEST(SurfaceLayout, AWordOfASphereOrOfOneSidedSurfacesIsRefused)
{
  EXPECT_THROW(shapeton::CanonicalWords({ 1, 1 }), std::invalid_argument);
  EXPECT_THROW(shapeton::CanonicalWords({ 1, 2, -1, 2 }), std::invalid_argument);
  EXPECT_EQ(shapeton::CanonicalWords({ 1, 2, -1, -2 }), (std::vector<std::vector<int>>{ { 1 }, { 2 } }));
}
