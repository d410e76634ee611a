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
 * \brief The option dicomMap of a tool that computes a value for each voxel: its result as a DICOM Parametric Map
 * beside the series that it was made from. */
class DicomMapOutput
{
public:
  /** Reads the headers of the series, so that a run that could not be written ends before it begins. Throws
   * ParameterError where the input is no DICOM, InputError as ReadDicomSource(). */
  explicit DicomMapOutput(CommandLine & commandLine);
  ~DicomMapOutput();

  /** Writes what was asked for. `code` is in the scheme 99SHAPETON, `meaning` in words; values have no unit. */
  void
  Write(const itk::Image<float, 3> * image, const std::string & code, const std::string & meaning) const;
  /** The same of counts, which 32 bits of floating point hold exactly up to 2^24. */
  void
  Write(const itk::Image<unsigned int, 3> * image, const std::string & code, const std::string & meaning) const;

private:
  const CommandLine &          m_CommandLine;
  std::string                  m_Path;
  std::unique_ptr<DicomSource> m_Source;
};
} // namespace shapeton

#endif
