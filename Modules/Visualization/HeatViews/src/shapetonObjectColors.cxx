#include "shapetonObjectColors.h"

#include "shapetonColorMap.h"
#include "shapetonCsvTable.h"
#include "shapetonExceptions.h"
#include "shapetonMappedImage.h"
#include "shapetonParallelFor.h"
#include "shapetonSliceMontage.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace shapeton
{
namespace
{
using ImageType = itk::Image<float, 3>;
using LabelImage = HeatObjectList::LabelImage;

/** Number of voxels with each label. */
std::vector<std::uint64_t>
CountLabels(const LabelImage * labels)
{
  std::vector<std::uint64_t> counts(std::numeric_limits<unsigned short>::max() + std::size_t{ 1 }, 0);
  const std::size_t          voxels = labels->GetBufferedRegion().GetNumberOfPixels();
  for (std::size_t voxel = 0; voxel < voxels; ++voxel)
  {
    ++counts[labels->GetBufferPointer()[voxel]];
  }
  return counts;
}

void
RequireObjects(const std::vector<std::uint64_t> & counts,
               const std::vector<ObjectColor> &   objects,
               const std::string &                name)
{
  for (const ObjectColor & object : objects)
  {
    const auto add = [&](std::uint64_t sum, int label) { return sum + counts[label]; };
    const auto voxels = std::accumulate(object.labels.begin(), object.labels.end(), std::uint64_t{ 0 }, add);
    if (voxels != object.voxels)
    {
      throw InputError(NameOfObject(object.number) + " has " + std::to_string(voxels) + " voxels in " + name +
                       ", but " + std::to_string(object.voxels) +
                       " in the transfer function: use the labels that HeatObjects has written with its page");
    }
  }
}

/** Index of the smallest object of each label; -1 for none. */
std::vector<int>
SmallestObjects(const std::vector<ObjectColor> & objects)
{
  std::vector<int> order(objects.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return objects[a].voxels > objects[b].voxels; });
  std::vector<int> smallest(std::numeric_limits<unsigned short>::max() + std::size_t{ 1 }, -1);
  for (const int object : order)
  {
    for (const int label : objects[object].labels)
    {
      smallest[label] = object;
    }
  }
  return smallest;
}

ShapeTransferFunction
ClassesOf(const ShapeTransferFunction & transferFunction, const std::vector<ObjectColor> & objects)
{
  auto       lines = transferFunction.GetLines();
  const auto legend = LegendOf(transferFunction);
  for (std::size_t line = 0; line < lines.size(); ++line)
  {
    lines[line].name = legend[line].text;
  }
  for (const ObjectColor & object : objects)
  {
    TransferFunctionLine line; // its range comes from OfClasses()
    line.color = object.color;
    line.opacity = object.opacity;
    line.name = NameOfObject(object.number);
    lines.push_back(line);
  }
  return ShapeTransferFunction::OfClasses(std::move(lines));
}
} // namespace

std::string
NameOfObject(int number)
{
  return "object " + std::to_string(number);
}

RGBColor
ColorOfObject(int number)
{
  return ClassColor(static_cast<unsigned int>(number));
}

ColoredClasses
ColorObjects(const ImageType *                heat,
             const ShapeTransferFunction &    lines,
             const LabelImage *               labels,
             const std::vector<ObjectColor> & objects,
             const std::string &              name)
{
  RequireObjects(CountLabels(labels), objects, name);
  const auto smallest = SmallestObjects(objects);
  auto       values = NewImageOn<ImageType>(heat);
  const int  numberOfLines = static_cast<int>(lines.GetLines().size());
  const auto numberOfClasses = static_cast<float>(numberOfLines + objects.size());
  const auto valueOf = [numberOfClasses](int index) { return (static_cast<float>(index) + 0.5F) / numberOfClasses; };
  ParallelForBlocks(heat->GetBufferedRegion().GetNumberOfPixels(), [&](std::size_t voxel) {
    const int object = smallest[labels->GetBufferPointer()[voxel]];
    const int line = object < 0 ? lines.LineOf(heat->GetBufferPointer()[voxel]) : numberOfLines + object;
    values->GetBufferPointer()[voxel] = line < 0 ? -1.0F : valueOf(line);
  });
  return { values.GetPointer(), ClassesOf(lines, objects) };
}

std::string
TextOf(const std::vector<ObjectColor> & objects)
{
  std::string text;
  for (const ObjectColor & object : objects)
  {
    text += (text.empty() ? "" : ",") + std::to_string(object.number) + ":" + HexOf(object.color) + ":" +
            CsvTable::Number(object.opacity);
  }
  return text;
}
} // namespace shapeton
