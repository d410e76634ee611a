#include "shapetonDicomOutput.h"

#include "shapetonCommandLine.h"
#include "shapetonDicomPictures.h"
#include "shapetonDicomText.h"
#include "shapetonExceptions.h"
#include "shapetonImageFile.h"
#include "shapetonMappedImage.h"
#include "shapetonPrintable.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace shapeton
{
namespace
{
// After the series of a usual study.
constexpr int NumberOfMapSeries = 9100;
constexpr int NumberOfSegmentSeries = 9101;

std::string
FactOf(const CommandLine & commandLine, const std::string & name)
{
  for (const auto & [key, value] : commandLine.GetProvenance())
  {
    if (key == name)
    {
      return value;
    }
  }
  return {};
}

DicomResultHeader
HeaderOf(const CommandLine & commandLine, int seriesNumber, const std::string & content)
{
  return { FactOf(commandLine, "tool"), FactOf(commandLine, "version"), seriesNumber, "Research: " + content };
}

/** A name as a Long String: at most 64 characters, without a backslash (DICOM PS3.5 6.2). */
std::string
LongStringOf(const std::string & name)
{
  constexpr int longest = 64;
  std::string   text;
  int           characters = 0;
  for (const char c : Printable(name))
  {
    characters += (static_cast<unsigned char>(c) & 0xC0) != 0x80 ? 1 : 0; // first byte of a character in UTF-8
    if (characters <= longest)
    {
      text += c == '\\' ? '/' : c;
    }
  }
  return Trimmed(text);
}

std::vector<std::string>
SplitAt(const std::string & text, char separator)
{
  std::vector<std::string> parts(1);
  for (const char c : text)
  {
    c == separator ? (void)parts.emplace_back() : parts.back().push_back(c);
  }
  return parts;
}

/** The code "scheme^value^meaning"; none if a part is missing. */
std::optional<DicomCode>
CodeOf(const std::string & text)
{
  const auto parts = SplitAt(text, '^');
  if (parts.size() != 3 || parts[0].empty() || parts[1].empty() || parts[2].empty())
  {
    return {};
  }
  return DicomCode{ parts[1], parts[0], LongStringOf(parts[2]) };
}

/** Sets the terms that the tags state: "TerminologyEntry:context~category~type~modifier~context~region~modifier|", as
 * vtkSlicerTerminologiesModuleLogic of 3D Slicer writes them. */
void
PutTerms(const std::string & tags, DicomSegment & segment)
{
  const DicomCode tissue{ "85756007", "SCT", "Tissue" };
  segment.category = segment.type = tissue;
  const std::string key = "TerminologyEntry:";
  const auto        begin = tags.find(key);
  if (begin == std::string::npos)
  {
    return;
  }
  const auto terms = SplitAt(tags.substr(begin + key.size(), tags.find('|', begin) - begin - key.size()), '~');
  const auto codeAt = [&](std::size_t place) { return place < terms.size() ? CodeOf(terms[place]) : std::nullopt; };
  if (const auto category = codeAt(1), type = codeAt(2); category && type)
  {
    segment.category = *category;
    segment.type = *type;
  }
  constexpr std::size_t placeOfRegion = 5;
  segment.region = codeAt(placeOfRegion);
}
} // namespace

DicomOutput::DicomOutput(CommandLine & commandLine, const std::string & parameter)
  : m_CommandLine(commandLine), m_Path(commandLine.OutputOf(parameter))
{
  commandLine.LeaveOutOfProvenance(parameter);
  if (!m_Path.empty())
  {
    const std::string input = commandLine.GetString("inputVolume");
    RequireParameter(!IsImageFile(input),
                     "the parameter \"" + parameter + "\" requires a DICOM series as input: \"" + input +
                       "\" is not one");
    m_Source = std::make_unique<DicomSource>(ReadDicomSource(input, { commandLine.GetString("seriesUID") }));
  }
}

DicomOutput::~DicomOutput() = default;

void
DicomOutput::WriteMap(const itk::Image<float, 3> * image, const std::string & code, const std::string & meaning) const
{
  if (m_Source)
  {
    const DicomMapMeaning what{
      { code, "99SHAPETON", meaning }, { "1", "UCUM", "no units" }, code, meaning, { "38266002", "SCT", "Entire body" }
    };
    WriteDicomMap(*m_Source, image, what, HeaderOf(m_CommandLine, NumberOfMapSeries, meaning), m_Path);
  }
}

void
DicomOutput::WriteMap(const itk::Image<unsigned int, 3> * image,
                      const std::string &                 code,
                      const std::string &                 meaning) const
{
  if (m_Source)
  {
    const auto values = MapVoxels<float>(image, [](unsigned int count) { return static_cast<float>(count); });
    this->WriteMap(values.GetPointer(), code, meaning);
  }
}

void
DicomOutput::WriteSegments(const DicomLabelImage *      labels,
                           const std::vector<Segment> & segments,
                           bool                         isSemiautomatic,
                           DicomSegmentationFormat      format) const
{
  if (!m_Source)
  {
    return;
  }
  const DicomResultHeader header =
    HeaderOf(m_CommandLine, NumberOfSegmentSeries, "Segments of " + FactOf(m_CommandLine, "tool"));
  std::vector<DicomSegment> written;
  for (const Segment & segment : segments)
  {
    DicomSegment & one = written.emplace_back();
    PutTerms(segment.tags, one);
    one.name = one.description = LongStringOf(segment.name);
    one.trackingID = LongStringOf(header.tool + ' ' + std::to_string(segment.label) + ' ' + segment.name);
    one.trackingUID = MakeDicomUID(ConcatenateTexts({ m_Source->series.uid, one.trackingID }));
    std::transform(segment.color.begin(), segment.color.end(), one.color.begin(), [](double share) {
      constexpr double greatest = 255.0;
      return static_cast<unsigned char>(std::lround(greatest * share));
    });
    one.labels = labels;
    one.label = static_cast<unsigned short>(segment.label);
    one.isSemiautomatic = isSemiautomatic;
  }
  WriteDicomSegmentation(*m_Source, written, header, m_Path, format);
}
} // namespace shapeton
