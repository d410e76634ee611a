#include "shapetonLabelFiles.h"

#include "shapetonAxisTicks.h"
#include "shapetonHeatColoring.h"
#include "shapetonObjectColors.h"

#include <algorithm>

namespace shapeton
{
namespace
{
Segment
MakeSegment(unsigned int label, const std::string & name, const RGBColor & color)
{
  constexpr double most = 255.0;
  return { label, name, { color[0] / most, color[1] / most, color[2] / most } };
}

template <typename TPixel>
void
WriteSegments(const itk::Image<TPixel, 3> * labels,
              const std::vector<Segment> &  segments,
              const std::string &           path,
              const Provenance &            provenance)
{
  auto       metadata = ProvenanceMetadata(provenance);
  const auto ofSegments = SegmentMetadata(labels, segments);
  metadata.insert(metadata.end(), ofSegments.begin(), ofSegments.end());
  WriteVolume(labels, path, metadata);
}
} // namespace

void
WriteClassLabels(const itk::Image<unsigned char, 3> * labels,
                 const std::vector<HeatClass> &       classes,
                 const ShapeQuantity &                quantity,
                 const std::string &                  path,
                 const Provenance &                   provenance)
{
  std::vector<Segment> segments;
  for (const HeatClass & heatClass : classes)
  {
    if (heatClass.label > 0)
    {
      const std::string name = "class " + std::to_string(heatClass.label) + ": " + quantity.name + " " +
                               HeatLabel(heatClass.lowerHeat) + " to " + HeatLabel(heatClass.upperHeat);
      segments.push_back(MakeSegment(
        heatClass.label, name + (heatClass.isSurroundings ? ", surroundings" : ""), ColorOfClass(heatClass)));
    }
  }
  WriteSegments(labels, segments, path, provenance);
}

void
WriteObjectLabels(const HeatObjectList::LabelImage * labels,
                  const std::vector<int> &           objects,
                  const std::string &                path,
                  const Provenance &                 provenance)
{
  std::vector<Segment> segments;
  for (const int object : objects)
  {
    const auto label = static_cast<unsigned int>(segments.size() + 1);
    segments.push_back(MakeSegment(label, NameOfObject(object), ColorOfObject(object)));
  }
  WriteSegments(labels, segments, path, provenance);
}

void
WriteSeededLabels(const itk::Image<unsigned short, 3> * labels,
                  const std::vector<unsigned short> &   labelValues,
                  const std::vector<Segment> &          ofSeeds,
                  const std::string &                   path,
                  const Provenance &                    provenance)
{
  std::vector<Segment> segments;
  for (const unsigned short label : labelValues)
  {
    const auto known =
      std::find_if(ofSeeds.begin(), ofSeeds.end(), [&](const Segment & seed) { return seed.label == label; });
    segments.push_back(
      known != ofSeeds.end() ? *known : MakeSegment(label, "label " + std::to_string(label), ColorOfObject(label)));
  }
  WriteSegments(labels, segments, path, provenance);
}
} // namespace shapeton
