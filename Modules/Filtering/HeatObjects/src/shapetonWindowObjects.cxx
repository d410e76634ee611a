#include "shapetonWindowObjects.h"

#include "shapetonExceptions.h"
#include "shapetonParallelFor.h"
#include "shapetonImageGrid.h"
#include "shapetonWindowMerge.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

namespace shapeton
{
namespace
{
constexpr double NearlyAll = 0.9; // borders of one object differ between windows
constexpr double Few = 0.1;       // so its voxels outside of an object that contains it are few
/** Nested objects count as the same one if the smaller has at least this fraction of the larger one's voxels. */
constexpr double SameObject = 0.5;
/** Objects inside another one with a smaller fraction of its voxels are separate objects, not its core. */
constexpr double LeastPart = 0.1;

using Objects = std::vector<HeatObject>;

/** Calls f(object) for an object, numbered from 1, and those that contain it. */
template <typename TFunction>
void
ForEachAround(const Objects & objects, int object, const TFunction & f)
{
  for (; object > 0; object = objects[object - 1].parent)
  {
    f(object);
  }
}

/** For each object of one list, the number of voxels shared with objects of the other list; index 0 stands for none. */
using Shared = std::vector<std::map<int, double>>;

Shared
SharedVoxels(const HeatObjectList & a, const HeatObjectList & b)
{
  Shared             ofLabels(a.objects.size() + 1);
  const auto         voxels = a.labels->GetBufferedRegion().GetNumberOfPixels();
  const auto * const inA = a.labels->GetBufferPointer();
  const auto * const inB = b.labels->GetBufferPointer();
  for (std::size_t i = 0; i < voxels; ++i)
  {
    if (inA[i] > 0 && inB[i] > 0)
    {
      ofLabels[inA[i]][inB[i]] += 1.0;
    }
  }
  Shared shared(ofLabels.size());
  for (std::size_t label = 1; label < ofLabels.size(); ++label)
  {
    for (const auto & [other, count] : ofLabels[label])
    {
      ForEachAround(a.objects, static_cast<int>(label), [&, other = other, count = count](int ofA) {
        ForEachAround(b.objects, other, [&](int ofB) { shared[ofA][ofB] += count; });
      });
    }
  }
  return shared;
}

/** How an object of a later window relates to the listed objects. */
struct Relation
{
  int  around{ 0 };         ///< the smallest listed object that contains it, from 1; 0: none
  bool isListed{ false };   ///< shows a listed object
  bool isCrossing{ false }; ///< crosses the border of a listed object
};

Relation
Relate(const HeatObject & object, const std::map<int, double> & shared, const Objects & listed)
{
  Relation     relation;
  const double voxels = static_cast<double>(object.voxels);
  for (const auto & [number, both] : shared) // the last one that contains it is the smallest
  {
    const double other = static_cast<double>(listed[number - 1].voxels);
    const double smaller = std::min(voxels, other);
    const bool   isNested = both >= NearlyAll * smaller;
    relation.isListed = relation.isListed || (isNested && smaller >= SameObject * std::max(voxels, other));
    relation.isCrossing = relation.isCrossing || (!isNested && both > Few * smaller);
    relation.around = isNested && voxels <= other ? number : relation.around;
  }
  return relation;
}

/** Which objects are cores. A core is a large part of a listed object that is its only one or contains all others. */
std::vector<bool>
FindCores(const Objects & found, const std::vector<Relation> & relations, const Objects & listed)
{
  const auto isLargePart = [&](int object, int around) {
    return around > 0 && relations[object - 1].around == around &&
           static_cast<double>(found[object - 1].voxels) >= LeastPart * static_cast<double>(listed[around - 1].voxels);
  };
  std::vector<bool> isDivided(found.size(), false); // contains a smaller large part
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    if (found[i].parent > 0 && isLargePart(static_cast<int>(i + 1), relations[i].around))
    {
      isDivided[found[i].parent - 1] =
        isDivided[found[i].parent - 1] || isLargePart(found[i].parent, relations[i].around);
    }
  }
  std::vector<int> smallestParts(listed.size(), 0); // of each listed object
  std::vector<int> partsInside(found.size(), 0);
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    const int around = relations[i].around;
    if (isLargePart(static_cast<int>(i + 1), around) && !isDivided[i])
    {
      ++smallestParts[around - 1];
      ForEachAround(found, static_cast<int>(i + 1), [&](int object) { ++partsInside[object - 1]; });
    }
  }
  std::vector<bool> areCores(found.size(), false);
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    const int around = relations[i].around;
    areCores[i] = isLargePart(static_cast<int>(i + 1), around) && smallestParts[around - 1] == partsInside[i];
  }
  return areCores;
}

/** Two lists merged into one: all objects of the first, and some of the second, with their new numbers. */
struct Merged
{
  Objects                              objects;
  std::vector<std::vector<VoxelRange>> ranges;
  std::vector<int> ofFirst, ofSecond; ///< new number of each old one; that of the next larger one if it is left out
};

