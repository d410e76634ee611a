#include "ObjectMeasures.h"
#include "Tables.h"

#include "shapetonCumulativeHeatDiffusionImageFilter.h"
#include "shapetonParallelFor.h"
#include "shapetonPhiloxStream.h"

#include <algorithm>
#include <map>

using namespace shapeton;

namespace
{
using Image = itk::Image<float, 3>;

constexpr int numberOfPoints = 200;

/** Counts and Dice coefficients of the objects of a list. */
class ListedObjects
{
public:
  ListedObjects(const HeatObjectList & list, const ReferenceParts & parts)
    : m_List(list), m_Parts(parts), m_Counts(list.objects.size())
  {
    ParallelFor(m_Counts.size(), [&](std::size_t i) { m_Counts[i] = CountsIn(list.ranges[i], parts); });
  }

  /** The object that a click selects; 0 for none. */
  int
  Clicked(std::size_t voxel) const
  {
    const int smallest = m_List.labels->GetBufferPointer()[voxel];
    return smallest > 0 ? ObjectOfClick(m_List, smallest) : 0;
  }

  double
  Dice(int part, int object) const
  {
    return object > 0 ? m_Parts.Dice(part, m_Counts[object - 1].data(), m_List.objects[object - 1].voxels) : 0.0;
  }

  bool
  IsWhole(int part, int object) const
  {
    return this->Dice(part, object) >= wholeObject;
  }

  /** Whether an object at the voxel is whole. */
  bool
  IsReached(int part, std::size_t voxel) const
  {
    int object = m_List.labels->GetBufferPointer()[voxel];
    while (object > 0 && !this->IsWhole(part, object))
    {
      object = m_List.objects[object - 1].parent;
    }
    return object > 0;
  }

private:
  const HeatObjectList &              m_List;
  const ReferenceParts &              m_Parts;
  std::vector<ReferenceParts::Counts> m_Counts;
};

PartMeasures
MeasurePart(int part, const ListedObjects & objects, const ReferenceParts & parts)
{
  PartMeasures measures;
  measures.part = part;
  const auto         depths = parts.DepthsOf(part);
  const auto         deepest = std::max_element(depths.squares.begin(), depths.squares.end()) - depths.squares.begin();
  std::map<int, int> clicks; // number by object
  int                right = 0;
  int                reached = 0;
  measures.deepestClick = objects.Dice(part, objects.Clicked(depths.voxels[deepest]));
  for (const std::size_t voxel : PointsIn(part, depths, numberOfPoints))
  {
    const int object = objects.Clicked(voxel);
    ++clicks[object];
    right += objects.IsWhole(part, object) ? 1 : 0;
    reached += objects.IsReached(part, voxel) ? 1 : 0;
  }
  const auto mostFrequent =
    std::max_element(clicks.begin(), clicks.end(), [](const auto & a, const auto & b) { return a.second < b.second; });
  measures.firstClick = ShareOf(right, numberOfPoints);
  measures.bestClimb = ShareOf(reached, numberOfPoints);
  measures.sameObject = ShareOf(mostFrequent->second, numberOfPoints);
  return measures;
}
} // namespace

Image::Pointer
AutomaticHeat(const Image * image)
{
  const auto filter = CumulativeHeatDiffusionImageFilter<Image>::New();
  filter->SetInput(image);
  filter->UseParameters(ChooseHeatParameters(VolumeView(image), filter->GetOptions()));
  filter->Update();
  return filter->GetOutput();
}

std::vector<PartMeasures>
MeasureParts(const HeatObjectTree & tree, const ReferenceParts & parts)
{
  const auto                list = tree.List(true);
  const ListedObjects       objects(list, parts);
  const auto                counts = CountsOfRegions(tree.GetTree(), parts);
  const auto &              regions = tree.GetTree().GetRegions();
  const std::size_t         labels = parts.GetTotals().size();
  std::vector<PartMeasures> measures;
  for (const int part : parts.GetLabels())
  {
    measures.push_back(MeasurePart(part, objects, parts));
    double & best = measures.back().bestRegion;
    for (std::size_t region = 0; region < regions.size(); ++region)
    {
      best = std::max(best, parts.Dice(part, &counts[region * labels], regions[region].NumberOfVoxels()));
    }
  }
  return measures;
}

std::vector<double>
CountsOfRegions(const PartitionTree & tree, const ReferenceParts & parts)
{
  const auto &        regions = tree.GetRegions();
  const std::size_t   labels = parts.GetTotals().size();
  std::vector<double> counts(regions.size() * labels, 0.0);
  for (std::size_t region = 0; region < regions.size(); ++region)
  {
    if (tree.IsBasin(static_cast<PartitionTree::Index>(region)))
    {
      for (auto i = regions[region].first; i < regions[region].end; ++i)
      {
        counts[region * labels + parts.LabelOf(tree.GetVoxels()[i])] += 1.0;
      }
    }
    if (regions[region].parent != region)
    {
      for (std::size_t label = 0; label < labels; ++label)
      {
        counts[regions[region].parent * labels + label] += counts[region * labels + label];
      }
    }
  }
  return counts;
}

std::vector<std::size_t>
PointsIn(int part, const ReferenceParts::Depths & depths, std::size_t number)
{
  constexpr std::uint32_t  purpose = 0x506f696eU;
  constexpr std::size_t    least = 20;
  std::vector<std::size_t> inner;
  for (float depth = 2.0F; depth >= 0.0F && inner.size() < least; depth -= 1.0F) // voxels
  {
    inner.clear();
    for (std::size_t i = 0; i < depths.voxels.size(); ++i)
    {
      if (depths.squares[i] > depth * depth)
      {
        inner.push_back(depths.voxels[i]);
      }
    }
  }
  PhiloxStream             stream(0, static_cast<std::uint32_t>(part), purpose);
  std::vector<std::size_t> points(number);
  std::generate(points.begin(), points.end(), [&] { return inner[stream.Below(static_cast<int>(inner.size()))]; });
  return points;
}
