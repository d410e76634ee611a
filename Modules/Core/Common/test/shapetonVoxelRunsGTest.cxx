#include "shapetonVoxelRuns.h"

#include "gtest/gtest.h"

#include <cstdlib>
#include <random>

namespace shapeton
{
void
PrintTo(VoxelContact contact, std::ostream * stream)
{
  *stream << (contact == VoxelContact::Face          ? "Face"
              : contact == VoxelContact::FaceInSlice ? "FaceInSlice"
                                                     : "FaceOrEdge");
}
} // namespace shapeton

namespace
{
using shapeton::VoxelContact;
using shapeton::VoxelGrid;

class VoxelRunsOf : public testing::TestWithParam<VoxelContact>
{
protected:
  std::vector<char>
  RandomMask(double share)
  {
    std::vector<char> mask(m_Grid.NumberOfVoxels());
    for (char & voxel : mask)
    {
      voxel = m_Random() < share * 4294967296.0 ? 1 : 0;
    }
    return mask;
  }

  bool
  AreNeighbors(std::size_t p, std::size_t q) const
  {
    const auto a = m_Grid.Voxel(p);
    const auto b = m_Grid.Voxel(q);
    const int  d[3] = { std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2]) };
    const int  steps = d[0] + d[1] + d[2];
    const bool isEdge = steps == 2 && d[0] < 2 && d[1] < 2 && d[2] < 2;
    return (steps == 1 && (GetParam() != VoxelContact::FaceInSlice || d[2] == 0)) ||
           (GetParam() == VoxelContact::FaceOrEdge && isEdge);
  }

  /** Reference labels by comparing all pairs, in the order of the first voxels. */
  std::vector<int>
  BruteForce(const std::vector<char> & mask) const
  {
    std::vector<int> labels(mask.size(), 0);
    int              number = 0;
    for (std::size_t first = 0; first < mask.size(); ++first)
    {
      if (!mask[first] || labels[first] != 0)
      {
        continue;
      }
      std::vector<std::size_t> reached{ first };
      labels[first] = ++number;
      for (std::size_t n = 0; n < reached.size(); ++n)
      {
        for (std::size_t q = 0; q < mask.size(); ++q)
        {
          if (mask[q] && labels[q] == 0 && this->AreNeighbors(reached[n], q))
          {
            labels[q] = number;
            reached.push_back(q);
          }
        }
      }
    }
    return labels;
  }

  VoxelGrid    m_Grid{ 9, 7, 5 };
  std::mt19937 m_Random{ 3 };
};
} // namespace

TEST_P(VoxelRunsOf, ComponentsAreThoseOfBruteForce)
{
  for (const double share : { 0.0, 0.1, 0.3, 0.5, 0.8, 1.0 })
  {
    const auto mask = this->RandomMask(share);
    const auto expected = this->BruteForce(mask);
    const auto set = shapeton::CollectRuns(m_Grid, [&](std::size_t p) { return mask[p] != 0; });
    const auto labels = shapeton::LabelRuns(set, GetParam());
    for (std::size_t p = 0; p < mask.size(); ++p)
    {
      const auto v = m_Grid.Voxel(p);
      const auto run = set.Find(v[0], v[1], v[2]);
      ASSERT_EQ(run >= 0, mask[p] != 0);
      ASSERT_EQ(run >= 0 ? labels.ofRun[run] : 0, expected[p]);
    }
    EXPECT_EQ(labels.number, *std::max_element(expected.begin(), expected.end()));
  }
}

TEST_P(VoxelRunsOf, RunsThatTakeNoPartAreAsIfTheyWereNotThere)
{
  const auto              mask = this->RandomMask(0.6);
  const auto              set = shapeton::CollectRuns(m_Grid, [&](std::size_t p) { return mask[p] != 0; });
  const auto              part = this->RandomMask(0.5);
  const std::vector<char> use(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(set.runs.size()));
  std::vector<char>       used(mask.size(), 0);
  shapeton::ForEachRun(set, [&](std::size_t r, int j, int k) {
    for (int i = set.runs[r].begin; i < set.runs[r].end && use[r]; ++i)
    {
      used[m_Grid.Index(i, j, k)] = 1;
    }
  });
  const auto expected = this->BruteForce(used);
  const auto labels = shapeton::LabelRuns(set, GetParam(), use);
  shapeton::ForEachRun(set, [&](std::size_t r, int j, int k) {
    EXPECT_EQ(labels.ofRun[r], expected[m_Grid.Index(set.runs[r].begin, j, k)]);
  });
}

INSTANTIATE_TEST_SUITE_P(Contacts,
                         VoxelRunsOf,
                         testing::Values(VoxelContact::Face, VoxelContact::FaceInSlice, VoxelContact::FaceOrEdge));

TEST(VoxelRuns, OverlapsAreCountedInColumns)
{
  const std::vector<char> mask{ 1, 1, 1, 0, 1, 1, 0, 1, 1, 0, 1, 0 }; // two rows of six voxels
  const auto              set = shapeton::CollectRuns(VoxelGrid(6, 2, 1), [&](std::size_t p) { return mask[p] != 0; });
  std::vector<std::array<int, 3>> found;
  shapeton::ForEachOverlap(set, 0, 1, [&](std::size_t r, std::size_t s, int overlap) {
    found.push_back({ { static_cast<int>(r), static_cast<int>(s), overlap } });
  });
  EXPECT_EQ(found, (std::vector<std::array<int, 3>>{ { { 0, 2, 2 } }, { { 1, 3, 1 } } }));
}
