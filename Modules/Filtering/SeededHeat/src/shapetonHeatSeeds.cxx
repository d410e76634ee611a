#include "shapetonHeatSeeds.h"

#include "shapetonExceptions.h"
#include "shapetonVoxelRuns.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <vector>

namespace shapeton
{
namespace
{
SeedImage::Pointer
NewSeeds(const itk::ImageBase<3> * image)
{
  auto seeds = SeedImage::New();
  seeds->CopyInformation(image);
  seeds->SetRegions(image->GetLargestPossibleRegion());
  seeds->Allocate(true);
  return seeds;
}

VoxelGrid
GridOf(const itk::ImageBase<3> * image)
{
  const auto size = image->GetLargestPossibleRegion().GetSize();
  return { static_cast<int>(size[0]), static_cast<int>(size[1]), static_cast<int>(size[2]) };
}

/** Marks the voxels of one markups node. */
class SeedPen
{
public:
  SeedPen(SeedImage * seeds, const Markup & markup, unsigned short label)
    : m_Seeds(seeds), m_Markup(markup), m_Label(label)
  {}

  void
  MarkPoint(std::size_t number)
  {
    this->Mark(m_Markup.points[number], number);
  }

  /** The voxels of the segment between two points: the midpoint of two consecutive face crossings is in the voxel
   * between these faces. */
  void
  MarkPiece(std::size_t from, std::size_t to)
  {
    this->MarkPoint(from);
    this->MarkPoint(to);
    const Eigen::Vector3d     a = m_Markup.points[from];
    const Eigen::Vector3d     b = m_Markup.points[to];
    const std::vector<double> crossings = this->CrossingsOf(a, b);
    for (std::size_t i = 1; i < crossings.size(); ++i)
    {
      if (crossings[i] - crossings[i - 1] > 1e-9)
      {
        this->Mark(a + 0.5 * (crossings[i - 1] + crossings[i]) * (b - a), to);
      }
    }
  }

private:
  Eigen::Vector3d
  IndexOf(const Eigen::Vector3d & place) const
  {
    SeedImage::PointType point;
    std::copy_n(place.data(), 3, point.begin());
    itk::ContinuousIndex<double, 3> index;
    m_Seeds->TransformPhysicalPointToContinuousIndex(point, index);
    return Eigen::Vector3d(index.GetDataPointer());
  }

  /** 0, 1, and the crossings of voxel faces, which are halfway between indices, from a to b; ascending. */
  std::vector<double>
  CrossingsOf(const Eigen::Vector3d & a, const Eigen::Vector3d & b) const
  {
    const Eigen::Vector3d from = this->IndexOf(a);
    const Eigen::Vector3d along = this->IndexOf(b) - from;
    std::vector<double>   crossings{ 0.0, 1.0 };
    for (int axis = 0; axis < 3; ++axis)
    {
      const double low = std::min(from[axis], from[axis] + along[axis]);
      const double high = std::max(from[axis], from[axis] + along[axis]);
      for (double face = std::floor(low + 0.5) + 0.5; face < high; face += 1.0)
      {
        crossings.push_back((face - from[axis]) / along[axis]);
      }
    }
    std::sort(crossings.begin(), crossings.end());
    return crossings;
  }

  std::string
  NameOf(std::size_t number) const
  {
    return "point " + std::to_string(number + 1) + " of the markup \"" + m_Markup.name + '"';
  }

  void
  Mark(const Eigen::Vector3d & place, std::size_t number)
  {
    SeedImage::PointType point;
    std::copy_n(place.data(), 3, point.begin());
    SeedImage::IndexType index;
    if (!m_Seeds->TransformPhysicalPointToIndex(point, index))
    {
      throw InputError(NameOf(number) + " lies outside the volume; place it on the volume that is segmented");
    }
    unsigned short & voxel = m_Seeds->GetPixel(index);
    if (voxel != 0 && voxel != m_Label)
    {
      throw InputError(NameOf(number) + " lies in a voxel that is already a seed of label " + std::to_string(voxel) +
                       "; a voxel can have only one label");
    }
    voxel = m_Label;
  }

