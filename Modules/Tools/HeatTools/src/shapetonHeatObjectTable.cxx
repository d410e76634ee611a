#include "shapetonHeatObjectTable.h"

#include "shapetonExceptions.h"
#include "shapetonMappedImage.h"
#include "shapetonObjectColors.h"
#include "shapetonSliceChoice.h"
#include "shapetonSliceMontage.h"

#include "itkCastImageFilter.h"

#include <numeric>

namespace shapeton
{
namespace
{
double
MeanIntensity(const std::vector<VoxelRange> & ranges, const itk::Image<float, 3> * image)
{
  double sum = 0.0;
  double voxels = 0.0;
  for (const VoxelRange & range : ranges)
  {
    sum = std::accumulate(image->GetBufferPointer() + range.begin, image->GetBufferPointer() + range.end, sum);
    voxels += range.end - range.begin;
  }
  return sum / voxels;
}
} // namespace

CsvTable
HeatObjectTable(const HeatObjectList & list, const std::vector<int> & objects, const itk::Image<float, 3> * image)
{
  CsvTable table({ "object",
                   "parent",
                   "voxels",
                   "volume",
                   "x",
                   "y",
                   "z",
                   "meanIntensity",
                   "meanHeat",
                   "probability",
                   "range",
                   "contrast",
                   "compactness",
                   "cut" });
  for (const int number : objects)
  {
    const HeatObject &       object = list.objects.at(number - 1);
    std::vector<std::string> row{ std::to_string(number),
                                  std::to_string(object.parent),
                                  std::to_string(object.voxels) };
    for (const double value : { object.volume,
                                object.center[0],
                                object.center[1],
                                object.center[2],
                                MeanIntensity(list.ranges[number - 1], image),
                                object.meanHeat,
                                object.probability,
                                object.range,
                                object.contrast,
                                object.compactness,
                                object.cut })
    {
      row.push_back(CsvTable::Number(value));
    }
    table.AddRow(row);
  }
  return table;
}

HeatObjectList::LabelImage::Pointer
LabelsOfObjects(const HeatObjectList & list, const std::vector<int> & objects)
{
  const auto labels = NewImageOn<HeatObjectList::LabelImage>(list.labels, true);
  for (std::size_t i = 0; i < objects.size(); ++i)
  {
    RequireParameter(objects[i] >= 1 && objects[i] <= static_cast<int>(list.ranges.size()),
                     "object " + std::to_string(objects[i]) + " is not in the list");
    for (const VoxelRange & range : list.ranges[objects[i] - 1])
    {
      std::fill(labels->GetBufferPointer() + range.begin,
                labels->GetBufferPointer() + range.end,
                static_cast<HeatObjectList::LabelImage::PixelType>(i + 1));
    }
  }
  return labels;
}

std::vector<int>
ObjectsAt(const HeatObjectList & list, const itk::Point<double, 3> & point)
{
  const std::string words =
    CsvTable::Number(point[0]) + ',' + CsvTable::Number(point[1]) + ',' + CsvTable::Number(point[2]);
  itk::Index<3> index;
  if (!list.labels->TransformPhysicalPointToIndex(point, index))
  {
    throw ParameterError("the point " + words + " mm is outside of the volume");
  }
  std::vector<int> objects;
  for (int object = list.labels->GetPixel(index); object > 0; object = list.objects[object - 1].parent)
  {
    objects.push_back(object);
  }
  if (objects.empty())
  {
    throw InputError("no object contains the point " + words +
                     " mm: choose another point, reduce the parameter \"leastProbability\", or change the diffusion");
  }
  return objects;
}

Picture::Pointer
DrawHeatObjects(const itk::Image<float, 3> *       image,
                const HeatObjectList::LabelImage * labels,
                const std::vector<int> &           objects,
                const std::string &                title)
{
  const auto cast = itk::CastImageFilter<HeatObjectList::LabelImage, itk::Image<float, 3>>::New();
  cast->SetInput(labels);
  cast->Update();
  SliceMontageOptions options;
  options.title = title;
  options.cut = CutThroughParts(labels);
  for (const int object : objects)
  {
    options.legend.push_back({ ColorOfObject(object), NameOfObject(object) });
  }
  const auto color = [&](float label) {
    return label > 0.0F ? std::optional<RGBColor>(options.legend.at(static_cast<std::size_t>(label) - 1).color)
                        : std::nullopt;
  };
  return DrawSliceMontage(image, cast->GetOutput(), color, options);
}
} // namespace shapeton
