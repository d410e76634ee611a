#include "shapetonDicomMapOutput.h"

#include "shapetonCommandLine.h"
#include "shapetonDicomPictures.h"
#include "shapetonExceptions.h"
#include "shapetonImageFile.h"
#include "shapetonMappedImage.h"

#include <algorithm>

namespace shapeton
{
namespace
{
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
} // namespace

DicomMapOutput::DicomMapOutput(CommandLine & commandLine)
  : m_CommandLine(commandLine), m_Path(commandLine.OutputOf("dicomMap"))
{
  commandLine.LeaveOutOfProvenance("dicomMap");
  if (!m_Path.empty())
  {
    const std::string input = commandLine.GetString("inputVolume");
    RequireParameter(!IsImageFile(input),
                     "the parameter \"dicomMap\" requires a DICOM series as input: \"" + input + "\" is not one");
    m_Source = std::make_unique<DicomSource>(ReadDicomSource(input, { commandLine.GetString("seriesUID") }));
  }
}

DicomMapOutput::~DicomMapOutput() = default;

void
DicomMapOutput::Write(const itk::Image<float, 3> * image, const std::string & code, const std::string & meaning) const
{
  if (m_Source)
  {
    const DicomMapMeaning what{
      { code, "99SHAPETON", meaning }, { "1", "UCUM", "no units" }, code, meaning, { "38266002", "SCT", "Entire body" }
    };
    const DicomResultHeader header{
      FactOf(m_CommandLine, "tool"), FactOf(m_CommandLine, "version"), 9100, "Research: " + meaning
    };
    WriteDicomMap(*m_Source, image, what, header, m_Path);
  }
}

void
DicomMapOutput::Write(const itk::Image<unsigned int, 3> * image,
                      const std::string &                 code,
                      const std::string &                 meaning) const
{
  if (m_Source)
  {
    const auto values = MapVoxels<float>(image, [](unsigned int count) { return static_cast<float>(count); });
    this->Write(values.GetPointer(), code, meaning);
  }
}
} // namespace shapeton
