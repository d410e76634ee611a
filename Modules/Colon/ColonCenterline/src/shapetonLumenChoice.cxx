#include "shapetonLumenChoice.h"

#include "shapetonPieceOrder.h"
#include "shapetonPlaceInWords.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shapeton
{
namespace
{
/** Maximum distance (mm) of a seed or start from the lumen. */
constexpr double farthestSeed = 30.0;

struct NearComponent
{
  int    component{ 0 };
  double distance{ std::numeric_limits<double>::infinity() };
};

NearComponent
FindNear(const LumenLabelImage * labels, const itk::Point<double, 3> & point)
{
  const auto          at = labels->TransformPhysicalPointToContinuousIndex<double>(point);
  itk::ImageRegion<3> around = labels->GetBufferedRegion();
  for (unsigned int a = 0; a < 3; ++a)
  {
    const double reach = farthestSeed / labels->GetSpacing()[a] + 1.0;
    const auto   first = static_cast<itk::IndexValueType>(std::floor(at[a] - reach));
    around.SetIndex(a, first);
    around.SetSize(a, static_cast<itk::SizeValueType>(2.0 * reach + 2.0));
  }
  NearComponent near;
  if (!around.Crop(labels->GetBufferedRegion()))
  {
    return near;
  }
  const itk::Index<3> first = around.GetIndex();
  const itk::Index<3> last = around.GetUpperIndex();
  itk::Index<3>       index;
  for (index[2] = first[2]; index[2] <= last[2]; ++index[2])
  {
    for (index[1] = first[1]; index[1] <= last[1]; ++index[1])
    {
      for (index[0] = first[0]; index[0] <= last[0]; ++index[0])
      {
        const int component = labels->GetPixel(index);
        if (component == 0)
        {
          continue;
        }
        itk::Point<double, 3> place;
        labels->TransformIndexToPhysicalPoint(index, place);
        const double distance = place.EuclideanDistanceTo(point);
        if (distance < near.distance)
        {
          near = { component, distance };
        }
      }
    }
  }
  return near;
}

void
Want(const LumenComponents &       components,
     const itk::Point<double, 3> & point,
     const std::string &           name,
     LumenChoice &                 choice)
{
  const NearComponent near = FindNear(components.labels, point);
  if (near.distance > farthestSeed)
  {
    throw InputError("the " + name + " " + PlaceInWords(point) + " is more than " +
                     std::to_string(std::lround(farthestSeed)) +
                     " mm from the lumen. Give a point in the colon, in LPS mm.");
  }
  choice.isUsed[near.component] = 1;
  choice.isWanted[near.component] = 1;
  choice.reasons[near.component].clear();
}

/** Diagonal of the bounding box, mm. */
double
ExtentOf(const LumenMask * lumen, const LumenComponent & component)
{
  double squared = 0.0;
  for (unsigned int a = 0; a < 3; ++a)
  {
    const double side = lumen->GetSpacing()[a] * (component.last[a] - component.first[a] + 1);
    squared += side * side;
  }
  return std::sqrt(squared);
}

/** Drops the smallest pieces if there are too many to order. */
void
LimitNumber(LumenChoice & choice)
{
  int used = 0;
  for (std::size_t c = 1; c < choice.isUsed.size(); ++c)
  {
    used += choice.isUsed[c];
  }
  for (std::size_t c = choice.isUsed.size() - 1; c > 0 && used > mostJoinPieces; --c)
  {
    if (choice.isUsed[c] && !choice.isWanted[c])
    {
      choice.isUsed[c] = 0;
      choice.reasons[c] = "more than " + std::to_string(mostJoinPieces) + " pieces are larger";
      --used;
    }
  }
  if (used > mostJoinPieces)
  {
    throw InputError("the seeds are in more than " + std::to_string(mostJoinPieces) +
                     " pieces of lumen. Give fewer seeds.");
  }
}

void
RequireSome(const LumenMask *              lumen,
            const LumenComponents &        components,
            const LumenChoice &            choice,
            const ColonCenterlineOptions & options)
{
  if (std::find(choice.isUsed.begin(), choice.isUsed.end(), 1) != choice.isUsed.end())
  {
    return;
  }
  const LumenComponent & largest = components.components.front();
  throw InputError("no piece of lumen is at least " + InTenths(options.minimumVolume) + " ml: the largest of " +
                   std::to_string(components.components.size()) + " is " + InTenths(largest.volume) + " ml at " +
                   PlaceInWords(PlaceOf(lumen, largest)) + ". Give a mask of the whole lumen.");
}
} // namespace

itk::Point<double, 3>
PlaceOf(const LumenMask * lumen, const LumenComponent & component)
{
  itk::ContinuousIndex<double, 3> middle;
  for (unsigned int a = 0; a < 3; ++a)
  {
    middle[a] = 0.5 * (component.first[a] + component.last[a]);
  }
  itk::Point<double, 3> place;
  lumen->TransformContinuousIndexToPhysicalPoint(middle, place);
  return place;
}

LumenChoice
ChooseLumen(const LumenMask * lumen, const LumenComponents & components, const ColonCenterlineOptions & options)
{
  const std::size_t number = components.components.size() + 1;
  LumenChoice       choice;
  choice.isUsed.assign(number, 0);
  choice.isWanted.assign(number, 0);
  choice.reasons.assign(number, "");
  for (std::size_t c = 1; c < number; ++c)
  {
    const LumenComponent & component = components.components[c - 1];
    const bool             isLong =
      component.volume >= 0.2 * options.minimumVolume && ExtentOf(lumen, component) >= options.minimumExtent;
    choice.isUsed[c] = component.volume >= options.minimumVolume || isLong;
    choice.reasons[c] = choice.isUsed[c] ? "" : "it is smaller than " + InTenths(options.minimumVolume) + " ml";
  }
  if (options.start)
  {
    Want(components, *options.start, "start", choice);
  }
  for (const auto & seed : options.seedPoint)
  {
    Want(components, seed, "seed point", choice);
  }
  RequireSome(lumen, components, choice, options);
  LimitNumber(choice);
  return choice;
}

bool
IsComplete(const LumenGrid & grid, const std::vector<char> & isUsed)
{
  std::vector<char> isMissing = isUsed;
  for (int node = 0; node < grid.NumberOfNodes(); ++node)
  {
    isMissing[grid.Component(node)] = 0;
  }
  return std::find(isMissing.begin(), isMissing.end(), 1) == isMissing.end();
}
} // namespace shapeton
