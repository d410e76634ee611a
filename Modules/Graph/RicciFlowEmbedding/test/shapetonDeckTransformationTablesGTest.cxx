#include "shapetonSurfaceLayout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

// Tables 6.1 to 6.5 of the dissertation: deck transformations T(z) = e^{i theta} (z - z0) / (1 - conj(z0) z) of five
// graphs of genus 2 and 3, printed with six digits. The tables print the inverse of each, too.
namespace
{
struct Row
{
  double re;
  double im;
  double theta;
};

const std::vector<std::vector<Row>> tables{
  {
    { 0.554278, 0.784424, 2.13226 },
    { -0.595666, 0.638663, 1.16896 },
    { 0.763219, -0.536063, 1.67342 },
    { 0.92414, -0.274074, 2.21251 },
  },
  {
    { 0.473141, 0.793373, 1.68923 },
    { -0.0444407, 0.926901, 1.77595 },
    { -0.511646, -0.718428, 1.47841 },
    { 0.241374, -0.875041, 1.4262 },
  },
  {
    { -0.423878, 0.767216, 1.16253 },
    { -0.867863, 0.127443, 1.39665 },
    { 0.140488, -0.936178, 1.9649 },
    { 0.636244, -0.688274, 1.90233 },
  },
  {
    { -0.483681, -0.846774, 2.31836 },
    { -0.228992, -0.959415, 2.51752 },
    { 0.574592, -0.803201, 2.53001 },
    { 0.837867, -0.511424, 2.44972 },
    { 0.0897692, 0.93249, 1.59591 },
    { -0.705865, 0.527996, 1.34124 },
  },
  {
    { 0.684803, -0.664529, 1.69622 },
    { 0.911636, -0.204362, 1.81809 },
    { 0.277177, 0.927289, 2.24515 },
    { -0.13187, 0.967995, 2.29782 },
    { -0.954146, 0.186617, 2.30815 },
    { -0.919973, -0.315278, 2.16587 },
  },
};

shapeton::PlaneMotion
MotionOf(const Row & row)
{
  const std::complex<double> z0(row.re, row.im);
  const std::complex<double> turn = std::polar(1.0, 0.5 * row.theta) / std::sqrt(1.0 - std::norm(z0));
  return { shapeton::FlowGeometry::Hyperbolic, turn, -turn * z0 };
}

std::vector<shapeton::PlaneMotion>
GeneratorsOf(const std::vector<Row> & table)
{
  std::vector<shapeton::PlaneMotion> generators;
  std::transform(table.begin(), table.end(), std::back_inserter(generators), MotionOf);
  return generators;
}

/** The four letters of handle k, which alternate between its two generators, in each of eight orders. */
std::vector<std::vector<int>>
WordsOfHandle(int k)
{
  const int                     a = 2 * k + 1;
  const int                     b = 2 * k + 2;
  std::vector<std::vector<int>> words;
  for (const int first : { a, -a })
  {
    for (const int second : { b, -b })
    {
      words.push_back({ first, second, -first, -second });
      words.push_back({ second, first, -second, -first });
    }
  }
  return words;
}

/** The product of commutators, one per handle in any order after the first, that is closest to the identity. */
std::vector<int>
ClosestRelation(const std::vector<shapeton::PlaneMotion> & generators)
{
  const int        handles = static_cast<int>(generators.size()) / 2;
  std::vector<int> order(handles);
  std::iota(order.begin(), order.end(), 0);
  std::vector<int> best;
  double           least = 1e300;
  do
  {
    for (int choice = 0; choice < (handles == 2 ? 64 : 512); ++choice)
    {
      std::vector<int> word;
      for (int i = 0; i < handles; ++i)
      {
        const std::vector<int> part = WordsOfHandle(order[i])[(choice >> (3 * i)) & 7];
        word.insert(word.end(), part.begin(), part.end());
      }
      const double residual = shapeton::WordResidual(generators, word);
      if (residual < least)
      {
        least = residual;
        best = word;
      }
    }
  } while (std::next_permutation(order.begin() + 1, order.end()));
  return best;
}
} // namespace

TEST(DeckTransformationTables, ThePrintedGeneratorsObeyTheRelationOfTheirSurface)
{
  for (const std::vector<Row> & table : tables)
  {
    const std::vector<shapeton::PlaneMotion> generators = GeneratorsOf(table);
    const std::vector<int>                   word = ClosestRelation(generators);
    EXPECT_LT(shapeton::WordResidual(generators, word), 5e-3);
  }
}

TEST(DeckTransformationTables, RefinementChangesTheLastPrintedDigitsAlone)
{
  for (const std::vector<Row> & table : tables)
  {
    const std::vector<shapeton::PlaneMotion> generators = GeneratorsOf(table);
    const std::vector<int>                   word = ClosestRelation(generators);
    const shapeton::DeckRelation             relation =
      shapeton::RefineDeckRelation(generators, word, shapeton::CanonicalWords(word));
    EXPECT_TRUE(relation.isRefined);
    EXPECT_LT(relation.residual, 1e-11);
    EXPECT_LT(relation.canonicalResidual, 1e-250);
    for (std::size_t i = 0; i < generators.size(); ++i)
    {
      EXPECT_LT(std::abs((relation.generators[i].Inverse()(0.0)) - (generators[i].Inverse()(0.0))), 2e-4);
    }
  }
}