/** Numbers the objects by descending size; for ties, objects of the first list come first. */
Merged
Number(const HeatObjectList & list, const HeatObjectList & found, const std::vector<bool> & isNew)
{
  struct Source
  {
    const HeatObject *              object;
    const std::vector<VoxelRange> * ranges;
    int *                           number;
  };
  const Objects & first = list.objects;
  const Objects & second = found.objects;
  Merged          merged;
  merged.ofFirst.assign(first.size() + 1, 0);
  merged.ofSecond.assign(second.size() + 1, 0);
  std::vector<Source> sources;
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    sources.push_back({ &first[i], &list.ranges[i], &merged.ofFirst[i + 1] });
  }
  for (std::size_t i = 0; i < second.size(); ++i)
  {
    if (isNew[i])
    {
      sources.push_back({ &second[i], &found.ranges[i], &merged.ofSecond[i + 1] });
    }
  }
  std::stable_sort(sources.begin(), sources.end(), [](const Source & a, const Source & b) {
    return a.object->voxels > b.object->voxels;
  });
  constexpr std::size_t most = std::numeric_limits<HeatObjectList::LabelImage::PixelType>::max();
  sources.resize(std::min(sources.size(), most));
  for (const Source & source : sources)
  {
    merged.objects.push_back(*source.object);
    merged.ranges.push_back(*source.ranges);
    *source.number = static_cast<int>(merged.objects.size());
  }
  for (std::size_t i = 0; i < second.size(); ++i)
  {
    if (merged.ofSecond[i + 1] == 0)
    {
      merged.ofSecond[i + 1] = merged.ofSecond[second[i].parent];
    }
  }
  return merged;
}

/** Sets the parents: larger objects have smaller numbers, so the parent is the enclosing object with the greatest
 * number. */
void
SetParents(const HeatObjectList &        first,
           const HeatObjectList &        second,
           const Shared &                sharedOfFirst,
           const std::vector<Relation> & relations,
           const std::vector<bool> &     isNew,
           Merged &                      merged)
{
  for (std::size_t i = 0; i < first.objects.size(); ++i)
  {
    const int number = merged.ofFirst[i + 1];
    int       parent = merged.ofFirst[first.objects[i].parent];
    for (const auto & [other, both] : sharedOfFirst[i + 1])
    {
      const bool isAround = isNew[other - 1] && merged.ofSecond[other] < number &&
                            both >= NearlyAll * static_cast<double>(first.objects[i].voxels);
      parent = isAround ? std::max(parent, merged.ofSecond[other]) : parent;
    }
    if (number > 0)
    {
      merged.objects[number - 1].parent = parent;
    }
  }
  for (std::size_t i = 0; i < second.objects.size(); ++i)
  {
    if (isNew[i] && merged.ofSecond[i + 1] > 0)
    {
      merged.objects[merged.ofSecond[i + 1] - 1].parent =
        std::max(merged.ofSecond[second.objects[i].parent], merged.ofFirst[relations[i].around]);
    }
  }
}

} // namespace

double
AddWindowObjects(const HeatObjectList & found, HeatObjectList & list)
{
  const Shared          shared = SharedVoxels(found, list);
  std::vector<Relation> relations;
  for (std::size_t i = 0; i < found.objects.size(); ++i)
  {
    relations.push_back(Relate(found.objects[i], shared[i + 1], list.objects));
  }
  std::vector<bool> isNew = FindCores(found.objects, relations, list.objects);
  for (std::size_t i = 0; i < isNew.size(); ++i)
  {
    isNew[i] = !isNew[i] && !relations[i].isListed && !relations[i].isCrossing;
  }
  Merged merged = Number(list, found, isNew);
  SetParents(list, found, SharedVoxels(list, found), relations, isNew, merged);
  auto * const       labels = list.labels->GetBufferPointer();
  const auto * const others = found.labels->GetBufferPointer();
  ParallelForBlocks(list.labels->GetBufferedRegion().GetNumberOfPixels(), [&](std::size_t i) {
    labels[i] = static_cast<unsigned short>(std::max(merged.ofFirst[labels[i]], merged.ofSecond[others[i]]));
  });
  list.objects = std::move(merged.objects);
  list.ranges = std::move(merged.ranges);
  double added = 0.0;
  for (std::size_t i = 0; i < isNew.size(); ++i)
  {
    added += isNew[i] ? found.objects[i].probability : 0.0;
  }
  return added;
}

double
SumOfProbabilities(const std::vector<HeatObject> & objects)
{
  return std::accumulate(objects.begin(), objects.end(), 0.0, [](double sum, const HeatObject & object) {
    return sum + object.probability;
  });
}

HeatObjectList
FindWindowObjects(const std::vector<const itk::Image<float, 3> *> & heats,
                  const HeatObjectOptions &                         options,
                  const Progress &                                  progress)
{
  if (heats.empty())
  {
    throw ParameterError("objects need at least one heat volume");
  }
  HeatObjectList list;
  for (std::size_t window = 0; window < heats.size(); ++window)
  {
    if (!HaveSameGrid(heats[window], heats[0]))
    {
      throw InputError("the grid of heat volume " + std::to_string(window + 1) + " differs from that of the first one");
    }
    const double share = 1.0 / static_cast<double>(heats.size());
    auto         found = FindHeatObjects(
      { heats[window] }, options, progress.Part("Finding objects", window * share, (window + 1) * share));
    for (HeatObject & object : found.objects)
    {
      object.time = static_cast<int>(window);
    }
    if (window == 0)
    {
      list = std::move(found);
    }
    else
    {
      AddWindowObjects(found, list);
    }
  }
  return list;
}
} // namespace shapeton
