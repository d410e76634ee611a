#include "shapetonDisjointSets.h"

#include "gtest/gtest.h"

#include <cstdint>
#include <random>

namespace
{
/** Reference implementation: a label for each number; joining relabels all numbers. */
class BruteForce
{
public:
  explicit BruteForce(int number) : m_Labels(number) { std::iota(m_Labels.begin(), m_Labels.end(), 0); }
  int
  Find(int i) const
  {
    return m_Labels[i];
  }
  bool
  Relabel(int from, int to)
  {
    std::replace(m_Labels.begin(), m_Labels.end(), from, to);
    return from != to;
  }
  void
  Add()
  {
    m_Labels.push_back(static_cast<int>(m_Labels.size()));
  }

private:
  std::vector<int> m_Labels;
};
} // namespace

TEST(DisjointSets, JoinsAreThoseOfBruteForceAndTheLeastMemberStandsForAll)
{
  std::mt19937 random(1);
  for (const int number : { 1, 2, 10, 200 })
  {
    shapeton::DisjointSets<std::uint32_t> sets(number);
    BruteForce                            expected(number);
    for (int join = 0; join < number; ++join)
    {
      const int a = static_cast<int>(random() % number);
      const int b = static_cast<int>(random() % number);
      const int rootA = expected.Find(a);
      const int rootB = expected.Find(b);
      ASSERT_EQ(expected.Relabel(std::max(rootA, rootB), std::min(rootA, rootB)), sets.Join(a, b));
      for (int i = 0; i < number; ++i)
      {
        ASSERT_EQ(expected.Find(i), static_cast<int>(sets.Find(i)));
      }
    }
  }
}

TEST(DisjointSets, SetsThatGrowAreAbsorbedByTheOneThatIsNamedFirst)
{
  std::mt19937             random(2);
  shapeton::DisjointSets<> sets;
  BruteForce               expected(0);
  for (int number = 1; number <= 200; ++number)
  {
    expected.Add();
    ASSERT_EQ(sets.Add(), number - 1);
    const int keeper = static_cast<int>(random() % number);
    const int other = static_cast<int>(random() % number);
    ASSERT_EQ(expected.Relabel(expected.Find(other), expected.Find(keeper)), sets.Absorb(keeper, other));
    for (int i = 0; i < number; ++i)
    {
      ASSERT_EQ(expected.Find(i), sets.Find(i));
    }
  }
}
