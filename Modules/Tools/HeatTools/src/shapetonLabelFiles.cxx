#include "shapetonLabelFiles.h"

#include "shapetonAxisTicks.h"
#include "shapetonCommandLine.h"
#include "shapetonDicomOutput.h"
#include "shapetonExceptions.h"
#include "shapetonHeatColoring.h"
#include "shapetonLabelSurfaces.h"
#include "shapetonObjectColors.h"
#include "shapetonReadOptions.h"
#include "shapetonSurfaceScene.h"
#include "shapetonVolumeWriter.h"

#include <algorithm>
#include <iomanip>
#include <set>
#include <sstream>

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
WriteSegmentation(const itk::Image<TPixel, 3> * labels,
                  const std::vector<Segment> &  segments,
                  const std::string &           path,
                  const Provenance &            provenance)
{
  auto       metadata = ProvenanceMetadata(provenance);
  const auto ofSegments = SegmentMetadata(labels, segments);
  metadata.insert(metadata.end(), ofSegments.begin(), ofSegments.end());
  WriteVolume(labels, path, metadata);
}

std::string
FileNameOf(unsigned int label, const std::string & extension)
{
  constexpr int      digits = 5; // of labels up to 65535
  std::ostringstream name;
  name << "segment-" << std::setw(digits) << std::setfill('0') << label << '.' << extension;
  return name.str();
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
  WriteSegmentation(labels, segments, path, provenance);
}

SegmentFiles::SegmentFiles(CommandLine & commandLine, const std::string & labelsParameter) : m_CommandLine(commandLine)
{
  RequireVolumeName(commandLine.GetString(labelsParameter));
  RequireParameter(commandLine.IsGiven("dicom") || !commandLine.GetFlag("labelMap"), "--labelMap requires --dicom");
  RequireParameter(commandLine.IsGiven("surfaces") || !commandLine.IsGiven("surfaceFormat"),
                   "--surfaceFormat: give the folder of the surfaces by --surfaces");
  ReadOptions(commandLine, m_Options);
  for (const std::string name : { "labelMap", "surfaces", "surfaceFormat" })
  {
    commandLine.LeaveOutOfProvenance(name);
  }
  m_Labels = commandLine.MainOutput(labelsParameter);
  m_Dicom = std::make_shared<DicomOutput>(commandLine, "dicom");
}

void
SegmentFiles::WriteObjects(const LabelImage * labels, const std::vector<int> & objects) const
{
  std::vector<Segment> segments;
  for (const int object : objects)
  {
    const auto label = static_cast<unsigned int>(segments.size() + 1);
    segments.push_back(MakeSegment(label, NameOfObject(object), ColorOfObject(object)));
  }
  this->Write(labels, segments, false);
}

void
SegmentFiles::WriteSeeded(const LabelImage *                  labels,
                          const std::vector<unsigned short> & labelValues,
                          const std::vector<Segment> &        ofSeeds) const
{
  std::vector<Segment> segments;
  for (const unsigned short label : labelValues)
  {
    const auto known =
      std::find_if(ofSeeds.begin(), ofSeeds.end(), [&](const Segment & seed) { return seed.label == label; });
    segments.push_back(
      known != ofSeeds.end() ? *known : MakeSegment(label, "label " + std::to_string(label), ColorOfObject(label)));
  }
  this->Write(labels, segments, true);
}

void
SegmentFiles::Write(const LabelImage * labels, const std::vector<Segment> & segments, bool isSemiautomatic) const
{
  WriteSegmentation(labels, segments, m_Labels, m_CommandLine.GetProvenance());
  m_Dicom->WriteSegments(labels,
                         segments,
                         isSemiautomatic,
                         m_Options.labelMap ? DicomSegmentationFormat::LabelMap : DicomSegmentationFormat::Binary);
  this->WriteSurfaces(labels, segments);
}

void
SegmentFiles::WriteSurfaces(const LabelImage * labels, const std::vector<Segment> & segments) const
{
  const std::string folder = m_CommandLine.MakeFolderOf("surfaces");
  if (folder.empty())
  {
    return;
  }
  std::vector<unsigned short> values;
  std::transform(segments.begin(), segments.end(), std::back_inserter(values), [](const Segment & segment) {
    return static_cast<unsigned short>(segment.label);
  });
  std::vector<SurfaceMesh>    meshes = SurfacesOfLabels(labels, values);
  std::vector<SurfaceOfScene> scene;
  std::set<std::string>       names;
  const std::string           extension = m_CommandLine.GetString("surfaceFormat");
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    if (meshes[i].NumberOfFaces() == 0)
    {
      continue; // all of its voxels have the labels of segments in it
    }
    if (m_Options.surfaceFormat == SurfaceFormat::Glb)
    {
      scene.push_back({ segments[i].name, segments[i].color, std::move(meshes[i]) });
      continue;
    }
    auto provenance = m_CommandLine.GetProvenance();
    provenance.emplace_back("segment", segments[i].name);
    const std::string name = FileNameOf(segments[i].label, extension);
    names.insert(name);
    WriteSurface(std::move(meshes[i]), provenance, m_CommandLine.Output(folder + '/' + name));
  }
  if (!scene.empty())
  {
    WriteSurfaceScene(scene, m_CommandLine.Output(folder + "/segments.glb"));
  }
  CommandLine::RequireNoOthers(folder, "segment-", names);
}
} // namespace shapeton
