#include "Overlaps.h"

#include <numeric>

namespace
{
double
Pairs(double members)
{
  return 0.5 * members * (members - 1.0);
}

/** Members of each part of the second partition. */
std::map<int, double>
MembersOfSecond(const Overlaps & overlaps)
{
  std::map<int, double> members;
  for (const auto & [first, counts] : overlaps)
  {
    for (const auto & [second, count] : counts)
    {
      members[second] += count;
    }
  }
  return members;
}

double
MembersOf(const std::map<int, double> & counts)
{
  return std::accumulate(
    counts.begin(), counts.end(), 0.0, [](double sum, const auto & count) { return sum + count.second; });
}
} // namespace

std::map<int, BestFit>
BestFits(const Overlaps & overlaps)
{
  const std::map<int, double> membersOfSecond = MembersOfSecond(overlaps);
  std::map<int, BestFit>      fits;
  for (const auto & [first, counts] : overlaps)
  {
    BestFit & fit = fits[first];
    fit.members = MembersOf(counts);
    for (const auto & [second, count] : counts)
    {
      const double dice = 2.0 * count / (fit.members + membersOfSecond.at(second));
      fit = dice > fit.dice ? BestFit{ fit.members, second, dice } : fit;
    }
  }
  return fits;
}

double
AdjustedRandIndex(const Overlaps & overlaps)
{
  double together = 0.0, inFirst = 0.0, inSecond = 0.0, all = 0.0;
  for (const auto & [first, counts] : overlaps)
  {
    for (const auto & [second, count] : counts)
    {
      together += Pairs(count);
    }
    inFirst += Pairs(MembersOf(counts));
    all += MembersOf(counts);
  }
  for (const auto & [second, count] : MembersOfSecond(overlaps))
  {
    inSecond += Pairs(count);
  }
  const double byChance = inFirst * inSecond / Pairs(all);
  const double most = 0.5 * (inFirst + inSecond);
  return most > byChance ? (together - byChance) / (most - byChance) : 0.0;
}
