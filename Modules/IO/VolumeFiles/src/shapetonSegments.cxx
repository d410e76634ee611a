#include "shapetonSegments.h"

#include "shapetonCsvTable.h"
#include "shapetonPrintable.h"
#include "shapetonStoredVoxels.h"
#include "shapetonTextHeader.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>

namespace shapeton
{
namespace
{
// 3D Slicer's entry for a part without a more specific term.
constexpr auto terminology =
  "TerminologyEntry:Segmentation category and type - 3D Slicer General Anatomy list~SCT^85756007^Tissue~"
  "SCT^85756007^Tissue~^^~Anatomic codes - DICOM master list~^^~^^|";

/** First and last index of each axis in the file, whose indices start at 0. */
std::string
ExtentOf(const itk::ImageBase<3> * image)
{
  std::string extent;
  for (const auto size : image->GetBufferedRegion().GetSize())
  {
    extent += (extent.empty() ? "0 " : " 0 ") + std::to_string(size - 1);
  }
  return extent;
}

/** The value of a key in a NRRD header, in which backslashes and line ends are escaped. */
std::string
Unescaped(const std::string & text)
{
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const bool isEscape = text[i] == '\\' && i + 1 < text.size() && (text[i + 1] == '\\' || text[i + 1] == 'n');
    i += isEscape ? 1 : 0;
    plain += isEscape && text[i] == 'n' ? '\n' : text[i];
  }
  return plain;
}
} // namespace

VolumeMetadata
SegmentMetadata(const itk::ImageBase<3> * labels, const std::vector<Segment> & segments)
{
  constexpr int  digits = 6;
  VolumeMetadata metadata{ { "Segmentation_ContainedRepresentationNames", "Binary labelmap|" },
                           { "Segmentation_MasterRepresentation", "Binary labelmap" },
                           { "Segmentation_ReferenceImageExtentOffset", "0 0 0" } };
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    const Segment &   segment = segments[i];
    const std::string key = "Segment" + std::to_string(i) + "_";
    const std::string color = CsvTable::Rounded(segment.color[0], digits) + " " +
                              CsvTable::Rounded(segment.color[1], digits) + " " +
                              CsvTable::Rounded(segment.color[2], digits);
    metadata.insert(metadata.end(),
                    { { key + "ID", "Segment_" + std::to_string(segment.label) },
                      { key + "Name", segment.name },
                      { key + "Color", color },
                      { key + "LabelValue", std::to_string(segment.label) },
                      { key + "Layer", "0" },
                      { key + "Extent", ExtentOf(labels) },
                      { key + "Tags", segment.tags.empty() ? terminology : segment.tags } });
  }
  return metadata;
}

std::vector<Segment>
SegmentsOfFile(const std::string & path)
{
  std::vector<Segment> segments;
  if (ImageFormatOf(path) != ImageFormat::nrrd)
  {
    return segments;
  }
  const TextHeader header = ReadNrrdHeader(path);
  const auto       valueOf = [&](std::size_t number, const std::string & name) {
    const std::string value = header.ValueOf("segment" + std::to_string(number) + "_" + name, ':');
    return Printable(Unescaped(value.substr(value.compare(0, 1, "=") == 0 ? 1 : 0)));
  };
  for (std::size_t i = 0; !valueOf(i, "id").empty(); ++i)
  {
    Segment            segment;
    const std::string  value = valueOf(i, "labelvalue");
    std::istringstream color(valueOf(i, "color"));
    color >> segment.color[0] >> segment.color[1] >> segment.color[2];
    segment.label = static_cast<unsigned int>(std::strtoul(value.c_str(), nullptr, 10));
    segment.name = valueOf(i, "name");
    segment.tags = valueOf(i, "tags");
    for (double & channel : segment.color)
    {
      channel = std::clamp(channel, 0.0, 1.0);
    }
    if (segment.label > 0)
    {
      segments.push_back(segment);
    }
  }
  return segments;
}
} // namespace shapeton
