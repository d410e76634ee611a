#ifndef Overlaps_h
#define Overlaps_h

#include <cstddef>
#include <map>

/** Number of common members of the parts of two partitions. */
using Overlaps = std::map<int, std::map<int, double>>;

/** Overlaps of the labels of voxels. */
template <typename TFirst, typename TSecond>
Overlaps
OverlapsOf(const TFirst * first, const TSecond * second, std::size_t voxels)
{
  Overlaps overlaps;
  for (std::size_t i = 0; i < voxels; ++i)
  {
    overlaps[static_cast<int>(first[i])][static_cast<int>(second[i])] += 1.0;
  }
  return overlaps;
}

/** The part of the second partition that fits a part of the first one best. */
struct BestFit
{
  double members{ 0.0 }; ///< of the part of the first partition
  int    part{ 0 };
  double dice{ 0.0 };
};

/** For each part of the first partition. */
std::map<int, BestFit>
BestFits(const Overlaps & overlaps);

/** Agreement of two partitions: 1 for identical partitions, 0 on average for random ones (Hubert and Arabie 1985); 0 if
 * one has a single part. */
double
AdjustedRandIndex(const Overlaps & overlaps);

#endif
