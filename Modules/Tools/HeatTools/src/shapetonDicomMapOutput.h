#ifndef shapetonDicomMapOutput_h
#define shapetonDicomMapOutput_h

#include "itkImage.h"

#include <memory>
#include <string>

namespace shapeton
{
class CommandLine;
struct DicomSource;

/** \class DicomMapOutput
 * \brief The option dicomMap of a tool that computes a value per voxel: writes the result as a DICOM Parametric Map
 * that references the input series. */
class DicomMapOutput
{
public:
  /** Reads the headers of the series, to reject unsuitable input before the run. Throws ParameterError if the
   * input is not DICOM, and the exceptions of ReadDicomSource(). */
  explicit DicomMapOutput(CommandLine & commandLine);
  ~DicomMapOutput();

  /** Writes the map if requested. `code` is in the scheme 99SHAPETON, `meaning` is its text. Values are
   * dimensionless. */
  void
  Write(const itk::Image<float, 3> * image, const std::string & code, const std::string & meaning) const;
  /** Writes counts, which 32-bit floats represent exactly up to 2^24. */
  void
  Write(const itk::Image<unsigned int, 3> * image, const std::string & code, const std::string & meaning) const;

private:
  const CommandLine &          m_CommandLine;
  std::string                  m_Path;
  std::unique_ptr<DicomSource> m_Source;
};
} // namespace shapeton

#endif