  SeedImage *          m_Seeds;
  const Markup &       m_Markup;
  const unsigned short m_Label;
};

/** Marks a set of voxels without its border; all of them if the border is the whole set. */
void
MarkInside(const VoxelGrid &                grid,
           const std::vector<std::size_t> & voxels,
           const std::vector<int> &         part,
           int                              of,
           unsigned short                   label,
           unsigned short *                 seeds)
{
  std::vector<std::size_t> inside;
  std::copy_if(voxels.begin(), voxels.end(), std::back_inserter(inside), [&](std::size_t voxel) {
    bool isInside = true;
    ForEachNeighbor(grid, voxel, [&](std::size_t neighbor) { isInside &= part[neighbor] == of; });
    return isInside;
  });
  for (const std::size_t voxel : inside.empty() ? voxels : inside)
  {
    seeds[voxel] = label;
  }
}

/** The voxels of each label from 1 to `number`. */
std::vector<std::vector<std::size_t>>
VoxelsOf(const std::vector<int> & part, int number)
{
  std::vector<std::vector<std::size_t>> voxels(static_cast<std::size_t>(number));
  for (std::size_t i = 0; i < part.size(); ++i)
  {
    if (part[i] > 0)
    {
      voxels[static_cast<std::size_t>(part[i]) - 1].push_back(i);
    }
  }
  return voxels;
}

/** The part, 1, 2, ..., of each voxel of one class: the class itself, or its components. */
std::vector<int>
PartsOfClass(const VoxelGrid & grid, const unsigned short * classes, int value, bool byComponent, int & number)
{
  const auto       isIn = [&](std::size_t voxel) { return classes[voxel] == value; };
  std::vector<int> part(grid.NumberOfVoxels(), 0);
  const VoxelRuns  runs = CollectRuns(grid, isIn);
  const RunLabels  labels = byComponent ? LabelRuns(runs) : RunLabels{ std::vector<int>(runs.runs.size(), 1), 1 };
  for (int k = 0; k < grid.size[2]; ++k)
  {
    for (int j = 0; j < grid.size[1]; ++j)
    {
      for (std::size_t r = runs.firstOfRow[runs.Row(j, k)]; r < runs.firstOfRow[runs.Row(j, k) + 1]; ++r)
      {
        std::fill(part.begin() + static_cast<std::ptrdiff_t>(grid.Index(runs.runs[r].begin, j, k)),
                  part.begin() + static_cast<std::ptrdiff_t>(grid.Index(runs.runs[r].end - 1, j, k)) + 1,
                  labels.ofRun[r]);
      }
    }
  }
  number = runs.runs.empty() ? 0 : labels.number;
  return part;
}

std::vector<int>
ChosenClasses(const SeedImage * classes, const ClassSeeds & choice)
{
  const unsigned short * const begin = classes->GetBufferPointer();
  const std::set<int>          present(begin, begin + classes->GetLargestPossibleRegion().GetNumberOfPixels());
  for (const int value : choice.classes)
  {
    if (present.count(value) == 0)
    {
      throw InputError("class " + std::to_string(value) + " has no voxel; choose classes of the label map");
    }
  }
  std::vector<int> chosen = choice.classes;
  if (chosen.empty())
  {
    std::copy_if(present.begin(), present.end(), std::back_inserter(chosen), [](int value) { return value != 0; });
  }
  return chosen;
}
} // namespace

SeedImage::Pointer
SeedsOfVolume(const Volume & volume, const std::string & path, const itk::ImageBase<3> * image)
{
  if (!HaveSameGrid(image, volume.image))
  {
    throw InputError(path + ": the labels differ in size or position from the volume; use labels of that volume");
  }
  const auto        seeds = NewSeeds(image);
  const std::size_t number = image->GetLargestPossibleRegion().GetNumberOfPixels();
  for (std::size_t i = 0; i < number; ++i)
  {
    const float value = volume.image->GetBufferPointer()[i];
    if (!(value >= 0.0F && value <= 65535.0F) || value != std::floor(value))
    {
      throw InputError(path + ": labels must be whole numbers from 0 to 65535, found " + std::to_string(value));
    }
    seeds->GetBufferPointer()[i] = static_cast<unsigned short>(value);
  }
  return seeds;
}

SeedImage::Pointer
SeedsOfMarkups(const std::vector<Markup> & markups, const itk::ImageBase<3> * image)
{
  const auto     seeds = NewSeeds(image);
  unsigned short label = 0;
  for (const Markup & markup : markups)
  {
    SeedPen           pen(seeds, markup, ++label);
    const std::size_t number = markup.points.size();
    if (number == 0)
    {
      throw InputError("the markup \"" + markup.name + "\" has no point: label " + std::to_string(label) +
                       " would have no seed");
    }
    for (std::size_t i = 0; i < number; ++i)
    {
      pen.MarkPoint(i);
      if (markup.kind != Markup::Kind::Points && i > 0)
      {
        pen.MarkPiece(i - 1, i);
      }
    }
    if (markup.kind == Markup::Kind::ClosedCurve)
    {
      pen.MarkPiece(number - 1, 0);
    }
  }
  return seeds;
}

SeedImage::Pointer
SeedsOfClasses(const SeedImage * classes, const ClassSeeds & choice)
{
  RequireParameter(choice.components >= 0, "the parameter \"components\" must not be negative");
  const VoxelGrid grid = GridOf(classes);
  const auto      seeds = NewSeeds(classes);
  unsigned short  label = 0;
  for (const int value : ChosenClasses(classes, choice))
  {
    int              number = 0;
    const auto       part = PartsOfClass(grid, classes->GetBufferPointer(), value, choice.components > 0, number);
    const auto       voxels = VoxelsOf(part, number);
    std::vector<int> order(voxels.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return voxels[a].size() > voxels[b].size(); });
    order.resize(std::min<std::size_t>(order.size(), static_cast<std::size_t>(std::max(1, choice.components))));
    for (const int i : order)
    {
      MarkInside(grid, voxels[i], part, i + 1, ++label, seeds->GetBufferPointer());
    }
  }
  return seeds;
}
} // namespace shapeton
